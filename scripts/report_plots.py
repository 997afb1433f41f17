"""Curves and bars of one or several runs, as SVG texts for a page."""
import io
import itertools

import matplotlib

matplotlib.use("Agg")
from matplotlib import rc_context
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

COLOURS = ["#2b6cb0", "#e07b39", "#2f7d4f", "#b5332e", "#6b4c9a", "#8a6d1d", "#3a9a9a", "#c2588f"]
STYLES = ["-", "--", ":", "-."]
PHASES = {"assembly_seconds": "cells", "contact_seconds": "contact", "setup_seconds": "set-up of the linear solver",
          "solve_seconds": "linear solution"}
LOOPS = {"geometry_loops": "geometry", "threshold_loops": "threshold", "status_loops": "status"}
FAILED = {"color": "#b5332e", "hatch": "///", "edgecolor": "white", "linewidth": 0.0}


def colour(i):
    return COLOURS[i % len(COLOURS)]


def marker(n):
    """Points are shown while they can be told apart."""
    return "o" if n <= 40 else None


def svg(figure):
    text = io.StringIO()
    with rc_context({"svg.fonttype": "path", "svg.hashsalt": "stickslip"}):
        figure.savefig(text, format="svg", facecolor="white", metadata={"Date": None})
    return text.getvalue()


def axes_of(n_columns, width=5.2, height=3.3, n_rows=1):
    figure = Figure(figsize=(width * n_columns, height * n_rows), layout="constrained")
    axes = figure.subplots(n_rows, n_columns, squeeze=False).ravel()
    for a in axes:
        a.spines[["top", "right"]].set_visible(False)
        a.grid(True, color="0.92")
        a.set_axisbelow(True)
    return figure, axes


def _legend(axes):
    labels = axes.get_legend_handles_labels()[1]
    if labels:
        axes.legend(fontsize=8, framealpha=0.85, edgecolor="none", ncol=2 if len(labels) > 6 else 1)


def _legend_above(axes):
    """For wide axes: to the right of the title."""
    labels = axes.get_legend_handles_labels()[1]
    if labels:
        axes.legend(fontsize=8, frameon=False, ncol=len(labels), loc="lower right", bbox_to_anchor=(1, 0.98))


def _flatten_roundoff(all_axes):
    """What is roundoff beside the other panels is drawn as the zero that it is."""
    sizes = [max((abs(y) for line in axes.lines for y in line.get_ydata()), default=0.0) for axes in all_axes]
    for axes, size in zip(all_axes, sizes):
        if size < 1e-8 * max(sizes):
            axes.set_ylim(-0.01 * max(sizes), 0.01 * max(sizes))


def _curve(axes, table, column, **options):
    time = table["time"]
    options.setdefault("markersize", 3)
    options.setdefault("marker", marker(len(time)))
    options.setdefault("linewidth", 1.5)
    axes.plot(time, table[column], **options)


def _choose(runs, i, k):
    """Look of the k-th curve of run i: runs have colours and, where they coincide, all are seen; one run's curves have colours."""
    if len(runs) == 1:
        return {"color": colour(k)}
    return {"color": colour(i), "linestyle": STYLES[k % 4], "linewidth": 1.3 + 1.1 * min(len(runs) - 1 - i, 4)}


def _run_name(runs, run, text):
    return text if len(runs) == 1 else ", ".join(filter(None, [run.label, text]))


def forces(runs):
    """Force of each pair on the slave, a panel per component; colours: runs, or the pairs of one."""
    axis_names = "xyz"[: max(run.dimension for run in runs)]
    if not any(run.pairs for run in runs):
        return None
    figure, all_axes = axes_of(len(axis_names))
    for axis, axes in zip(axis_names, all_axes):
        for i, run in enumerate(runs):
            for k, pair in enumerate(run.pairs):
                column = f"{pair}.force_{axis}"
                if column in run.resultants:
                    _curve(axes, run.resultants, column, **_choose(runs, i, k),
                           label=_run_name(runs, run, pair if len(run.pairs) > 1 or len(runs) == 1 else ""))
        axes.set(title=f"Contact force on the slave, {axis}", xlabel="t")
    _flatten_roundoff(all_axes)
    _legend(all_axes[0])
    return svg(figure)


def reactions(runs):
    """Forces of supports, a panel per component."""
    if not any(len(run.reactions) > 2 for run in runs):
        return None
    axis_names = "xyz"[: max(run.dimension for run in runs)]
    figure, all_axes = axes_of(len(axis_names))
    for axis, axes in zip(axis_names, all_axes):
        for i, run in enumerate(runs):
            conditions = [key[: -len(f".force_{axis}")] for key in run.reactions if key.endswith(f".force_{axis}")]
            for k, condition in enumerate(conditions):
                _curve(axes, run.reactions, f"{condition}.force_{axis}", **_choose(runs, i, k),
                       label=_run_name(runs, run, condition))
        axes.set(title=f"Force of the supports, {axis}", xlabel="t")
    _flatten_roundoff(all_axes)
    _legend(all_axes[0])
    return svg(figure)


def points(runs):
    """Displacements of the named points, a panel per component."""
    names = list(dict.fromkeys(key[:-2] for run in runs for key in run.points if key.endswith("_x") and "." not in key))
    if not names:
        return None
    axis_names = "xyz"[: max(run.dimension for run in runs)]
    figure, all_axes = axes_of(len(axis_names))
    for axis, axes in zip(axis_names, all_axes):
        for (i, run), (k, name) in itertools.product(enumerate(runs), enumerate(names)):
            if f"{name}_{axis}" in run.points:
                _curve(axes, run.points, f"{name}_{axis}", **_choose(runs, i, k),
                       label=_run_name(runs, run, name))
        axes.set(title=f"Displacement of points, {axis}", xlabel="t")
    _flatten_roundoff(all_axes)
    _legend(all_axes[0])
    return svg(figure)


def contact_and_work(runs):
    """Contact area, largest pressure, work."""
    if not any(run.n_steps for run in runs):
        return None
    figure, (area, pressure, work) = axes_of(3)
    for i, run in enumerate(runs):
        for k, pair in enumerate(run.pairs):
            label = _run_name(runs, run, pair if len(run.pairs) > 1 or len(runs) == 1 else "")
            options = {**_choose(runs, i, k), "label": label}
            _curve(area, run.resultants, f"{pair}.contact_area", **options)
            _curve(pressure, run.resultants, f"{pair}.max_pressure", **options)
        for k, (column, name) in enumerate((("external_work", "loads and supports"), ("friction_work", "dissipated by friction"),
                                            ("stabilization_work", "stabilization"))):
            values = run.statistics.get(column, [])
            if any(values):
                _curve(work, run.statistics, column, **_choose(runs, i, k),
                       label=_run_name(runs, run, name))
    area.set(title="Contact area (deformed)", xlabel="t")
    pressure.set(title="Largest contact pressure", xlabel="t")
    work.set(title="Work since the start", xlabel="t")
    _legend(area)
    _legend(work)
    return svg(figure)


def contact_states(run):
    """Numbers of sticking and slipping points of each pair, stacked."""
    pairs = [pair for pair in run.pairs if f"{pair}.stick_points" in run.resultants][:4]
    if not pairs or len(run.resultants["time"]) < 2:
        return None
    figure, all_axes = axes_of(len(pairs), width=min(5.2, 15.6 / len(pairs)), height=2.8)
    for pair, axes in zip(pairs, all_axes):
        table = run.resultants
        stick, slip = table[f"{pair}.stick_points"], table[f"{pair}.slip_points"]
        rest = [max(0.0, c - a - b) for c, a, b in zip(table[f"{pair}.closed_points"], stick, slip)]
        stacks = [(stick, "stick", "#2b6cb0"), (slip, "slip", "#e07b39"), (rest, "closed, no friction", "#9aa5b1")]
        stacks = [stack for stack in stacks if any(stack[0])]
        if stacks:
            axes.stackplot(table["time"], *(s[0] for s in stacks), labels=[s[1] for s in stacks], colors=[s[2] for s in stacks],
                           step=None)
        axes.set(title=f"Closed contact points: {pair}", xlabel="t")
        axes.margins(x=0)
        _legend(axes)
    return svg(figure)


def iterations_per_step(runs):
    """One run: a bar per step, failed attempts on top. Several: sums over time."""
    if not any(run.log.attempts or run.n_steps for run in runs):
        return None
    figure, (axes,) = axes_of(1, width=15.6 if len(runs) == 1 else 8, height=2.9)
    if len(runs) > 1:
        for i, run in enumerate(runs):
            if run.n_steps:
                table = run.statistics
                both = [a + b for a, b in zip(table["newton_iterations"], table["failed_newton_iterations"])]
                axes.plot(table["time"], list(itertools.accumulate(both)), **_choose(runs, i, 0), label=run.label)
        axes.set(title="Newton iterations so far, failed attempts included", xlabel="t")
        _legend(axes)
        return svg(figure)

    run = runs[0]
    table = run.statistics
    algorithms = list(dict.fromkeys(table.get("algorithm", [])))
    for i, algorithm in enumerate(algorithms):
        rows = [k for k, name in enumerate(table["algorithm"]) if name == algorithm]
        axes.bar([table["step"][k] for k in rows], [table["newton_iterations"][k] for k in rows], width=0.85, color=colour(i),
                 label=algorithm)
    failed = dict(zip(table.get("step", []), table.get("failed_newton_iterations", [])))
    height = dict(zip(table.get("step", []), table.get("newton_iterations", [])))
    for attempt in run.log.attempts:
        if attempt.step not in height:
            failed[attempt.step] = failed.get(attempt.step, 0) + attempt.n_iterations
    bars = [(step, count) for step, count in failed.items() if count]
    if bars:
        axes.bar([s for s, _ in bars], [c for _, c in bars], bottom=[height.get(s, 0) for s, _ in bars], width=0.85,
                 label="failed attempts", **FAILED)
    axes.set(title="Newton iterations of each load step", xlabel="step")
    axes.xaxis.set_major_locator(MaxNLocator(integer=True))
    axes.yaxis.set_major_locator(MaxNLocator(integer=True))
    first, last = axes.get_xlim()
    axes.set_xlim(min(first, 0.0), max(last, 8.0))
    _legend_above(axes)
    return svg(figure)


def totals(runs):
    """Bars per run: Newton iterations (failed ones hatched) and passes of the loops."""
    has_loops = any(run.total(column) for run in runs for column in LOOPS)
    figure, all_axes = axes_of(2 if has_loops else 1, width=7.8, height=1.4 + 0.34 * len(runs))
    labels = [run.label for run in runs]
    rows = range(len(runs))[::-1]
    axes = all_axes[0]
    done = [run.total("newton_iterations") for run in runs]
    failed = [run.n_failed_iterations for run in runs]
    axes.barh(rows, done, color=COLOURS[0], height=0.62, label="accepted steps")
    if any(failed):
        axes.barh(rows, failed, left=done, height=0.62, label="failed attempts", **FAILED)
    for row, a, b, run in zip(rows, done, failed, runs):
        text = f" {a:.0f}" + (f" + {b:.0f}" if b else "") + ("" if run.log.state == "done" else f"  ({run.log.state})")
        axes.text(a + b, row, text, va="center", fontsize=9)
    axes.set_yticks(list(rows), labels)
    axes.set_xlim(right=1.2 * max([a + b for a, b in zip(done, failed)] + [1]))
    axes.set(title="Newton iterations in all")
    axes.grid(False, axis="y")
    if any(failed):
        _legend(axes)
    if has_loops:
        axes = all_axes[1]
        for k, (column, name) in enumerate(LOOPS.items()):
            values = [run.total(column) for run in runs]
            positions = [row + 0.22 * (1 - k) for row in rows]
            axes.barh(positions, values, height=0.2, color=colour(k + 1), label=name)
            for position, value in zip(positions, values):
                if value:
                    axes.text(value, position, f" {value:.0f}", va="center", fontsize=8)
        axes.set_yticks(list(rows), labels)
        axes.set(title="Passes of the fixed-point loops")
        axes.grid(False, axis="y")
        _legend(axes)
    return svg(figure)


def residuals(run, max_iterations=3000):
    """The equilibrium and contact residuals of all iterations; attempts that failed on red ground."""
    attempts = [attempt for attempt in run.log.attempts if attempt.residuals]
    if not attempts or sum(len(a.residuals) for a in attempts) > max_iterations:
        return None
    figure, (axes,) = axes_of(1, width=15.6, height=2.9)
    start = 0
    for i, attempt in enumerate(attempts):
        x = range(start, start + len(attempt.residuals))
        ends = [*attempt.starts[1:], len(attempt.residuals)]
        for a, b in zip(attempt.starts, ends):
            for column, shade, label in ((0, COLOURS[0], "equilibrium"), (1, "#e0a030", "contact")):
                axes.plot(x[a:b], [row[column] if row[column] > 0 else None for row in attempt.residuals[a:b]], color=shade, linewidth=0.9,
                          label=label if i == 0 and a == 0 else None)
        if attempt.failure is not None:
            axes.axvspan(start - 0.5, start + len(attempt.residuals) - 0.5, color="#b5332e", alpha=0.13, linewidth=0)
        elif i % 2:
            axes.axvspan(start - 0.5, start + len(attempt.residuals) - 0.5, color="0.96", linewidth=0)
        start += len(attempt.residuals)
    axes.set_yscale("log")
    axes.margins(x=0.005)
    axes.set(title="Residuals of all iterations; each stripe is an attempt at a load step" +
             (", red: it failed" if run.log.failed_attempts else ""), xlabel="iteration")
    _legend_above(axes)
    return svg(figure)


def phases(runs):
    """Time per phase, a bar per run."""
    if not any(run.seconds for run in runs):
        return None
    figure, (axes,) = axes_of(1, width=10, height=1.1 + 0.36 * len(runs))
    rows = list(range(len(runs)))[::-1]
    left = [0.0] * len(runs)
    for k, (column, name) in enumerate(PHASES.items()):
        values = [run.total(column) for run in runs]
        axes.barh(rows, values, left=left, height=0.6, color=colour(k), label=name)
        left = [a + b for a, b in zip(left, values)]
    axes.set_yticks(rows, [run.label for run in runs])
    axes.set(title="Wall time of rank 0 in accepted steps [s]")
    axes.grid(False, axis="y")
    axes.legend(fontsize=8, frameon=False, ncol=4, loc="upper center", bbox_to_anchor=(0.5, -0.35 if len(runs) < 3 else -0.15))
    return svg(figure)


def failed_points(table, dimension):
    """The contact points of a failed step (columns of diagnosis-NNNN.csv), in the plane in which they spread most."""
    axis_names = "xyz"[:dimension]
    spreads = {axis: max(table[axis]) - min(table[axis]) for axis in axis_names if axis in table}
    if len(spreads) < 2:
        return None
    kept = sorted(sorted(spreads, key=lambda axis: -spreads[axis])[:2])
    figure, (axes,) = axes_of(1, width=8, height=3.6)
    colours = {"unpaired": "#d5d5d5", "open": "#a5a5a5", "stick": "#2b6cb0", "slip": "#e07b39"}
    for status in dict.fromkeys(table["status"]):
        rows = [i for i, value in enumerate(table["status"]) if value == status]
        axes.plot(*([table[axis][i] for i in rows] for axis in kept), "o", markersize=4, color=colours.get(status, "#6b4c9a"),
                  label=str(status))
    cycling = [i for i, period in enumerate(table.get("period", [])) if period > 0]
    if cycling:
        axes.plot(*([table[axis][i] for i in cycling] for axis in kept), "o", markersize=10, markerfacecolor="none",
                  markeredgecolor="#b5332e", label="cycles between statuses")
    axes.set(title="Contact points of the last failed attempt", xlabel=kept[0], ylabel=kept[1])
    axes.margins(0.08)
    _legend(axes)
    return svg(figure)
