"""What the tests that start the program several times have in common."""
import csv
import os
import pathlib
import shutil
import subprocess

MARK = ".of_a_test"


def fresh_directory(path):
    """An empty directory; what an earlier test left there goes, and nothing else."""
    path = pathlib.Path(path)
    if path.exists() and any(path.iterdir()) and not (path / MARK).exists():
        raise SystemExit(f"'{path}' holds something that is not of a test. Give another working directory.")
    shutil.rmtree(path, ignore_errors=True)
    path.mkdir(parents=True)
    (path / MARK).touch()
    return path


def environment_of(ranks):
    """The environment of a run: on one rank nobody is waited for (scripts/environment)."""
    return {**os.environ, **({"OMPI_MCA_mpi_yield_when_idle": "0"} if ranks == 1 else {})}


def start(program, arguments, ranks=1):
    """Runs PROGRAM in the present directory; output and errors apart."""
    # mpirun would have the last word about a failure: alone if one rank is enough
    command = [program] if ranks == 1 else ["mpirun", "--oversubscribe", "-np", str(ranks), program]
    return subprocess.run(command + list(arguments), capture_output=True, text=True, env=environment_of(ranks))


def settings(overrides):
    """{"Section/Name": value} as command line options."""
    return [word for name, value in dict(overrides).items() for word in ("--set", f"{name}={value}")]


def rows_of(path):
    """Rows of a CSV file as dictionaries of texts."""
    with open(path, newline="") as file:
        return list(csv.DictReader(file))
