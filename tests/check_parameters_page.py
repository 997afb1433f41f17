#!/usr/bin/env python3
"""Holds doc/parameters.md against the program.

    check_parameters_page.py PROGRAM PAGE             exit code 1 if they differ
    check_parameters_page.py PROGRAM PAGE --renew     writes the page

The page is what `stickslip --print-parameters markdown` prints, nothing else. The other ways to print the parameters
are held against each other, too: expert parameters are in all but the one for users, and what is allowed is in words.
"""
import difflib
import json
import pathlib
import re
import subprocess
import sys


def print_parameters(program, *options):
    command = [program, "--print-parameters", *options]
    run = subprocess.run(command, capture_output=True, text=True)
    if run.returncode != 0 or not run.stdout:
        sys.exit(f"{' '.join(command)} failed (exit code {run.returncode}): {run.stderr}")
    return run.stdout


def declared_parameters(section, path=""):
    """path -> description, from the JSON of --print-parameters."""
    result = {}
    for name, content in section.items():
        if isinstance(content.get("documentation"), str):
            result[f"{path}/{name}"] = content
        else:
            result.update(declared_parameters(content, f"{path}/{name}"))
    return result


def parameters_of_file(text):
    """The paths of what a .prm sets."""
    path, result = [], set()
    for line in map(str.strip, text.splitlines()):
        if line.startswith("subsection "):
            path.append(line[len("subsection "):])
        elif line == "end":
            path.pop()
        elif setting := re.match(r"set (.*?) =", line):
            result.add("".join(f"/{name}" for name in [*path, setting[1]]))
    return result


def check_formats(program):
    """Returns a list of complaints."""
    declared = declared_parameters(json.loads(print_parameters(program, "json")))
    experts = {path for path, parameter in declared.items() if parameter["expert"]}
    n = len({path.split("/")[-1] for path in set(declared) - experts}), len({path.split("/")[-1] for path in experts})
    print(f"{n[0]} names of parameters for users, {n[1]} for experts")
    faults = [f"{path}: allowed is not in words: {parameter['allowed']}"
              for path, parameter in declared.items() if parameter["allowed"].startswith("[")]
    faults += [f"{path}: the mark of experts is in the text"
               for path, parameter in declared.items() if "[expert" in parameter["documentation"]]
    for name, expected in (("prm", set(declared) - experts), ("all", set(declared))):
        printed = parameters_of_file(print_parameters(program, name))
        faults += [f"{path}: {'not ' if path in expected else ''}printed by --print-parameters {name}"
                   for path in sorted(expected ^ printed)]
    if not experts:
        faults.append("no parameter is for experts")
    return faults


def main():
    if len(sys.argv) not in (3, 4) or sys.argv[3:] not in ([], ["--renew"]):
        sys.exit(__doc__)
    program, page = sys.argv[1], pathlib.Path(sys.argv[2])
    text = print_parameters(program, "markdown")
    if sys.argv[3:]:
        page.write_text(text)
        return
    if faults := check_formats(program):
        sys.exit("\n".join(faults))
    written = page.read_text() if page.exists() else ""
    if written == text:
        print(f"{page.name} is current")
        return
    sys.stdout.writelines(
        difflib.unified_diff(
            written.splitlines(keepends=True), text.splitlines(keepends=True), str(page), "the program", n=0
        )
    )
    sys.exit(f"{page} is not what the program says. Renew it:\n  {program} --print-parameters markdown > {page}")


if __name__ == "__main__":
    main()
