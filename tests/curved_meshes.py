#!/usr/bin/env python3
"""Bodies from meshes of the second order have to be as curved as their files say, in all formats, on any number of
ranks, and after refinements; a tube has to converge to Lame's closed form with order 3, and with order 2 if its
meshes are straightened.

usage: curved_meshes.py PROGRAM MPIEXEC TEST [--verbose]
TEST: orders_2d, orders_3d, volumes_2d, volumes_3d, formats_2d, formats_3d, restart, adaptation
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
        self.program, self.mpiexec = os.path.abspath(sys.argv[1]), sys.argv[2]
        self.verbose = "--verbose" in sys.argv
        self.n_wrong = 0

    def run(self, *arguments, n_ranks=1):
        command = [self.program, *arguments]
        if n_ranks > 1:
            command = [self.mpiexec, "-n", str(n_ranks)] + command
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


def test_orders(runs, is_in_space):
    """Between two meshes for each kind of cells: at points that are in all cells alike."""
    n = 4 if is_in_space else 8
    for kind in (k for k in meshes.KINDS if is_3d(k) == is_in_space):
        for straight in (False, True) if kind in ("QUAD9", "TRI6", "HEX27", "TET10") else (False,):
            coarse, fine = (error(runs, kind, k, 2 * k, straight) for k in (n // 2, n))
            order = math.log2(coarse / fine)
            low, high = (1.9, 2.3) if straight else (2.5 if is_in_space else 2.75, 3.4)
            runs.expect(low < order < high, "%s %s: errors %.2e and %.2e, order %.2f" % (
                kind, "straight" if straight else "curved", coarse, fine, order))


BODY_FORCE = """  subsection hold
    set Body = ring
    set Boundary = ring inner
    set Value = 0; 0%s
  end
  subsection weight
    set Body = ring
    set Type = body force
    set Value = 1; 0%s
  end
"""


def volume(runs, kind, n_radial, n_angular, degree=2, body="", rest="", n_ranks=1):
    """What a body force of 1 adds up to, in reactions.csv."""
    with open("ring.msh", "w") as file:
        file.write(meshes.gmsh(kind, ("ring", mesh(kind, n_radial, n_angular))))
    z = "; 0" if is_3d(kind) else ""
    text = CASE % dict(dim=3 if is_3d(kind) else 2, degree=degree, file="ring.msh", body=body, rest=rest, inner="ring inner",
                       symmetries=BODY_FORCE % (z, z), points="")
    text = text[:text.index("  subsection pressure")] + text[text.index("end\n" + rest + "\nsubsection Output"):]
    runs.results(text, n_ranks=n_ranks)
    with open("results/reactions.csv") as file:
        rows = [line.strip().split(",") for line in file]
    return -float(dict(zip(rows[0], rows[-1]))["hold.force_x"])


def expected_volume(kind, n_angular, degree):
    """Between polygons, with the parts between parabolas and chords in curved meshes."""
    def area(r):
        half = math.pi / 4 / n_angular
        chord, height = 2 * r * math.sin(half), r * (1 - math.cos(half))
        return n_angular * (r * math.cos(half) * chord / 2 + (2 * chord * height / 3 if degree == 2 else 0.))
    return (area(OUTER) - area(INNER)) * (HEIGHT if is_3d(kind) else 1.)


REFINED_SPOT = """subsection Refinement
  subsection spot
    set Type = condition
    set Condition = x > y
    set Levels = 2
  end
end
"""


def test_volumes(runs, is_in_space):
    """Refined, cut, moved and distributed cells make up the same curved body."""
    globally = "subsection Mesh\nset Global refinements = 1\n%send\n"
    moved = "set Coordinates = 3*x; y%s\nset Scale = 2\nset Rotation angle = 30\nset Translation = 5, 7%s"
    moved %= ("; z", ", 9") if is_in_space else ("", "")
    # ranks, lines of the body, other lines, factor of the volume
    variants = {"as it is": ((1, 2), "", "", 1.), "refined": ((1,), "" if is_in_space else "set Refinements = 1", globally % "", 1.),
                "refined locally": ((2,), "", REFINED_SPOT, 1.), "METIS": ((2,), "", globally % "set Partitioner = METIS\n", 1.),
                "cut": ((1,), "set Simplices = true", "", 1.), "moved": ((1,), moved, "", 24. if is_in_space else 12.)}
    without = {"QUAD9": list(variants)[1:], "HEX27": list(variants)[1:], "TRI6": ("refined locally", "cut"), "TET10": ("refined locally", "cut")}
    for kind in (k for k in meshes.KINDS if is_3d(k) == is_in_space):
        for name, (ranks, body, rest, factor) in variants.items():
            for n_ranks in () if name in without.get(kind, ()) else ranks:
                found = volume(runs, kind, 1, 3, 2, body, rest, n_ranks)
                expected = factor * expected_volume(kind, 3, 2)
                runs.expect(abs(found - expected) < 2e-6 * expected,
                            "%s %s on %d ranks: volume %.8g, expected %.8g" % (kind, name, n_ranks, found, expected))


def test_degree_1(runs, is_in_space):
    for kind in ("HEX20", "TET10") if is_in_space else ("QUAD8", "TRI6"):
        found = volume(runs, kind, 1, 3, degree=1)
        expected = expected_volume(kind, 3, 1)
        runs.expect(abs(found - expected) < 2e-6 * expected, "%s of degree 1: volume %.8g, expected %.8g" % (kind, found, expected))
        with open("results/convergence.log") as file:
            log = file.read()
        runs.expect(log.count("Degree = 1 makes the curved sides of the cells of 'ring' straight") == 1, "%s of degree 1: %s" % (kind, log))


def test_formats(runs, is_in_space):
    """All formats give the same, with the names or numbers that they have."""
    for kind in (k for k in meshes.KINDS if is_3d(k) == is_in_space):
        ring, points, found = mesh(kind, 1, 3), points_in_cells(kind, 1, 3), {}
        texts = {"ring.msh": meshes.gmsh(kind, ("ring", ring)), "ring.inp": meshes.abaqus(kind, ring), "ring.vtk": meshes.vtk(kind, ring)}
        for name, text in texts.items():
            with open(name, "w") as file:
                file.write(text)
            prm = case(kind, name, points, numbers=name == "ring.vtk")
            found[name], _ = runs.results(prm.replace("= ring ", "= ") if name == "ring.inp" else prm)
            inspected = json.loads(runs.run("--inspect-mesh", name, "json").stdout)
            runs.expect(inspected["degree"] == 2 and inspected["curved"] and inspected["cells inside out"] == 0
                        and abs(inspected["distance from straight"] - largest_deviation(kind, 3)) < 1e-6, "%s: %s" % (name, inspected))
        runs.expect(len(found["ring.msh"]) > 2 and found["ring.msh"] == found["ring.inp"] == found["ring.vtk"],
                    "%s in all formats: %s" % (kind, found))


def largest_deviation(kind, n_angular):
    """From the middle of a chord of the outer circle; with triangles, of the diagonal between two circles."""
    angle = math.pi / 2 / n_angular
    if kind not in ("TRI6", "TET10"):
        return OUTER * (1 - math.cos(angle / 2))
    middle = ((OUTER * math.cos(angle) + INNER) / 2, OUTER * math.sin(angle) / 2)
    radius = (OUTER + INNER) / 2
    return math.dist(middle, (radius * math.cos(angle / 2), radius * math.sin(angle / 2)))


def test_restart(runs):
    """One step on one number of ranks, one on another, and both on one."""
    for kind, rest in (("QUAD8", REFINED_SPOT), ("TET10", "")):
        with open("ring.msh", "w") as file:
            file.write(meshes.gmsh(kind, ("ring", mesh(kind, 1, 3))))
        prm = case(kind, "ring.msh", points_in_cells(kind, 1, 3), rest=rest + "subsection Load stepping\nset Initial step = 0.5\nend\n")
        whole, _ = runs.results(prm)
        runs.results(prm, "--set", "Load stepping/End time=0.5", n_ranks=2)
        continued, _ = runs.results(prm, "--restart", "latest")
        runs.results(prm, "--set", "Load stepping/End time=0.5")
        on_two, _ = runs.results(prm, "--restart", "latest", n_ranks=2)
        runs.expect(len(whole) > 2 and whole == continued == on_two, "%s restarted: %s, %s and %s" % (kind, whole, continued, on_two))


ADAPTATION = """subsection Adaptation
  set Estimator = recovery
  set Error target = 0.004
end
subsection Load stepping
  set Initial step = 0.5
end
"""


def test_adaptation(runs):
    """Meshes that are refined while the run goes on, on one rank and two: nearer to the closed form."""
    uniform = error(runs, "QUAD8", 2, 4)
    adapted, on_two = (error(runs, "QUAD8", 2, 4, rest=ADAPTATION, n_ranks=n) for n in (1, 2))
    runs.expect(adapted == on_two and adapted < 0.5 * uniform, "adapted: errors %.4e and %.4e instead of %.4e" % (adapted, on_two, uniform))


TESTS = {"restart": test_restart, "adaptation": test_adaptation}
for suffix, in_space in (("2d", False), ("3d", True)):
    TESTS["orders_" + suffix] = lambda runs, in_space=in_space: test_orders(runs, in_space)
    TESTS["volumes_" + suffix] = lambda runs, in_space=in_space: test_volumes(runs, in_space)
    TESTS["formats_" + suffix] = lambda runs, in_space=in_space: (test_formats(runs, in_space), test_degree_1(runs, in_space))


def main():
    runs = Runs()
    with tempfile.TemporaryDirectory() as directory:
        os.chdir(directory)
        TESTS[sys.argv[3]](runs)
        os.chdir("/")
    print("%d faults." % runs.n_wrong)
    return 1 if runs.n_wrong else 0


if __name__ == "__main__":
    sys.exit(main())
