#!/usr/bin/env python3
"""Continues runs from checkpoints and compares them with uninterrupted ones.

    restart_test.py PROGRAM WORKING_DIRECTORY

A block is pressed on another and dragged over it with friction, so that the
result depends on the path; beside them a third one is in plastic flow. Compared are the tables of all steps and every
number of the checkpoint at the end (nodal values, multipliers, slip, pairing);
on the same number of ranks also the Newton iterations, which show that the
multipliers to start from are right.
"""
import pathlib
import re
import shutil
import struct
import subprocess
import sys

from program_runs import environment_of, fresh_directory, rows_of

CASE = """
set Dimension = 2
subsection Bodies
  subsection lower
    set Generator = subdivided_hyper_rectangle
    set Arguments = 13, 4 : 0, 0 : 4, 1 : true
    set Material = soft
  end
  subsection upper
    set Generator = subdivided_hyper_rectangle
    set Arguments = 6, 3 : 0.5, 1 : 2, 1.8 : true
    set Material = soft
  end
  subsection metal
    set Generator = subdivided_hyper_rectangle
    set Arguments = 4, 3 : 5, 0 : 6, 1 : true
    set Material = plastic
  end
end
subsection Materials
  subsection soft
    set Law = St Venant-Kirchhoff
    set Young's modulus = 100
    set Poisson's ratio = 0.3
  end
  subsection plastic
    set Law = Simo-Miehe plasticity
    set Young's modulus = 100
    set Poisson's ratio = 0.3
    set Yield stress = 1
    set Hardening = linear
    set Hardening modulus = 20
  end
end
subsection Boundary conditions
  subsection base
    set Body = metal
    set Boundary = 2
    set Value = 0; 0
  end
  subsection stamp
    set Body = metal
    set Boundary = 3
    set Value = 0.04*max(t-2, 0) - 0.08*max(t-4, 0); -0.03*min(t, 5)
  end
  subsection foundation
    set Body = lower
    set Boundary = 2
    set Value = 0; 0
  end
  subsection drag
    set Body = upper
    set Boundary = 3
    set Value = 0.15*max(t-1, 0) - 0.3*max(t-4, 0); -0.02*min(t, 1)
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
  set End time = 6
  set Initial step = 1
  set Minimum step = 1
end
subsection Output
  set Verbosity = results
  set Every n steps = 100
  set Checkpoint every n steps = 1
  subsection Points
    subsection A
      set Body = upper
      set Position = 0.5, 1
    end
    subsection B
      set Body = upper
      set Position = 2, 1.8
    end
  end
end
"""
TOLERANCE = 1e-9
TABLES = {"points.csv": None, "resultants.csv": None,
          "statistics.csv": ["step", "time", "external_work", "friction_work"]}
FALLBACK_OPTIONS = ["Load stepping/Minimum step=0.01", "Load stepping/Requested times=3", "Algorithm/Newton/Max iterations=4"]
# Six iterations are enough for short steps, five count as easy.
CUT_OPTIONS = ["Load stepping/Minimum step=0.01", "Load stepping/Requested times=3", "Algorithm/Newton/Max iterations=6",
               "Load stepping/Easy iterations=5", "Algorithm/Name=GNM",
               "Boundary conditions/drag/Value=0.6*max(t-1, 0) - 1.2*max(t-4, 0); -0.02*min(t, 1)"]
failures = []


def check(holds, what):
    print(("passed  " if holds else "FAILED  ") + what, flush=True)
    if not holds:
        failures.append(what)


class Runs:
    def __init__(self, program, directory):
        self.program = program
        self.directory = fresh_directory(directory)
        (directory / "case.prm").write_text(CASE)

    def run(self, name, n_ranks=1, restart=None, options=(), exit_code=0):
        """Runs the case; returns all that was printed."""
        command = ["mpirun", "-np", str(n_ranks), self.program, "case.prm", "--output-directory", name]
        for option in options:
            command += ["--set", option]
        if restart:
            command += ["--restart", restart]
        result = subprocess.run(command, cwd=self.directory, env=environment_of(n_ranks), stdout=subprocess.PIPE,
                                stderr=subprocess.STDOUT, text=True)
        # mpirun frames its own messages in dashes
        printed = re.sub(r"^-{20,}\n.*?^-{20,}\n", "", result.stdout, flags=re.DOTALL | re.MULTILINE)
        if result.returncode != exit_code:
            check(False, f"{name}: exit code {result.returncode} instead of {exit_code}\n{printed}")
        return printed

    def copy(self, source, target):
        shutil.copytree(self.directory / source, self.directory / target)


def differences_of_tables(a, b):
    """Names of the columns that differ in any row."""
    result = []
    for name, columns in TABLES.items():
        tables = [rows_of(d / name) for d in (a, b)]
        if not tables[0] or len(tables[0]) != len(tables[1]) or tables[0][0].keys() != tables[1][0].keys():
            result.append(f"{name}: rows or columns")
            continue
        columns = columns or list(tables[0][0])
        rows = [[[float(row[c]) for c in columns] for row in table] for table in tables]
        # The components of a vector share their scale.
        families = [c[:-2] if c[-2:] in ("_x", "_y") else c for c in columns]
        scale = {}
        for row in rows[0]:
            for family, value in zip(families, row):
                scale[family] = max(scale.get(family, 0.), abs(value))
        for i, c in enumerate(columns):
            worst = max(abs(p[i] - q[i]) for p, q in zip(*rows))
            if not worst <= TOLERANCE * scale[families[i]]:
                result.append(f"{name} {c} by {worst:.1e}")
    return result


def read_checkpoint(directory):
    """The records of all cells: {cell: numbers}."""
    slot = directory / (directory / "checkpoint.latest").read_text().strip()
    cells = {}
    for path in slot.glob("cells.*"):
        data = path.read_bytes()
        n_cells = struct.unpack_from("=Q", data, len(data) - 24)[0]
        start = 0
        for i in range(n_cells):
            *cell, end, _ = struct.unpack_from("=4I2Q", data, len(data) - 32 * (n_cells - i + 1))
            cells[tuple(cell)] = struct.unpack_from(f"={end - start}d", data, 24 + 8 * start)
            start = end
    return cells


def differences_of_checkpoints(a, b):
    """What differs between the states at the end."""
    a, b = read_checkpoint(a), read_checkpoint(b)
    if a.keys() != b.keys() or any(len(a[cell]) != len(b[cell]) for cell in a):
        return ["the cells"]
    scale = {}
    for record in a.values():
        for i, value in enumerate(record):
            scale[len(record), i] = max(scale.get((len(record), i), 0.), abs(value))
    # Each record begins with displacement, force and rate of four nodes in two directions.
    for kind in range(3):
        largest = max(value for (_, i), value in scale.items() if i < 24 and i % 3 == kind)
        scale.update({key: largest for key in scale if key[1] < 24 and key[1] % 3 == kind})
    return [f"number {i} of cell {cell}: {p!r}, {q!r}" for cell in a for i, (p, q) in enumerate(zip(a[cell], b[cell]))
            if not abs(p - q) <= TOLERANCE * scale[len(a[cell]), i]]


def compare(runs, name, reference="uninterrupted"):
    paths = runs.directory / reference, runs.directory / name
    differences = differences_of_tables(*paths) + differences_of_checkpoints(*paths)
    check(not differences, f"{name} is like {reference}" + "".join("\n    " + d for d in differences[:10]))


def test_partitions(runs):
    metis = ["Mesh/Partitioner=METIS"]
    expected = runs.run("uninterrupted")
    runs.run("half-2", 2, options=["Load stepping/End time=3"])
    runs.run("half-4-metis", 4, options=["Load stepping/End time=3"] + metis)
    for half, n_ranks, options in [("half-2", 1, []), ("half-2", 2, []), ("half-2", 4, metis), ("half-4-metis", 2, []),
                                   ("half-4-metis", 3, metis), ("half-4-metis", 4, metis)]:
        name = f"from-{half}-on-{n_ranks}{'-metis' if options else ''}"
        runs.copy(half, name)
        printed = runs.run(name, n_ranks, "latest", options)
        compare(runs, name)
        check(printed == expected, f"{name} prints the same")
    names = {path.name for path in (runs.directory / "from-half-4-metis-on-2").glob("checkpoint-?/cells.*")}
    check(names == {"cells.0", "cells.1"}, f"no files of further ranks are left: {sorted(names)}")
    runs.run("elsewhere", 2, "half-2")
    check(len(rows_of(runs.directory / "elsewhere/points.csv")) == 3,
          "a run that continues another directory's begins its own tables")
    check(not differences_of_checkpoints(runs.directory / "uninterrupted", runs.directory / "elsewhere"),
          "... and ends in the same state")


def test_algorithms(runs):
    for algorithm in ("GNM", "PNM", "FPM"):
        options = [f"Algorithm/Name={algorithm}"]
        half = algorithm + "-half"
        runs.run(algorithm, 1, options=options)
        runs.run(half, 1, options=options + ["Load stepping/End time=3"])
        runs.run(half, 1, "latest", options)
        compare(runs, half, algorithm)
        iterations = [[row["newton_iterations"] for row in rows_of(runs.directory / d / "statistics.csv")]
                      for d in (algorithm, half)]
        check(iterations[0] == iterations[1], f"{half} takes the Newton iterations of {algorithm}: {iterations}")


def decisions_of(directory):
    """What the step control has decided in each step."""
    return [[row[c] for c in ("time", "algorithm", "newton_iterations", "cuts", "failed_newton_iterations")]
            for row in rows_of(directory / "statistics.csv")]


def compare_decisions(runs, name, options, times):
    """Interrupts a run at times where the whole one has a step, too; returns its decisions."""
    runs.run(name, 1, options=options)
    whole = decisions_of(runs.directory / name)
    print("\n".join("    " + " ".join(row) for row in whole))
    for time in times:
        part = f"{name}-to-{time}"
        no_later_times = ["Load stepping/Requested times="] if time < 3 else []
        runs.run(part, 1, options=options + [f"Load stepping/End time={time}"] + no_later_times)
        runs.run(part, 1, "latest", options)
        check(decisions_of(runs.directory / part) == whole,
              f"continued at {time}, a run decides as one that is not interrupted: {decisions_of(runs.directory / part)}")
        compare(runs, part, name)
    return whole


def test_fallback(runs):
    """The same attempts with fallback algorithms."""
    whole = compare_decisions(runs, "fallback", FALLBACK_OPTIONS, [3])
    check(sum(int(row[4]) for row in whole if float(row[0]) <= 3) > 0, "attempts have failed in the first half")
    check(len({row[1] for row in whole}) > 1, "another algorithm than the first was needed")


def test_cuts_and_growth(runs):
    """The same sizes of steps. At 2 growth waits after cuts, at 2.25 a step has grown, after 3 one is cut."""
    whole = compare_decisions(runs, "cuts", CUT_OPTIONS, [2, 2.25, 3])
    times = [0.] + [float(row[0]) for row in whole]
    sizes = [after - before for before, after in zip(times, times[1:])]
    n = times.index(3.)
    for half, steps in (("first", range(1, n)), ("second", range(n + 1, len(sizes)))):
        check(any(sizes[i] > 1.1 * sizes[i - 1] for i in steps), f"steps have grown in the {half} half")
    for half, rows in (("first", whole[:n]), ("second", whole[n:])):
        check(any(int(row[3]) > 0 for row in rows), f"steps were cut in the {half} half")


def test_failed_run(runs):
    runs.run("failed", 2, options=["Load stepping/End time=2", "Output/Checkpoint every n steps=0"], exit_code=0)
    check(not (runs.directory / "failed/checkpoint.latest").exists(), "no checkpoints unless asked for")
    shutil.rmtree(runs.directory / "failed")
    runs.run("failed", 2, options=["Load stepping/End time=2"])
    before = (runs.directory / "failed/checkpoint.latest").read_text()
    text = runs.run("failed", 2, "latest", ["Algorithm/Newton/Max iterations=1"], exit_code=2)
    check("--restart latest" in text, "a run that fails says how to continue")
    check((runs.directory / "failed/checkpoint.latest").read_text() != before, "... and writes a checkpoint")
    runs.run("failed", 1, "latest")
    compare(runs, "failed")
    shutil.copytree(runs.directory / "failed", runs.directory / "run anew")
    runs.run("run anew", 1, options=["Load stepping/End time=2", "Output/Checkpoint every n steps=0"])
    text = runs.run("run anew", 1, "latest", exit_code=1)
    check("An earlier run has left 'run anew/checkpoint-" in text, "a new run does not pass an old checkpoint off as its own")


def test_path_dependence(runs):
    """The comparisons above mean nothing if any path leads to the same end."""
    runs.run("other path", options=["Load stepping/Initial step=2", "Load stepping/Maximum step=2"])
    check(differences_of_checkpoints(runs.directory / "uninterrupted", runs.directory / "other path"),
          "another path ends in another state")


def test_refused(runs):
    def refused(name, restart, words, options=()):
        text = runs.run(name, 2, restart, options, exit_code=1)
        check(text.count("wrong input") == 1 and all(word in text for word in words), f"{name}: {text.strip()}")

    refused("nothing", "latest", ["there is no checkpoint in 'nothing'"])
    refused("another mesh", "half-2", ["of another case", "cells = "], ["Mesh/Global refinements=1"])
    refused("another degree", "half-2", ["of another case", "degree = 1", "degree = 2"], ["Degree=2"])
    refused("other coordinates", "half-2", ["other coordinates"], ["Bodies/upper/Translation=1e-3, 0, 0"])
    refused("no friction", "half-2", ["of another case", "contact pair 1"], ["Contact/interface/Friction=none", "Contact/interface/Friction coefficient=0"])

    latest = (runs.directory / "half-2/checkpoint.latest").read_text().strip()
    other = {"checkpoint-a": "checkpoint-b", "checkpoint-b": "checkpoint-a"}[latest]
    file = f"half-2/{latest}/cells.1"
    data = (runs.directory / file).read_bytes()
    for damage, bad in [("truncated", data[:-len(data) // 3]), ("last byte lost", data[:-1]), ("empty", b""),
                        ("a bit flipped", data[:1000] + bytes([data[1000] ^ 1]) + data[1001:])]:
        (runs.directory / file).write_bytes(bad)
        refused(damage, "half-2", ["damaged", file, f"half-2/{other}"])
    description = runs.directory / f"half-2/{latest}/description"
    text = description.read_text()
    description.write_text(text.replace("stickslip checkpoint 2", "stickslip checkpoint 1", 1))
    refused("an older format", "half-2", ["another version", "format is 1", "reads format 2"])
    description.write_text(text)
    (runs.directory / file).write_bytes(data)
    (runs.directory / file).unlink()
    refused("a file lost", "half-2", ["damaged", file])
    runs.run("from the one before", 2, f"half-2/{other}")
    check(not differences_of_checkpoints(runs.directory / "uninterrupted", runs.directory / "from the one before"),
          "the checkpoint before the damaged one leads to the same end")


def main():
    runs = Runs(sys.argv[1], pathlib.Path(sys.argv[2]))
    for test in (test_partitions, test_path_dependence, test_algorithms, test_fallback, test_cuts_and_growth, test_failed_run, test_refused):
        test(runs)
    print(f"{len(failures)} comparisons failed")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
