#!/usr/bin/env python3
"""A cube of six tetrahedra, in several formats and of both orders, has to give the exact stretch of a bar.

usage: simplex_meshes.py PROGRAM
"""
import os
import subprocess
import sys
import tempfile

POINTS = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
# Paths along the edges from the first to the last corner; every second one is inverted, which readers have to see.
TETRAHEDRA = [(1, 1 + a, 1 + a + b, 8) for a, b in ((1, 2), (1, 4), (2, 1), (2, 4), (4, 1), (4, 2))]
CASE = """
set Dimension = 3
set Degree = %d
subsection Bodies
  subsection bar
    set Mesh file = %s
    set Boundary ids = left: x < 1e-6; right: x > 1 - 1e-6; front: y < 1e-6; floor: z < 1e-6
    set Material = soft
  end
end
subsection Materials
  subsection soft
    set Law = linear elastic
    set Young's modulus = 100
    set Poisson's ratio = 0.3
  end
end
subsection Boundary conditions
  subsection left
    set Body = bar
    set Boundary = left
    set Type = symmetry
  end
  subsection front
    set Body = bar
    set Boundary = front
    set Type = symmetry
  end
  subsection floor
    set Body = bar
    set Boundary = floor
    set Type = symmetry
  end
  subsection pull
    set Body = bar
    set Boundary = right
    set Type = traction
    set Value = t; 0; 0
  end
end
subsection Output
  subsection Points
    subsection corner
      set Body = bar
      set Position = 1, 1, 1
    end
  end
end
subsection Checks
  subsection x
    set Quantity = corner_x
    set Expected = 0.01
    set Tolerance = 1e-10
  end
  subsection y
    set Quantity = corner_y
    set Expected = -0.003
    set Tolerance = 1e-10
  end
end
"""


def second_order():
    """All points, and tetrahedra with the middles of the edges in Abaqus' order."""
    points, middles, cells = list(POINTS), {}, []
    for cell in TETRAHEDRA:
        nodes = list(cell)
        for a, b in ((0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3)):
            edge = tuple(sorted((cell[a], cell[b])))
            if edge not in middles:
                points.append(tuple(0.5 * (p + q) for p, q in zip(POINTS[edge[0] - 1], POINTS[edge[1] - 1])))
                middles[edge] = len(points)
            nodes.append(middles[edge])
        cells.append(nodes)
    return points, cells


def gmsh(points, cells, code):
    return ("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n%d\n" % len(points)
            + "".join("%d %g %g %g\n" % (i + 1, *p) for i, p in enumerate(points))
            + "$EndNodes\n$Elements\n%d\n" % len(cells)
            + "".join("%d %d 2 1 1 %s\n" % (i + 1, code, " ".join(map(str, c))) for i, c in enumerate(cells)) + "$EndElements\n")


def abaqus(points, cells, kind):
    return ("*NODE\n" + "".join("%d, %g, %g, %g\n" % (i + 1, *p) for i, p in enumerate(points)) + "*ELEMENT, TYPE=%s\n" % kind
            + "".join("%d, %s\n" % (i + 1, ", ".join(map(str, c))) for i, c in enumerate(cells)))


def vtk(points, cells, code):
    return ("# vtk DataFile Version 3.0\ncube\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS %d double\n" % len(points)
            + "".join("%g %g %g\n" % p for p in points) + "CELLS %d %d\n" % (len(cells), sum(len(c) + 1 for c in cells))
            + "".join("%d %s\n" % (len(c), " ".join(str(n - 1) for n in c)) for c in cells)
            + "CELL_TYPES %d\n" % len(cells) + "%d\n" % code * len(cells))


def main():
    program = os.path.abspath(sys.argv[1])
    points, cells = second_order()
    files = {"linear.msh": gmsh(POINTS, TETRAHEDRA, 4), "linear.inp": abaqus(POINTS, TETRAHEDRA, "C3D4"),
             "linear.vtk": vtk(POINTS, TETRAHEDRA, 10), "quadratic.inp": abaqus(points, cells, "C3D10"),
             "quadratic.vtk": vtk(points, cells, 24)}
    n_wrong = 0
    with tempfile.TemporaryDirectory() as directory:
        os.chdir(directory)
        for name, text in files.items():
            with open(name, "w") as file:
                file.write(text)
            for degree in (1, 2):
                with open("case.prm", "w") as case:
                    case.write(CASE % (degree, name))
                result = subprocess.run([program, "case.prm"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=120)
                if result.returncode != 0 or "straight" in result.stdout:
                    n_wrong += 1
                    print("%s, degree %d:\n%s" % (name, degree, result.stdout))
            result = subprocess.run([program, "--inspect-mesh", name], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=120)
            says_degree = "Degree 2, straight" in result.stdout
            if result.returncode != 0 or "1: 6 cells" not in result.stdout or says_degree != name.startswith("quadratic"):
                n_wrong += 1
                print("--inspect-mesh %s:\n%s" % (name, result.stdout))
        os.chdir("/")
    print("%d faults." % n_wrong)
    return 1 if n_wrong else 0


if __name__ == "__main__":
    sys.exit(main())
