"""Pictures of the steps of a run: deformed bodies beside their contact surfaces.

    pictures = RunPictures(run, PictureOptions(), steps)
    figure = pictures.draw(step)            # a matplotlib figure

Colours, axes and views are the same for all `steps`, so that the pictures of a
run can be compared and played one after the other.
"""
import dataclasses

import matplotlib

matplotlib.use("Agg")
import numpy as np
from matplotlib import pyplot as plt
from matplotlib.collections import LineCollection
from matplotlib.colors import ListedColormap, Normalize
from matplotlib.figure import Figure
from matplotlib.patches import Patch
from vtk.util.numpy_support import vtk_to_numpy

from contact_curves import contact_curves
from stickslip import ResultsError
from vtk_pictures import (add_scalar, cell_edges, colour_range, line_actor, lookup_table, outline_edges, picture_of,
                          split_by_value, surface_actor, surface_of, warped)

STATES = [("no partner", "#e8e8e8"), ("open", "#bdbdbd"), ("stick", "#2b6cb0"), ("slip", "#e07b39"), ("closed", "#2f7d4f"),
          ("tied", "#6b4c9a")]
STATE_COLOURS = [colour for _, colour in STATES]
PAIR_COLOURS = ["#b5332e", "#2f7d4f", "#6b4c9a", "#8a6d1d"]
# The ends of "turbo" are too dark for edges to be seen.
BODY_COLOURS = ListedColormap(plt.get_cmap("turbo")(np.linspace(0.08, 0.94, 256)))
PRESSURE_COLOURS = ListedColormap(plt.get_cmap("inferno_r")(np.linspace(0., 0.9, 256)))
FIELD_TITLES = {"von_mises_stress": "von Mises stress", "displacement": "displacement", "cauchy_stress_zz": "out-of-plane stress"}
MAX_PANELS = 4  # contact curves or surfaces in one picture


@dataclasses.dataclass
class PictureOptions:
    field: str = "von_mises_stress"  # colours of the bodies
    component: int = None  # of a vector or tensor; None: the norm
    warp: float = 1.0  # factor on the displacements
    is_deformed: bool = None  # the grids are deformed already; None: find out
    view: tuple = (-60.0, 28.0)  # azimuth, elevation in 3D
    dpi: int = 100  # of a picture of 16 x 8


def number(value):
    return f"{value:.4g}"


class RunPictures:
    def __init__(self, run, options, steps):
        if not steps:
            raise ResultsError(f"'{run.directory}' has no fields (solution.pvd or solution.xdmf).")
        self.run, self.options, self.steps = run, options, steps
        self.factor = 0.0 if self._is_deformed() else options.warp
        self._look_at_all_steps()

    # ---------------------------------------------------- what all steps share
    def _is_deformed(self):
        if self.options.is_deformed is not None:
            return self.options.is_deformed
        if self.run.parameters:
            return self.run.parameters.get("Output/Deformed", "false") == "true"
        first, last = self.run.bodies.steps[0], self.run.bodies.steps[-1]
        if first is last:
            return False
        a, b = (vtk_to_numpy(step.vtk().GetPoints().GetData()) for step in (first, last))
        return a.shape != b.shape or bool((a != b).any())

    def _grids(self, step):
        """Deformed bodies, deformed contact surfaces (None without any)."""
        contact_step = self.run.contact.at_step(step.number)
        contact = contact_step.vtk() if contact_step else None
        if contact is not None and contact.GetNumberOfCells() == 0:
            contact = None
        return step.vtk(), contact

    def _look_at_all_steps(self):
        """Ranges, bounds, views and curves: one pass over the steps."""
        low, high, clipped, bounds = np.inf, -np.inf, 0.0, np.tile([np.inf, -np.inf], (3, 1))
        pressures, weight, normals = {}, None, {}
        for step in self.steps:
            bodies, contact = self._grids(step)
            if contact is not None:
                pressure = vtk_to_numpy(contact.GetPointData().GetArray("pressure")).astype(float)
                pairs = self._pairs_of(contact)
                for pair in np.unique(pairs):
                    of_pair = pressure[pairs == pair]
                    a, b = pressures.get(pair, (0.0, 0.0))
                    pressures[pair] = (min(a, of_pair.min()), max(b, of_pair.max()))
                    normals[pair] = normals.get(pair, 0.0) + self._loaded_normal(contact, pressure, pairs == pair)
                if weight is None:
                    weight, self.first_contact = np.zeros(len(pressure)), contact
                if len(weight) == len(pressure):
                    weight += np.maximum(pressure, 0.0)
            bodies = warped(bodies, self.factor)
            values = add_scalar(bodies, self.options.field, self.options.component)
            low, high = min(low, values.min()), max(high, values.max())
            clipped = max(clipped, np.quantile(values, 0.995))
            box = np.array(bodies.GetBounds()).reshape(3, 2)
            bounds = np.column_stack([np.minimum(bounds[:, 0], box[:, 0]), np.maximum(bounds[:, 1], box[:, 1])])
        self.bounds = bounds
        self.is_flat = bounds[2, 1] - bounds[2, 0] == 0.0
        # a corner where stresses are singular would leave the rest in one colour
        self.is_clipped = high > 1.5 * clipped > 0
        self.largest = high
        self.value_range = colour_range(np.array([low, clipped if self.is_clipped else high]))
        self.pressure_ranges = {pair: colour_range(np.array(limits)) for pair, limits in pressures.items()}
        self.normals = normals
        self.curves = []
        self.shown_pairs = []
        if weight is None:
            return
        by_pressure = sorted(pressures, key=lambda pair: -pressures[pair][1])
        if self.is_flat:
            # reference positions: the first grid has not been warped
            curves = contact_curves(self.first_contact, weight)
            order = {pair: i for i, pair in enumerate(by_pressure)}
            chosen = sorted(curves, key=lambda curve: order[curve.pair])[:MAX_PANELS]
            self.curves = [curve for curve in curves if curve in chosen]
            self.shown_pairs = sorted({curve.pair for curve in self.curves})
            self._find_abscissae()
        else:
            self.shown_pairs = sorted(by_pressure[: MAX_PANELS - 1])

    @staticmethod
    def _pairs_of(contact):
        array = contact.GetPointData().GetArray("pair")
        return np.rint(vtk_to_numpy(array)).astype(int) if array is not None else np.zeros(contact.GetNumberOfPoints(), int)

    @staticmethod
    def _loaded_normal(contact, pressure, chosen):
        """Sum of the normals, those under pressure above all."""
        array = contact.GetPointData().GetArray("normal")
        if array is None:
            return np.zeros(3)
        weights = np.maximum(pressure[chosen], 0.0)
        weights = weights / weights.max() if weights.max() > 0 else np.full(chosen.sum(), 1e-6)
        return -(weights[:, None] * vtk_to_numpy(array)[chosen]).sum(axis=0)

    def _find_abscissae(self):
        limits = [(np.inf, -np.inf)] * len(self.curves)
        for step in self.steps:
            contact = self._grids(step)[1]
            if contact is None:
                continue
            positions = self._current_positions(contact)
            for i, curve in enumerate(self.curves):
                s = curve.abscissa(positions)
                limits[i] = (min(limits[i][0], s.min()), max(limits[i][1], s.max()))
        self.abscissa_limits = limits

    def _current_positions(self, contact):
        displacement = vtk_to_numpy(contact.GetPointData().GetArray("displacement"))
        return vtk_to_numpy(contact.GetPoints().GetData()).astype(float) + self.factor * displacement

    @staticmethod
    def share_colours(all_pictures):
        """The same colours for the same values in the pictures of several runs."""
        low = min(pictures.value_range[0] for pictures in all_pictures)
        high = max(pictures.value_range[1] for pictures in all_pictures)
        for pictures in all_pictures:
            pictures.value_range = (low, high)
            pictures.is_clipped = pictures.largest > 1.001 * high
            for pair in pictures.pressure_ranges:
                same = [other.pressure_ranges[pair] for other in all_pictures
                        if pair in other.pressure_ranges and other.pair_name(pair) == pictures.pair_name(pair)]
                pictures.pressure_ranges[pair] = (min(a for a, _ in same), max(b for _, b in same))

    def pair_name(self, pair):
        names = self.run.pairs
        return names[pair] if pair < len(names) else f"pair {pair}"

    # -------------------------------------------------------------- one picture
    def draw(self, step, title=None):
        bodies, contact = self._grids(step)
        with plt.rc_context({"font.size": 13, "axes.titlesize": 14, "font.family": "DejaVu Sans"}):
            figure = Figure(figsize=(16, 8), dpi=self.options.dpi, facecolor="white")
            title = self.run.title or self.run.label if title is None else title
            figure.text(0.015, 0.965, title, fontsize=17, va="center", ha="left")
            figure.text(0.985, 0.965, f"t = {number(step.time)}    step {step.number}", fontsize=17, va="center", ha="right",
                        family="DejaVu Sans Mono")
            has_contact = contact is not None and bool(self.shown_pairs)
            self._draw_bodies(figure, step, bodies, contact, 0.56 if has_contact else 0.92)
            if has_contact:
                (self._draw_curves if self.is_flat else self._draw_surfaces)(figure, contact)
        return figure

    def _pixels(self, box):
        """Of VTK's picture in a box of the figure; twice as many where there is time for it."""
        scale = self.options.dpi / 100 * (2 if self.options.dpi >= 100 else 1)
        return int(1600 * box[2] * scale), int(800 * box[3] * scale)

    def _edge_opacity(self, opacity):
        """A line is at least a pixel wide: in small pictures it is paler instead."""
        return opacity * min(1.0, self.options.dpi / 130)

    def _tools(self, step, size):
        """Lines of the tools that have no mesh."""
        drawn = self.run.tools.at_step(step.number)
        if drawn is None or drawn.vtk().GetNumberOfCells() == 0:
            return []
        tools = warped(drawn.vtk(), self.factor)
        if self.is_flat:
            return [line_actor(surface_of(tools), (0.25, 0.25, 0.25), 5. * size[1] / 1300)]
        return [line_actor(cell_edges(tools), (0.25, 0.25, 0.25), 1., self._edge_opacity(0.5))]

    def _draw_bodies(self, figure, step, grid, contact, width):
        box = [0.015, 0.05, width - 0.07, 0.83]
        axes = figure.add_axes(box)
        axes.axis("off")
        size = self._pixels(box)
        table = lookup_table(BODY_COLOURS, self.value_range)
        actors = []
        for part in split_by_value(warped(grid, self.factor), "body"):
            surface = surface_of(part)
            add_scalar(surface, self.options.field, self.options.component)
            actors += [surface_actor(surface, table, self.is_flat), line_actor(cell_edges(part), (0.1, 0.1, 0.1), 1., self._edge_opacity(0.35)),
                       line_actor(outline_edges(surface), (0.05, 0.05, 0.05), 2.5 * size[1] / 1300)]
        actors += self._tools(step, size)
        direction, up = self._body_view()
        image, pixel = picture_of(actors, size, direction, up, self.bounds.ravel())
        axes.imshow(image, interpolation="antialiased")
        name = FIELD_TITLES.get(self.options.field, self.options.field.replace("_", " "))
        if self.options.component is not None:
            name += f", component {self.options.component}"
        enlarged = f", displacements × {self.factor:g}" if self.factor not in (0.0, 1.0) else ""
        axes.set_title(f"Deformed bodies: {name}{enlarged}", loc="left")
        if self.is_flat and contact is not None:
            self._draw_states_on_bodies(axes, contact, size, pixel)
        self._draw_scale(axes, size, pixel)
        bar = figure.colorbar(plt.cm.ScalarMappable(Normalize(*self.value_range), BODY_COLOURS),
                              cax=figure.add_axes([box[0] + box[2] + 0.008, 0.22, 0.010, 0.5]),
                              extend="max" if self.is_clipped else "neither")
        if self.is_clipped:
            bar.ax.set_title(f"max\n{number(self.largest)}", fontsize=11)

    def _draw_states_on_bodies(self, axes, contact, size, pixel):
        """2D: the slave surface as a line in the colours of its state."""
        positions = self._current_positions(contact)[:, :2]
        centre = self.bounds[:2].mean(axis=1)
        pixels = (positions - centre) / pixel * [1, -1] + [size[0] / 2 - 0.5, size[1] / 2 - 0.5]
        lines = vtk_to_numpy(contact.GetCells().GetConnectivityArray()).reshape(-1, 2)
        states = np.rint(vtk_to_numpy(contact.GetPointData().GetArray("status"))).astype(int)[lines[:, 0]]
        for state in np.unique(states):
            axes.add_collection(LineCollection(pixels[lines[states == state]], colors=STATE_COLOURS[state], linewidths=4,
                                               capstyle="round", zorder=2 + state))
        for curve in self.curves:
            if curve.axis is None:  # where its arc length begins, and in which sense it grows
                first = pixels[curve.lines[0]]
                axes.annotate("", first[1], first[0], arrowprops={"arrowstyle": "-|>", "color": "black", "linewidth": 1.5}, zorder=9)
                axes.plot(*first[0], "o", color="black", markersize=5, zorder=9)

    @staticmethod
    def _draw_scale(axes, size, pixel):
        """A bar of a round length in the lower left corner."""
        largest = 0.22 * size[0] * pixel
        power = 10.0 ** np.floor(np.log10(largest))
        length = max(factor * power for factor in (1, 2, 5) if factor * power <= largest)
        y = size[1] * 1.035
        axes.plot([0, length / pixel], [y, y], color="0.2", linewidth=3, clip_on=False, solid_capstyle="butt")
        axes.text(length / pixel + 0.012 * size[0], y, f"{number(length)} (length)", va="center", fontsize=12, color="0.2")
        axes.set(xlim=(0, size[0]), ylim=(size[1], 0))

    def _body_view(self):
        if self.is_flat:
            return np.array([0., 0., 1.]), [0, 1, 0]
        azimuth, elevation = np.radians(self.options.view)
        return np.array([np.cos(azimuth) * np.cos(elevation), np.sin(azimuth) * np.cos(elevation), np.sin(elevation)]), [0, 0, 1]

    def _surface_view(self, pair):
        """Looks at the slave surface from the side that it turns to its partner."""
        mean = self.normals[pair]
        size = np.linalg.norm(mean)
        mean = mean / size if size > 1e-9 else np.array([0., 0., 1.])
        # A little from the side, so that its shape is seen.
        up = np.eye(3)[1 if int(np.argmax(np.abs(mean))) != 1 else 2]
        tilt = mean - 0.45 * up + 0.25 * np.cross(up, mean)
        return tilt / np.linalg.norm(tilt), up

    # ---------------------------------------------------------- contact surfaces
    def _legend(self, figure, x, y):
        figure.legend(handles=[Patch(facecolor=colour, edgecolor="0.3", label=name) for name, colour in STATES],
                      loc="center", ncol=len(STATES), frameon=False, bbox_to_anchor=(x, y), fontsize=12,
                      handlelength=1.4, columnspacing=0.9)

    def _note_hidden(self, figure, n_all, what):
        n_hidden = n_all - (len(self.curves) or len(self.shown_pairs))
        if n_hidden > 0:
            figure.text(0.985, 0.012, f"{n_hidden} more {what} with smaller pressures", ha="right", fontsize=11, color="0.4")

    def _draw_curves(self, figure, contact):
        """2D: per curve its pressure and, below, a strip of its states."""
        n = len(self.curves)
        pressure, status = (vtk_to_numpy(contact.GetPointData().GetArray(name)) for name in ("pressure", "status"))
        positions = self._current_positions(contact)
        height = 0.84 / n
        for i, (curve, limits) in enumerate(zip(self.curves, self.abscissa_limits)):
            bottom = 0.90 - (i + 1) * height + 0.095 * min(1.0, 2.2 / n + 0.25)
            top = 0.90 - i * height - 0.045
            strip = min(0.12 * (top - bottom), 0.045)
            upper = figure.add_axes([0.645, bottom + 1.3 * strip, 0.33, top - bottom - 1.3 * strip])
            lower = figure.add_axes([0.645, bottom, 0.33, strip], sharex=upper)
            colour = PAIR_COLOURS[curve.pair % len(PAIR_COLOURS)]
            s, p = curve.abscissa(positions), pressure[curve.lines]
            rows = np.rint(status[curve.lines[:, 0]]).astype(int)
            for x, y, state in zip(s, p, rows):
                upper.fill_between(x, 0., y, color=colour, alpha=0.25, linewidth=0.)
                lower.axvspan(x[0], x[1], color=STATE_COLOURS[state], linewidth=0.)
            upper.add_collection(LineCollection(np.stack([s, p], axis=2), colors=colour, linewidths=2.))
            margin = 0.01 * (limits[1] - limits[0]) or 1.0
            low, high = self.pressure_ranges[curve.pair]
            upper.set(xlim=(limits[0] - margin, limits[1] + margin), ylim=(low, high * 1.05 if high > 0 else 1.0))
            upper.set_title(f"Contact pressure: {self.pair_name(curve.pair)}", loc="left", fontsize=14 if n < 3 else 12, pad=4)
            upper.tick_params(labelbottom=False)
            upper.locator_params(axis="y", nbins=5 if n < 3 else 3)
            lower.set(ylim=(0, 1), yticks=[])
            lower.set_xlabel(curve.abscissa_name, fontsize=12 if n < 3 else 11, labelpad=1)
            upper.spines[["top", "right"]].set_visible(False)
            lower.spines[["top", "right", "left"]].set_visible(False)
        self._legend(figure, 0.81, 0.025)
        self._note_hidden(figure, len(contact_curves(contact, np.zeros(contact.GetNumberOfPoints()))), "contact lines")

    def _draw_surfaces(self, figure, contact):
        """3D: pressure and state of the slave surface of each pair."""
        n = len(self.shown_pairs)
        parts = {self._pairs_of(part)[0]: part for part in split_by_value(warped(contact, self.factor), "pair")
                 if part.GetNumberOfCells() > 0}
        for i, pair in enumerate(self.shown_pairs):
            if n == 1:
                boxes = [[0.60, 0.50, 0.33, 0.38], [0.60, 0.06, 0.33, 0.38]]
            else:
                height = 0.83 / n
                bottom = 0.89 - (i + 1) * height
                boxes = [[0.575, bottom + 0.01, 0.175, height - 0.06], [0.80, bottom + 0.01, 0.175, height - 0.06]]
            if pair in parts:
                name = self.pair_name(pair)
                self._draw_surface(figure, parts[pair], pair, boxes[0], "pressure", f"Contact pressure: {name}", n)
                self._draw_surface(figure, parts[pair], pair, boxes[1], "status", "Contact state", n)
        self._legend(figure, 0.77, 0.03)
        self._note_hidden(figure, len(self.pressure_ranges), "pairs")

    def _draw_surface(self, figure, part, pair, box, field, title, n):
        axes = figure.add_axes(box)
        axes.axis("off")
        size = self._pixels(box)
        surface = surface_of(part, subdivisions=3)
        add_scalar(surface, field, None)
        if field == "status":
            table = lookup_table(ListedColormap(STATE_COLOURS), (-0.5, len(STATES) - 0.5), len(STATES))
        else:
            table = lookup_table(PRESSURE_COLOURS, self.pressure_ranges[pair])
        direction, up = self._surface_view(pair)
        actors = [surface_actor(surface, table, True), line_actor(cell_edges(part), (0.2, 0.2, 0.2), 1., self._edge_opacity(0.5)),
                  line_actor(outline_edges(surface), (0.05, 0.05, 0.05), 2. if self.options.dpi >= 100 else 1.)]
        # Edges are chords between nodes: lift them over the finer curved surface.
        for lines in actors[1:]:
            lines.AddPosition(*(0.02 * surface.GetLength() * direction))
        axes.imshow(picture_of(actors, size, direction, up)[0], interpolation="antialiased")
        axes.set_title(title, loc="left", fontsize=14 if n == 1 else 12)
        if field == "pressure":
            bar = figure.colorbar(plt.cm.ScalarMappable(Normalize(*self.pressure_ranges[pair]), PRESSURE_COLOURS),
                                  cax=figure.add_axes([box[0] + box[2] + 0.004, box[1] + 0.04, 0.008, box[3] - 0.08]))
            bar.ax.tick_params(labelsize=11)
            bar.locator = matplotlib.ticker.MaxNLocator(5)
            bar.update_ticks()
