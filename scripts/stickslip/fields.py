"""Fields of a run: the steps that were written, each as a grid of VTK, meshio or pyvista.

    step = Results("results").bodies.steps[-1]
    step.vtk()          # vtkUnstructuredGrid
    step.pyvista()      # pyvista.UnstructuredGrid
    step.meshio()       # meshio.Mesh
    step.arrays()       # points, cells and point data as numpy arrays

Needs VTK's Python modules (Debian: python3-vtk9), for HDF5 output also h5py.
"""
from __future__ import annotations

import dataclasses
import pathlib
import re
import typing

import numpy as np

from .errors import ResultsError

# Numbers of VTK's cells: in XDMF files, and what meshio calls them.
XDMF_CELLS = {"Polyline": 3, "Triangle": 5, "Quadrilateral": 9, "Tetrahedron": 10, "Hexahedron": 12}
MESHIO_CELLS = {3: "line", 5: "triangle", 9: "quad", 10: "tetra", 12: "hexahedron", 68: "VTK_LAGRANGE_CURVE", 70: "VTK_LAGRANGE_QUADRILATERAL",
                72: "VTK_LAGRANGE_HEXAHEDRON"}


def _imported(name: str, package: str) -> typing.Any:
    import importlib

    try:
        return importlib.import_module(name)
    except ImportError as error:
        raise ResultsError(f"Reading these fields needs {name.split('.')[0]} ({package}): {error}.") from error


def _numpy_support() -> typing.Any:
    return _imported("vtkmodules.util.numpy_support", "on Debian: apt-get install python3-vtk9, and use /usr/bin/python3")


@dataclasses.dataclass
class GridArrays:
    """A grid as numpy arrays."""

    points: np.ndarray  # (n, 3)
    cells: list[tuple[int, np.ndarray]]  # (number of VTK's cell type, (m, nodes per cell)) of neighbouring cells of one kind
    point_data: dict[str, np.ndarray]  # (n,) or (n, components)


@dataclasses.dataclass
class FieldStep:
    """The fields of one accepted step: a .pvtu, or a .h5 with the kind of its cells (an XDMF topology)."""

    number: int
    time: float
    path: pathlib.Path
    topology: str | None = None

    def vtk(self) -> typing.Any:
        """A vtkUnstructuredGrid, the pieces of all ranks together."""
        if self.topology is not None:
            return self._from_hdf5(XDMF_CELLS[self.topology])
        _numpy_support()
        from vtkmodules.vtkIOXML import vtkXMLPUnstructuredGridReader

        reader = vtkXMLPUnstructuredGridReader()
        reader.SetFileName(str(self.path))
        reader.Update()
        return reader.GetOutput()

    def _from_hdf5(self, cell_type: int) -> typing.Any:
        support = _numpy_support()
        h5py = _imported("h5py", "on Debian: apt-get install python3-h5py, and use /usr/bin/python3")
        from vtkmodules.vtkCommonCore import vtkPoints
        from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkUnstructuredGrid

        grid = vtkUnstructuredGrid()
        with h5py.File(self.path) as file:
            nodes = np.zeros((len(file["nodes"]), 3))
            nodes[:, : file["nodes"].shape[1]] = file["nodes"]
            points = vtkPoints()
            points.SetDataTypeToDouble()
            points.SetData(support.numpy_to_vtk(nodes, deep=1))
            grid.SetPoints(points)
            connectivity = np.asarray(file["cells"], dtype=np.int64)
            cells = vtkCellArray()
            cells.SetData(connectivity.shape[1], support.numpy_to_vtkIdTypeArray(connectivity.ravel(), deep=1))
            grid.SetCells(cell_type, cells)
            for name, data in file.items():
                if name not in ("nodes", "cells"):
                    values = np.asarray(data, dtype=float)
                    array = support.numpy_to_vtk(values[:, 0] if values.shape[1] == 1 else values, deep=1)
                    array.SetName(name)
                    grid.GetPointData().AddArray(array)
        return grid

    def arrays(self) -> GridArrays:
        to_numpy = _numpy_support().vtk_to_numpy
        grid = self.vtk()
        data = grid.GetPointData()
        point_data = {data.GetArrayName(i): to_numpy(data.GetArray(i)).astype(float) for i in range(data.GetNumberOfArrays())}
        if grid.GetNumberOfCells() == 0:
            return GridArrays(np.zeros((0, 3)), [], point_data)
        starts = to_numpy(grid.GetCells().GetOffsetsArray())
        nodes = to_numpy(grid.GetCells().GetConnectivityArray())
        # newer VTK keeps one number where all cells are of a kind
        types = grid.GetCellTypesArray()
        types = to_numpy(types) if types is not None else np.full(len(starts) - 1, grid.GetCellType(0))
        kinds = np.column_stack([types, np.diff(starts)])
        ends = [*(np.flatnonzero((kinds[1:] != kinds[:-1]).any(axis=1)) + 1), len(kinds)]
        cells, begin = [], 0
        for end in ends:
            cells.append((int(kinds[begin, 0]), nodes[starts[begin]: starts[end]].reshape(end - begin, -1)))
            begin = end
        return GridArrays(to_numpy(grid.GetPoints().GetData()).astype(float), cells, point_data)

    def pyvista(self) -> typing.Any:
        """A pyvista.UnstructuredGrid."""
        return _imported("pyvista", "pip install pyvista").wrap(self.vtk())

    def meshio(self) -> typing.Any:
        """A meshio.Mesh; curved cells are Lagrange cells in VTK's order."""
        meshio = _imported("meshio", "pip install meshio")
        arrays = self.arrays()
        return meshio.Mesh(arrays.points, [(MESHIO_CELLS[kind], nodes) for kind, nodes in arrays.cells], arrays.point_data)


class FieldSeries:
    """The steps that NAME.pvd or NAME.xdmf lists; files of earlier runs are not among them."""

    def __init__(self, directory: pathlib.Path, name: str):
        self.steps: list[FieldStep] = []
        for index, reader in ((directory / f"{name}.pvd", self._read_pvd), (directory / f"{name}.xdmf", self._read_xdmf)):
            if index.exists():
                reader(directory, index.read_text(errors="replace"))
                break

    def _add(self, directory: pathlib.Path, time: str, file: str, topology: str | None = None) -> None:
        path = directory / file
        number = re.search(r"-(\d+)\.", file)
        if path.exists() and number:
            self.steps.append(FieldStep(int(number[1]), float(time), path, topology))

    def _read_pvd(self, directory: pathlib.Path, text: str) -> None:
        for time, file in re.findall(r'timestep="([^"]+)".*?file="([^"]+)"', text):
            self._add(directory, time, file)

    def _read_xdmf(self, directory: pathlib.Path, text: str) -> None:
        pattern = r'<Time Value="([^"]+)".*?TopologyType="([^"]+)".*?(\S+\.h5):/cells'
        for time, topology, file in re.findall(pattern, text, re.DOTALL):
            self._add(directory, time, file, topology)

    def at_step(self, number: int) -> FieldStep | None:
        """The step of this number, or None."""
        return next((step for step in self.steps if step.number == number), None)
