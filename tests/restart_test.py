#!/usr/bin/env python3
"""Continues runs from checkpoints and compares them with uninterrupted ones.

    restart_test.py PROGRAM WORKING_DIRECTORY

Compared are the tables of all steps and every number of the checkpoint at the end; on the same number of ranks also the
Newton iterations, which show that the multipliers to start from are right.
"""
import pathlib
import re
import shutil
import sys

from checkpoint_runs import Runs, check, compare, differences_of_checkpoints, differences_of_tables, failures
from program_runs import rows_of

# Point-to-segment rules: their points remember their facets.
NODAL = "Contact/interface/Quadrature=nodal"
FALLBACK_OPTIONS = [NODAL, "Load stepping/Minimum step=0.01", "Load stepping/Requested times=3", "Algorithm/Newton/Max iterations=4"]
# Nine iterations, with those of a solve that is on its way, are enough for short steps; six count as easy.
CUT_OPTIONS = [NODAL, "Load stepping/Minimum step=0.01", "Load stepping/Requested times=3", "Algorithm/Newton/Max iterations=6",
               "Load stepping/Easy iterations=6", "Algorithm/Name=GNM",
               "Boundary conditions/drag/Value=1.8*max(min(t, 2.6)-1, 0) - 3.6*max(t-4, 0); -0.02*min(t, 1) - 0.02*max(t-3, 0)"]
SHORT = ["Load stepping/End time=3"]


def test_partitions(runs):
    metis, p4est = (["Mesh/Partitioner=" + name] for name in ("METIS", "p4est"))
    expected = runs.run("uninterrupted")
    runs.run("half-2", 2, options=["Load stepping/End time=3"] + p4est)
    runs.run("half-4-metis", 4, options=["Load stepping/End time=3"] + metis)
    for half, n_ranks, options in [("half-2", 1, []), ("half-2", 2, p4est), ("half-2", 4, metis), ("half-4-metis", 2, p4est),
                                   ("half-4-metis", 3, metis), ("half-4-metis", 4, metis), ("half-4-metis", 2, [])]:
        name = "-".join(["from", half, "on", str(n_ranks), *(option.split("=")[1] for option in options)])
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


def test_simplices(runs):
    """Triangles of degree 2, with plastic flow and friction."""
    options = ["Degree=2", *(f"Bodies/{body}/Simplices=true" for body in ("lower", "upper", "metal"))]
    printed = runs.run("simplices", 1, options=options + SHORT)
    for n_ranks, other in [(2, 1), (1, 4)]:
        name = f"simplices-{n_ranks}-{other}"
        runs.run(name, n_ranks, options=options + ["Load stepping/End time=2"])
        check(runs.run(name, other, "latest", options + SHORT) == printed, f"{name} prints the same")
        compare(runs, name, "simplices", n_nodes=6)


def test_mixed_cells(runs):
    """Quadrilaterals slide over triangles, beside triangles in plastic flow."""
    options = ["Degree=2", *(f"Bodies/{body}/Simplices=true" for body in ("lower", "metal"))]
    printed = runs.run("mixed-cells", 1, options=options + SHORT)
    for n_ranks, other in [(2, 3), (3, 1)]:
        name = f"mixed-cells-{n_ranks}-{other}"
        runs.run(name, n_ranks, options=options + ["Load stepping/End time=2"])
        check(runs.run(name, other, "latest", options + SHORT) == printed, f"{name} prints the same")
        # the cells of the lower body come first, 13 * 4 * 8 triangles, then the upper one's 6 * 3 quadrilaterals
        compare(runs, name, "mixed-cells", n_nodes=lambda cell: 9 if 0 <= cell[0] - 416 < 18 else 6)


def test_ties(runs):
    """Partners are those of the undeformed bodies, not those of the state."""
    options = [f"Contact/interface/{name}" for name in ("Law=tied", "Friction=none", "Friction coefficient=0")]
    printed = runs.run("tied", 1, options=options + SHORT)
    for n_ranks, other in [(2, 1), (1, 2)]:
        name = f"tied-{n_ranks}-{other}"
        runs.run(name, n_ranks, options=options + ["Load stepping/End time=2"])
        check(runs.run(name, other, "latest", options + SHORT) == printed, f"{name} prints the same")
        compare(runs, name, "tied")


def test_tools(runs):
    """A block is dragged over a round tool without facets that turns; with the default rule and with points."""
    tool = ["Bodies/lower/Generator=tool_circle", "Bodies/lower/Arguments=1.25, -9 : 10", "Contact/interface/Master boundary=all",
            *(f"Boundary conditions/foundation/{text}" for text in (
                "Type=rigid motion", "Boundary=", "Value=", "Rotation angle=2*max(t-1, 0)", "Rotation centre=1.25, -9"))]
    for rule in "segments", "Gauss":
        options = [*tool, f"Contact/interface/Quadrature={rule}"]
        printed = runs.run(f"tool-{rule}", 1, options=options + SHORT)
        for n_ranks, other in [(2, 1), (1, 2)]:
            name = f"tool-{rule}-{n_ranks}-{other}"
            runs.run(name, n_ranks, options=options + ["Load stepping/End time=2"])
            check(runs.run(name, other, "latest", options + SHORT) == printed, f"{name} prints the same")
            compare(runs, name, f"tool-{rule}")


def test_reference_points(runs):
    """A boundary that a force drives and that may tilt: where it is follows from the displacements."""
    options = [f"Boundary conditions/drag/{text}" for text in (
        "Type=rigid motion", "Value=", "Translation=free; free", "Rotation angle=free", "Rotation centre=1.4, 1.8",
        "Force=0.58*max(t-1, 0); -4*min(t, 1)")]
    printed = runs.run("driven", 1, options=options + SHORT)
    for n_ranks, other in [(2, 1), (1, 2)]:
        name = f"driven-{n_ranks}-{other}"
        runs.run(name, n_ranks, options=options + ["Load stepping/End time=2"])
        check(runs.run(name, other, "latest", options + SHORT) == printed, f"{name} prints the same")
        # not the checkpoints: slip of points that stick is roundoff, and nothing there says of what size
        differences = differences_of_tables(runs.directory / "driven", runs.directory / name)
        check(not differences, f"{name} has the tables of driven {differences[:3]}")


BOLT = """include case.prm
subsection Bodies
  subsection cap
    set Generator = subdivided_hyper_rectangle
    set Arguments = 4, 2 : 5, 1 : 6, 2 : true
    set Material  = soft
  end
end
subsection Boundary conditions
  subsection stamp
    set Body = cap
  end
  subsection bolt
    set Type            = pretension
    set Body            = metal
    set Boundary        = 3
    set Second body     = cap
    set Second boundary = 2
    set Force           = 0.8*t
    set Locked from     = 2.5
  end
end
"""


def test_pretension(runs):
    """A bolt of a plastic and an elastic part: the shortening that is kept follows from the displacements."""
    (runs.directory / "bolt.prm").write_text(BOLT)
    printed = runs.run("bolt", 1, options=SHORT, case="bolt.prm")
    for half, n_ranks, other in [(2, 2, 1), (2, 1, 2), (2.5, 1, 2), (2.5, 2, 1)]:
        name = f"bolt-{half}-{n_ranks}-{other}"
        runs.run(name, n_ranks, options=[f"Load stepping/End time={half}"], case="bolt.prm")
        check(runs.run(name, other, "latest", SHORT, case="bolt.prm") == printed, f"{name} prints the same")
        compare(runs, name, "bolt")


def test_axisymmetric(runs):
    """Bodies of revolution: a ring is pressed on a disc, widened and let go, with friction; another one is in plastic flow."""
    options = ["Axisymmetric=true", "Load stepping/Minimum step=0.01", "Load stepping/Requested times=3",
               "Boundary conditions/drag/Value=0.1*max(t-1, 0) - 0.2*max(t-4, 0); -0.02*min(t, 1)"]
    printed = runs.run("revolution", 1, options=options)
    row = rows_of(runs.directory / "revolution/statistics.csv")[-1]
    check(float(row["friction_work"]) > 0, f"the ring slips: friction dissipates {row['friction_work']}")
    for n_ranks, other in [(2, 1), (1, 2)]:
        name = f"revolution-{n_ranks}-{other}"
        runs.run(name, n_ranks, options=options + SHORT)
        check(runs.run(name, other, "latest", options) == printed, f"{name} prints the same")
        # slip of points that stick is roundoff, and nothing there says of what size
        compare(runs, name, "revolution", only_nodal=True)
    text = runs.run("revolution-plane", 1, "revolution-2-1", exit_code=1)
    check("of another case" in text and "axisymmetric" in text, f"a plane case cannot go on from bodies of revolution: {text.strip()[:200]}")


def test_adapted(runs):
    """Meshes that are adapted before and after the interruption, with friction; the same cells on all numbers of ranks."""
    options = ["Adaptation/Estimator=Kelly", "Adaptation/Most levels=2", "Adaptation/Error target=0.15"]
    half = ["Load stepping/End time=2"]
    printed = runs.run("adapted", 1, options=options + SHORT)
    rows = rows_of(runs.directory / "adapted/statistics.csv")
    cells = [int(float(row["cells"])) for row in rows]
    check(cells[0] == cells[1] < cells[2], f"the mesh is adapted at the start and in the second half: {cells} cells")
    for n_ranks, other in [(1, 1), (2, 1), (1, 2), (2, 4)]:
        name = f"adapted-{n_ranks}-{other}"
        runs.run(name, n_ranks, options=options + half)
        check(runs.run(name, other, "latest", options + SHORT) == printed, f"{name} prints the same")
        compare(runs, name, "adapted")
    # an estimate that slips of the last step decide about is not made again
    options = ["Adaptation/Estimator=contact edge", "Adaptation/Most levels=2", "Adaptation/Distance=0.05"]
    printed = runs.run("edges", 1, options=options + SHORT)
    for n_ranks, other in [(1, 2), (2, 1)]:
        name = f"edges-{n_ranks}-{other}"
        runs.run(name, n_ranks, options=options + half)
        check(runs.run(name, other, "latest", options + SHORT) == printed, f"{name} prints the same")
        compare(runs, name, "edges")
    # interrupted before the first step that is solved again on finer meshes, the third; its checks are of later steps
    case = str(pathlib.Path(__file__).resolve().parent / "application" / "adapted_tool.prm")
    printed = runs.run("approach", 1, case=case)
    runs.run("approach-2", 2, options=["Load stepping/End time=0.4", "Load stepping/Requested times="], exit_code=4, case=case)
    check(runs.run("approach-2", 1, "latest", case=case) == printed, "approach-2 prints the same")
    cells = [[row["cells"] for row in rows_of(runs.directory / name / "statistics.csv")] for name in ("approach", "approach-2")]
    check(cells[0] == cells[1], f"approach-2 has the same meshes: {cells}")
    runs.run("not-adapted", 2, "adapted-1-1")
    cells = len(rows_of(runs.directory / "not-adapted/statistics.csv"))
    check(cells > 0, "an adapted state goes on without adaptation")
    text = runs.run("adapted-metis", 2, "adapted-1-1", ["Mesh/Partitioner=METIS"], exit_code=1)
    check("adapted mesh" in text and "p4est" in text, f"METIS cannot take an adapted mesh: {text.strip()[:200]}")


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
    """The same sizes of steps. At 2 growth waits after cuts, at 2.625 a step has grown, after 3 one is cut."""
    whole = compare_decisions(runs, "cuts", CUT_OPTIONS, [2, 2.625, 3])
    times = [0.] + [float(row[0]) for row in whole]
    sizes = [after - before for before, after in zip(times, times[1:])]
    n = times.index(3.)
    for half, steps in (("first", range(1, n)), ("second", range(n + 1, len(sizes)))):
        check(any(sizes[i] > 1.1 * sizes[i - 1] for i in steps), f"steps have grown in the {half} half")
    for half, rows in (("first", whole[:n]), ("second", whole[n:])):
        check(any(int(row[3]) > 0 for row in rows), f"steps were cut in the {half} half")


def test_failed_run(runs):
    runs.run("failed", 2, options=["Load stepping/End time=2", "Output/Checkpoint every n steps=0",
                                "Output/Checkpoint at the end=false"])
    check(not (runs.directory / "failed/checkpoint.latest").exists(), "no checkpoints if they are switched off")
    runs.run("failed", 2, options=["Load stepping/End time=2", "Output/Checkpoint every n steps=0"])
    check((runs.directory / "failed/checkpoint.latest").exists(), "a checkpoint at the end")
    shutil.rmtree(runs.directory / "failed")
    runs.run("failed", 2, options=["Load stepping/End time=2"])
    before = (runs.directory / "failed/checkpoint.latest").read_text()
    text = runs.run("failed", 2, "latest", ["Algorithm/Newton/Max iterations=1"], exit_code=2)
    check("--restart latest" in text, "a run that fails says how to continue")
    check((runs.directory / "failed/checkpoint.latest").read_text() != before, "... and writes a checkpoint")
    runs.run("failed", 1, "latest")
    compare(runs, "failed")
    shutil.copytree(runs.directory / "failed", runs.directory / "run anew")
    runs.run("run anew", 1, options=["Load stepping/End time=2", "Output/Checkpoint every n steps=0",
                                     "Output/Checkpoint at the end=false"])
    text = runs.run("run anew", 1, "latest", exit_code=1)
    check("There is 'run anew/checkpoint-" in text and "of an earlier time or run" in text,
          "a new run does not pass an old checkpoint off as its own")


def test_directory(runs):
    """No file of an earlier run passes for one of this run."""
    fields = ["Output/Every n steps=1"]
    directory = runs.directory / "directory"

    def steps_of(pattern):
        names = (re.search(r"-(\d{4})\.", path.name) for path in directory.glob(pattern))
        return sorted({int(name[1]) for name in names if name})

    def index():
        return [int(step) for step in re.findall(r'file="solution-(\d+).pvtu"', (directory / "solution.pvd").read_text())]

    runs.run("directory", 2, options=fields + ["Load stepping/End time=4", "Output/Contact points=true"])
    check(index() == steps_of("solution-*") == steps_of("contact_points-*") == [1, 2, 3, 4], "four steps are there")
    (directory / "solution-of-mine.vtu").write_text("")
    runs.run("directory", 1, options=fields + ["Load stepping/End time=2", "Output/Format=hdf5"])
    check(steps_of("solution-*.h5") == [1, 2] and not steps_of("*.*vtu") and not steps_of("contact_points-*")
          and not (directory / "solution.pvd").exists(), "a new run removes the files of a longer one, also of another format")
    check((directory / "solution-of-mine.vtu").exists(), "... but no others")

    runs.run("directory", 2, options=fields + ["Load stepping/End time=4"])
    latest = (directory / "checkpoint.latest").read_text().strip()
    older = {"checkpoint-a": "checkpoint-b", "checkpoint-b": "checkpoint-a"}[latest]
    runs.run("directory", 2, "directory/" + older, fields + ["Load stepping/End time=3", "Output/Checkpoint every n steps=0",
                                                              "Output/Checkpoint at the end=false"])
    check(index() == steps_of("solution-*") == [1, 2, 3], f"a run that goes on from step 3 drops step 4: {index()}")
    check((directory / "checkpoint.latest").read_text().strip() == older, "the checkpoint that it goes on from is the latest")
    record = (directory / "parameters.prm").read_text().splitlines()
    check(re.fullmatch(r"# stickslip [0-9.]+ \(.*\), 2 ranks", record[0]), f"parameters.prm begins with '{record[0]}'")
    (runs.directory / "again.prm").write_text("\n".join(record))
    first = runs.run("directory", 2, options=["Load stepping/End time=3"])
    again = runs.run("again", 2, case="again.prm", options=["Output/Checkpoint every n steps=1"])
    check(first == again and "interface.force_x" in again, "parameters.prm is the case")


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
    description.write_text(text.replace("stickslip checkpoint 9", "stickslip checkpoint 8", 1))
    refused("an older format", "half-2", ["another version", "format is 8", "reads format 9"])
    description.write_text(text)
    (runs.directory / file).write_bytes(data)
    (runs.directory / file).unlink()
    refused("a file lost", "half-2", ["damaged", file])
    runs.run("from the one before", 2, f"half-2/{other}")
    check(not differences_of_checkpoints(runs.directory / "uninterrupted", runs.directory / "from the one before"),
          "the checkpoint before the damaged one leads to the same end")


def main():
    runs = Runs(sys.argv[1], pathlib.Path(sys.argv[2]))
    for test in (test_partitions, test_simplices, test_mixed_cells, test_ties, test_tools, test_reference_points, test_pretension, test_axisymmetric, test_adapted, test_path_dependence, test_algorithms, test_fallback, test_cuts_and_growth,
                 test_failed_run, test_directory, test_refused):
        test(runs)
    print(f"{len(failures)} comparisons failed")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
