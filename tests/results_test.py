#!/usr/bin/env python3
"""Holds the tables of a run against each other and against equilibrium.

    results_test.py PROGRAM WORKING_DIRECTORY

A block is pressed on another one, dragged along it and beyond its end, in 2D
and in 3D. Forces of supports, contact forces and contact points have to agree,
on one and on two ranks, and where the whole surface slips, friction has to be
Coulomb's. Also: continuing with another parameter, and
the surfaces of an Abaqus file.
"""
import os
import pathlib
import sys

from program_runs import fresh_directory, rows_of, settings, start

CASE = """
set Dimension = 2
subsection Bodies
  subsection lower
    set Generator = subdivided_hyper_rectangle
    set Arguments = 8, 2 : 0, 0 : 2, 0.5 : true
    set Material = soft
  end
  subsection upper
    set Generator = subdivided_hyper_rectangle
    set Arguments = 5, 2 : 1, 0.5 : 1.9, 1 : true
    set Material = soft
  end
end
subsection Materials
  subsection soft
    set Law = neo-Hookean
    set Young's modulus = 100
    set Poisson's ratio = 0.3
  end
end
subsection Boundary conditions
  subsection foundation
    set Body = lower
    set Boundary = 2
    set Value = 0; 0
  end
  subsection side
    set Body = lower
    set Boundary = 0
    set Type = symmetry
  end
  subsection hand
    set Body = upper
    set Boundary = 3
    set Value = 0.6*max(t - 0.2, 0); -0.05*min(t/0.2, 1)
  end
  subsection wind
    set Body = upper
    set Boundary = 1
    set Type = traction
    set Value = -1*t; 0.5*t
  end
end
subsection Contact
  subsection interface
    set Slave body = upper
    set Slave boundary = 2
    set Master body = lower
    set Master boundary = 3
    set Friction = Coulomb
    set Friction coefficient = 0.3
  end
end
subsection Load stepping
  set Initial step = 0.1
  set Requested times = 0.2
end
subsection Output
  set Contact points = true
  set Checkpoint every n steps = 5
  set Verbosity = quiet
end
"""

# 2D and 3D; the wind blows on an edge of 0.5 or a face of 0.5 x 1.
IN_3D = {
    "Dimension": "3", "Bodies/lower/Arguments": "4, 2, 2 : 0, 0, 0 : 2, 0.5, 1 : true",
    "Bodies/upper/Arguments": "3, 1, 2 : 1, 0.5, 0 : 1.9, 1, 1 : true",
    "Boundary conditions/foundation/Value": "0; 0; 0", "Boundary conditions/foundation/Boundary": "2",
    "Boundary conditions/hand/Value": "0.6*max(t - 0.2, 0); -0.05*min(t/0.2, 1); 0",
    "Boundary conditions/wind/Value": "-1*t; 0.5*t; 0",
}

ABAQUS = """*Heading
*Node
1, 0., 0.
2, 1., 0.
3, 1., 1.
4, 0., 1.
*Element, type=CPS4
1, 1, 2, 3, 4
*Elset, elset=all
1
*Surface, type=ELEMENT, name=top
all, S3
*Surface, type=ELEMENT, name=left side
all, S4
*SURFACE, NAME=SURF-2, TYPE=ELEMENT
all, S2
"""

failures = []


def check(what, holds):
    if not holds:
        failures.append(what)


def close(a, b, scale):
    return abs(a - b) <= 1e-7 * scale


def run(*arguments, ranks=1):
    return start(program, arguments, ranks)


def check_forces(directory, dim):
    """Supports, loads and contact are in equilibrium at every step."""
    axes = "xyz"[:dim]
    resultants = {row["step"]: row for row in rows_of(f"{directory}/resultants.csv")}
    unpaired = 0
    for row in rows_of(f"{directory}/reactions.csv"):
        step = f"{directory}, step {row['step']}"
        forces = {key: float(value) for key, value in row.items() if ".force_" in key}
        scale = max(map(abs, forces.values()))
        wind = {"x": -0.5 * float(row["time"]), "y": 0.25 * float(row["time"]), "z": 0.0}
        for axis in axes:
            contact = float(resultants[row["step"]][f"interface.force_{axis}"])
            check(f"{step}: contact on the upper body, {axis}", close(forces[f"hand.force_{axis}"], -contact - wind[axis], scale))
            supports = forces[f"foundation.force_{axis}"] + forces[f"side.force_{axis}"]
            check(f"{step}: contact on the lower body, {axis}", close(supports, contact, scale))
        check(f"{step}: a symmetry plane carries normal forces only", close(forces["side.force_y"], 0, scale))
        unpaired += float(resultants[row["step"]]["interface.unpaired_points"])
        points = rows_of(f"{directory}/contact_points-{int(row['step']):04}.csv")
        for axis in axes:
            total = sum(float(p["reference_weight"]) * (float(p["pressure"]) * float(p[f"normal_{axis}"]) +
                        float(p[f"tangential_traction_{axis}"])) for p in points)
            check(f"{step}: sum over the contact points, {axis}",
                  close(total, float(resultants[row["step"]][f"interface.force_{axis}"]), scale))
    check(f"{directory}: the slave should slide over the end", unpaired > 0)


def check_slip(directory, friction_coefficient):
    """2D: where every closed point slips to the right, friction is mu times the normal force, turned by 90 degrees."""
    n_steps = 0
    for row in rows_of(f"{directory}/resultants.csv"):
        value = {key[len("interface."):]: float(number) for key, number in row.items() if key.startswith("interface.")}
        if value["slip_points"] > 0 and value["stick_points"] == 0 and value["friction_force_x"] < 0:
            n_steps += 1
            scale = value["normal_force_y"]
            for axis, turned in (("x", -value["normal_force_y"]), ("y", value["normal_force_x"])):
                check(f"{directory}, step {row['step']}: Coulomb's law, {axis}",
                      close(value[f"friction_force_{axis}"], friction_coefficient * turned, scale))
    check(f"{directory}: some steps in which all closed points slip", n_steps > 1)


def check_same_tables(one, other):
    for name in ("reactions.csv", "resultants.csv", "contact_points-0010.csv"):
        a, b = rows_of(f"{one}/{name}"), rows_of(f"{other}/{name}")
        check(f"{name} of {one} and {other}", len(a) == len(b) and all(
            abs(float(x[key]) - float(y[key])) <= 1e-6 * (1 + abs(float(x[key]))) for x, y in zip(a, b) for key in x))


program = os.path.abspath(sys.argv[1])
os.chdir(fresh_directory(sys.argv[2]))
pathlib.Path("case.prm").write_text(CASE)

for dim, overrides in ((2, {}), (3, IN_3D)):
    for ranks in (1, 2):
        directory = f"{dim}D_{ranks}"
        result = run("case.prm", "--output-directory", directory, *settings(overrides), ranks=ranks)
        check(f"{directory}: exit code {result.returncode}\n{result.stderr}", result.returncode == 0)
        check_forces(directory, dim)
    if dim == 2:
        check_slip("2D_1", 0.3)
    check_same_tables(f"{dim}D_1", f"{dim}D_2")
    fields = pathlib.Path(f"{dim}D_1/contact-0010.0.vtu").read_text(errors="replace")
    check(f"{dim}D: field 'paired'", 'Name="paired"' in fields)
    fields = pathlib.Path(f"{dim}D_1/solution-0010.pvtu").read_text()
    check(f"{dim}D: a tensor has nine components", 'Name="cauchy_stress" NumberOfComponents="9"' in fields)

# What the state depends on has changed: that is said, and nothing else.
again = ("case.prm", "--output-directory", "2D_1", "--restart", "latest", "--set", "Load stepping/End time=1.05")
result = run(*again, "--set", "Contact/interface/Friction coefficient=0.4", "--set", "Materials/soft/Young's modulus=1e2")
log = pathlib.Path("2D_1/convergence.log").read_text()
check(f"restart with another mu: exit code {result.returncode}\n{result.stderr}", result.returncode == 0)
check("restart with another mu is said", "'Contact/interface/Friction coefficient' was 0.3 and is 0.4" in log)
check("100 is 1e2", "Young's modulus" not in log)
check("the reactions go on", len(rows_of("2D_1/reactions.csv")) > 10)

# What only contact holds is said, on all numbers of ranks.
for ranks in (1, 2):
    result = run("case.prm", "--validate", "--set", "Boundary conditions/side/Type=traction", "--set",
                 "Boundary conditions/side/Value=0; 0", "--set", "Boundary conditions/foundation/Value=free; 0", ranks=ranks)
    check(f"held by contact, {ranks} ranks: {result.stdout}{result.stderr}",
          result.returncode == 0 and "held by contact alone: body 'lower': translation along x\n" in result.stdout)

# Surfaces of an Abaqus file: top gets 1, the left side 3, because 2 is there.
pathlib.Path("square.inp").write_text(ABAQUS)
for boundary, found in (("1", True), ("2", True), ("3", True), ("4", False)):
    result = run("case.prm", "--validate", "--set", "Bodies/upper/Generator=", "--set", "Bodies/upper/Arguments=",
                 "--set", "Bodies/upper/Mesh file=square.inp", "--set", "Contact/interface/Slave boundary=2",
                 "--set", "Boundary conditions/wind/Boundary=1", "--set", f"Boundary conditions/hand/Boundary={boundary}")
    known = "Boundaries of this body: 'SURF-2' (2), 'left side' (3), 'top' (1), 0" in result.stderr
    check(f"Abaqus surface {boundary}: {result.stderr}", result.returncode == 0 if found else known)

print("\n".join(failures) if failures else "all tables agree")
sys.exit(1 if failures else 0)
