"""The output directory of a run: tables, log, steps with fields, parameters.

    run = Run("results")
    run.statistics["newton_iterations"]     # columns, empty without the table
    run.log.attempts                        # every attempt at a load step
    run.bodies.steps[-1].time               # steps with fields: bodies, contact
    run.parameters                          # Parameters, or None

Reads what scripts/report, render and study have in common; no VTK.
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "parameters" / "benchmarks"))
from benchmark import read_csv
from parameter_file import Parameters, ParameterFileError

PARAMETERS = "parameters.prm"  # in an output directory: the parameters of its run


class ResultsError(Exception):
    """What a user gave is not what a script needs; the text is for the user."""


class FieldStep:
    """The fields of one accepted step: a .pvtu, or a .h5 with its cell type."""

    def __init__(self, number, time, path, topology=None):
        self.number = number
        self.time = time
        self.path = path
        self.topology = topology  # HDF5: Quadrilateral, Hexahedron, Polyline


class FieldSeries:
    """The steps that NAME.pvd or NAME.xdmf lists; files of earlier runs are not among them."""

    def __init__(self, directory, name):
        self.steps = []
        for index, reader in ((directory / f"{name}.pvd", self._read_pvd), (directory / f"{name}.xdmf", self._read_xdmf)):
            if index.exists():
                reader(directory, index.read_text(errors="replace"))
                break

    def _add(self, directory, time, file, topology=None):
        path = directory / file
        if path.exists():
            self.steps.append(FieldStep(int(re.search(r"-(\d+)\.", file)[1]), float(time), path, topology))

    def _read_pvd(self, directory, text):
        for time, file in re.findall(r'timestep="([^"]+)".*?file="([^"]+)"', text):
            self._add(directory, time, file)

    def _read_xdmf(self, directory, text):
        pattern = r'<Time Value="([^"]+)".*?TopologyType="([^"]+)".*?(\S+\.h5):/cells'
        for time, topology, file in re.findall(pattern, text, re.DOTALL):
            self._add(directory, time, file, topology)

    def at_step(self, number):
        """The step of this number, or None."""
        return next((step for step in self.steps if step.number == number), None)


class Attempt:
    """One attempt at a load step, as convergence.log tells it."""

    def __init__(self, step, time, size):
        self.step, self.time, self.size = step, time, size
        self.residuals = []  # (equilibrium, contact) of each Newton iteration; number 0 begins a solve
        self.starts = []  # index into residuals where a Newton solve begins
        self.loop_passes = []  # (loop, pass, change)
        self.notes = []  # what was said in between: fallbacks, retries
        self.failure = None  # {"cause", "why", "where", "try"} if the attempt was given up

    @property
    def n_iterations(self):
        return len(self.residuals) - len(self.starts)


class Log:
    """convergence.log: attempts, warnings, how the run ended."""

    ITERATION = re.compile(r"\s+(\d+)\s+(\S+)\s+(\S+)\s+\S+\s+\S+\s+\S+\s*$")
    STEP = re.compile(r"step (\d+) to t = (\S+) \(size (\S+)\)")
    PASS = re.compile(r"\s+(\w+) pass (\d+): change (\S+)")
    EXPLANATION = re.compile(r"\s*(cause|why|where|try):\s*(.*)", re.IGNORECASE)

    def __init__(self, path):
        self.exists = path.exists()
        self.attempts = []
        self.warnings = []
        self.state = "unfinished"  # or "done", "stopped"
        self.last_words = ""  # of a run that has stopped
        for line in path.read_text(errors="replace").splitlines() if self.exists else []:
            self._read(line)

    def _read(self, line):
        if match := self.STEP.match(line):
            self.attempts.append(Attempt(int(match[1]), float(match[2]), float(match[3])))
            self.state, self.last_words = "unfinished", ""  # also of a run that has been continued
        elif line.startswith("done:"):
            self.state = "done"
        elif line.startswith("stopped:"):
            self.state, self.last_words = "stopped", line[len("stopped:"):].strip()
        elif line.startswith("interrupted:"):
            self.state = "unfinished"
        elif line.startswith("warning:"):
            self.warnings.append(line[len("warning:"):].strip())
        elif self.state == "stopped":
            self.last_words += "\n" + line
        elif self.attempts:
            self._read_of_attempt(self.attempts[-1], line)

    def _read_of_attempt(self, attempt, line):
        if match := self.ITERATION.match(line):
            if int(match[1]) == 0:
                attempt.starts.append(len(attempt.residuals))
            attempt.residuals.append((float(match[2]), float(match[3])))
        elif match := self.PASS.match(line):
            attempt.loop_passes.append((match[1], int(match[2]), float(match[3])))
        elif line.startswith("step failed:"):
            attempt.failure = {"cause": "", "why": line[len("step failed:"):].strip(), "where": "", "try": ""}
        elif attempt.failure is not None and (match := self.EXPLANATION.match(line)):
            attempt.failure[match[1].lower()] = match[2]
        elif line.strip() and not line.split()[0] == "Newton":
            attempt.notes.append(line.strip())

    @property
    def failed_attempts(self):
        return [attempt for attempt in self.attempts if attempt.failure is not None]


class Run:
    """
    One output directory. `case` is the .prm file of the run, for a directory
    that does not keep its parameters, `overrides` are its "Section/Name=value". Throws ResultsError if there is no run.
    """

    def __init__(self, directory, case=None, overrides=()):
        self.directory = pathlib.Path(directory)
        self.label = self.directory.resolve().name
        if not self.directory.is_dir():
            raise ResultsError(f"'{directory}' is not a directory.")
        self.log = Log(self.directory / "convergence.log")
        for name in ("statistics", "resultants", "reactions", "points"):
            setattr(self, name, self.table(f"{name}.csv"))
        self.bodies = FieldSeries(self.directory, "solution")
        self.contact = FieldSeries(self.directory, "contact")
        if not (self.log.exists or self.statistics or self.bodies.steps):
            raise ResultsError(f"'{directory}' is not the output directory of a run: it has neither convergence.log "
                               "nor statistics.csv nor solution.pvd.")
        self.parameters = self._parameters(case, overrides)

    def table(self, name):
        """Columns without rows that are not written to their end; {} if there is nothing."""
        path = self.directory / name
        if not path.exists() or path.stat().st_size == 0:
            return {}
        columns = read_csv(path)
        is_whole = [not isinstance(row[0], str) and "" not in row[:2] and row[-1] != "" for row in zip(*columns.values())]
        return {key: [value for value, whole in zip(values, is_whole) if whole] for key, values in columns.items()}

    def _parameters(self, case, overrides):
        path = self.directory / PARAMETERS
        if not path.exists():
            if case is None:
                return None
            path = pathlib.Path(case)
        else:
            overrides = ()
        try:
            parameters = Parameters.read(path)
        except ParameterFileError as error:
            raise ResultsError(str(error)) from error
        for override in overrides:
            name, equals, value = override.partition("=")
            if not equals or not name.strip():
                raise ResultsError(f"--set '{override}' is not of the form Section/Name=value.")
            parameters.set("/".join(part.strip() for part in name.split("/")), value.strip())
        return parameters

    @property
    def title(self):
        return self.parameters.get("Title", "") if self.parameters else ""

    @property
    def pairs(self):
        """Names of the contact pairs, in the order of their index."""
        return [key[: -len(".force_x")] for key in self.resultants
                if key.endswith(".force_x")]

    @property
    def dimension(self):
        if self.parameters:
            return int(self.parameters.get("Dimension", "2"))
        return 3 if any(key.endswith((".force_z", "_z")) and not key.endswith("moment_z")
                        for key in [*self.resultants, *self.reactions, *self.points]) else 2

    def total(self, column):
        """Sum over the accepted steps; 0 without the column."""
        return sum(value for value in self.statistics.get(column, []) if isinstance(value, float))

    @property
    def n_steps(self):
        return len(self.statistics.get("step", []))

    @property
    def end_time(self):
        return self.statistics["time"][-1] if self.n_steps else 0.0

    @property
    def seconds(self):
        return sum(self.total(column) for column in self.statistics if column.endswith("_seconds"))

    @property
    def n_failed_iterations(self):
        """Of all attempts that were given up, also at a step that was never accepted."""
        last = self.statistics["step"][-1] if self.n_steps else 0
        return self.total("failed_newton_iterations") + sum(
            attempt.n_iterations for attempt in self.log.attempts if attempt.step > last)

    @property
    def n_cuts(self):
        last = self.statistics["step"][-1] if self.n_steps else 0
        return self.total("cuts") + sum(attempt.step > last for attempt in self.log.failed_attempts)

