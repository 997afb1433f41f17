"""Parameters of a case as a Python object, and the case in words.

    parameters = Parameters.read("case.prm")
    parameters.get("Contact/interface/Friction", "none")
    parameters.sections("Contact")              # names of the pairs
    parameters.set("Degree", 2)
    parameters.text()                           # again a .prm

The program checks parameters; this only reads what the program accepts:
subsections, 'set', comments, lines continued with \\, 'include'. In what
`stickslip case.prm --print-parameters` prints, a comment says which values
differ from their default; others are left out of the words.
"""
from __future__ import annotations

import os
import pathlib
import re
import typing

from .errors import ParameterFileError


def _words(text: str) -> str:
    """Any white space counts as one blank, as in the program."""
    return " ".join(text.split())


class Parameters:
    def __init__(self) -> None:
        self.values: dict[str, str] = {}  # "Section/Name": text, in the order of the file
        self.defaults: set[str] = set()  # paths that a complete print says have their default
        self.origin = ""  # "stickslip 0.2.0 (...)" if the first line is a comment that says so

    @staticmethod
    def read(path: str | os.PathLike[str]) -> Parameters:
        parameters = Parameters()
        path = pathlib.Path(path)
        parameters._include(path, [])
        with open(path, errors="replace") as file:
            first = file.readline().strip()
        if first.startswith("# stickslip "):
            parameters.origin = first[2:]
        return parameters

    @staticmethod
    def of(values: typing.Mapping[str, typing.Any]) -> Parameters:
        """Of a dictionary: of sections (dictionaries again) and names, or of "Section/Name"; values as text_of() has them."""
        parameters = Parameters()

        def add(section: list[str], members: typing.Mapping[str, typing.Any]) -> None:
            for name, value in members.items():
                if isinstance(value, typing.Mapping):
                    add([*section, name], value)
                else:
                    parameters.set("/".join([*section, name]), value)

        add([], values)
        return parameters

    @staticmethod
    def text_of(value: typing.Any) -> str:
        """A value as a .prm has it: true, 1e-3, 'a, b' for a list."""
        if isinstance(value, bool):
            return str(value).lower()
        if isinstance(value, (list, tuple)):
            return ", ".join(Parameters.text_of(member) for member in value)
        return str(value)

    # ---------------------------------------------------------------- reading
    def _include(self, path: pathlib.Path, section: list[str]) -> None:
        try:
            text = path.read_text(errors="replace")
        except OSError as error:
            raise ParameterFileError(f"The parameter file '{path}' cannot be read: {error.strerror}.") from error
        outer = len(section)
        comment: list[str] = []
        for number, line in enumerate(re.sub(r"\\\n", " ", text).splitlines(), 1):
            if line.strip().startswith("#"):
                comment.append(line.strip("# \t"))
                continue
            line = _words(line.split("#", 1)[0])
            if line.lower().startswith("subsection "):
                section.append(line.split(" ", 1)[1])
            elif line.lower() == "end":
                if len(section) == outer:
                    raise ParameterFileError(f"{path}:{number}: 'end' without a subsection.")
                section.pop()
            elif line.lower().startswith("set ") and "=" in line:
                name, value = (part.strip() for part in line[4:].split("=", 1))
                self._assign("/".join([*section, name]), value, comment)
            elif line.lower().startswith("include "):
                # a file specializes what it includes: its own value wins
                own, own_defaults = dict(self.values), set(self.defaults)
                self._include(path.parent / line.split(" ", 1)[1], section)
                self.values.update(own)
                self.defaults = {key for key in self.defaults if key not in own} | own_defaults
            elif line:
                raise ParameterFileError(f"{path}:{number}: '{line}' is no line of a parameter file.")
            comment = []
        if len(section) != outer:
            raise ParameterFileError(f"{path}: subsection '{section[-1]}' has no end.")

    def _assign(self, path: str, value: str, comment: list[str]) -> None:
        self.values[path] = value
        self.defaults.discard(path)
        is_complete_print = any(line.startswith("Allowed:") for line in comment)
        if is_complete_print and not any(line.startswith(("Default:", "Must be set")) for line in comment):
            self.defaults.add(path)

    # ----------------------------------------------------------------- access
    def get(self, path: str, default: str = "") -> str:
        return self.values.get(path, default)

    def sections(self, path: str) -> list[str]:
        """Names of the subsections of a section, in the order of the file."""
        start = path + "/"
        return list(dict.fromkeys(key[len(start):].split("/")[0] for key in self.values
                                  if key.startswith(start) and "/" in key[len(start):]))

    def given(self, path: str) -> dict[str, str]:
        """What is set in a section itself and is not a default: {name: value}."""
        start = path + "/" if path else ""
        return {key[len(start):]: value for key, value in self.values.items()
                if key.startswith(start) and "/" not in key[len(start):] and key not in self.defaults and value != ""}

    def set(self, path: str, value: typing.Any) -> None:
        self.values[path] = self.text_of(value)
        self.defaults.discard(path)

    def differences(self, other: Parameters) -> list[str]:
        """Paths whose values differ, where both or one of them is set to something else than the default."""
        def shown(parameters: Parameters, path: str) -> str:
            return parameters.get(path) if path not in parameters.defaults else ""

        return [path for path in dict.fromkeys([*self.values, *other.values])
                if not path.startswith(("Output/Directory", "Title")) and shown(self, path) != shown(other, path)]

    def text(self) -> str:
        """All values as a .prm file."""
        lines: list[str] = []

        def write(section: list[str], indent: str) -> None:
            start = "/".join(section) + "/" if section else ""
            for path, value in self.values.items():
                if path.startswith(start) and "/" not in path[len(start):]:
                    lines.append(f"{indent}set {path[len(start):]} = {value}")
            for name in self.sections("/".join(section)) if section else dict.fromkeys(
                    path.split("/")[0] for path in self.values if "/" in path):
                lines.append(f"{indent}subsection {name}")
                write([*section, name], indent + "  ")
                lines.append(indent + "end")

        write([], "")
        return "\n".join(lines) + "\n"

    # ------------------------------------------------------------------ words
    def described(self, path: str, leave_out: typing.Collection[str] = ()) -> str:
        """'name value, name value' of what a section sets."""
        return ", ".join(f"{name} {value}" for name, value in self.given(path).items() if name not in leave_out)

    def bodies(self) -> list[tuple[str, str, str]]:
        """(name, shape, material) of each body."""
        rows = []
        for body in self.sections("Bodies"):
            path = f"Bodies/{body}/"
            shape = self.get(path + "Mesh file") or f"{self.get(path + 'Generator')} {self.get(path + 'Arguments')}"
            more = self.described(path[:-1], ("Mesh file", "Generator", "Arguments", "Material", "Rigid"))
            is_rigid = self.get(path + "Rigid", "false") == "true"
            rows.append((body, shape + (f"; {more}" if more else ""), "rigid" if is_rigid else self.get(path + "Material")))
        return rows

    def materials(self) -> list[tuple[str, str, str]]:
        return [(name, self.get(f"Materials/{name}/Law"), self.described(f"Materials/{name}", ("Law",)))
                for name in self.sections("Materials")]

    def boundary_conditions(self) -> list[tuple[str, str, str, str]]:
        """(name, type, where, value) of each."""
        rows = []
        for name in self.sections("Boundary conditions"):
            given = self.given(f"Boundary conditions/{name}")
            where = [given.get("Body", "")]
            where += [f"boundary {given['Boundary']}"] if "Boundary" in given else []
            where += [f"where {given['Where']}"] if "Where" in given else []
            more = [f"{key} {value}" for key, value in given.items() if key not in ("Body", "Boundary", "Where", "Type", "Value")]
            value = given.get("Value", "")
            rows.append((name, given.get("Type", "displacement"), ", ".join(filter(None, where)),
                         "; ".join(filter(None, [value, ", ".join(more)]))))
        return rows

    def contact_pairs(self) -> list[tuple[str, str, str, str, str]]:
        """(name, slave, master, friction, further choices) of each."""
        rows = []
        for name in self.sections("Contact"):
            path = f"Contact/{name}"
            given = self.given(path)
            slave, master = (f"{self.get(f'{path}/{which} body')}, boundary {self.get(f'{path}/{which} boundary')}"
                             for which in ("Slave", "Master"))
            friction = given.get("Friction", "none")
            law = [friction] + [f"{key.lower()} {given[key]}" for key in ("Friction coefficient", "Tresca threshold") if key in given]
            more = self.described(path, ("Slave body", "Slave boundary", "Master body", "Master boundary", "Friction",
                                         "Friction coefficient", "Tresca threshold"))
            regularization = self.described(f"{path}/Regularization")
            rows.append((name, slave, master, "none" if friction == "none" else ", ".join(law),
                         ", ".join(filter(None, [more, regularization]))))
        return rows

    def sections_in_words(self, names: typing.Iterable[str]) -> list[tuple[str, str]]:
        """(section, 'name value, ...') of these sections and what is below them."""
        rows = []
        for name in names:
            below = sorted({key.rsplit("/", 1)[0] for key in self.values if key.startswith(name + "/")})
            for section in below:
                if text := self.described(section):
                    rows.append((section, text))
        return rows
