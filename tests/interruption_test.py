#!/usr/bin/env python3
"""Interrupts runs and continues them: nothing may be lost, nothing wrong may be read.

    interruption_test.py PROGRAM WORKING_DIRECTORY [--kills N] [--flips N] [--seed S]

Signals and Output/Stop after end a run with a checkpoint and exit code 5. Runs are killed at random moments, again and
again, and continued on another number of ranks each time; at the end every table and every number of the state is that
of the uninterrupted run. A disk may be full. A flipped bit anywhere in a checkpoint is refused.
"""
import argparse
import os
import pathlib
import random
import signal
import subprocess
import sys
import time

from checkpoint_runs import Runs, check, compare, failures
from program_runs import environment_of, rows_of

STOPPED = 5
LIMIT = 300  # seconds that a run may take before it counts as hanging


class Process:
    """A run in the background."""

    def __init__(self, runs, name, ranks=1, restart=None, options=()):
        command = ["mpirun", "-np", str(ranks)] if ranks > 1 else []
        command += [runs.program, "case.prm", "--output-directory", name]
        for option in options:
            command += ["--set", option]
        self.directory = runs.directory / name
        self.process = subprocess.Popen(command + (["--restart", restart] if restart else []), cwd=runs.directory,
                                        env=environment_of(ranks), stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                                        errors="backslashreplace")
        self.ranks = ranks

    def wait_for_step(self, step):
        """Returns once the step is in the tables, or the run is over."""
        while self.process.poll() is None and (not (self.directory / "statistics.csv").exists()
                                               or len(rows_of(self.directory / "statistics.csv")) < step):
            time.sleep(0.005)

    def rank_ids(self):
        """Process ids of the ranks."""
        if self.ranks == 1:
            return [self.process.pid]
        children = pathlib.Path(f"/proc/{self.process.pid}/task/{self.process.pid}/children")
        try:
            return [int(word) for word in children.read_text().split()]
        except OSError:
            return []

    def send(self, number, to_rank=None):
        """To the one process, to mpirun, or to one of its ranks. A run that is over gets nothing."""
        ranks = self.rank_ids()
        target = self.process.pid if to_rank is None or to_rank >= len(ranks) else ranks[to_rank]
        if self.process.poll() is None:
            try:
                os.kill(target, number)
            except ProcessLookupError:
                pass

    def end(self):
        """Exit code and what was printed."""
        text = self.process.communicate(timeout=LIMIT)[0]
        return self.process.returncode, text


def test_signals(runs):
    """Who asks for an end gets one soon, with a checkpoint and an exit code that says so."""
    runs.run("uninterrupted")
    for what, ranks, number, to_rank in (("SIGTERM", 1, signal.SIGTERM, None), ("SIGUSR1", 1, signal.SIGUSR1, None),
                                         ("SIGUSR1 to mpirun", 2, signal.SIGUSR1, None),
                                         ("SIGTERM to rank 1", 3, signal.SIGTERM, 1), ("SIGUSR1 to rank 2", 3, signal.SIGUSR1, 2)):
        name = what.replace(" ", "-") + f"-of-{ranks}"
        process = Process(runs, name, ranks, options=["Output/Checkpoint every n steps=0"])
        process.wait_for_step(3)
        process.send(number, to_rank)
        code, text = process.end()
        n_done = n_steps(runs, name)
        check(code == STOPPED and 3 <= n_done < 6, f"{what}: exit code {code} after step {n_done}")
        words = f"stopped: {what.split()[0]} has come. The last accepted state, step {n_done} at t = {n_done}, is saved in '{name}'"
        check(text.count("stickslip: ") == 1 and words in text, f"... and one message that says so: {text.strip()[:300]}")
        runs.run(name, 3 - ranks % 3, "latest")
        compare(runs, name)


def test_mpirun_terminated(runs):
    """Open MPI's mpirun passes SIGTERM on after a second and kills the ranks after another, whatever they do: what is saved
    then depends on the machine, but nothing that was saved is lost. Its exit code is always 1."""
    process = Process(runs, "terminated", 2)
    process.wait_for_step(3)
    process.send(signal.SIGTERM)
    code, _ = process.end()
    check(code in (0, 1), f"SIGTERM to mpirun: exit code {code} after step {n_steps(runs, 'terminated')}")
    runs.run("terminated", 3, "latest")
    compare(runs, "terminated")


def test_time_limit(runs):
    process = Process(runs, "time", 2, options=["Output/Stop after=0 s"])
    code, text = process.end()
    check(code == STOPPED and "'Output/Stop after' (0 s) is used up" in text and "step 0 at t = 0" in text, "stopped before the first step")
    summary = subprocess.run([runs.program, "--diagnose", "time"], cwd=runs.directory, capture_output=True, text=True).stdout
    check("interrupted (--restart latest goes on), 0 steps" in summary, f"--diagnose says so: {summary.strip()[:100]}")
    runs.run("time", 3, "latest", ["Output/Stop after=01:00:00"])
    compare(runs, "time")


def n_steps(runs, name):
    """Rows of the tables of a run that may not have begun."""
    path = runs.directory / name / "statistics.csv"
    return len(rows_of(path)) if path.exists() else 0


def interrupt_again_and_again(runs, name, n_kills, chance):
    """Returns what was done. The uninterrupted run has six steps."""
    story = []
    for _ in range(n_kills):
        ranks = chance.choice([1, 2, 3])
        has_checkpoint = (runs.directory / name / "checkpoint.latest").exists()
        n_before = n_steps(runs, name)
        process = Process(runs, name, ranks, "latest" if has_checkpoint else None)
        if chance.random() < 0.7:
            process.wait_for_step(min(n_before + chance.choice([0, 1, 1]), 5))
        time.sleep(chance.uniform(0., 0.3))
        number = chance.choice([signal.SIGKILL, signal.SIGKILL, signal.SIGTERM, signal.SIGUSR1])
        process.send(number, chance.choice([None, *range(ranks)]))
        code, _ = process.end()
        story.append(f"{ranks}:{signal.Signals(number).name}:{code}:{n_steps(runs, name)}")
        if code == 0:
            break
    return " ".join(story)


def test_kills(runs, n_kills, chance):
    n_left = n_kills
    for chain in range(n_kills):
        if n_left <= 0:
            break
        name = f"killed-{chain}"
        story = interrupt_again_and_again(runs, name, min(n_left, 8), chance)
        n_left -= len(story.split())
        has_checkpoint = (runs.directory / name / "checkpoint.latest").exists()
        check(has_checkpoint or ":0" in story, f"{name} can be continued; ranks:signal:exit code:steps {story}")
        runs.run(name, chance.choice([1, 2, 3]), "latest" if has_checkpoint else None)
        compare(runs, name)


def test_full_disk(runs):
    """Writing one of the files fails as on a full disk: the run ends with a message, and the checkpoint before stays."""
    runs.run("full", 2, options=["Load stepping/End time=2"])
    directory = runs.directory / "full"
    latest = (directory / "checkpoint.latest").read_text().strip()
    older = {"checkpoint-a": "checkpoint-b", "checkpoint-b": "checkpoint-a"}[latest]
    for file, words in ((f"{older}/cells.0", [f"The checkpoint 'full/{latest}' is whole."]),
                        (f"{older}/cells.1", [f"The checkpoint 'full/{latest}' is whole."]),
                        (f"{older}/description.part", [f"The checkpoint 'full/{latest}' is whole."]),
                        ("checkpoint.latest.part", []), ("statistics.csv.part", []), ("parameters.prm.part", [])):
        (directory / file).unlink(missing_ok=True)
        (directory / file).symlink_to("/dev/full")
        text = runs.run("full", 2, "latest", exit_code=1)
        (directory / file).unlink(missing_ok=True)
        check(text.count("stickslip: ") == 1 and f"Cannot write 'full/{file}': No space left on device." in text
              and all(word in text for word in words), f"no space for {file}: {text.strip()[:300]}")
        check((directory / "checkpoint.latest").read_text().strip() == latest, "... the checkpoint before is still the latest")
    runs.run("full", 2, "latest")
    compare(runs, "full")


def test_flips(runs, n_flips, chance):
    """tests/unit/checkpoint_damage.cc flips every bit; here the program reads, on one and on two ranks."""
    runs.run("flips", 3, options=["Load stepping/End time=2"])
    whole = runs.directory / "flips"
    latest = (whole / "checkpoint.latest").read_text().strip()
    older = {"checkpoint-a": "checkpoint-b", "checkpoint-b": "checkpoint-a"}[latest]
    accepted, silent = [], []
    for n in range(n_flips):
        path = whole / chance.choice([f"{latest}/description", f"{latest}/cells.0", f"{latest}/cells.1", f"{latest}/cells.2",
                                      "checkpoint.latest"])
        data = path.read_bytes()
        place, bit = chance.randrange(len(data)), chance.randrange(8)
        path.write_bytes(data[:place] + bytes([data[place] ^ (1 << bit)]) + data[place + 1:])
        code, text = Process(runs, "elsewhere", 2 if n % 8 == 0 else 1, "flips").end()
        path.write_bytes(data)
        what = f"{path.name}, byte {place}, bit {bit}: {text.strip()[:300]}"
        if code != 1:
            accepted.append(what)
        elif f"'flips/{older}'" not in text or text.count("stickslip: ") != 1 or "\\x" in text:
            silent.append(what)
    shown = "".join("\n    " + what for what in (accepted + silent)[:5])
    check(not accepted, f"{n_flips} flipped bits are refused{shown}")
    check(not silent, f"... with a message that names the checkpoint before{shown}")
    # damage of both: none is recommended
    for slot in (latest, older):
        path = whole / slot / "description"
        path.write_bytes(path.read_bytes()[:-1])
    code, text = Process(runs, "elsewhere", 1, "flips").end()
    check(code == 1 and "damaged" in text and "whole" not in text, f"no damaged one is recommended: {text.strip()}")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program", type=os.path.abspath)
    parser.add_argument("directory", type=pathlib.Path)
    parser.add_argument("--kills", type=int, default=8)
    parser.add_argument("--flips", type=int, default=24)
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    runs = Runs(arguments.program, arguments.directory)
    chance = random.Random(arguments.seed)
    for test in (test_signals, test_mpirun_terminated, test_time_limit, test_full_disk):
        test(runs)
    test_flips(runs, arguments.flips, chance)
    test_kills(runs, arguments.kills, chance)
    print(f"{len(failures)} comparisons failed")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
