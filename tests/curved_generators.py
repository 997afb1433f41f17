#!/usr/bin/env python3
"""Bodies of generators with curved surfaces, or bent by 'Coordinates', have to follow these at degree 2: their volume
converges to that of the true body with order 4, of hexahedra and quadrilaterals as of the tetrahedra and triangles that
these are cut into.

usage: curved_generators.py PROGRAM MPIEXEC DIMENSION [--verbose]
"""

import math
import os
import sys
import tempfile

from curved_meshes import Runs

CASE = """set Dimension = %(dim)d
set Degree = %(degree)d
subsection Bodies
  subsection body
    set Generator = %(generator)s
    set Arguments = %(arguments)s
    set Simplices = %(simplices)s
    set Coordinates = %(coordinates)s
    set Refinements = %(refinements)d
    set Material = steel
  end
end
subsection Materials
  subsection steel
    set Law = linear elastic
    set Young's modulus = 1000
  end
end
subsection Boundary conditions
  subsection hold
    set Body = body
    set Boundary = all
    set Value = %(zero)s
  end
  subsection weight
    set Body = body
    set Type = body force
    set Value = 1%(zeros)s
  end
end
subsection Output
  set Verbosity = results
  set Directory = results
end
"""
PI = math.pi
POLAR = "x*cos(pi/2*y); x*sin(pi/2*y)"
# generator: dimension, arguments, volume, refinements of the finer mesh, coordinates
GENERATORS = {
    "annular_sector": (2, "1 : 2 : 0 : 90 : 1 : 2", 0.75 * PI, 2, ""),
    "hyper_shell": (2, "0, 0 : 1 : 2 : 6", 3 * PI, 2, ""),
    "hyper_ball": (2, "0, 0 : 1", PI, 3, ""),
    "plate_with_a_hole": (2, "0.4 : 1 : 1 : 1 : 1 : 1", 16 - 0.16 * PI, 2, ""),
    "subdivided_hyper_rectangle to a sector": (2, "1, 2 : 1, 0 : 2, 1", 0.75 * PI, 2, POLAR),
    "annular_sector to an ellipse": (2, "1 : 2 : 0 : 90 : 1 : 2", 1.5 * PI, 2, "2*x; y"),
    "subdivided_hyper_rectangle to a sector in space": (3, "1, 2, 1 : 1, 0, 0 : 2, 1, 1", 0.75 * PI, 1, POLAR + "; z"),
    "annular_sector in space": (3, "1 : 2 : 0 : 90 : 1 : 2 : 1 : 1", 0.75 * PI, 1, ""),
    "cylinder": (3, "1 : 1", 2 * PI, 2, ""),
    "hyper_shell in space": (3, "0, 0, 0 : 1 : 2 : 6", 4 / 3 * PI * 7, 2, ""),
}


def volume(runs, name, refinements, degree=2, simplices=False):
    dim, arguments, _, _, coordinates = GENERATORS[name]
    zero = "; ".join(["0"] * dim)
    runs.results(CASE % dict(dim=dim, degree=degree, generator=name.split()[0], arguments=arguments, refinements=refinements,
                             coordinates=coordinates, simplices=str(simplices).lower(),
                             zero=zero, zeros="; 0" * (dim - 1)))
    with open("results/reactions.csv") as file:
        rows = [line.strip().split(",") for line in file]
    return -float(dict(zip(rows[0], rows[-1]))["hold.force_x"])


def main():
    runs = Runs()
    with tempfile.TemporaryDirectory() as directory:
        os.chdir(directory)
        for name, (dim, _, expected, refinements, _) in GENERATORS.items():
            if dim != int(sys.argv[3]):
                continue
            for simplices in (False, True) if "sector" in name or name in ("hyper_shell", "hyper_ball") else (False,):
                errors = [abs(volume(runs, name, r, simplices=simplices) / expected - 1) for r in (refinements - 1, refinements)]
                order = math.log2(errors[0] / errors[1])
                runs.expect(order > 3.5 and errors[1] < 1e-2, "%s%s: errors of the volume %.2e and %.2e, order %.2f" % (
                    name, ", cut" if simplices else "", *errors, order))
        os.chdir("/")
    print("%d faults." % runs.n_wrong)
    return 1 if runs.n_wrong else 0


if __name__ == "__main__":
    sys.exit(main())
