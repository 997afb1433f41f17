"""A study: one case with many values of some parameters, described in a TOML file.

The format is explained in parameters/studies/example.toml. Every mistake in the
file is a StudyError with the file's name and what is allowed.
"""
import difflib
import hashlib
import itertools
import pathlib
import re
import tomllib

from stickslip import ParameterFileError, Parameters

KEYS = {"title": str, "case": str, "ranks": int, "time limit": (int, float), "fixed": dict, "grid": dict, "runs": list,
        "collect": dict, "plots": list}
PLOT_KEYS = {"file", "title", "x", "y", "value", "curves", "panels", "log", "reference"}
LABEL = "label "  # begins what is a column and no parameter
HOWS = ("last", "first", "max", "min", "total")


class StudyError(Exception):
    """What is wrong with a study file; the text is for the user."""


def short_name(name):
    return name[len(LABEL):] if name.startswith(LABEL) else name.rsplit("/", 1)[-1]


class StudyRun:
    """One run: the value of each varied parameter."""

    def __init__(self, own, combination):
        """`own`: of [[runs]]; `combination`: of [grid]."""
        self.values = {name: Parameters.text_of(value) for name, value in {**own, **combination}.items()}
        named = {name for name in own if name.startswith(LABEL)} or set(own)
        self.label = self._make_label([name for name in self.values if name in named or name in combination])

    @property
    def settings(self):
        """What the program gets."""
        return {name: value for name, value in self.values.items() if not name.startswith(LABEL)}

    def _make_label(self, names):
        """Name of the directory: says what the run is, whatever else the study holds; with a hash where that is too long."""
        text = ",".join(f"{short_name(name)}={self.values[name]}" for name in names)
        label = re.sub(r"[^\w=.,+-]+", "_", text)
        if label != text.replace(" ", "_") or len(label) > 80:
            label = label[:70] + "-" + hashlib.sha1(repr(sorted(self.values.items())).encode()).hexdigest()[:8]
        return label


class Collected:
    """A column of the study's table: 'last points.csv A_x'."""

    def __init__(self, name, text, complain):
        words = text.split(None, 2) if isinstance(text, str) else []
        if len(words) != 3 or words[0] not in HOWS or not words[1].endswith(".csv"):
            complain(f"collect/{name}: '{text}' is not of the form 'last points.csv A_x'; the first word is one of "
                     f"{', '.join(HOWS)}.")
        self.name = name
        self.how, self.table, self.column = words

    def of(self, values):
        """What a column of a table gives, which has rows: a number, or a word."""
        return {"last": lambda: values[-1], "first": lambda: values[0], "max": lambda: max(values), "min": lambda: min(values),
                "total": lambda: sum(values)}[self.how]()


class Study:
    def __init__(self, path):
        self.path = pathlib.Path(path)
        self.name = self.path.stem
        data = self._parsed()
        self._check_keys(data, KEYS, "")
        for key, kind in KEYS.items():
            if key in data and not isinstance(data[key], kind):
                self._complain(f"'{key}' has a wrong type.")
        if "case" not in data:
            self._complain("it names no 'case' (a .prm file, relative to the study).")
        self.title = data.get("title", self.name)
        self.case = (self.path.parent / data["case"]).resolve()
        self.ranks = data.get("ranks", 1)
        if self.ranks < 1:
            self._complain(f"'ranks' is {self.ranks}; it has to be at least 1.")
        self.time_limit = data.get("time limit")
        try:
            self.parameters = Parameters.read(self.case)
        except ParameterFileError as error:
            self._complain(str(error))
        self.fixed = {name: Parameters.text_of(value) for name, value in data.get("fixed", {}).items()}
        self.runs = self._make_runs(data.get("grid", {}), data.get("runs", []))
        self.columns = self._short_names()
        self.collected = [Collected(name, text, self._complain) for name, text in data.get("collect", {}).items()]
        self.plots = data.get("plots", [])
        for plot in self.plots:
            self._check_plot(plot)

    def _complain(self, text):
        raise StudyError(f"{self.path}: {text}")

    def _parsed(self):
        try:
            with open(self.path, "rb") as file:
                return tomllib.load(file, parse_float=str)  # 1e-3 stays 1e-3
        except OSError as error:
            raise StudyError(f"The study '{self.path}' cannot be read: {error.strerror}.") from error
        except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
            self._complain(f"this is no TOML: {error}")

    def _check_keys(self, data, known, where):
        for key in data:
            if key not in known:
                near = difflib.get_close_matches(key, known, 1)
                hint = f" Did you mean '{near[0]}'?" if near else ""
                self._complain(f"{where}there is no key '{key}'.{hint} Known: {', '.join(sorted(known))}.")

    def _make_runs(self, grid, listed):
        for name, values in grid.items():
            if not isinstance(values, list) or not values:
                self._complain(f"grid/{name}: a list of values is needed, as in [0, 1, 2].")
        for i, values in enumerate(listed, 1):
            if not isinstance(values, dict) or not values:
                self._complain(f"runs, number {i}: a table of parameters is needed.")
        if not grid and not listed:
            self._complain("nothing varies: give [grid] or [[runs]].")
        combinations = [dict(zip(grid, combination)) for combination in itertools.product(*grid.values())]
        runs, known = [], set()
        for own, combination in itertools.product(listed or [{}], combinations):
            both = set(own) & set(combination)
            if both:
                self._complain(f"'{both.pop()}' is in [grid] and in [[runs]].")
            run = StudyRun(own, combination)
            if run.label in known:
                self._complain(f"two runs are called '{run.label}'.")
            known.add(run.label)
            runs.append(run)
        self.varied = list(dict.fromkeys(name for run in runs for name in run.values))
        for name in self.varied:
            if name in self.fixed:
                self._complain(f"'{name}' is fixed and varied.")
        return runs

    def _short_names(self):
        """Column of each varied parameter: its last part, if that says it."""
        last = [short_name(name) for name in self.varied]
        return {name: short if last.count(short) == 1 else name for name, short in zip(self.varied, last)}

    def all_columns(self):
        return [*self.columns.values(), *ALWAYS, *(collected.name for collected in self.collected)]

    def _check_plot(self, plot):
        if not isinstance(plot, dict):
            self._complain("plots: write [[plots]] before each.")
        self._check_keys(plot, PLOT_KEYS, "plots: ")
        for key in ("x", "y"):
            if key not in plot:
                self._complain(f"plots: '{key}' is missing.")
        if not set(plot.get("log", "")) <= {"x", "y"}:
            self._complain(f"plots: log is '{plot['log']}'; it can be \"x\", \"y\" or \"xy\".")
        for key in ("x", "y", "value", "curves", "panels"):
            if key in plot and plot[key] not in self.all_columns():
                self._complain(f"plots: {key} = '{plot[key]}' is no column; there are {', '.join(self.all_columns())}.")

    def parameters_of(self, run):
        """All parameters of a run."""
        parameters = Parameters.read(self.case)
        for name, value in {**self.fixed, **run.settings}.items():
            parameters.set(name, value)
        return parameters


# Columns that every study has.
ALWAYS = ["state", "exit_code", "load_steps", "newton_iterations", "failed_newton_iterations", "cuts", "geometry_loops",
          "threshold_loops", "status_loops", "linear_iterations", "seconds"]
