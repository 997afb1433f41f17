"""How stable a block of St Venant-Kirchhoff is in a state of the ironing test.

    python3 stability.py RESULT_DIRECTORY [YOUNG POISSON]

prints for each written step of a run without friction

- the smallest principal stretch at the integration points (the law is weaker in
  compression below 1/sqrt(3) = 0.577 than at it);
- the smallest eigenvalue of the acoustic tensors Q_ik(N) = A_iJkL N_J N_L at the
  integration points, A = d2W/dF2, N any unit vector, over the shear modulus, which it is
  without load: below zero the material itself has lost its stability (ellipticity) there,
  whatever surrounds it. With nu = 0.3 it vanishes at a stretch of 0.59 in uniaxial, 0.65 in
  plane and 0.71 in confined compression;
- the smallest eigenvalue of the second variation of the energy of the whole block
  (hexahedra of degree 1, bottom held) for displacements that keep the closed nodes on the
  cylinder. A node that is pressed with the force f slides along a cylinder of radius R,
  which adds -f / R.
"""
import pathlib
import re
import sys

import numpy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from fields import read_fields

BLOCK = 0  # index of the body
CLOSED = 2  # contact states from here on: stick, slip
RADIUS = 26.7
# VTK's order of the corners of a hexahedron on [-1, 1]^3
CORNERS = numpy.array([(-1, -1, -1), (1, -1, -1), (1, 1, -1), (-1, 1, -1), (-1, -1, 1), (1, -1, 1), (1, 1, 1), (-1, 1, 1)])
GAUSS = CORNERS / numpy.sqrt(3.0)


def shape_gradients(x):
    """dN_a/dxi_j at the point x, [a, j]."""
    factors = 1 + CORNERS * x
    return numpy.array([[CORNERS[a, j] * numpy.prod(numpy.delete(factors[a], j)) for j in range(3)] for a in range(8)]) / 8


def moduli(young, poisson):
    """Lame's modulus and shear modulus."""
    return young * poisson / ((1 + poisson) * (1 - 2 * poisson)), young / (2 * (1 + poisson))


def unit_vectors(n=400):
    """About evenly spread over a hemisphere (a Fibonacci spiral), [n, 3]."""
    height = (numpy.arange(n) + 0.5) / n
    angle = numpy.pi * (1 + numpy.sqrt(5)) * numpy.arange(n)
    radius = numpy.sqrt(1 - height**2)
    return numpy.column_stack((radius * numpy.cos(angle), radius * numpy.sin(angle), height))


def stress(F, lame, shear):
    """Second Piola-Kirchhoff stress of the law."""
    E = 0.5 * (F.T @ F - numpy.eye(3))
    return lame * numpy.trace(E) * numpy.eye(3) + 2 * shear * E


def smallest_acoustic_eigenvalue(F, lame, shear, directions=unit_vectors()):
    """The smallest eigenvalue of Q(N) over the given directions N and the principal ones of F."""
    N = numpy.vstack((directions, numpy.linalg.svd(F)[2]))
    FN = N @ F.T
    Q = numpy.einsum("nJ,JL,nL,ik->nik", N, stress(F, lame, shear), N, numpy.eye(3), optimize=True)
    Q += (lame + shear) * numpy.einsum("ni,nk->nik", FN, FN) + shear * (F @ F.T)
    return numpy.linalg.eigvalsh(Q)[:, 0].min()


def nodal_forces(G, S, F):
    """Internal nodal forces F S G_a of a point, [a, i]."""
    return G @ S @ F.T


class Block:
    """Merged nodes, displacements and closed nodes of one written step."""

    def __init__(self, solution, contact, time):
        body = read_fields(solution).in_body(BLOCK)
        surface = read_fields(contact)
        key = lambda points: [tuple(row) for row in numpy.round(points, 6)]
        numbers = {}
        self.cells = numpy.array([[numbers.setdefault(k, len(numbers)) for k in key(body.points[cell])] for cell in body.cells])
        self.points, self.displacement = numpy.zeros((len(numbers), 3)), numpy.zeros((len(numbers), 3))
        for cell, merged in zip(body.cells, self.cells):
            self.points[merged], self.displacement[merged] = body.points[cell], body["displacement"][cell]
        self.bottom = self.points[:, 2] < 1e-9
        self.closed = sorted({numbers[k] for k in key(surface.points[surface["status"] > CLOSED - 0.5])})
        self.axis = numpy.array([22.5 + max(time - 10, 0), 30 + RADIUS - 1.4 * min(time, 10)])  # x, z

    def at_points(self):
        """For each cell and integration point: nodes, gradients G_aJ, weight, F."""
        for cell in self.cells:
            for x in GAUSS:
                reference = shape_gradients(x)
                jacobian = self.points[cell].T @ reference
                gradients = reference @ numpy.linalg.inv(jacobian)
                yield cell, gradients, numpy.linalg.det(jacobian), numpy.eye(3) + self.displacement[cell].T @ gradients

    def smallest_stretch(self):
        return min(numpy.linalg.svd(F, compute_uv=False)[-1] for _, _, _, F in self.at_points())

    def smallest_acoustic_eigenvalue(self, young, poisson):
        """Over the shear modulus."""
        lame, shear = moduli(young, poisson)
        return min(smallest_acoustic_eigenvalue(F, lame, shear) for _, _, _, F in self.at_points()) / shear

    def forces_and_tangent(self, young, poisson):
        lame, shear = moduli(young, poisson)
        force = numpy.zeros_like(self.points)
        K = numpy.zeros((self.points.size, self.points.size))
        for cell, G, weight, F in self.at_points():
            S = stress(F, lame, shear)
            FG = G @ F.T  # [a, i]: (F G_a)_i
            force[cell] += weight * nodal_forces(G, S, F)
            local = numpy.einsum("ab,ij->aibj", G @ S @ G.T, numpy.eye(3))
            local += lame * numpy.einsum("ai,bj->aibj", FG, FG)
            local += shear * numpy.einsum("ab,ij->aibj", G @ G.T, F @ F.T) + shear * numpy.einsum("aj,bi->aibj", FG, FG)
            dofs = (3 * cell[:, None] + numpy.arange(3)).ravel()
            K[numpy.ix_(dofs, dofs)] += weight * local.reshape(24, 24)
        return force, K

    def smallest_eigenvalue(self, young, poisson):
        force, K = self.forces_and_tangent(young, poisson)
        directions = []  # unit vectors of the displacements that are possible
        for n in range(len(self.points)):
            if self.bottom[n]:
                continue
            frame = numpy.eye(3)
            if n in self.closed:
                radial = (self.points[n] + self.displacement[n])[[0, 2]] - self.axis
                radial /= numpy.linalg.norm(radial)
                frame = numpy.array([[-radial[1], 0, radial[0]], [0, 1, 0]])
                pressing = force[n, [0, 2]] @ radial  # of the cylinder on the block: as the internal force
                K[3 * n : 3 * n + 3, 3 * n : 3 * n + 3] -= pressing / RADIUS * numpy.outer(frame[0], frame[0])
            for direction in frame:
                directions.append(numpy.zeros(self.points.size))
                directions[-1][3 * n : 3 * n + 3] = direction
        Z = numpy.array(directions)
        return numpy.linalg.eigvalsh(Z @ K @ Z.T)[0]


def history(directory, young=1.0, poisson=0.3, stride=1):
    """[(time, smallest stretch, smallest acoustic eigenvalue, smallest eigenvalue)] of the written steps."""
    directory = pathlib.Path(directory)
    entries = {name: dict(re.findall(r'timestep="([^"]+)".*?file="([^"]+)"', (directory / f"{name}.pvd").read_text()))
               for name in ("solution", "contact")}
    rows = []
    times = list(entries["solution"])
    for time in sorted(set(times[::-stride]), key=float):
        block = Block(str(directory / entries["solution"][time]), str(directory / entries["contact"][time]), float(time))
        rows.append((float(time), block.smallest_stretch(), block.smallest_acoustic_eigenvalue(young, poisson),
                     block.smallest_eigenvalue(young, poisson)))
    return rows


if __name__ == "__main__":
    for row in history(sys.argv[1], *(float(v) for v in sys.argv[2:])):
        print("t = %8.5f   smallest stretch %.4f   acoustic tensor %8.4f   smallest eigenvalue %.3e" % row)
