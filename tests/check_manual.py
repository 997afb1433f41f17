#!/usr/bin/env python3
"""Holds the manual against examples and source.

    check_manual.py SOURCE_DIRECTORY     exit code 1 and one line per violation
    check_manual.py --self-test          shows that each rule can fail

Checked: each case of parameters/examples has an entry in doc/gallery.md (a
heading with its title, a link to its file, its picture), a small picture, and a
run in example_test.py; there are at least ten, and no picture without a case;
doc/symptoms.md has a row for each cause of failure that the program names.
"""
import pathlib
import re
import tempfile

from check_runner import run_check
from example_test import SHORTER

LARGEST_PICTURE = 100_000  # bytes
FEWEST_EXAMPLES = 10
CAUSE = re.compile(r'(?:name\s*=|FailureExplanation\s*\{|return\s*\{)\s*"([a-z][a-z ]+)(?:: )?"')


def check_example(root, case, page, runs):
    name, text = case.stem, case.read_text()
    title = re.search(r"^set Title\s*=\s*(.*)$", text, re.MULTILINE)
    if not title:
        yield f"{name}.prm has no Title"
    elif not re.search(rf"^## {re.escape(title[1].strip())}$", page, re.MULTILINE):
        yield f"doc/gallery.md has no heading '{title[1].strip()}'"
    if f"](../parameters/examples/{name}.prm)" not in page:
        yield f"doc/gallery.md has no link to {name}.prm"
    if f"](gallery/{name}.png)" not in page:
        yield f"doc/gallery.md does not show gallery/{name}.png"
    picture = root / "doc" / "gallery" / f"{name}.png"
    if not picture.exists():
        yield f"there is no picture doc/gallery/{name}.png (scripts/gallery {name})"
    elif picture.stat().st_size > LARGEST_PICTURE:
        yield f"doc/gallery/{name}.png has {picture.stat().st_size} bytes, more than {LARGEST_PICTURE}"
    if name not in runs:
        yield f"{name}.prm is not run by tests/example_test.py"


def check_gallery(root, runs):
    page = (root / "doc" / "gallery.md").read_text()
    cases = sorted((root / "parameters" / "examples").glob("*.prm"))
    names = {case.stem for case in cases}
    for case in cases:
        yield from check_example(root, case, page, runs)
    for name in sorted(set(runs) - names):
        yield f"tests/example_test.py runs {name}, which is no example"
    for picture in sorted((root / "doc" / "gallery").glob("*")):
        if picture.stem not in names:
            yield f"doc/gallery/{picture.name} is of no example"
    if len(cases) < FEWEST_EXAMPLES:
        yield f"{len(cases)} examples; there have to be {FEWEST_EXAMPLES}"


def check_symptoms(root):
    page = (root / "doc" / "symptoms.md").read_text()
    causes = {cause.strip() for file in ("failure_explanation.cc", "singular_matrix.cc")
              for cause in CAUSE.findall((root / "source" / "simulation" / file).read_text())}
    if len(causes) < 3:
        yield "no causes of failure found in source/simulation: has their layout changed?"
    for cause in sorted(causes):
        if not re.search(rf"^\| {re.escape(cause)}[ :|]", page, re.MULTILINE):
            yield f"doc/symptoms.md has no row for the cause '{cause}'"


def violations(root, runs):
    yield from check_gallery(root, runs)
    yield from check_symptoms(root)


def self_test():
    names = [f"case{i}" for i in range(FEWEST_EXAMPLES)]
    good = {f"parameters/examples/{name}.prm": f"set Title = The {name}\n" for name in names}
    good |= {f"doc/gallery/{name}.png": "png" for name in names}
    good["doc/gallery.md"] = "".join(f"## The {name}\n\n[x](../parameters/examples/{name}.prm)\n![x](gallery/{name}.png)\n" for name in names)
    good["doc/symptoms.md"] = "| wrong state | a |\n| cycle: ... | b |\n| singular matrix | c |\n"
    good["source/simulation/failure_explanation.cc"] = 'return {"wrong state", x}; explanation.name = "cycle: " + kind;\n'
    good["source/simulation/singular_matrix.cc"] = 'explanation.name = "singular matrix";\n'
    page, symptoms = good["doc/gallery.md"], good["doc/symptoms.md"]
    bad = {  # what is wrong: (changed files, None removes one; runs; a part of the message)
        "no title": ({"parameters/examples/case1.prm": "# none\n"}, names, "has no Title"),
        "no heading": ({"doc/gallery.md": page.replace("## The case2\n", "")}, names, "no heading 'The case2'"),
        "no link": ({"doc/gallery.md": page.replace("examples/case2.prm", "x")}, names, "no link to case2.prm"),
        "not shown": ({"doc/gallery.md": page.replace("gallery/case2.png", "x")}, names, "does not show gallery/case2.png"),
        "no picture": ({"doc/gallery/case3.png": None}, names, "no picture doc/gallery/case3.png"),
        "large picture": ({"doc/gallery/case3.png": "x" * (LARGEST_PICTURE + 1)}, names, "more than"),
        "no run": ({}, names[1:], "case0.prm is not run"),
        "run of nothing": ({}, [*names, "gone"], "runs gone, which is no example"),
        "picture of nothing": ({"doc/gallery/gone.png": ""}, names, "gone.png is of no example"),
        "too few": ({f"{place}/case0.{end}": None for place, end in (("parameters/examples", "prm"), ("doc/gallery", "png"))},
                    names[1:], "9 examples"),
        "unexplained cause": ({"doc/symptoms.md": symptoms.replace("| cycle: ... | b |\n", "")}, names, "cause 'cycle'"),
        "no causes": ({"source/simulation/failure_explanation.cc": ""}, names, "has their layout changed"),
    }

    def found_in(files, runs):
        with tempfile.TemporaryDirectory() as directory:
            root = pathlib.Path(directory)
            for name, text in files.items():
                if text is not None:
                    (root / name).parent.mkdir(parents=True, exist_ok=True)
                    (root / name).write_text(text)
            return list(violations(root, runs))

    failures = [f"false alarm: {message}" for message in found_in(good, names)]
    for what, (files, runs, expected) in bad.items():
        if not any(expected in message for message in found_in({**good, **files}, runs)):
            failures.append(f"not noticed: {what}")
    return failures


if __name__ == "__main__":
    run_check(__doc__, lambda root: violations(root, SHORTER), self_test)
