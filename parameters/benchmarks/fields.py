"""Fields of the program's VTU output as numpy arrays, with integrals over cells.

    surface = read_fields(result.directory / "contact-0001.pvtu")
    surface.points                    # (n, 3), reference positions
    surface["pressure"]               # (n,) or (n, components)
    x, p = surface.along_line("pressure")

Needs the Debian package python3-vtk9. Lines, quadrilaterals, hexahedra (linear,
quadratic Lagrange) and the subdivided faces of contact surfaces.
"""
import functools
import pathlib
import sys

import numpy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
from stickslip import FieldStep

VTK_LINE, VTK_QUAD = 3, 9


def _gauss(n):
    """Points and weights on [0, 1]."""
    x, w = numpy.polynomial.legendre.leggauss(n)
    return 0.5 * (x + 1), 0.5 * w


def _shape_1d(degree, x):
    """Values and derivatives on [0, 1]; nodes 0, 1 (, 1/2), VTK's order."""
    x = numpy.asarray(x)
    if degree == 1:
        return numpy.array([1 - x, x]), numpy.array([-numpy.ones_like(x), numpy.ones_like(x)])
    values = [(1 - x) * (1 - 2 * x), x * (2 * x - 1), 4 * x * (1 - x)]
    return numpy.array(values), numpy.array([4 * x - 3, 4 * x - 1, 4 - 8 * x])


# Nodes of VTK's cells as tuples of 1D nodes (0, 1 ends, 2 middle), by number of directions.
_ENDS = [(0, 0), (1, 0), (1, 1), (0, 1)]
_SIDES = [(2, 0), (1, 2), (2, 1), (0, 2)]
_NODES = {
    1: [(0,), (1,), (2,)],
    2: _ENDS + _SIDES + [(2, 2)],
    3: [(*end, z) for z in (0, 1) for end in _ENDS]  # vertices; edges below, above, upright; faces; centre
    + [(*side, z) for z in (0, 1) for side in _SIDES] + [(*end, 2) for end in _ENDS]
    + [(0, 2, 2), (1, 2, 2), (2, 0, 2), (2, 1, 2), (2, 2, 0), (2, 2, 1), (2, 2, 2)],
}
# (Directions, degree) of a cell by its number of nodes, for lines, quadrilaterals and hexahedra.
_KINDS = {(degree + 1) ** n: (n, degree) for n in (1, 2, 3) for degree in (1, 2)}


class Fields:
    def __init__(self, points, cells, point_data):
        self.points = points
        self.cells = cells  # (number of cells, nodes per cell), in VTK's order
        self.point_data = point_data

    def __getitem__(self, name):
        if name not in self.point_data:
            raise KeyError(f"no field '{name}'; there are: {', '.join(sorted(self.point_data))}")
        return self.point_data[name]

    def select(self, keep):
        """The cells for which keep(mean position) holds."""
        means = self.points[self.cells].mean(axis=1)
        return Fields(self.points, self.cells[[bool(keep(mean)) for mean in means]], self.point_data)

    def in_body(self, index):
        return Fields(self.points, self.cells[self["body"][self.cells[:, 0]].round() == index], self.point_data)

    def integrate(self, integrand, n_points=4):
        """
        Integral over the cells (lines, quadrilaterals, hexahedra, in the plane or
        in space) of integrand(x, value, gradient): x (m, space), and functions
        value(NAME) (m, ...), gradient(NAME) (m, ..., space) at m quadrature points;
        gradients of surfaces are tangential.
        """
        directions, degree = _KINDS[self.cells.shape[1]]
        space = 3 if self.points[:, 2].any() else 2
        x1, w1 = _gauss(n_points)
        value_1d, slope_1d = _shape_1d(degree, x1)
        product = lambda factors: functools.reduce(numpy.multiply.outer, factors).ravel()
        factors = lambda node, d: [(slope_1d if e == d else value_1d)[i] for e, i in enumerate(node)]
        nodes = _NODES[directions][: self.cells.shape[1]]
        values = numpy.array([product(factors(node, None)) for node in nodes])
        slopes = numpy.array([[product(factors(node, d)) for d in range(directions)] for node in nodes])
        corners = self.points[self.cells][:, :, :space]
        x = numpy.einsum("cnd,nq->cqd", corners, values)
        jacobian = numpy.einsum("cnd,neq->cqde", corners, slopes)
        metric = numpy.einsum("cqde,cqdf->cqef", jacobian, jacobian)
        weight = numpy.sqrt(numpy.linalg.det(metric)) * product([w1] * directions)
        merge = lambda field: field.reshape((-1,) + field.shape[2:])

        def value(name):
            return merge(numpy.einsum("cn...,nq->cq...", self[name][self.cells], values))

        def gradient(name):
            return merge(numpy.einsum("cn...,neq,cqed->cq...d", self[name][self.cells], slopes, numpy.linalg.pinv(jacobian)))

        return float(numpy.sum(integrand(merge(x), value, gradient) * weight.ravel()))

    def along_line(self, name, coordinate=None):
        """Values at the vertices of line cells, sorted by x (or coordinate(points)); doubles dropped."""
        ends = self.cells[:, :2].ravel()
        where = self.points[ends, 0] if coordinate is None else coordinate(self.points[ends])
        order = numpy.argsort(where, kind="stable")
        x, v = where[order], self[name][ends][order]
        keep = numpy.concatenate([[True], numpy.diff(x) > 1e-9 * max(1e-300, abs(x).max())])
        return x[keep], v[keep]


def read_fields(path):
    grid = FieldStep(0, 0.0, pathlib.Path(path)).arrays()
    if not grid.cells:
        raise SystemExit(f"{path} has no cells.")
    if len({(kind, nodes.shape[1]) for kind, nodes in grid.cells}) > 1:
        # A mixed file has rigid or linear cells beside others: by number of nodes.
        raise SystemExit(f"{path} mixes cells of different kinds.")
    kind, cells = grid.cells[0]
    # A face of degree k is written as parts with points of its own: one cell of degree k again.
    if kind == VTK_LINE:
        n_faces = len(grid.points) - len(cells)
        degree = len(cells) // n_faces
        first = numpy.arange(n_faces)[:, None] * (degree + 1)
        cells = first + numpy.array([0, degree, *range(1, degree)])
    elif kind == VTK_QUAD and 4 * len(grid.points) == 9 * len(cells):
        first = numpy.arange(len(cells) // 4)[:, None] * 9
        cells = first + numpy.array([0, 2, 8, 6, 1, 5, 7, 3, 4])
    return Fields(grid.points, cells, grid.point_data)
