#!/usr/bin/env python3
"""Runs cases that fail and looks at what they leave behind.

    diagnosis_test.py PROGRAM WORKING_DIRECTORY

Checked: exit code 2; the last three lines of message and log; the diagnosis of
all contact points on one and two ranks; what --diagnose says of failed and
completed runs; that a later success removes nothing and a new run everything.
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
    set Arguments = 9, 3 : 0, 0 : 3, 1 : true
    set Material = soft
  end
  subsection upper
    set Generator = subdivided_hyper_rectangle
    set Arguments = 4, 2 : 0.5, 1 : 2, 2 : true
    set Material = soft
  end
end
subsection Materials
  subsection soft
    set Law = St Venant-Kirchhoff
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
  subsection hand
    set Body = upper
    set Boundary = 3
    set Value = 0; -0.1*t
  end
end
subsection Contact
  subsection interface
    set Slave body = upper
    set Slave boundary = 2
    set Master body = lower
    set Master boundary = 3
    set Quadrature = nodal
    set Friction = Coulomb
    set Friction coefficient = 0.3
  end
end
subsection Algorithm
  set Name = GNM
end
subsection Load stepping
  set Initial step = 0.5
  set Minimum step = 0.5
end
"""

HAND = "Boundary conditions/hand/"
FAILING = {
    # name: (cause, place, advice, overrides)
    "held by nothing": ("body held by nothing", "body 'upper'", "spring",
                        {HAND + "Type": "traction", HAND + "Value": "0; -1*t", "Bodies/upper/Translation": "0, 0.1"}),
    "crushed": ("inadmissible deformation", "body 'upper' at the reference position (", "neo-Hookean",
                {HAND + "Value": "0; -5*t", "Algorithm/Newton/Max halvings": "0"}),
    "few iterations": ("iteration limit", "the contact conditions.", "Max iterations", {"Algorithm/Newton/Max iterations": "1"}),
}

failures = []


def check(what, holds):
    if not holds:
        failures.append(what)


def run(directory, overrides=(), ranks=1, arguments=None):
    if arguments is None:
        arguments = ["case.prm", "--output-directory", directory, "--quiet", *settings(overrides)]
    return start(program, arguments, ranks)


def numbers_agree(a, b):
    try:
        return abs(float(a) - float(b)) <= 1e-8 * (1 + abs(float(a)))
    except ValueError:
        return a == b


def last_lines(text):
    return [line.split(":", 1) for line in text.rstrip().split("\n")[-3:]]


program = os.path.abspath(sys.argv[1])
os.chdir(fresh_directory(sys.argv[2]))
pathlib.Path("case.prm").write_text(CASE)

for name, (cause, place, advice, overrides) in FAILING.items():
    directory = name.replace(" ", "_")
    tables = {}
    for ranks in (1, 2):
        result = run(directory, overrides, ranks)
        check(f"{name}: exit code {result.returncode} instead of 2", result.returncode == 2)
        log = pathlib.Path(directory, "convergence.log").read_text()
        for text in (result.stderr, log) if ranks == 1 else (log,):
            lines = last_lines(text)
            check(f"{name}: the last lines are {lines}", [line[0].strip() for line in lines] == ["why", "where", "try"])
            check(f"{name}: '{place}' is not in {lines[1]}", place in lines[1][-1])
            check(f"{name}: '{advice}' is not in {lines[2]}", advice in lines[2][-1])
        check(f"{name}: the cause '{cause}' is not in the log", f"  cause: {cause}\n" in log)
        check(f"{name}: no VTU of the points", pathlib.Path(directory, "diagnosis-0001.vtu").exists())
        tables[ranks] = rows_of(pathlib.Path(directory, "diagnosis-0001.csv"))
    check(f"{name}: {len(tables[1])} points instead of 8", len(tables[1]) == 8)
    check(f"{name}: one rank and two ranks differ",
          all(numbers_agree(a[key], b[key]) for a, b in zip(tables[1], tables[2]) for key in a if key != "history"))
    summary = run(directory, arguments=["--diagnose", directory]).stdout
    for text in ("stopped without convergence, 0 steps", f"1 x {cause}, first in step 1 to t = 0.5", "Why it stopped", advice,
                 "diagnosis-0001.csv"):
        check(f"{name}: --diagnose does not say '{text}' but\n{summary}", text in summary)

# The stiffness of the bodies alone is singular: refused before the first step, and not if all of them are held.
GCP = {"Algorithm/Name": "GCP"}
for name, overrides in {"pressed by a force": {HAND + "Type": "traction", HAND + "Value": "0; -1*t"},
                        "driven by contact": {HAND + "Value": "free; -0.01*t", "Boundary conditions/foundation/Value": "0.1*t; 0"}}.items():
    result = run("unheld", {**GCP, **overrides})
    check(f"{name}: exit code {result.returncode}, {result.stderr}", result.returncode == 1 and result.stderr.count("wrong input") == 1
          and all(text in result.stderr for text in ("'Algorithm/Name = GCP'", "body 'upper': translation along x", "automatic")))
result = run("held", {**GCP, HAND + "Value": "0; -0.01*t"})
check(f"held without contact: exit code {result.returncode}, {result.stderr}", result.returncode == 0)

# Held, but by soft springs: one failed solve says so. One rank: on several, a thousand small solves with factors take long.
result = run("springs", {**GCP, HAND + "Type": "spring", HAND + "Value": "", HAND + "Stiffness": "1e-6",
                         "Boundary conditions/foundation/Value": "0.1*t; 0.1*t"})
check(f"held by springs: exit code {result.returncode}", result.returncode == 2)
for text in ("Cause: body held by contact and springs", "body 'upper': translation along x", "'Algorithm/Name = automatic'"):
    check(f"held by springs: '{text}' is not in\n{result.stderr}", text in result.stderr)

# A history has a letter per iteration.
run("history", {"Algorithm/Newton/Max iterations": "3", "Algorithm/Newton/Equilibrium tolerance": "0"})
rows = rows_of("history/diagnosis-0001.csv")
check(f"histories {[row['history'] for row in rows]}", all(len(row["history"]) == 3 for row in rows))
check("the state of all points is known", all(row["status"] in ("open", "stick", "slip") for row in rows))

# A run that has to cut and completes.
result = run("cut", {HAND + "Value": "0; -0.4*t", "Load stepping/Minimum step": "0.001", "Algorithm/Newton/Max iterations": "5"})
summary = run("cut", arguments=["--diagnose", "cut"]).stdout
check(f"the run with cuts: exit code {result.returncode}\n{result.stderr}", result.returncode == 0)
for text in ("done, ", "Why a step was cut the last time", "max_penetration", "solve_seconds", " %"):
    check(f"after cuts --diagnose does not say '{text}' but\n{summary}", text in summary)
check("the diagnosis of a cut step stays", list(pathlib.Path("cut").glob("diagnosis-*.csv")))

# A new run in the same directory begins without it; --diagnose has nothing to explain.
result = run("cut")
check(f"the plain run: exit code {result.returncode}", result.returncode == 0)
check("a new run removes old diagnoses", not list(pathlib.Path("cut").glob("diagnosis-*")))
summary = run("cut", arguments=["--diagnose", "cut"]).stdout
check(f"--diagnose does not say that no step was cut but\n{summary}", "No step was cut." in summary)

result = run("", arguments=["--diagnose", "nowhere"], ranks=2)
check("--diagnose of nothing is wrong input", result.returncode == 1 and "there is no run in 'nowhere'" in result.stderr)

print("\n".join(failures) if failures else "all runs that fail say why")
sys.exit(1 if failures else 0)
