#!/usr/bin/python3
"""The tube, cut open, with the rollers inside and the sheet near the bore; colours: von Mises stress.

    picture.py RESULT_DIRECTORY OUTPUT.png [STEP]
"""
import pathlib
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / "scripts"))
from vtk_pictures import run_under_a_display

run_under_a_display("picture.py")
import numpy as np
import vtk
from matplotlib import colormaps, colors, pyplot
from vtk_pictures import add_scalar, cell_edges, colour_range, line_actor, lookup_table, part_of, picture_of, split_by_value, surface_actor, surface_of, warped
from stickslip import Results

TUBE, SHEET = 0, 1  # bodies, in the order of the .prm
NEAR = 22.0  # radius up to which the sheet is drawn


def cells_where(grid, keep):
    """The cells of a grid at whose centre keep(x, y, z) holds."""
    centres = vtk.vtkCellCenters()
    centres.SetInputData(grid)
    centres.Update()
    points = centres.GetOutput()
    return part_of(grid, np.array([i for i in range(points.GetNumberOfPoints()) if keep(*points.GetPoint(i))], dtype=int))


def turned(grid, degrees):
    """A copy, turned about the axis of the tube."""
    transform = vtk.vtkTransform()
    transform.RotateZ(degrees)
    turn = vtk.vtkTransformFilter()
    turn.SetInputData(grid)
    turn.SetTransform(transform)
    turn.Update()
    return turn.GetOutput()


def shown(x, y, z):
    return y > 0 and x * x + y * y < NEAR * NEAR


directory, output = sys.argv[1:3]
steps = Results(directory).bodies
step = steps.at_step(int(sys.argv[3])) if len(sys.argv) > 3 else steps.steps[-1]
grid = step.vtk()
add_scalar(grid, "von_mises_stress", None)
bodies = split_by_value(warped(grid, 1.0), "body")
is_sector = len(bodies) == 3  # one roller
pieces = [(i, turned(body, angle)) for angle in ((0, 120, 240) if is_sector else (0,)) for i, body in enumerate(bodies)]
pieces = [(i, part if i > SHEET else cells_where(part, shown)) for i, part in pieces]
pieces = [(i, part) for i, part in pieces if part.GetNumberOfCells() > 0]
parts = [part for _, part in pieces]
surfaces = [surface_of(part, subdivisions=3) for part in parts]
stresses = [surface.GetPointData().GetArray("colour") for surface, (i, _) in zip(surfaces, pieces) if i <= SHEET]
limits = colour_range(np.concatenate([[array.GetValue(i) for i in range(array.GetNumberOfTuples())] for array in stresses]))
table = lookup_table(colormaps["turbo"], limits)
actors = [actor for surface, part in zip(surfaces, parts)
          for actor in (surface_actor(surface, table, False), line_actor(cell_edges(part), (0.1, 0.1, 0.1), 1.0, 0.3))]
image, _ = picture_of(actors, (1000, 1100), (0.25, -1.0, 0.35), (0.0, 0.0, 1.0))

figure, axes = pyplot.subplots(figsize=(6.5, 6.5), constrained_layout=True)
axes.imshow(image)
axes.axis("off")
axes.set_title(f"t = {step.time:g} s: von Mises stress [MPa]", fontsize=10)
figure.colorbar(pyplot.cm.ScalarMappable(colors.Normalize(*limits), "turbo"), ax=axes, shrink=0.6)
figure.savefig(output, dpi=120, facecolor="white")
