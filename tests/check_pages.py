#!/usr/bin/env python3
"""Holds the pages (*.md) against the source.

    check_pages.py SOURCE_DIRECTORY     exit code 1 and one line per violation
    check_pages.py --self-test          shows that each rule can fail

Checked: lines of text have at most 120 characters (not those of tables, code,
formulas, and what cannot be broken); links lead to files that exist, and to a
heading if they name one; the tables of doc/architecture.md, section 1, name
every file of the program in its folder, and no other; that of section 2 says
what check_includes.py allows, and classes and functions that the page names
exist. doc/parameters.md, which the program writes, need not keep the length.
"""
import pathlib
import re
import tempfile

from check_includes import MAY_INCLUDE
from check_runner import run_check

MAX_LENGTH = 120
WRITTEN_BY_THE_PROGRAM = ["doc/parameters.md"]
LINK = re.compile(r"\[[^\]]*\]\(([^)\s]+)\)")
FOLDER_HEADING = re.compile(r"^\*\*([a-z_/]+)/\*\*", re.MULTILINE)


def lines_of_text(text):
    """(number, line) of what is neither a table, nor code, nor a formula."""
    fence = formula = False
    for number, line in enumerate(text.split("\n"), 1):
        stripped = line.strip()
        if stripped.startswith("```"):
            fence = not fence
        elif not fence and stripped.count("$$") == 1:
            formula = not formula
        elif not fence and not formula and not stripped.startswith(("|", "$$", "![")) and not line.startswith("    "):
            yield number, line


def check_length(path, text):
    for number, line in lines_of_text(text):
        if len(line) > MAX_LENGTH and " " in line.strip():
            yield f"{path}:{number}: {len(line)} characters; a line of text has at most {MAX_LENGTH}"


def anchor(heading):
    """The name that a heading gets on a page."""
    return re.sub(r"[^\w\- ]", "", heading.strip().lower()).replace(" ", "-")


def check_links(root, path, text):
    for target in LINK.findall(text):
        if re.match(r"[a-z]+:", target):
            continue
        file_name, _, heading = target.partition("#")
        file = (root / path).parent / file_name if file_name else root / path
        if not file.exists():
            yield f"{path}: the link to {target} leads nowhere"
        elif heading and heading not in map(anchor, re.findall(r"^#+ (.*)$", file.read_text(), re.MULTILINE)):
            yield f"{path}: {file_name or path} has no heading #{heading}"


def section_of(text, number):
    found = re.search(rf"^## {number}\..*?(?=^## |\Z)", text, re.MULTILINE | re.DOTALL)
    return found.group(0) if found else ""


def tables_of_folders(text):
    """{folder: names in the first column of its table} in section 1 of the architecture."""
    parts = FOLDER_HEADING.split(section_of(text, 1))
    tables = {}
    for folder, part in zip(parts[1::2], parts[2::2]):
        first_cells = re.findall(r"^\|([^|]*)\|", part, re.MULTILINE)
        tables[folder] = [name for cell in first_cells for name in re.findall(r"`([a-z_0-9]+)(?:\.h)?`", cell)]
    return tables


def files_of_folders(root):
    """{folder: names of its files without .h and .cc}"""
    files = {}
    for top, ending in (("include/stickslip", "h"), ("source", "cc")):
        for file in (root / top).rglob(f"*.{ending}"):
            folder = str(file.parent.relative_to(root / top))
            if folder != ".":
                files.setdefault(folder, set()).add(file.stem)
    return files


def check_architecture(root):
    page = root / "doc" / "architecture.md"
    tables = tables_of_folders(page.read_text())
    files = files_of_folders(root)
    for folder in sorted(set(tables) | set(files)):
        named = tables.get(folder, [])
        existing = files.get(folder, set())
        for name in sorted(existing - set(named)):
            yield f"doc/architecture.md: the table of {folder}/ lacks `{name}`"
        for name in sorted(set(named) - existing):
            yield f"doc/architecture.md: the table of {folder}/ has `{name}`, which does not exist"
        for name in sorted({name for name in named if named.count(name) > 1}):
            yield f"doc/architecture.md: the table of {folder}/ has `{name}` twice"


def check_arrows(root, allowed):
    rows = re.findall(r"^\| `([a-z_/]+)` \|(.*)\|$", section_of((root / "doc/architecture.md").read_text(), 2), re.MULTILINE)
    shown = {folder: set(re.findall(r"`([a-z_/]+)`", cell)) for folder, cell in rows}
    for folder in sorted(set(shown) | set(allowed)):
        if shown.get(folder) != allowed.get(folder):
            yield f"doc/architecture.md: section 2 is not what tests/check_includes.py allows {folder}/"


def check_names(root):
    """Classes and functions that the architecture names."""
    page = re.sub(r"\s*\n\s*", " ", (root / "doc/architecture.md").read_text())
    files = [file for top in ("include", "source", "tests", "scripts") for file in (root / top).rglob("*") if file.is_file()]
    words = {part for file in files for part in (file.stem, *file.parts)} | {word for file in files for word in re.findall(rb"\w+", file.read_bytes())}
    for span in sorted(set(re.findall(r"`([A-Za-z_][A-Za-z_0-9:]*(?:\(\w*\))?)`", page))):
        for word in re.findall(r"[A-Za-z_]\w*", span):
            if word not in words and word.encode() not in words:
                yield f"doc/architecture.md: `{span}` is nowhere in the source"


def violations(root, allowed):
    pages = [path for path in sorted(root.rglob("*.md"))
             if not path.relative_to(root).parts[0].startswith(("build", "."))]
    for page in pages:
        path = page.relative_to(root)
        text = page.read_text()
        if str(path) not in WRITTEN_BY_THE_PROGRAM:
            yield from check_length(path, text)
        yield from check_links(root, path, text)
    yield from check_architecture(root)
    yield from check_arrows(root, allowed)
    yield from check_names(root)


def self_test():
    good = {
        "README.md": "# A\n\nSee [b](doc/architecture.md#1-the-house) and [c](https://x.y/z).\n\n| " + "x " * 99 + "|\n\n"
                     "    " + "code " * 40 + "\n\n$$\n" + "x + " * 50 + "\n$$\n\n```\n" + "y " * 80 + "\n```\n",
        "doc/architecture.md": "## 1. The house\n\n**base/**: words\n\n| file | concept |\n|---|---|\n| `types`, `choice` | `law` |\n\n"
                               "**contact/point/**: points\n\n| file | concept |\n|---|---|\n| `law.h` | law |\n\n## 2. Arrows\n\n| `base` | deal.II |\n| `contact/point` | `base` |\n",
        "doc/parameters.md": "word " * 40 + "\n",
        "include/stickslip/base/types.h": "",
        "include/stickslip/base/choice.h": "",
        "include/stickslip/contact/point/law.h": "",
        "source/base/types.cc": "",
        "source/main.cc": "",
    }
    house = good["doc/architecture.md"]
    bad = {  # file, its text, a part of the message
        "long line": ("README.md", "word " * 25 + "\n", "README.md:1: 125 characters"),
        "long line after a formula": ("README.md", "$$\nx\n$$\n" + "word " * 25 + "\n", "README.md:4: 125 characters"),
        "dead link": ("README.md", "[b](doc/absent.md)\n", "leads nowhere"),
        "dead heading": ("README.md", "[b](doc/architecture.md#3-the-garden)\n", "has no heading #3-the-garden"),
        "file without a line": ("source/base/other.cc", "", "the table of base/ lacks `other`"),
        "folder without a table": ("source/mesh/a.cc", "", "the table of mesh/ lacks `a`"),
        "line without a file": ("doc/architecture.md", house.replace("`types`", "`types`, `gone`"), "has `gone`, which does not exist"),
        "file in another folder": ("doc/architecture.md", house.replace("`choice`", "`law`"), "the table of base/ has `law`"),
        "class of the past": ("doc/architecture.md", house + "`Law::evaluate()`\n", "`Law::evaluate()` is nowhere"),
        "arrow too many": ("doc/architecture.md", house.replace("deal.II", "`contact/point`"), "allows base/"),
        "arrow too few": ("doc/architecture.md", house.replace("| `base` |\n", "| |\n"), "allows contact/point/"),
        "folder without arrows": ("doc/architecture.md", house.replace("| `base` | deal.II |\n", ""), "allows base/"),
        "twice": ("doc/architecture.md", house.replace("`types`", "`types`, `types`"), "has `types` twice"),
    }

    def found_in(files):
        with tempfile.TemporaryDirectory() as directory:
            root = pathlib.Path(directory)
            for name, text in files.items():
                (root / name).parent.mkdir(parents=True, exist_ok=True)
                (root / name).write_text(text)
            return list(violations(root, {"base": set(), "contact/point": {"base"}}))

    failures = [f"false alarm: {message}" for message in found_in(good)]
    for what, (name, text, expected) in bad.items():
        if not any(expected in message for message in found_in({**good, name: text})):
            failures.append(f"not noticed: {what}")
    return failures


if __name__ == "__main__":
    run_check(__doc__, lambda root: violations(root, MAY_INCLUDE), self_test)
