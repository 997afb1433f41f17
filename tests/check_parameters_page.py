#!/usr/bin/env python3
"""Holds doc/parameters.md against the program.

    check_parameters_page.py PROGRAM PAGE             exit code 1 if they differ
    check_parameters_page.py PROGRAM PAGE --renew     writes the page

The page is what `stickslip --print-parameters markdown` prints, nothing else.
"""
import difflib
import pathlib
import subprocess
import sys


def main():
    if len(sys.argv) not in (3, 4) or sys.argv[3:] not in ([], ["--renew"]):
        sys.exit(__doc__)
    program, page = sys.argv[1], pathlib.Path(sys.argv[2])
    command = [program, "--print-parameters", "markdown"]
    run = subprocess.run(command, capture_output=True, text=True)
    if run.returncode != 0 or not run.stdout:
        sys.exit(f"{' '.join(command)} failed (exit code {run.returncode}): {run.stderr}")
    if sys.argv[3:]:
        page.write_text(run.stdout)
        return
    written = page.read_text() if page.exists() else ""
    if written == run.stdout:
        print(f"{page.name} is current")
        return
    sys.stdout.writelines(
        difflib.unified_diff(
            written.splitlines(keepends=True), run.stdout.splitlines(keepends=True), str(page), "the program", n=0
        )
    )
    sys.exit(f"{page} is not what the program says. Renew it:\n  {' '.join(command)} > {page}")


if __name__ == "__main__":
    main()
