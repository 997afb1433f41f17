#!/usr/bin/env python3
"""Runs small studies: what is run, what is not run again, tables, plots, Slurm.

    study_test.py PROGRAM SOURCE_DIRECTORY WORKING_DIRECTORY
"""
import os
import pathlib
import signal
import subprocess
import sys
import time

from browser import browser, errors_of, render
from program_runs import fresh_directory, rows_of, settings, start

STUDY = """
title = "Friction and algorithm"
case  = "{case}"

[fixed]
"Output/Every n steps" = 100
"Load stepping/End time" = 1
"Load stepping/Minimum step" = 0.2

[grid]
"Algorithm/Name" = ["GNM", "FPM"]
"Contact/interface/Friction coefficient" = [0.1, 3e-1]

[[runs]]
"label push" = "gentle"
[[runs]]
"label push" = "crushing"
"Boundary conditions/hand/Value" = "0; -20*t"

[collect]
press = "last resultants.csv interface.force_y"
most  = "max resultants.csv interface.max_pressure"
work  = "last statistics.csv external_work"

[[plots]]
file   = "curve.png"
x      = "Friction coefficient"
y      = "most"
curves = "Name"
panels = "push"

[[plots]]
x     = "Friction coefficient"
y     = "Name"
value = "newton_iterations"
panels = "push"
"""
failures = []


def check(holds, what):
    print(("passed  " if holds else "FAILED  ") + what, flush=True)
    if not holds:
        failures.append(what)


def study(*arguments, **options):
    return subprocess.run([str(script), *map(str, arguments)], capture_output=True, text=True,
                          env={**os.environ, "STICKSLIP": program}, **options)


def records(output):
    """{label: time of its record} of the runs that are over."""
    return {path.parent.name: path.stat().st_mtime_ns for path in pathlib.Path(output).glob("*/study.json")}


def test_grid():
    pathlib.Path("grid.toml").write_text(STUDY.format(case=case))
    result = study("grid.toml")
    check(result.returncode == 0, f"grid: exit code {result.returncode} {result.stderr.strip()[-300:]}")
    rows = rows_of("results/grid/study.csv")
    check(len(rows) == 8, f"grid: {len(rows)} rows of 2 x 2 x 2 runs")
    gentle = [row for row in rows if row["push"] == "gentle"]
    crushing = [row for row in rows if row["push"] == "crushing"]
    check(all(row["state"] == "done" for row in gentle), "grid: the gentle push is done")
    check(all(row["state"] == "no convergence" and row["exit_code"] == "2" for row in crushing), "grid: the crushing one is marked as failed")
    check([(row["Name"], row["Friction coefficient"]) for row in gentle] ==
          [("GNM", "0.1"), ("GNM", "3e-1"), ("FPM", "0.1"), ("FPM", "3e-1")], "grid: values as they are in the file")

    # against a run made by hand
    start(program, [str(case), "--output-directory", "by hand", "--quiet", *settings(
        {"Load stepping/End time": 1, "Algorithm/Name": "FPM", "Contact/interface/Friction coefficient": 0.3})])
    resultants, statistics = rows_of("by hand/resultants.csv"), rows_of("by hand/statistics.csv")
    expected = {"press": float(resultants[-1]["interface.force_y"]),
                "most": max(float(row["interface.max_pressure"]) for row in resultants),
                "work": float(statistics[-1]["external_work"]), "load_steps": len(statistics),
                "newton_iterations": sum(int(row["newton_iterations"]) for row in statistics),
                "threshold_loops": sum(int(row["threshold_loops"]) for row in statistics)}
    for name, value in expected.items():
        check(abs(float(gentle[3][name]) - value) <= 1e-9 * abs(value), f"grid: {name} {gentle[3][name]} is {value}")
    for name in ("curve.png", "plot-2.png"):
        check(pathlib.Path("results/grid", name).stat().st_size > 5000, f"grid: {name}")
    page = pathlib.Path("results/grid/study.html").read_text()
    check(page.count("<td>no convergence</td>") == 8 and "<th>cause</th>" in page, "grid: the page says what has not succeeded")
    if browser() is None:
        print("skipped the page in a browser: there is no chromium")
    else:
        check(not errors_of(render("results/grid/study.html")), "grid: the page has no errors in a browser")


def test_going_on():
    before = records("results/grid")
    result = study("grid.toml")
    check(result.returncode == 0 and records("results/grid") == before, "again: nothing is run again, failed runs included")

    study("grid.toml", "--retry")
    after = records("results/grid")
    again = {label for label in before if before[label] != after[label]}
    check(len(again) == 4 and all("crushing" in label for label in again), f"--retry: what has failed: {sorted(again)}")

    text = pathlib.Path("grid.toml").read_text()
    pathlib.Path("grid.toml").write_text(text.replace('["GNM", "FPM"]', '["GNM", "FPM", "PNM"]').replace(
        '[[runs]]\n"label push" = "crushing"\n"Boundary conditions/hand/Value" = "0; -20*t"\n', ""))
    study("grid.toml")
    new = records("results/grid")
    check(set(new) - set(after) == {"push=gentle,Name=PNM,Friction_coefficient=0.1", "push=gentle,Name=PNM,Friction_coefficient=3e-1"}
          and all(new[label] == after[label] for label in after), "a value more: only its runs")
    pathlib.Path("grid.toml").write_text(pathlib.Path("grid.toml").read_text().replace('time" = 1', 'time" = 1.2'))
    study("grid.toml")
    check(all(new[label] != value for label, value in records("results/grid").items() if "gentle" in label),
          "another fixed value: all of it again")


def test_interruption():
    pathlib.Path("long.toml").write_text(f'case = "{case}"\n[grid]\n"Contact/interface/Friction coefficient" = '
                                         "[0.1, 0.12, 0.14, 0.16, 0.18, 0.2]\n")
    process = subprocess.Popen([str(script), "long.toml", "--jobs", "1"], start_new_session=True,
                               stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env={**os.environ, "STICKSLIP": program})
    deadline = time.time() + 120
    while not records("results/long") and process.poll() is None and time.time() < deadline:
        time.sleep(0.05)
    os.killpg(process.pid, signal.SIGTERM)  # as a batch system does, and Ctrl-C with another signal
    errors = process.communicate()[1]
    done = records("results/long")
    check(process.returncode == 1 and "interrupted" in errors and "Traceback" not in errors, f"interrupted: {errors.strip()[-200:]}")
    check(0 < len(done) < 6, f"interrupted: {len(done)} of 6 runs are done")
    result = study("long.toml")
    after = records("results/long")
    check(result.returncode == 0 and len(after) == 6 and all(after[label] == done[label] for label in done),
          "the same command goes on with the rest")
    check(all(row["state"] == "done" for row in rows_of("results/long/study.csv")), "... and all is done")


def test_slurm():
    pathlib.Path("array.toml").write_text(f'case = "{case}"\n[fixed]\n"Load stepping/End time" = 1\n[grid]\n"Degree" = [1, 2]\n')
    result = study("array.toml", "--slurm")
    job = pathlib.Path("results/array/study.slurm")
    check(result.returncode == 0 and job.exists(), f"--slurm: {result.stdout.strip()}{result.stderr.strip()}")
    check(subprocess.run(["bash", "-n", str(job)]).returncode == 0, "--slurm: a shell reads the script")
    text = job.read_text()
    check("#SBATCH --array=0-1\n" in text and text.index("#SBATCH --ntasks=1") < text.index("labels="), "--slurm: the array has two jobs")
    for task in ("0", "1"):
        result = subprocess.run(["bash", str(job)], capture_output=True, text=True, env={**os.environ, "SLURM_ARRAY_TASK_ID": task})
        check(result.returncode == 0, f"--slurm: job {task} {result.stdout.strip()}{result.stderr.strip()}")
    study("array.toml", "--collect")
    check([row["state"] for row in rows_of("results/array/study.csv")] == ["done", "done"], "--slurm: its runs are collected")
    result = study("array.toml", "--slurm")
    check(result.returncode == 1 and "nothing is left" in result.stderr, "--slurm: nothing is left to run")


def test_shipped():
    """The studies that come with the program are valid; the map has the runs of the figure."""
    for path in sorted((source / "parameters" / "studies").glob("*.toml")):
        result = study(path, "--list", "--output", "shipped")
        check(result.returncode == 0 and result.stdout.count("not run") >= 8, f"{path.name}: {len(result.stdout.splitlines())} runs")


def test_refused():
    grid = '[grid]\n"Degree" = [1, 2]\n'
    begin = f'case = "{case}"\n'
    for name, text, words in [
            ("no TOML", "case = \n", "no TOML"), ("no case", grid, "names no 'case'"), ("no such case", 'case = "x.prm"\n' + grid, "x.prm"),
            ("nothing varies", begin, "nothing varies"), ("unknown key", begin + "[gird]\n", "Did you mean 'grid'?"),
            ("no list", begin + '[grid]\n"Degree" = 1\n', "a list of values is needed"),
            ("twice", begin + '[grid]\n"Degree" = [1, 1]\n', "two runs are called"),
            ("fixed and varied", begin + '[fixed]\n"Degree" = 1\n' + grid, "fixed and varied"),
            ("collect", begin + grid + '[collect]\nu = "points.csv A"\n', "not of the form"),
            ("plot", begin + grid + '[[plots]]\nx = "Degree"\ny = "height"\n', "'height' is no column"),
            ("parameter", begin + '[grid]\n"Contact/interface/Frction" = ["none"]\n', "Did you mean 'Friction'?"),
            ("value", begin + '[grid]\n"Degree" = [1, 0]\n', "Degree"),
            ("column", begin + '[fixed]\n"Load stepping/End time" = 1\n' + grid + '[collect]\nu = "last points.csv A"\n', "has no column 'A'")]:
        pathlib.Path("bad.toml").write_text(text)
        result = study("bad.toml", "--output", "bad")
        check(result.returncode == 1 and words in result.stderr and "Traceback" not in result.stderr,
              f"{name}: {result.stderr.strip()[-160:]}")
    result = study("nowhere.toml")
    check(result.returncode == 1 and "cannot be read" in result.stderr, f"no file: {result.stderr.strip()}")
    result = study("array.toml", "--run", "Degree=7")
    check(result.returncode == 1 and "there is no run" in result.stderr, f"no run: {result.stderr.strip()}")


program, source = os.path.abspath(sys.argv[1]), pathlib.Path(sys.argv[2]).resolve()
script, case = source / "scripts" / "study", source / "parameters" / "two_blocks.prm"
os.chdir(fresh_directory(sys.argv[3]))
for test in (test_grid, test_going_on, test_interruption, test_slurm, test_shipped, test_refused):
    test()
print(f"{len(failures)} checks failed")
sys.exit(1 if failures else 0)
