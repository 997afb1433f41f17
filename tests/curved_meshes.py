#!/usr/bin/env python3
"""Bodies from meshes of the second order have to be as curved as their files say, in all formats, on any number of
ranks, and after refinements; a tube has to converge to Lame's closed form with order 3, and with order 2 if its
meshes are straightened.

usage: curved_meshes.py PROGRAM MPIEXEC N_RANKS [--verbose]
"""

import json
import math
import os
import re
import subprocess
import sys
import tempfile

import sector_meshes as meshes

INNER, OUTER, HEIGHT = 1., 2., 0.5
YOUNG, POISSON, PRESSURE = 1000., 0.3, 10.
CASE = """set Dimension = %(dim)d
set Degree = %(degree)d
subsection Bodies
  subsection ring
    set Mesh file = %(file)s
    set Material = steel
    %(body)s
  end
end
subsection Materials
  subsection steel
    set Law = linear elastic
    set Young's modulus = 1000
    set Poisson's ratio = 0.3
  end
end
subsection Boundary conditions
%(symmetries)s  subsection pressure
    set Body = ring
    set Boundary = %(inner)s
    set Type = pressure
    set Value = 10*t
  end
end
%(rest)s
subsection Output
  set Verbosity = results
  set Directory = results
  subsection Points
%(points)s  end
end
"""
SYMMETRY = """  subsection plane %s
    set Body = ring
    set Boundary = %s
    set Type = symmetry
  end
"""
POINT = """    subsection p%d
      set Body = ring
      set Position = %s
    end
"""


def lame(r):
    """The radial displacement of a long tube under inner pressure."""
    A = PRESSURE * INNER**2 / (OUTER**2 - INNER**2)
    return (1 + POISSON) / YOUNG * ((1 - 2 * POISSON) * A * r + A * OUTER**2 / r)


def is_3d(kind):
    return kind in ("HEX20", "HEX27", "TET10")


def mesh(kind, n_radial, n_angular, straight=False):
    return meshes.sector(kind, (INNER, OUTER), n_radial, n_angular, HEIGHT if is_3d(kind) else None, 1, straight)


def case(kind, file, points, degree=2, body="", rest="", numbers=False):
    """Boundaries by their names in a Gmsh file with the body "ring", or by their numbers."""
    names = list(meshes.BOUNDARIES.items())[2:6 if is_3d(kind) else 4]
    name = (lambda number, text: str(number)) if numbers else (lambda number, text: "ring " + text)
    return CASE % dict(dim=3 if is_3d(kind) else 2, degree=degree, file=file, body=body, rest=rest, inner=name(1, "inner"),
                       symmetries="".join(SYMMETRY % (text, name(number, text)) for number, text in names),
                       points="".join(POINT % (i, ", ".join("%.16g" % x for x in p)) for i, p in enumerate(points)))


def points_in_cells(kind, n_radial, n_angular):
    """In each cell of a mesh alike, at some distance from nodes and from the sides between triangles."""
    dim, result = (3 if is_3d(kind) else 2), []
    for i in range(n_radial):
        for j in range(n_angular):
            r = INNER + (OUTER - INNER) * (i + 0.3) / n_radial
            angle = math.pi / 2 * (j + 0.2) / n_angular
            result.append((r * math.cos(angle), r * math.sin(angle), 0.37 * HEIGHT)[:dim])
    return result


class Runs:
    def __init__(self):
        self.program, self.mpiexec, self.ranks_flag = (os.path.abspath(sys.argv[1]), sys.argv[2], sys.argv[3])
        self.verbose = "--verbose" in sys.argv
        self.n_wrong = 0

    def run(self, *arguments, n_ranks=1):
        command = [self.program, *arguments]
        if n_ranks > 1:
            command = [self.mpiexec, self.ranks_flag, str(n_ranks)] + command
        return subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=120)

    def results(self, text, *arguments, n_ranks=1):
        """The results of a case by name, and all that it has printed."""
        with open("case.prm", "w") as file:
            file.write(text)
        result = self.run("case.prm", *arguments, n_ranks=n_ranks)
        if result.returncode != 0:
            self.expect(False, result.stdout)
        pairs = re.findall(r"^(\S.*?) {2,}(\S+)$", result.stdout, re.MULTILINE)
        return {name: float(value) for name, value in pairs if re.fullmatch(r"[-+.0-9e]+", value)}, result.stdout

    def expect(self, holds, text):
        if not holds or self.verbose:
            print(("" if holds else "WRONG: ") + text)
        self.n_wrong += not holds


def error(runs, kind, n_radial, n_angular, straight=False, degree=2, body="", rest="", n_ranks=1):
    """The error of the displacement at points in all cells (root mean square), over the displacement."""
    with open("ring.msh", "w") as file:
        file.write(meshes.gmsh(kind, ("ring", mesh(kind, n_radial, n_angular, straight))))
    points = points_in_cells(kind, n_radial, n_angular)
    found, _ = runs.results(case(kind, "ring.msh", points, degree, body, rest), n_ranks=n_ranks)
    square = 0.
    for i, (x, y, *_) in enumerate(points):
        r = math.hypot(x, y)
        dx, dy = (found.get("p%d_%s" % (i, c), 0.) - lame(r) * v / r for c, v in (("x", x), ("y", y)))
        square += (dx**2 + dy**2) / len(points)
    return math.sqrt(square) / lame(INNER)


def test_orders(runs):
    for kind in meshes.KINDS:
        levels = (1, 2, 4) if is_3d(kind) else (2, 4, 8)
        for straight, low, high in ((False, 2.75, 3.6), (True, 1.7, 2.3)):
            errors = [error(runs, kind, n, 2 * n, straight) for n in levels]
            orders = [math.log2(a / b) for a, b in zip(errors, errors[1:])]
            runs.expect(low < orders[-1] < high, "%s %s: errors %s, orders %s" % (
                kind, "straight" if straight else "curved", " ".join("%.2e" % e for e in errors), " ".join("%.2f" % o for o in orders)))


def main():
    runs = Runs()
    with tempfile.TemporaryDirectory() as directory:
        os.chdir(directory)
        test_orders(runs)
        os.chdir("/")
    print("%d faults." % runs.n_wrong)
    return 1 if runs.n_wrong else 0


if __name__ == "__main__":
    sys.exit(main())
