"""Plots of a study: curves over one parameter, maps over two."""
import math

import matplotlib

matplotlib.use("Agg")
from matplotlib.colors import LogNorm, Normalize
from matplotlib.patches import Rectangle
from matplotlib.pyplot import get_cmap

from report_plots import axes_of, colour, STYLES

SUCCESS = ("done", "check failed")


def number(value):
    """A number, or None where there is none."""
    try:
        return float(value)
    except (TypeError, ValueError):
        return None


def distinct(rows, column):
    """Values in their order: of numbers, else of the table."""
    values = list(dict.fromkeys(row[column] for row in rows))
    return sorted(values, key=number) if all(number(value) is not None for value in values) else values


def split(rows, column):
    """[(value, rows)]; one part without a column."""
    return [(value, [row for row in rows if row[column] == value]) for value in distinct(rows, column)] if column else [("", rows)]


def title_of(plot):
    if "title" in plot:
        return plot["title"]
    return f"{plot['value']} over {plot['x']} and {plot['y']}" if "value" in plot else f"{plot['y']} over {plot['x']}"


def draw(plot, rows):
    """A matplotlib figure."""
    return (draw_map if "value" in plot else draw_curves)(plot, rows)


def draw_map(plot, rows):
    """A panel per value of `panels`; a cross where a run has not succeeded."""
    panels = split(rows, plot.get("panels"))
    xs, ys = distinct(rows, plot["x"]), distinct(rows, plot["y"])
    title = title_of(plot) + "; × did not succeed"
    width = max(3.0, 0.62 * len(xs) + 1.0, 0.075 * len(title) / len(panels))
    figure, all_axes = axes_of(len(panels), width=width, height=max(2.6, 0.44 * len(ys) + 1.3))
    values = [v for row in rows if row["state"] in SUCCESS and (v := number(row[plot["value"]])) is not None]
    low, high = (min(values), max(values)) if values else (0.0, 1.0)
    norm = LogNorm(low, max(high, 1.01 * low)) if low > 0 and high > 10 * low else Normalize(low, max(high, low + 1e-12))
    colours = get_cmap("viridis_r")
    for axes, (name, of_panel) in zip(all_axes, panels):
        axes.grid(False)
        for row in of_panel:
            i, j = xs.index(row[plot["x"]]), ys.index(row[plot["y"]])
            value = number(row[plot["value"]])
            is_good = row["state"] in SUCCESS and value is not None
            face = colours(norm(value)) if is_good else ("#f2f2f2" if row["state"] == "not run" else "#e3dede")
            axes.add_patch(Rectangle((i - 0.5, j - 0.5), 1, 1, facecolor=face, edgecolor="white"))
            text = f"{value:.4g}" if is_good else ("" if row["state"] == "not run" else "×")
            is_dark = is_good and norm(value) > 0.45
            axes.text(i, j, text, ha="center", va="center", fontsize=9,
                      color="white" if is_dark else ("black" if is_good else "#b03030"))
        axes.set(xlim=(-0.5, len(xs) - 0.5), ylim=(-0.5, len(ys) - 0.5), xlabel=plot["x"], title=name)
        axes.set_xticks(range(len(xs)), xs, rotation=45 if max(map(len, xs)) > 5 else 0)
        axes.set_yticks(range(len(ys)), ys)
    all_axes[0].set_ylabel(plot["y"])
    figure.suptitle(title, fontsize=10, x=0.01, ha="left")
    return figure


def draw_curves(plot, rows):
    """
    y over x, a curve per value of `curves`. With a reference: the distance from it
    over both scales logarithmic, and the observed order between the last two points.
    """
    panels = split(rows, plot.get("panels"))
    figure, all_axes = axes_of(len(panels), width=5.6, height=3.9)
    reference = number(plot.get("reference"))
    for axes, (name, of_panel) in zip(all_axes, panels):
        curves = split(of_panel, plot.get("curves"))
        for k, (curve, of_curve) in enumerate(curves):
            points = [(number(row[plot["x"]]), number(row[plot["y"]])) for row in of_curve if row["state"] in SUCCESS]
            points = sorted(point for point in points if None not in point)
            if reference is not None:
                points = [(x, abs(y - reference)) for x, y in points if y != reference]
            label = curve
            if reference is not None and len(points) > 1:
                label = f"{curve}  (order {observed_order(points):.2f})"
            above = min(len(curves) - 1 - k, 4)  # wider than those drawn over it: equal curves are all seen
            if points:
                axes.plot(*zip(*points), "o", linestyle=STYLES[(k // 8) % 4], color=colour(k), linewidth=1.5 + 1.5 * above,
                          markersize=4 + 2 * above, label=label)
        log = plot.get("log", "xy" if reference is not None else "")
        axes.set(xscale="log" if "x" in log else "linear", yscale="log" if "y" in log else "linear", xlabel=plot["x"], title=name)
        places = [x for x in map(number, distinct(of_panel, plot["x"])) if x is not None]
        if "x" in log and 0 < len(places) <= 8:  # few values: these are the ticks
            axes.minorticks_off()
            axes.set_xticks(places, [f"{x:g}" for x in places])
        if axes.get_legend_handles_labels()[1] and (plot.get("curves") or reference is not None):
            axes.legend(fontsize=8, framealpha=0.85, edgecolor="none")
    ylabel = plot["y"] if reference is None else f"|{plot['y']} - {reference:g}|"
    all_axes[0].set_ylabel(ylabel)
    figure.suptitle(title_of(plot), fontsize=10, x=0.01, ha="left")
    return figure


def observed_order(points):
    """Slope of the last refinement: between the two points of the smallest x."""
    (x0, y0), (x1, y1) = points[:2]
    return math.log(y1 / y0) / math.log(x1 / x0)
