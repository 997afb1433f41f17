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
import pathlib
import re


class ParameterFileError(Exception):
    pass


def _words(text):
    """Any white space counts as one blank, as in the program."""
    return " ".join(text.split())


class Parameters:
    def __init__(self):
        self.values = {}  # "Section/Name": text, in the order of the file
        self.defaults = set()  # paths that a complete print says have their default
        self.origin = ""  # "stickslip 0.2.0 (...)" if the first line is a comment that says so

    @staticmethod
    def read(path):
        parameters = Parameters()
        path = pathlib.Path(path)
        parameters._include(path, [])
        with open(path, errors="replace") as file:
            first = file.readline().strip()
        if first.startswith("# stickslip "):
            parameters.origin = first[2:]
        return parameters

    # ---------------------------------------------------------------- reading
    def _include(self, path, section):
        try:
            text = path.read_text(errors="replace")
        except OSError as error:
            raise ParameterFileError(f"The parameter file '{path}' cannot be read: {error.strerror}.") from error
        outer = len(section)
        comment = []
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

    def _assign(self, path, value, comment):
        self.values[path] = value
        self.defaults.discard(path)
        is_complete_print = any(line.startswith("Allowed:") for line in comment)
        if is_complete_print and not any(line.startswith(("Default:", "Must be set")) for line in comment):
            self.defaults.add(path)

    # ----------------------------------------------------------------- access
    def get(self, path, default=""):
        return self.values.get(path, default)

    def sections(self, path):
        """Names of the subsections of a section, in the order of the file."""
        start = path + "/"
        return list(dict.fromkeys(key[len(start):].split("/")[0] for key in self.values
                                  if key.startswith(start) and "/" in key[len(start):]))

    def given(self, path):
        """What is set in a section itself and is not a default: {name: value}."""
        start = path + "/" if path else ""
        return {key[len(start):]: value for key, value in self.values.items()
                if key.startswith(start) and "/" not in key[len(start):] and key not in self.defaults and value != ""}

    def set(self, path, value):
        self.values[path] = str(value)
        self.defaults.discard(path)

    def differences(self, other):
        """Paths whose values differ, where both or one of them is set to something else than the default."""
        def shown(parameters, path):
            return parameters.get(path) if path not in parameters.defaults else ""

        return [path for path in dict.fromkeys([*self.values, *other.values])
                if not path.startswith(("Output/Directory", "Title")) and shown(self, path) != shown(other, path)]

    def text(self):
        """All values as a .prm file."""
        lines = []

        def write(section, indent):
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
    def described(self, path, leave_out=()):
        """'name value, name value' of what a section sets."""
        return ", ".join(f"{name} {value}" for name, value in self.given(path).items() if name not in leave_out)

    def bodies(self):
        """(name, shape, material) of each body."""
        rows = []
        for body in self.sections("Bodies"):
            path = f"Bodies/{body}/"
            shape = self.get(path + "Mesh file") or f"{self.get(path + 'Generator')} {self.get(path + 'Arguments')}"
            more = self.described(path[:-1], ("Mesh file", "Generator", "Arguments", "Material", "Rigid"))
            is_rigid = self.get(path + "Rigid", "false") == "true"
            rows.append((body, shape + (f"; {more}" if more else ""), "rigid" if is_rigid else self.get(path + "Material")))
        return rows

    def materials(self):
        return [(name, self.get(f"Materials/{name}/Law"), self.described(f"Materials/{name}", ("Law",)))
                for name in self.sections("Materials")]

    def boundary_conditions(self):
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

    def contact_pairs(self):
        """(name, slave, master, friction, further choices) of each."""
        rows = []
        for name in self.sections("Contact"):
            path = f"Contact/{name}"
            given = self.given(path)
            side = lambda which: f"{self.get(f'{path}/{which} body')}, boundary {self.get(f'{path}/{which} boundary')}"
            friction = given.get("Friction", "none")
            law = [friction] + [f"{key.lower()} {given[key]}" for key in ("Friction coefficient", "Tresca threshold") if key in given]
            more = self.described(path, ("Slave body", "Slave boundary", "Master body", "Master boundary", "Friction",
                                         "Friction coefficient", "Tresca threshold"))
            regularization = self.described(f"{path}/Regularization")
            rows.append((name, side("Slave"), side("Master"), "none" if friction == "none" else ", ".join(law),
                         ", ".join(filter(None, [more, regularization]))))
        return rows

    def sections_in_words(self, names):
        """(section, 'name value, ...') of these sections and what is below them."""
        rows = []
        for name in names:
            below = sorted({key.rsplit("/", 1)[0] for key in self.values if key.startswith(name + "/")})
            for section in below:
                if text := self.described(section):
                    rows.append((section, text))
        return rows
