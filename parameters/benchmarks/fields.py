"""Fields of the program's VTU output as numpy arrays, with integrals over cells.

    surface = read_fields(result.directory / "contact-0001.pvtu")
    surface.points                    # (n, 3), reference positions
    surface["pressure"]               # (n,) or (n, components)
    x, p = surface.along_line("pressure")

Needs the Debian package python3-vtk9. Quadrilaterals (linear, quadratic Lagrange)
and the subdivided lines of contact surfaces.
"""
import pathlib
import sys

import numpy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
from stickslip import FieldStep

VTK_LINE = 3


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


# VTK's nodes of a quadrilateral as pairs of 1D nodes (0, 1 ends, 2 middle).
_QUADRILATERAL = [(0, 0), (1, 0), (1, 1), (0, 1), (2, 0), (1, 2), (2, 1), (0, 2), (2, 2)]


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

    # -------------------------------------------------------------- 2D cells
    def integrate(self, integrand, n_points=4):
        """
        Integral over the quadrilaterals of integrand(x, value, gradient):
        x (m, 2), and functions value(NAME) (m, ...), gradient(NAME) (m, ...,
        2) at m quadrature points.
        """
        degree = {4: 1, 9: 2}[self.cells.shape[1]]
        x1, w1 = _gauss(n_points)
        value_1d, slope_1d = _shape_1d(degree, x1)
        nodes = _QUADRILATERAL[: self.cells.shape[1]]
        values = numpy.array([numpy.outer(value_1d[i], value_1d[j]).ravel() for i, j in nodes])
        slopes = numpy.array([[numpy.outer(slope_1d[i], value_1d[j]).ravel(), numpy.outer(value_1d[i], slope_1d[j]).ravel()]
                              for i, j in nodes])
        corners = self.points[self.cells][:, :, :2]
        x = numpy.einsum("cnd,nq->cqd", corners, values)
        jacobian = numpy.einsum("cnd,neq->cqde", corners, slopes)
        weight = abs(numpy.linalg.det(jacobian)) * numpy.outer(w1, w1).ravel()
        inverse = numpy.linalg.inv(jacobian)
        merge = lambda field: field.reshape((-1,) + field.shape[2:])

        def value(name):
            return merge(numpy.einsum("cn...,nq->cq...", self[name][self.cells], values))

        def gradient(name):
            return merge(numpy.einsum("cn...,neq,cqed->cq...d", self[name][self.cells], slopes, inverse))

        return float(numpy.sum(integrand(merge(x), value, gradient) * weight.ravel()))

    # ------------------------------------------------------------- 1D cells
    def integrate_line(self, integrand, names, n_points=6):
        """Integral over line cells of integrand(x, *values of NAMES)."""
        degree = {2: 1, 3: 2}[self.cells.shape[1]]
        x1, w1 = _gauss(n_points)
        values, slopes = _shape_1d(degree, x1)
        corners = self.points[self.cells][:, :, :2]
        x = numpy.einsum("cnd,nq->cqd", corners, values)
        length = numpy.linalg.norm(numpy.einsum("cnd,nq->cqd", corners, slopes), axis=-1)
        fields = [numpy.einsum("cn,nq->cq", self[name][self.cells], values).ravel() for name in names]
        return float(numpy.sum(integrand(x.reshape(-1, 2), *fields) * (length * w1).ravel()))

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
    if kind == VTK_LINE:
        # A face of degree k is written as k lines with points of its own: one cell of degree k again.
        n_faces = len(grid.points) - len(cells)
        degree = len(cells) // n_faces
        first = numpy.arange(n_faces)[:, None] * (degree + 1)
        cells = first + numpy.array([0, degree, *range(1, degree)])
    return Fields(grid.points, cells, grid.point_data)
