"""convergence.log: every attempt at a load step, warnings, how the run ended."""
from __future__ import annotations

import dataclasses
import pathlib
import re


@dataclasses.dataclass
class Attempt:
    """One attempt at a load step."""

    step: int
    time: float
    size: float
    #: (equilibrium, contact) of each Newton iteration; number 0 begins a solve
    residuals: list[tuple[float, float]] = dataclasses.field(default_factory=list)
    #: index into residuals where a Newton solve begins
    starts: list[int] = dataclasses.field(default_factory=list)
    #: (loop, pass, change)
    loop_passes: list[tuple[str, int, float]] = dataclasses.field(default_factory=list)
    #: what was said in between: fallbacks, retries
    notes: list[str] = dataclasses.field(default_factory=list)
    #: {"cause", "why", "where", "try"} if the attempt was given up
    failure: dict[str, str] | None = None

    @property
    def n_iterations(self) -> int:
        return len(self.residuals) - len(self.starts)


class ConvergenceLog:
    """Reads the file if it is there (`exists`); `state` is "done", "stopped" or "unfinished"."""

    ITERATION = re.compile(r"\s+(\d+)\s+(\S+)\s+(\S+)\s+\S+\s+\S+\s+\S+\s*$")
    STEP = re.compile(r"step (\d+) to t = (\S+) \(size (\S+)\)")
    PASS = re.compile(r"\s+(\w+) pass (\d+): change (\S+)")
    EXPLANATION = re.compile(r"\s*(cause|why|where|try):\s*(.*)", re.IGNORECASE)

    def __init__(self, path: pathlib.Path):
        self.exists = path.exists()
        self.attempts: list[Attempt] = []
        self.warnings: list[str] = []
        self.state = "unfinished"
        self.last_words = ""  # of a run that has stopped
        for line in path.read_text(errors="replace").splitlines() if self.exists else []:
            self._read(line)

    def _read(self, line: str) -> None:
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

    def _read_of_attempt(self, attempt: Attempt, line: str) -> None:
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
    def failed_attempts(self) -> list[Attempt]:
        return [attempt for attempt in self.attempts if attempt.failure is not None]
