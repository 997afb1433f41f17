#!/usr/bin/env python3
"""Builds the manual, without warnings, and looks at its pages.

    manual_test.py SOURCE_DIRECTORY WORKING_DIRECTORY

All pages have to be there, need nothing of the network, and show their formulas
in a headless Chromium, if it is installed (it says so if not).
"""
import pathlib
import re
import subprocess
import sys

from browser import browser, errors_of, load
from program_runs import fresh_directory

failures = []


def check(holds, what):
    print(("passed  " if holds else "FAILED  ") + what, flush=True)
    if not holds:
        failures.append(what)


def check_pages(source, html):
    for page in [*source.glob("doc/*.md"), source / "README.md", source / "tests" / "README.md"]:
        check((html / page.relative_to(source)).with_suffix(".html").exists(), f"{page.relative_to(source)} is a page")
    check((html / "doc" / "api" / "classstickslip_1_1ConstitutiveLaw.html").exists(), "the classes have their pages")
    developers = re.sub("<[^>]*>", "", (html / "doc" / "developers.html").read_text())
    check("BlatzKo" in developers and "ContactRule::Gauss" in developers, "the tutorials show their code")
    loaded = re.compile(r'<(?:script|img|iframe)[^>]*\ssrc="(https?:[^"]*)|<link[^>]*rel="stylesheet"[^>]*href="(https?:[^"]*)')
    foreign = {address for page in html.rglob("*.html") for match in loaded.findall(page.read_text(errors="replace")) for address in match if address}
    check(not foreign, f"no page loads anything from the network {sorted(foreign)[:3] or ''}")
    missing = {f"{page.relative_to(html)}: {target}" for page in (html / "doc").glob("*.html")
               for target in re.findall(r'<(?:script|img)[^>]*\ssrc="([^":?#]+)', page.read_text())
               if not (page.parent / target).exists()}
    check(not missing, f"pictures and scripts are there {sorted(missing)[:3] or ''}")


def check_formulas(html):
    if browser() is None:
        print("skipped formulas in a browser: no chromium (apt-get install chromium)")
        return
    page = html / "doc" / "theory.html"
    n_formulas = len(re.findall(r'class="math', page.read_text()))
    rendered = load(page)
    n_typeset = len(re.findall(r'<svg[^>]*role="img"', rendered.document))
    check(n_formulas > 100 and n_typeset >= n_formulas, f"{n_typeset} formulas typeset of {n_formulas}")
    check(not re.search('class="(merror|MathJax_Error)|Math Processing Error', rendered.document), "none with an error")
    check(not errors_of(rendered), f"no errors of scripts {errors_of(rendered)[:2] or ''}")


def main():
    source, directory = pathlib.Path(sys.argv[1]), fresh_directory(sys.argv[2])
    result = subprocess.run([source / "scripts" / "manual", "--output", directory], capture_output=True, text=True)
    print(result.stdout)
    check(result.returncode == 0, f"scripts/manual, without warnings {result.stderr[-2000:]}")
    if result.returncode == 0:
        check_pages(source, directory / "html")
        check_formulas(directory / "html")
    sys.exit(1 if failures else 0)


main()
