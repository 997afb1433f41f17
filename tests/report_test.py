#!/usr/bin/env python3
"""Builds pages of small runs and looks at them, also with a browser if there is one.

    report_test.py PROGRAM SOURCE_DIRECTORY WORKING_DIRECTORY

Numbers of a page have to be those of the tables; every section has to be there; a
page must need nothing beside itself; wrong input gets one message and exit code 1.
"""
import html
import os
import pathlib
import re
import subprocess
import sys

from browser import browser, errors_of, render
from program_runs import fresh_directory, rows_of, settings, start

SECTIONS = ["Summary", "The case", "Pictures", "Forces, work, contact", "Convergence", "Time", "Files and versions"]
failures = []


def check(holds, what):
    print(("passed  " if holds else "FAILED  ") + what, flush=True)
    if not holds:
        failures.append(what)


def run_case(directory, overrides, exit_code=0):
    result = start(program, [str(case), "--output-directory", directory, "--quiet", *settings(overrides)])
    check(result.returncode == exit_code, f"{directory}: exit code {result.returncode} {result.stderr.strip()[:200]}")


def script(name, *arguments):
    return subprocess.run([str(source / "scripts" / name), *map(str, arguments)], capture_output=True, text=True)


def report(*arguments):
    result = script("report", *arguments)
    check(result.returncode == 0, f"report {' '.join(map(str, arguments))}: {result.stderr.strip()[-300:]}")
    if result.returncode != 0:
        sys.exit("Without this page there is nothing to look at.")
    return pathlib.Path(arguments[arguments.index("--output") + 1]).read_text()


def table_of(page, identifier):
    """{first cell: other cells} of a table of the page."""
    text = re.search(rf'<table id="{identifier}">(.*?)</table>', page, re.DOTALL)[1]
    rows = [[html.unescape(cell) for cell in re.findall(r"<t[dh][^>]*>(.*?)</t[dh]>", row)] for row in re.findall(r"<tr>(.*?)</tr>", text)]
    return {row[0]: row[1:] for row in rows}


def check_numbers(page, column, directory):
    """The summary against statistics.csv, resultants.csv and points.csv."""
    summary = table_of(page, "summary-table")
    statistics, resultants = rows_of(f"{directory}/statistics.csv"), rows_of(f"{directory}/resultants.csv")
    expected = {
        "load steps": len(statistics),
        "last time": float(statistics[-1]["time"]),
        "Newton iterations": sum(int(row["newton_iterations"]) for row in statistics),
        "linear iterations": sum(int(row["linear_iterations"]) for row in statistics),
        "work dissipated by friction": float(statistics[-1]["friction_work"]),
        "work of loads and supports": float(statistics[-1]["external_work"]),
        "largest contact pressure": max(float(row["interface.max_pressure"]) for row in resultants),
        "interface.force_x at the end": float(resultants[-1]["interface.force_x"]),
        "corner_y at the end": float(rows_of(f"{directory}/points.csv")[-1]["corner_y"]),
    }
    for name, value in expected.items():
        found = float(summary[name][column])
        check(abs(found - value) <= 1e-5 * abs(value), f"{directory}: {name} {found} is {value:.6g}")


def check_document(page, name, sections=SECTIONS):
    for section in sections:
        check(f">{section}</h2>" in page, f"{name}: section '{section}'")
    addresses = re.findall(r'(?:src|href)="([^"]*)"', page)
    check(all(address.startswith(("data:", "#")) for address in addresses), f"{name} needs nothing beside itself")
    check(len(page) < 10e6, f"{name} is below 10 MB")


def check_in_browser(file, name, n_players):
    if browser() is None:
        print(f"skipped {name} in a browser: there is no chromium")
        return
    # the animation goes one picture on when the button is pressed at its beginning
    rendered = render(file, """
        const loaded = [...document.images].filter(image => image.complete && image.naturalWidth > 0).length;
        document.body.dataset.broken = document.images.length - loaded;
        const together = document.getElementById('together');
        if (together) together.checked = false;
        document.querySelectorAll('.player').forEach(box => {
          const slider = box.querySelector('input[type=range]'), before = box.querySelector('output').textContent;
          slider.value = 0;
          slider.dispatchEvent(new Event('input'));
          box.dataset.moved = box.querySelector('output').textContent !== before;
          box.querySelector('button').click();
          setTimeout(() => { box.dataset.played = Number(slider.value) > 0; }, 1500);
        });""")
    check(not errors_of(rendered), f"{name} in a browser: {errors_of(rendered)}")
    check(f'data-players="{n_players}"' in rendered.document, f"{name} has {n_players} animations")
    check('data-broken="0"' in rendered.document, f"{name}: the browser shows all pictures")
    for what in ("moved", "played"):
        check(rendered.document.count(f'data-{what}="true"') == n_players, f"{name}: {what} by its controls")


def test_one_run():
    run_case("one", {})
    (pathlib.Path("one") / "parameters.prm").unlink()  # as of an older version
    page = report("one", "--case", case, "--set", "Degree=1", "--output", "one.html", "--frames", 4, "--times", "1,2")
    check_document(page, "one run")
    check_numbers(page, 0, "one")
    for words in ("Two blocks with friction", "upper, boundary 2", "Coulomb, friction coefficient 0.3", "St Venant-Kirchhoff"):
        check(words in page, f"one run: the case says '{words}'")
    check(">120<" in page and ">80<" in page, "one run: cells of both bodies")
    check(page.count('class="picture"') == 2, "one run: a picture for each time")
    check_in_browser("one.html", "one run", 1)


def test_side_by_side():
    run_case("hdf5", {"Output/Format": "hdf5", "Contact/interface/Friction coefficient": 0.1})
    (pathlib.Path("one") / "parameters.prm").write_text(case.read_text())
    (pathlib.Path("hdf5") / "parameters.prm").write_text(
        case.read_text().replace("set Friction coefficient = 0.3", "set Friction coefficient = 0.1"))
    page = report("one", "hdf5", "--output", "two.html", "--frames", 4)
    check_document(page, "two runs")
    check_numbers(page, 0, "one")
    check_numbers(page, 1, "hdf5")
    differences = table_of(page, "differences")
    check(differences == {"parameter": ["one", "hdf5"], "Contact/interface/Friction coefficient": ["0.3", "0.1"]},
          f"two runs: what differs {differences}")
    check_in_browser("two.html", "two runs", 2)


def test_troubled_runs():
    run_case("trouble", {"Algorithm/Newton/Max iterations": 3, "Algorithm/Name": "GNM", "Load stepping/Minimum step": 0.05}, 2)
    page = report("trouble", "--output", "trouble.html", "--no-pictures")
    log = pathlib.Path("trouble/convergence.log").read_text()
    cause = re.findall(r"^\s+cause:\s*(.*)$", log, re.MULTILINE)[-1]
    check("Why the run stopped" in page and f"<dd>{html.escape(cause)}</dd>" in page, f"failed run: its cause '{cause}'")
    check(page.count("<td>failed</td>") == log.count("step failed:"), "failed run: all failed attempts")
    check("Contact points" in page or "contact points of the failed step" in page, "failed run: its diagnosis")
    check('class="badge stopped"' in page, "failed run: its state")

    # an interrupted run: the last row of a table is not whole, the log has no end
    pathlib.Path("part").mkdir()
    for name in ("convergence.log", "statistics.csv", "resultants.csv"):
        text = pathlib.Path("one", name).read_text()
        pathlib.Path("part", name).write_text(text[: int(0.6 * len(text))])
    page = report("part", "--output", "part.html")
    check('class="badge unfinished"' in page, "interrupted run: its state")
    n_whole = len(pathlib.Path("part/statistics.csv").read_text().splitlines()) - 2
    check(table_of(page, "summary-table")["load steps"] == [str(n_whole)], "interrupted run: whole rows only")
    check_in_browser("part.html", "interrupted run", 0)

    run_case("bodies", {"Contact/interface/Slave boundary": 1, "Contact/interface/Master boundary": 0, "Load stepping/End time": 1})
    page = report("bodies", "--case", case, "--set", "Contact/interface/Slave boundary = 1", "--output", "bodies.html", "--frames", 2)
    check("upper, boundary 1" in page, "bodies that do not touch: --set of the run")
    check_document(page, "bodies that do not touch")


def test_render():
    result = script("render", "hdf5", "hdf5.png", "--step", 3)
    check(result.returncode == 0 and "step 3, t = 0.6" in result.stdout, f"render: {result.stdout}{result.stderr}".strip())
    check(pathlib.Path("hdf5.png").stat().st_size > 20000, "render: a picture")


def test_refused():
    pathlib.Path("empty").mkdir()
    pathlib.Path("bad.prm").write_text("subsection Bodies\n")
    run_case("no name", {"Load stepping/End time": 1})
    pathlib.Path("no name/parameters.prm").unlink()  # as of an older version
    for arguments, words in [(["report", "nowhere"], "'nowhere' is not a directory"),
                             (["report", "empty"], "not the output directory of a run"),
                             (["report", "no name", "--case", "bad.prm"], "'Bodies' has no end"),
                             (["report", "no name", "--case", "no.prm"], "cannot be read"),
                             (["report", "no name", "--case", str(case), "--set", "Degree"], "not of the form"),
                             (["report", "one", "one", "--no-pictures"], "named twice"),
                             (["report", "no name", "--field", "temperature", "--frames", 0], "no field 'temperature'"),
                             (["report", "no name", "--no-pictures", "--output", "no/where.html"], "No such file"),
                             (["render", "empty", "x.png"], "not the output directory of a run"),
                             (["render", "part", "x.png"], "has no fields"),
                             (["render", "one", "x.png", "--step", 77], "no fields of step 77")]:
        result = script(*arguments)
        text = result.stderr.strip()
        check(result.returncode == 1 and words in text and "Traceback" not in text and len(text.splitlines()) == 1,
              f"{' '.join(map(str, arguments))}: {text[-200:]}")


program, source = os.path.abspath(sys.argv[1]), pathlib.Path(sys.argv[2]).resolve()
case = source / "parameters" / "two_blocks.prm"
os.chdir(fresh_directory(sys.argv[3]))
for test in (test_one_run, test_side_by_side, test_troubled_runs, test_render, test_refused):
    test()
print(f"{len(failures)} checks failed")
sys.exit(1 if failures else 0)
