#!/usr/bin/env python3
"""Surfaces that meet themselves against the same bodies with a pair of two named parts of the surface.

    self_contact_test.py PROGRAM WORKING_DIRECTORY

A ring is crushed flat between two plates and let go again; a strip in the form of a U is pressed together and sheared,
in 2D and in 3D, with friction. Compared are the displacements and contact forces of all nodes. Besides: symmetry, the
work of a cycle, numbers of ranks, restarts.
"""
import math
import pathlib
import sys

from checkpoint_runs import Runs, check, compare, failures, read_checkpoint
from program_runs import rows_of

N_ANGLES = 8  # points of the ring in a quarter


def point(name, body, *position):
    return f"""  subsection {name}
    set Body = {body}
    set Position = {", ".join(f"{x:.16g}" for x in position)}
  end
"""


def solution(points):
    """The sections at the end of a case: steps as exact as roundoff lets them be, all of them in checkpoints."""
    return f"""subsection Algorithm
  subsection Newton
    set Equilibrium tolerance = 1e-11
  end
end
subsection Output
  set Verbosity = results
  set Every n steps = 1000
  set Checkpoint every n steps = 1
  subsection Points
{points}  end
end
"""


def ring_points():
    """Inner nodes at mirror places: a right, b left of the middle."""
    text = ""
    for i in range(N_ANGLES + 1):
        angle = math.pi / 2 * i / N_ANGLES
        for side, sign in (("a", 1), ("b", -1)):
            for half, up in (("u", 1), ("d", -1)):
                text += point(f"{half}{side}{i}", "ring", sign * 0.8 * math.cos(angle), up * 0.8 * math.sin(angle))
    return text


RING = """
set Dimension = 2
subsection Bodies
  subsection ring
    set Generator = hyper_shell
    set Arguments = 0, 0 : 0.8 : 1 : 32 : true
    set Refinements = 1
    set Boundary ids = 4: id == 0 && y > 0; 5: id == 0 && y < 0
    set Material = rubber
  end
  subsection top
    set Generator = subdivided_hyper_rectangle
    set Arguments = 4, 1 : -2, 1 : 2, 1.2 : true
    set Rigid = true
  end
  subsection bottom
    set Generator = subdivided_hyper_rectangle
    set Arguments = 4, 1 : -2, -1.2 : 2, -1 : true
    set Rigid = true
  end
end
subsection Materials
  subsection rubber
    set Law = neo-Hookean
    set Young's modulus = 10
    set Poisson's ratio = 0.4
  end
end
subsection Boundary conditions
  subsection press
    set Body = top
    set Type = rigid motion
    set Translation = 0; -1.65*min(t, 2 - t)
  end
  subsection held
    set Body = ring
    set Boundary = 1
    set Type = spring
    set Direction = x
    set Stiffness = 1e-4
  end
end
subsection Contact
  subsection top
    set Slave body = ring
    set Slave boundary = 1
    set Master body = top
    set Master boundary = 2
  end
  subsection bottom
    set Slave body = ring
    set Slave boundary = 1
    set Master body = bottom
    set Master boundary = 3
  end
  subsection fold
    set Slave body = ring
    set Slave boundary = 4, 5
    set Master body = ring
    set Master boundary = 4, 5
  end
end
subsection Load stepping
  set Initial step = 0.025
  set Maximum step = 0.025
  set End time = 2
end
""" + solution(ring_points())


def strip(dimension):
    """A U with legs along x whose nodes do not match."""
    is_3d = dimension == 3
    cells, low, high = ("32, 1, 2", "-3.6, 0, 0", "3.4, 0.3, 0.5") if is_3d else ("40, 3", "-3.6, 0", "3.4, 0.3")
    zero, third = ("; 0", "; z") if is_3d else ("", "")
    return f"""
set Dimension = {dimension}
subsection Bodies
  subsection strip
    set Generator = subdivided_hyper_rectangle
    set Arguments = {cells} : {low} : {high} : true
    set Coordinates = abs(x) > pi/4 ? abs(x) - pi/4 : -(0.5 + y)*cos(2*x); abs(x) > pi/4 ? (x > 0 ? 0.5 + y : -0.5 - y) : (0.5 + y)*sin(2*x){third}
    set Boundary ids = 11: id == 3 && x > 0.2 && y > 0; 12: id == 3 && x > 0.2 && y < 0; 13: id == 2 && y > 0; 14: id == 2 && y < 0
    set Material = rubber
  end
end
subsection Materials
  subsection rubber
    set Law = neo-Hookean
    set Young's modulus = 10
    set Poisson's ratio = 0.3
  end
end
subsection Boundary conditions
  subsection press
    set Body = strip
    set Boundary = 11
    set Type = displacement
    set Value = 0.2*max(t - 1, 0); -1.05*min(t, 1){zero}
  end
  subsection held
    set Body = strip
    set Boundary = 12
    set Type = displacement
    set Value = 0; 0{zero}
  end
end
subsection Contact
  subsection fold
    set Slave body = strip
    set Slave boundary = 13, 14
    set Master body = strip
    set Master boundary = 13, 14
    set Friction = Coulomb
    set Friction coefficient = 1
  end
end
subsection Load stepping
  set Initial step = 0.1
  set Maximum step = 0.1
  set End time = 1.5
end
""" + solution(point("A", "strip", *((0, 0.5, 0) if is_3d else (0, 0.5))))


def parts(slave, master):
    return [f"Contact/fold/Slave boundary={slave}", f"Contact/fold/Master boundary={master}"]


def nodal_differences(a, b, dimension):
    """Largest relative difference of the displacements, and of the contact forces, of all nodes."""
    a, b = read_checkpoint(a), read_checkpoint(b)
    n_numbers = 4 * dimension * 2 ** dimension
    result = []
    for kind in (0, 2):
        pairs = [(p, q) for cell in a for p, q in zip(a[cell][kind:n_numbers:4], b[cell][kind:n_numbers:4])]
        result.append(max(abs(p - q) for p, q in pairs) / max(abs(p) for p, _ in pairs))
    return result


def last_row(directory, table):
    return {name: float(value) for name, value in rows_of(directory / table)[-1].items()}


def compare_with_parts(runs, case, name, slave, master, dimension, options=(), exchanged=0.02):
    """SLAVE and MASTER are what the program chooses."""
    runs.run(f"{name}-parts", case=case, options=[*parts(slave, master), *options])
    runs.run(f"{name}-exchanged", case=case, options=[*parts(master, slave), *options])
    worst = nodal_differences(runs.directory / name, runs.directory / f"{name}-parts", dimension)
    check(max(worst) < 1e-8, f"{name}: like named parts (by {worst[0]:.1e}, contact forces by {worst[1]:.1e})")
    worst = nodal_differences(runs.directory / name, runs.directory / f"{name}-exchanged", dimension)
    check(worst[0] < exchanged, f"{name}: nearly like exchanged parts (displacements by {worst[0]:.1e})")
    row = last_row(runs.directory / name, "resultants.csv")
    closed = row["fold.closed_points"]
    check(closed > 0, f"{name}: {closed:.0f} closed points")


def test_ring(runs):
    crushed = ["Load stepping/End time=1"]
    printed = runs.run("crushed", case="ring.prm", options=crushed)
    compare_with_parts(runs, "ring.prm", "crushed", 4, 5, 2, crushed)
    row = last_row(runs.directory / "crushed", "points.csv")
    across = along = 0.
    for i in range(N_ANGLES + 1):
        for half in "ud":
            a, b = ([row[f"{half}{side}{i}_{c}"] for c in "xy"] for side in "ab")
            across = max(across, abs(a[0] + b[0]), abs(a[1] - b[1]))
        up, down = ([row[f"{half}a{i}_{c}"] for c in "xy"] for half in "ud")
        along = max(along, abs(up[0] - down[0]), abs(up[1] + down[1] + 1.65))
    check(across < 1e-7, f"crushed: left like right at {4 * N_ANGLES} places (by {across:.1e})")
    # slave below, master above: as good as the mesh
    check(along < 0.01, f"crushed: top nearly like bottom (by {along:.1e})")
    row = last_row(runs.directory / "crushed", "resultants.csv")
    check(abs(row["top.force_y"] + row["bottom.force_y"]) < 1e-8 * abs(row["top.force_y"]), "crushed: the plates balance")
    for n_ranks in (2, 4):
        check(runs.run(f"crushed-{n_ranks}", n_ranks, case="ring.prm", options=crushed).split("moment")[0]
              == printed.split("moment")[0], f"crushed: {n_ranks} ranks print the same")
        worst = nodal_differences(runs.directory / "crushed", runs.directory / f"crushed-{n_ranks}", 2)
        check(max(worst) < 1e-8, f"crushed: all nodes are the same on {n_ranks} ranks (by {max(worst):.1e})")
    # back to the second step: at t = 2 the plates only just touch, and whether they do is a matter of roundoff
    runs.run("cycle", case="ring.prm", options=["Load stepping/End time=1.95"])
    work = [float(row["external_work"]) for row in rows_of(runs.directory / "cycle/statistics.csv")]
    left = abs(work[-1] - work[1])
    check(left < 1e-8 * max(work), f"cycle: no work is left of {max(work):.3g}: {left:.1e}")


def test_strip(runs, dimension):
    case, name = f"strip-{dimension}.prm", f"strip-{dimension}"
    (runs.directory / case).write_text(strip(dimension))
    runs.run(name, case=case)
    compare_with_parts(runs, case, name, 14, 13, dimension)
    row = last_row(runs.directory / name, "resultants.csv")
    check(row["fold.stick_points"] > 0, f"{name}: {row['fold.stick_points']:.0f} points stick")
    friction = [row[f"fold.friction_force_{c}"] for c in "xy"]
    normal = [row[f"fold.normal_force_{c}"] for c in "xy"]
    ratio = math.hypot(*friction) / math.hypot(*normal)
    check(0.01 < ratio < 1.01, f"{name}: friction acts, within its limit ({ratio:.3g})")
    runs.run(f"{name}-on-2", 2, case=case, options=["Load stepping/End time=1.2"])
    runs.run(f"{name}-on-2", 4 if dimension == 2 else 1, "latest", case=case)
    worst = nodal_differences(runs.directory / name, runs.directory / f"{name}-on-2", dimension)
    check(max(worst) < 1e-8, f"{name}: a restart on other ranks goes on the same (by {max(worst):.1e})")


def test_automatic(runs):
    """The pair that the program finds, of all free boundaries with themselves, like the one of the two sides that meet."""
    before, section, after = strip(2).partition("subsection Contact\n")
    after = after[after.index("subsection Load stepping"):]
    (runs.directory / "automatic.prm").write_text(before + section + """  set Automatic = true
  set Automatic self contact = true
  set Automatic friction coefficient = 1
end
""" + after)
    runs.run("automatic", case="automatic.prm")
    closed = last_row(runs.directory / "automatic", "resultants.csv")["strip_on_itself.closed_points"]
    check(closed > 0, f"automatic: {closed:.0f} closed points")
    worst = nodal_differences(runs.directory / "strip-2", runs.directory / "automatic", 2)
    runs.run("automatic-2", 2, case="automatic.prm")
    ranks = nodal_differences(runs.directory / "automatic", runs.directory / "automatic-2", 2)
    check(max(ranks) < 1e-8, f"automatic: all nodes are the same on 2 ranks (by {max(ranks):.1e})")
    check(max(worst) < 1e-8, f"automatic: like the pair of the sides (by {worst[0]:.1e}, contact forces by {worst[1]:.1e})")


def main():
    runs = Runs(sys.argv[1], pathlib.Path(sys.argv[2]))
    (runs.directory / "ring.prm").write_text(RING)
    test_strip(runs, 2)
    test_strip(runs, 3)
    test_automatic(runs)
    test_ring(runs)
    print(f"{len(failures)} failed")
    sys.exit(1 if failures else 0)


if __name__ == "__main__":
    main()
