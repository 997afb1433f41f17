"""Grids of a run, and pictures of them: what scripts/render and report have VTK do."""
import os
import shutil
import sys

import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy


def run_under_a_display(program):
    """VTK of Debian draws through X only: start a virtual one if there is none."""
    if os.environ.get("DISPLAY"):
        return
    if shutil.which("xvfb-run") is None:
        sys.exit(f"{program}: no display and no xvfb-run. On Debian: apt-get install xvfb")
    os.environ.setdefault("LIBGL_ALWAYS_SOFTWARE", "1")
    os.execvp("xvfb-run", ["xvfb-run", "-a", "-s", "-screen 0 1600x1200x24", sys.executable, *sys.argv])


def warped(grid, factor):
    array = grid.GetPointData().GetArray("displacement")
    if array is None or factor == 0.:
        return grid
    points = vtk.vtkPoints()
    points.SetDataTypeToDouble()
    points.SetData(numpy_to_vtk(
        vtk_to_numpy(grid.GetPoints().GetData()).astype(float)
        + factor * vtk_to_numpy(array), deep=1))
    grid.SetPoints(points)
    return grid


def surface_of(grid, subdivisions=1):
    """Outer faces; curved cells are subdivided at their nodes."""
    surface = vtk.vtkDataSetSurfaceFilter()
    surface.SetInputData(grid)
    surface.SetNonlinearSubdivisionLevel(subdivisions)
    surface.Update()
    return surface.GetOutput()


def split_by_value(grid, name):
    """One grid per value of a point field ("body": so that touching bodies keep their own surfaces)."""
    array = grid.GetPointData().GetArray(name)
    if array is None or grid.GetNumberOfCells() == 0:
        return [grid]
    starts = vtk_to_numpy(grid.GetCells().GetOffsetsArray())
    values = np.rint(vtk_to_numpy(array))[vtk_to_numpy(grid.GetCells().GetConnectivityArray())[starts[:-1]]]
    return [part_of(grid, np.flatnonzero(values == value)) for value in np.unique(values)]


def part_of(grid, chosen):
    """The cells of these numbers, with their points and what colours them. (vtkExtractCells, which VTK's filters have for that, crashes.)"""
    starts = vtk_to_numpy(grid.GetCells().GetOffsetsArray())
    nodes = vtk_to_numpy(grid.GetCells().GetConnectivityArray())
    sizes = np.diff(starts)[chosen]
    ends = np.concatenate([[0], np.cumsum(sizes)])
    nodes = nodes[np.repeat(starts[:-1][chosen] - ends[:-1], sizes) + np.arange(ends[-1])]
    used, nodes = np.unique(nodes, return_inverse=True)
    # newer VTK keeps one number where all cells are of a kind
    kinds = grid.GetCellTypesArray()
    kinds = vtk_to_numpy(kinds)[chosen] if kinds is not None else np.full(len(chosen), grid.GetCellType(0))
    cells = vtk.vtkCellArray()
    cells.SetData(numpy_to_vtkIdTypeArray(ends.astype(np.int64), deep=1), numpy_to_vtkIdTypeArray(nodes.astype(np.int64), deep=1))
    points = vtk.vtkPoints()
    points.SetData(numpy_to_vtk(vtk_to_numpy(grid.GetPoints().GetData())[used], deep=1))
    part = vtk.vtkUnstructuredGrid()
    part.SetPoints(points)
    part.SetCells(numpy_to_vtk(kinds.astype(np.uint8), deep=1, array_type=vtk.VTK_UNSIGNED_CHAR), cells)
    for i in range(grid.GetPointData().GetNumberOfArrays()):
        old = grid.GetPointData().GetArray(i)
        new = numpy_to_vtk(vtk_to_numpy(old)[used], deep=1)
        new.SetName(old.GetName())
        part.GetPointData().AddArray(new)
    if grid.GetPointData().GetScalars() is not None:
        part.GetPointData().SetActiveScalars(grid.GetPointData().GetScalars().GetName())
    return part


def add_scalar(data, field, component):
    """The field as point scalars "colour": a scalar, a component or the norm."""
    array = data.GetPointData().GetArray(field)
    if array is None:
        known = [data.GetPointData().GetArrayName(i)
                 for i in range(data.GetPointData().GetNumberOfArrays())]
        sys.exit(f"There is no field '{field}' in the results. There are: {', '.join(sorted(known))}.")
    values = vtk_to_numpy(array).astype(float)
    if values.ndim > 1:
        values = (np.linalg.norm(values, axis=1) if component is None
                  else values[:, component])
    scalars = numpy_to_vtk(values, deep=1)
    scalars.SetName("colour")
    data.GetPointData().SetScalars(scalars)
    return values


def colour_range(values):
    low, high = float(np.min(values)), float(np.max(values))
    if low >= 0.:
        low = 0.
    return (low, high) if high > low else (low, low + 1.)


def lookup_table(colour_map, value_range, n=256):
    table = vtk.vtkLookupTable()
    table.SetNumberOfTableValues(n)
    table.SetRange(*value_range)
    for i in range(n):
        table.SetTableValue(i, *colour_map((i + 0.5) / n))
    table.Build()
    return table


def surface_actor(surface, table, is_flat):
    mapper = vtk.vtkPolyDataMapper()
    if not is_flat:
        normals = vtk.vtkPolyDataNormals()
        normals.SetInputData(surface)
        normals.SetFeatureAngle(35)
        normals.Update()
        surface = normals.GetOutput()
    mapper.SetInputData(surface)
    mapper.SetLookupTable(table)
    mapper.SetUseLookupTableScalarRange(True)
    mapper.InterpolateScalarsBeforeMappingOn()
    mapper.SetResolveCoincidentTopologyToPolygonOffset()
    mapper.SetRelativeCoincidentTopologyPolygonOffsetParameters(2, 8)
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    prop = actor.GetProperty()
    prop.SetAmbient(1. if is_flat else 0.6)
    prop.SetDiffuse(0. if is_flat else 0.45)
    prop.SetSpecular(0. if is_flat else 0.06)
    return actor


def line_actor(data, colour, width, opacity=1.):
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(data)
    mapper.ScalarVisibilityOff()
    mapper.SetResolveCoincidentTopologyToPolygonOffset()
    mapper.SetRelativeCoincidentTopologyLineOffsetParameters(-4, -8)
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    prop = actor.GetProperty()
    prop.SetColor(*colour)
    prop.SetLineWidth(width)
    prop.SetOpacity(opacity)
    prop.LightingOff()
    return actor


def cell_edges(grid):
    """Element edges through all nodes; those inside a body are hidden anyway."""
    edges = vtk.vtkExtractEdges()
    edges.SetInputData(grid)
    edges.Update()
    return edges.GetOutput()


def outline_edges(surface):
    clean = vtk.vtkCleanPolyData()
    clean.SetInputData(surface)
    clean.SetTolerance(1e-7)
    edges = vtk.vtkFeatureEdges()
    edges.SetInputConnection(clean.GetOutputPort())
    edges.BoundaryEdgesOn()
    edges.FeatureEdgesOn()
    edges.SetFeatureAngle(40)
    edges.NonManifoldEdgesOff()
    edges.ManifoldEdgesOff()
    edges.ColoringOff()
    edges.Update()
    return without_level_borders(edges.GetOutput())


def without_level_borders(lines):
    """Without edges that seem to have cells on one side only: a coarse one, and the two of finer cells that cover it."""
    pairs = vtk_to_numpy(lines.GetLines().GetData()).reshape(-1, 3)[:, 1:]
    if len(pairs) == 0:
        return lines
    points = vtk_to_numpy(lines.GetPoints().GetData())
    known = {frozenset(pair) for pair in pairs.tolist()}
    locator = vtk.vtkPointLocator()
    locator.SetDataSet(lines)
    locator.BuildLocator()
    covered = set()
    for a, b in pairs.tolist():
        middle = 0.5 * (points[a] + points[b])
        m = locator.FindClosestPoint(middle)
        halves = {frozenset((a, m)), frozenset((m, b))}
        is_there = np.linalg.norm(points[m] - middle) < 1e-3 * np.linalg.norm(points[b] - points[a])
        if is_there and halves <= known:
            covered |= halves | {frozenset((a, b))}
    rest = vtk.vtkCellArray()
    for pair in pairs.tolist():
        if frozenset(pair) not in covered:
            rest.InsertNextCell(2, pair)
    result = vtk.vtkPolyData()
    result.SetPoints(lines.GetPoints())
    result.SetLines(rest)
    return result


def picture_of(actors, size, direction, up, bounds=None):
    """
    Renders the actors, seen from `direction`, so that `bounds` (VTK's six
    numbers; without them what is seen) fill the picture. Returns an RGB array
    and the length that a pixel stands for.
    """
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    for actor in actors:
        renderer.AddActor(actor)
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    window.SetSize(*size)
    window.AddRenderer(renderer)

    bounds = np.array(bounds if bounds is not None else renderer.ComputeVisiblePropBounds()).reshape(3, 2)
    centre = bounds.mean(axis=1)
    radius = 0.5 * np.linalg.norm(bounds[:, 1] - bounds[:, 0])
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetFocalPoint(*centre)
    camera.SetPosition(*(centre + 4. * radius * np.asarray(direction)))
    camera.SetViewUp(*up)

    # Fill the picture: project the corners of the box onto the view plane.
    d = np.asarray(direction) / np.linalg.norm(direction)
    right = np.cross(up, d)
    right /= np.linalg.norm(right)
    upward = np.cross(d, right)
    corners = np.array([[bounds[0][i], bounds[1][j], bounds[2][k]]
                        for i in (0, 1) for j in (0, 1) for k in (0, 1)]) - centre
    width, height = np.ptp(corners @ right), np.ptp(corners @ upward)
    scale = 0.5 * max(height, width * size[1] / size[0]) * 1.06
    camera.SetParallelScale(scale)
    renderer.ResetCameraClippingRange()
    window.Render()

    to_image = vtk.vtkWindowToImageFilter()
    to_image.SetInput(window)
    to_image.ReadFrontBufferOff()
    to_image.Update()
    pixels = vtk_to_numpy(to_image.GetOutput().GetPointData().GetScalars()).copy()
    window.Finalize()
    return pixels.reshape(size[1], size[0], -1)[::-1, :, :3], 2. * scale / size[1]
