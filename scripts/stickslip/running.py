"""Runs of the program."""
from __future__ import annotations

import os
import pathlib
import shutil
import subprocess
import threading
import time
import typing

from .errors import ResultsError, RunError, StickslipError
from .parameters import Parameters
from .results import Results

HERE = pathlib.Path(__file__).resolve().parent
LOG = "log.txt"  # in an output directory: what the program has printed
STATES = {0: "done", 1: "wrong input", 2: "no convergence", 3: "internal error", 4: "check failed", 5: "interrupted"}


def variables_in(name: str) -> dict[str, str]:
    """Those that a file of NAME=value lines sets."""
    lines = (HERE / name).read_text().split("\n")
    return dict(line.split("=", 1) for line in lines if line and not line.startswith("#"))


def environment() -> dict[str, str]:
    """The caller's environment with that of a run on top (scripts/environment)."""
    return {**os.environ, **variables_in("environment")}


def variables_of(ranks: int) -> dict[str, str]:
    """What the environment has to say besides if a run is started without mpirun, on one rank."""
    return {} if ranks > 1 else variables_in("environment_of_one_rank")


def find_program() -> str:
    """$STICKSLIP, else build/stickslip of the source tree that this package lies in, else stickslip of the PATH."""
    built = HERE.parents[1] / "build" / "stickslip"
    path = os.environ.get("STICKSLIP") or (str(built) if built.exists() else shutil.which("stickslip") or "")
    if not path or not os.access(path, os.X_OK):
        raise StickslipError(f"The program {path or 'stickslip'} is missing; scripts/run builds it, or set STICKSLIP.")
    return path


class Usage(typing.NamedTuple):
    """What a command took, and its exit code."""

    exit_code: int
    seconds: float  # of wall clock; 0 if an earlier run is reused
    cpu_seconds: float  # in user mode, with all processes that it has waited for
    peak_mebibytes: float  # resident, of the largest of these processes
    is_out_of_time: bool = False  # was ended for that; mpirun hides it in its exit code


def measure(command: typing.Sequence[str], log: str | os.PathLike[str], directory: str | os.PathLike[str],
            variables: typing.Mapping[str, str] | None = None, timeout: float | None = None) -> Usage:
    """Runs a command in a directory, its output in the file `log`; the environment is environment() and `variables`."""
    start = time.time()
    is_out_of_time = threading.Event()

    def end() -> None:
        is_out_of_time.set()
        process.terminate()

    with open(log, "w") as stream:
        process = subprocess.Popen(command, stdout=stream, stderr=subprocess.STDOUT, cwd=directory,
                                   env={**environment(), **(variables or {})})
        timer = threading.Timer(timeout or threading.TIMEOUT_MAX, end)
        timer.daemon = True
        timer.start()
        try:
            _, status, usage = os.wait4(process.pid, 0)
        except BaseException:  # the user's Ctrl-C, for example: the run must not go on alone
            process.terminate()
            process.wait()
            raise
        finally:
            timer.cancel()
    process.returncode = os.waitstatus_to_exitcode(status)
    return Usage(process.returncode, time.time() - start, usage.ru_utime, usage.ru_maxrss / 1024, is_out_of_time.is_set())


def command_of(case: str | os.PathLike[str], directory: str | os.PathLike[str], overrides: typing.Mapping[str, typing.Any],
               ranks: int = 1, program: str | None = None) -> list[str]:
    """The command line of a run; with more than one rank that of mpirun."""
    command = [] if ranks == 1 else ["mpirun", "--oversubscribe", "-np", str(ranks)]
    command += [program or find_program(), str(case), "--output-directory", str(directory)]
    for name, value in overrides.items():
        command += ["--set", f"{name}={Parameters.text_of(value)}"]
    return command


def _written(parameters: Parameters, directory: pathlib.Path) -> pathlib.Path:
    """The case of a dictionary as a file in its output directory; names of mesh files start at the present directory."""
    for body in parameters.sections("Bodies"):
        name = f"Bodies/{body}/Mesh file"
        if parameters.get(name):
            parameters.set(name, pathlib.Path(parameters.get(name)).resolve())
    path = directory / "case.prm"
    path.write_text(parameters.text())
    return path


def run(case: str | os.PathLike[str] | typing.Mapping[str, typing.Any],
        settings: typing.Mapping[str, typing.Any] | None = None, *, directory: str | os.PathLike[str] | None = None,
        ranks: int = 1, check: bool = True, timeout: float | None = None, program: str | None = None,
        **overrides: typing.Any) -> Results:
    """
    Runs a case and returns its results.

        results = stickslip.run("case.prm", Degree=2, ranks=2)
        results = stickslip.run("case.prm", {"Mesh/Global refinements": 1}, directory="fine")
        results = stickslip.run({"Dimension": 2, "Bodies": {"block": {"Generator": "hyper_cube", ...}}, ...})

    `case` is a .prm file or a dictionary, of sections or of "Section/Name";
    `settings` and `overrides` replace its values. Lists and booleans become what
    a .prm has for them. The output goes to `directory` (default: the case's
    'Output/Directory', in the present directory), what the program prints to
    log.txt there. A `timeout` (seconds) ends the run like SIGTERM, with a checkpoint.

    Throws RunError, with exit code and what the program said, unless the run ends
    with exit code 0; with `check=False` only if there are no results.
    """
    if ranks < 1:
        raise StickslipError(f"run(): ranks is {ranks}; it has to be at least 1.")
    values = {**(settings or {}), **overrides}
    parameters = Parameters.of(case) if isinstance(case, typing.Mapping) else Parameters.read(case)
    chosen = directory or values.get("Output/Directory") or parameters.get("Output/Directory", "results")
    output = pathlib.Path(str(chosen)).resolve()
    output.mkdir(parents=True, exist_ok=True)
    path = _written(parameters, output) if isinstance(case, typing.Mapping) else pathlib.Path(case).resolve()
    values.pop("Output/Directory", None)
    usage = measure(command_of(path, output, values, ranks, program), output / LOG, os.getcwd(),
                    variables_of(ranks), timeout)
    try:
        results = Results(output) if usage.exit_code != 1 else None
    except ResultsError:
        results = None
    if results is not None:
        results.exit_code = usage.exit_code
    if results is None or (check and usage.exit_code != 0):
        raise RunError(usage.exit_code, _message(output / LOG, usage), results)
    return results


def _message(log: pathlib.Path, usage: Usage) -> str:
    """The program's own words about its failure, or the end of what it printed."""
    text = log.read_text(errors="replace").split("\n-----")[0].strip()  # mpirun's own report follows
    said = text.rfind("stickslip: ")
    words = text[said:] if said >= 0 else "\n".join(text.split("\n")[-5:])
    state = "out of time" if usage.is_out_of_time else STATES.get(usage.exit_code, "killed")
    return f"The run ended with exit code {usage.exit_code} ({state}): {words}"
