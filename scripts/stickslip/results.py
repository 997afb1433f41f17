"""The output directory of a run: tables, log, steps with fields, parameters."""
from __future__ import annotations

import os
import pathlib
import typing

from .convergence_log import ConvergenceLog
from .errors import ParameterFileError, ResultsError
from .fields import FieldSeries
from .parameters import Parameters
from .tables import Table

PARAMETERS = "parameters.prm"  # in an output directory: the parameters of its run
TABLES = ("statistics", "resultants", "reactions", "points")


class Results:
    """
    results = Results("results")
    results.statistics["newton_iterations"]   # Table: columns as numpy arrays, empty without the file
    results.log.attempts                      # every attempt at a load step
    results.bodies.steps[-1].vtk()            # steps with fields: bodies, contact
    results.parameters                        # Parameters, or None

    `case` is the .prm file of the run, for a directory that does not keep its
    parameters, `overrides` are its "Section/Name=value". Throws ResultsError if
    there is no run.
    """

    statistics: Table
    resultants: Table
    reactions: Table
    points: Table

    def __init__(self, directory: str | os.PathLike[str], case: str | os.PathLike[str] | None = None,
                 overrides: typing.Iterable[str] = ()):
        self.directory = pathlib.Path(directory)
        self.label = self.directory.resolve().name
        self.exit_code: int | None = None  # known where run() has made the results
        if not self.directory.is_dir():
            raise ResultsError(f"'{directory}' is not a directory.")
        self.log = ConvergenceLog(self.directory / "convergence.log")
        for name in TABLES:
            setattr(self, name, self.table(f"{name}.csv"))
        self.bodies = FieldSeries(self.directory, "solution")
        self.contact = FieldSeries(self.directory, "contact")
        #: Rigid tools without facets, as pieces of their surfaces.
        self.tools = FieldSeries(self.directory, "tools")
        if not (self.log.exists or self.statistics or self.bodies.steps):
            raise ResultsError(f"'{directory}' is not the output directory of a run: it has neither convergence.log "
                               "nor statistics.csv nor solution.pvd.")
        self.parameters = self._parameters(case, overrides)

    def table(self, name: str) -> Table:
        """NAME of the directory without a row that is not written to its end; without columns if there is nothing."""
        path = self.directory / name
        return Table.read(path, only_whole_rows=True) if path.exists() else Table({}, path)

    def contact_points(self, step: int) -> Table:
        """All contact points of a step ('Output/Contact points'); ResultsError if they were not written."""
        path = self.directory / f"contact_points-{step:04d}.csv"
        if not path.exists():
            raise ResultsError(f"'{path}' is not there: 'Output/Contact points' writes it, for steps with fields.")
        return Table.read(path)

    @property
    def diagnosis(self) -> Table:
        """The contact points of the last step that failed for good; without columns if none did."""
        files = sorted(self.directory.glob("diagnosis-*.csv"))
        return Table.read(files[-1]) if files else Table({})

    def _parameters(self, case: str | os.PathLike[str] | None, overrides: typing.Iterable[str]) -> Parameters | None:
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

    # ----------------------------------------------------------------- the case
    @property
    def title(self) -> str:
        return self.parameters.get("Title", "") if self.parameters else ""

    @property
    def pairs(self) -> list[str]:
        """Names of the contact pairs, in the order of their index."""
        return [key[: -len(".force_x")] for key in self.resultants if key.endswith(".force_x")]

    @property
    def dimension(self) -> int:
        if self.parameters:
            return int(self.parameters.get("Dimension", "2"))
        return 3 if any(key.endswith((".force_z", "_z")) and not key.endswith("moment_z")
                        for key in [*self.resultants, *self.reactions, *self.points]) else 2

    # ------------------------------------------------------------- what happened
    def total(self, column: str) -> float:
        """Of statistics.csv: sum over the accepted steps; 0 without the column."""
        return self.statistics.total(column)

    @property
    def n_steps(self) -> int:
        return self.statistics.n_rows

    @property
    def end_time(self) -> float:
        return float(self.statistics.last("time")) if self.n_steps else 0.0

    @property
    def seconds(self) -> float:
        """Wall-clock time in accepted steps."""
        return sum(self.total(column) for column in self.statistics if column.endswith("_seconds"))

    @property
    def _last_step(self) -> int:
        return int(self.statistics.last("step")) if self.n_steps else 0

    @property
    def n_failed_iterations(self) -> float:
        """Of all attempts that were given up, also at a step that was never accepted."""
        return self.total("failed_newton_iterations") + sum(
            attempt.n_iterations for attempt in self.log.attempts if attempt.step > self._last_step)

    @property
    def n_cuts(self) -> float:
        return self.total("cuts") + sum(attempt.step > self._last_step for attempt in self.log.failed_attempts)
