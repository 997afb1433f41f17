#!/usr/bin/env python3
"""Holds the architecture of doc/architecture.md against the source text.

    check_includes.py SOURCE_DIRECTORY     exit code 1 and one line per violation
    check_includes.py --self-test          shows that each rule can fail

Checked: a folder includes only folders below it; solid and contact do not
meet; base knows deal.II (with its boost) and the standard library only; a .cc
of the program has a header of its own and includes it first, so that compiling
the one shows that the other is complete; names of namespace std come with their
headers (std_headers.py); no file of the program has more than 400 lines; every
.cc has a line in source/sources.txt and every test a comparison file; include
guards follow the file name; nothing is called utils, helpers, common, manager.
"""
import pathlib
import re
import tempfile

from check_runner import run_check
from std_headers import missing_headers, unknown_names

# A folder may include itself and these, with what is inside them. Arrows go one
# way: each row lists all that is reachable, and only names of rows above it.
MAY_INCLUDE = {
    "base": set(),
    "mesh/file": {"base"},
    "mesh": {"base", "mesh/file"},
    "solid": {"base", "mesh"},
    "contact/surface": {"base", "mesh"},
    "contact/point": {"base", "mesh", "contact/surface"},
    "contact/pairing": {"base", "mesh", "contact/surface", "contact/point"},
    "contact/assembly": {"base", "mesh", "contact/surface", "contact/point", "contact/pairing"},
    "contact/cycling": {"base", "mesh", "contact/surface", "contact/point", "contact/pairing", "contact/assembly"},
    "contact/results": {"base", "mesh", "contact/surface", "contact/point", "contact/pairing", "contact/assembly"},
    "problem": {"base", "mesh", "solid", "contact"},
    "linear_solvers/factorization": {"base"},
    "linear_solvers/multigrid": {"base", "linear_solvers/factorization"},
    "linear_solvers": {"base", "linear_solvers/factorization", "linear_solvers/multigrid"},
    "strategy": {"base"},
    "adaptivity": {"base", "mesh", "solid", "contact", "problem"},
    "output": {"base", "mesh", "solid", "contact", "problem"},
    "simulation": {"base", "mesh", "solid", "contact", "problem", "linear_solvers", "strategy", "adaptivity", "output"},
}
MAX_LINES = 400
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*([<"])([^>"]+)[>"]', re.MULTILINE)
FORBIDDEN_NAME = re.compile(r"(^|_)(utils?|utilities|helpers?|common|managers?)(_|$)")


def may_include(folder, target):
    """TARGET is a folder of the table; a row that names its parent allows it too."""
    allowed = MAY_INCLUDE[folder] | {folder}
    return target in allowed or target.split("/")[0] in allowed - {folder}


def check_table():
    """Each row names rows above it only, and all that these reach."""
    above = set()
    for folder, targets in MAY_INCLUDE.items():
        for target in targets:
            inside = {row for row in above if row == target or row.startswith(target + "/")}
            if not inside:
                yield f"the table: {folder}/ may include {target}/, which is not above it"
            for row in inside:
                for reached in MAY_INCLUDE[row]:
                    if not may_include(folder, reached):
                        yield f"the table: {folder}/ reaches {reached}/ through {row}/ and does not name it"
        above.add(folder)


def check_arrows(folder, path, text):
    for bracket, included in INCLUDE.findall(text):
        if bracket == '"' and (folder is not None or "/" in included):
            # Tests may share a file beside them.
            yield f'{path}: includes "{included}"; write <stickslip/FOLDER/NAME.h>'
        elif included.startswith("stickslip/"):
            target = included[len("stickslip/"):].rpartition("/")[0]
            if target not in MAY_INCLUDE:
                yield f"{path}: includes <{included}> of the unknown folder {target}/"
            elif folder is not None and not may_include(folder, target):
                yield f"{path}: {folder}/ must not include {target}/ (<{included}>)"
        elif folder == "base" and "/" in included and not included.startswith(("deal.II/", "boost/")):
            yield f"{path}: base/ includes <{included}>, neither deal.II (with its boost) nor the standard library"


def check_text(path, text):
    n_lines = text.count("\n")
    if n_lines > MAX_LINES and path.parts[0] != "tests":
        yield f"{path}: {n_lines} lines; more than {MAX_LINES} means that a second concept has moved in"
    if FORBIDDEN_NAME.search(path.stem):
        yield f"{path}: the name does not say what the file is about"


def check_own_header(root, path, text):
    own = f"stickslip/{path.relative_to('source').with_suffix('.h')}"
    if not (root / "include" / own).exists():
        yield f"{path}: has no header <{own}>; find the concept that it stands for"
    elif [included for _, included in INCLUDE.findall(text)][:1] != [own]:
        yield f"{path}: must include its own header <{own}> first"


def check_std_headers(root, path, text):
    own = root / "include" / "stickslip" / pathlib.Path(*path.parts[1:]).with_suffix(".h")
    beside = [root / path.parent / name for bracket, name in INCLUDE.findall(text) if bracket == '"']
    given = "".join(file.read_text() for file in [own, *beside] if path.suffix == ".cc" and file.exists())
    for header, name in missing_headers(text, given).items():
        yield f"{path}: uses std::{name} and does not include <{header}>"
    for name in unknown_names(text):
        yield f"{path}: std::{name} has no header in tests/std_headers.py; add it"


def check_header(folder, path, text):
    # The list of headers to precompile is included by the compiler's command line.
    guard = f"stickslip_{folder.replace('/', '_')}_{path.stem}_h"
    if path.name != "precompiled.h" and not re.match(rf"#ifndef {guard}\n#define {guard}\n", text):
        yield f"{path}: must begin with the include guard {guard}"


def check_layout(root, sources):
    listed = set()
    sources_txt = root / "source" / "sources.txt"
    if sources_txt.exists():
        lines = [line for line in sources_txt.read_text().split("\n") if re.match("[a-z]", line)]
        listed = set(lines)
        if lines != sorted(listed):
            yield "source/sources.txt: not sorted, or a line appears twice"
    existing = {str(path.relative_to(root / "source")) for path in sources if path.name != "main.cc"}
    for name in sorted(existing - listed):
        yield f"source/{name}: not listed in source/sources.txt, so not built"
    for name in sorted(listed - existing):
        yield f"source/sources.txt: {name} does not exist"


def check_tests(root):
    """A test without a comparison file would never be run."""
    for folder, pattern in (("unit", "*.cc"), ("application", "*.prm*")):
        for path in sorted((root / "tests" / folder).glob(pattern)):
            name = path.name.split(".")[0]
            if not any(path.parent.glob(f"{name}.*output")):
                yield f"{path.relative_to(root)}: has no comparison file {name}.output"


def violations(root):
    headers = sorted((root / "include" / "stickslip").rglob("*.h"))
    sources = sorted((root / "source").rglob("*.cc"))
    tests = sorted((root / "tests").rglob("*.cc")) + sorted((root / "tests").rglob("*.h"))
    if not headers or not sources:
        yield f"{root}: no headers or no sources found; is this the source directory?"
    for path in headers + sources + tests:
        text = path.read_text()
        short = path.relative_to(root)
        yield from check_text(short, text)
        yield from check_std_headers(root, short, text)
        folder = "/".join(short.parts[2 if path in headers else 1:-1])
        if path in tests or short == pathlib.Path("source/main.cc"):
            folder = None  # above everything
        elif folder not in MAY_INCLUDE:
            yield f"{short}: not in one of the folders {', '.join(MAY_INCLUDE)}"
            continue
        yield from check_arrows(folder, short, text)
        if path in headers:
            yield from check_header(folder, short, text)
        elif folder is not None:
            yield from check_own_header(root, short, text)
    yield from check_table()
    yield from check_layout(root, sources)
    yield from check_tests(root)


def self_test():
    def header(folder, name, body=""):
        guard = f"stickslip_{folder}_{name}_h"
        return f"#ifndef {guard}\n#define {guard}\n{body}\n#endif\n"

    good = {
        "include/stickslip/base/types.h": header("base", "types", "#include <deal.II/base/mpi.h>\n#include <vector>"),
        "include/stickslip/contact/point/law.h": header("contact_point", "law", "#include <stickslip/base/types.h>\n#include <vector>"),
        "source/contact/point/law.cc": "#include <stickslip/contact/point/law.h>\n\nstd::vector<double> v; // not std::sort, \"std::sort\"\n",
        "include/stickslip/simulation/simulation.h": header("simulation", "simulation"),
        "include/stickslip/problem/p.h": header("problem", "p", "#include <stickslip/contact/point/law.h>"),
        "source/main.cc": "#include <stickslip/simulation/simulation.h>\n",
        "source/sources.txt": "# comment\ncontact/point/law.cc\n",
        "tests/unit/law.cc": "#include <stickslip/contact/point/law.h>\n",
        "tests/unit/law.output": "OK\n",
        "tests/application/case.prm": "set Dimension = 2\n",
        "tests/application/case.mpirun=2.output": "OK\n",
    }
    bad = {  # file, its text, a part of the message
        "upward arrow": ("include/stickslip/base/a.h", header("base", "a", "#include <stickslip/mesh/b.h>"), "must not include mesh/"),
        "solid meets contact": ("include/stickslip/solid/a.h", header("solid", "a", " # include <stickslip/contact/point/law.h>"), "must not include contact/point/"),
        "strategy sees mechanics": ("include/stickslip/strategy/a.h", header("strategy", "a", "#include <stickslip/problem/p.h>"), "must not include problem/"),
        "base knows Trilinos": ("include/stickslip/base/a.h", header("base", "a", "#include <Teuchos/x.hpp>"), "neither deal.II"),
        "upward arrow inside contact": ("include/stickslip/contact/surface/a.h", header("contact_surface", "a", "#include <stickslip/contact/point/law.h>"), "must not include contact/point/"),
        "multigrid sees the solvers": ("include/stickslip/linear_solvers/multigrid/a.h", header("linear_solvers_multigrid", "a", "#include <stickslip/linear_solvers/b.h>"), "must not include linear_solvers/"),
        "a file in the hall": ("include/stickslip/contact/a.h", header("contact", "a"), "not in one of the folders"),
        "quotes": ("source/contact/point/law.cc", '#include "law.h"\n', "write <stickslip/"),
        "path in quotes": ("tests/unit/a.cc", '#include "../law.h"\n', "write <stickslip/"),
        "unknown folder": ("include/stickslip/misc/a.h", header("misc", "a"), "not in one of the folders"),
        "unknown included folder": ("tests/unit/a.cc", "#include <stickslip/misc/a.h>\n", "unknown folder misc/"),
        "long file": ("source/contact/point/law.cc", "\n" * (MAX_LINES + 1), "401 lines"),
        "forbidden name": ("include/stickslip/mesh/mesh_utils.h", header("mesh", "mesh_utils"), "does not say"),
        "guard": ("include/stickslip/mesh/a.h", header("mesh", "b"), "include guard stickslip_mesh_a_h"),
        "unlisted source": ("source/contact/point/other.cc", "\n", "not listed"),
        "listed but absent": ("source/sources.txt", "contact/absent.cc\ncontact/point/law.cc\n", "does not exist"),
        "uncompared test": ("tests/unit/other.cc", "\n", "no comparison file"),
        "uncompared case": ("tests/application/other.prm.in", "\n", "no comparison file"),
        "source without a header": ("source/contact/point/law_2.cc", "#include <vector>\n", "has no header"),
        "own header second": ("source/contact/point/law.cc", "#include <vector>\n#include <stickslip/contact/point/law.h>\n", "own header"),
        "sort by luck": ("source/contact/point/law.cc", "#include <stickslip/contact/point/law.h>\nstd::sort(v);\n", "does not include <algorithm>"),
        "header by luck": ("include/stickslip/base/types.h", header("base", "types", "std::vector<int> v;"), "does not include <vector>"),
        "test by luck": ("tests/unit/law.cc", "std::cout << std::sqrt(2.);\n", "does not include <cmath>"),
        "name without a header": ("tests/unit/law.cc", "std::no_such_name();\n", "has no header in tests/std_headers.py"),
        "unsorted": ("source/sources.txt", "contact/point/law.cc\ncontact/point/law.cc\n", "not sorted"),
    }

    def found_in(files):
        with tempfile.TemporaryDirectory() as directory:
            root = pathlib.Path(directory)
            for name, text in files.items():
                (root / name).parent.mkdir(parents=True, exist_ok=True)
                (root / name).write_text(text)
            return list(violations(root))

    failures = [f"false alarm: {message}" for message in found_in(good)]
    for what, (name, text, expected) in bad.items():
        if not any(expected in message for message in found_in({**good, name: text})):
            failures.append(f"not noticed: {what}")
    return failures


if __name__ == "__main__":
    run_check(__doc__, violations, self_test)
