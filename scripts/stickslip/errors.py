"""What can go wrong; the texts are for users."""
from __future__ import annotations

import typing

if typing.TYPE_CHECKING:
    from .results import Results


class StickslipError(Exception):
    """Of all errors of this package."""


class ParameterFileError(StickslipError):
    """A parameter file cannot be read."""


class ResultsError(StickslipError):
    """What was given are not the results of a run, or they have not what is asked for."""


class RunError(StickslipError):
    """A run that did not end with exit code 0; `results` are those until then, None if there are none."""

    def __init__(self, exit_code: int, text: str, results: Results | None = None):
        super().__init__(text)
        self.exit_code = exit_code
        self.results = results
