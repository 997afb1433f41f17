"""What the tests that start the program several times have in common."""
import csv
import os
import pathlib
import shutil
import subprocess

MARK = ".of_a_test"
SCRIPTS = pathlib.Path(__file__).resolve().parents[1] / "scripts"


def fresh_directory(path):
    """An empty directory; what an earlier test left there goes, and nothing else."""
    path = pathlib.Path(path)
    if path.exists() and any(path.iterdir()) and not (path / MARK).exists():
        raise SystemExit(f"'{path}' holds something that is not of a test. Give another working directory.")
    shutil.rmtree(path, ignore_errors=True)
    path.mkdir(parents=True)
    (path / MARK).touch()
    return path


def variables_in(name):
    """Those that a file of NAME=value lines sets."""
    lines = (SCRIPTS / name).read_text().split("\n")
    return dict(line.split("=", 1) for line in lines if line and not line.startswith("#"))


def environment_of(ranks):
    """The environment of a run, which on one rank is started without mpirun."""
    return {**variables_in("environment"), **os.environ, **(variables_in("environment_of_one_rank") if ranks == 1 else {})}


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
