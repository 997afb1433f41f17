#!/usr/bin/env python3
"""Wrong input has to end in one clear message, on any number of ranks.

Each case is a file of application/data/ with some parameters changed
(bad_problems.py, bad_materials.py, ..., bad_runs.py), or a command line. The program has to exit with
the expected code and to print, once, the expected words, and nothing that looks
like a crash. What the reader of parameter files finds, which one rank does, is
tried on several ranks for every eleventh input only: a start of mpirun takes a second.

usage: bad_input.py PROGRAM MPIEXEC N_RANKS [--part K/N] [--verbose]
"""

import concurrent.futures
import os
import re
import subprocess
import sys
import tempfile

import bad_adaptations
import bad_bolts
import bad_materials
import bad_motions
import bad_periodicities
import bad_problems
import bad_runs
import bad_tools
from bad_words import HERE, WRONG_INPUT
from program_runs import environment_of

CASES = {**bad_problems.CASES, **bad_materials.CASES, **bad_motions.CASES, **bad_adaptations.CASES, **bad_tools.CASES,
         **bad_bolts.CASES, **bad_periodicities.CASES, **bad_runs.CASES}
CRASH = ["backtrace", "segmentation", "signal", "aborted", "internal error", "terminate called", "an error occurred in line", "stacktrace"]


def find_faults(expected_code, words, output, code):
    faults = []
    if code != expected_code:
        faults.append("exit code %d instead of %d" % (code, expected_code))
    # mpirun's own report of the exit code follows the program's message
    text = re.split(r"\n-{20,}\n", output)[0]
    faults += ["'%s' is missing" % word for word in words if word not in text]
    if text.count("stickslip: ") > 1 or text.count("FALLS SHORT") > 1:
        faults.append("the message is printed more than once")
    faults += ["'%s' appears" % word for word in CRASH if word in text.lower()]
    if len(text) > 25000:
        faults.append("the message has %d characters" % len(text))
    return faults


class Inputs:
    def __init__(self, program, mpiexec, n_ranks, all_of_them):
        self.program, self.mpiexec, self.n_ranks = program, mpiexec, n_ranks
        self.all = {name: (base, text, ["case.prm"], code, words) for name, (base, text, code, words) in CASES.items()}
        self.all.update({"command line: " + name: ("plate.prm", "", arguments, WRONG_INPUT, words)
                         for name, (arguments, words) in bad_runs.COMMAND_LINES.items()})
        self.names = [name for i, (name, case) in enumerate(self.all.items())
                      if n_ranks == 1 or all_of_them or i % 6 == 0 or case[3] != WRONG_INPUT]

    def start(self, arguments, directory):
        command = [self.program, *arguments]
        if self.n_ranks > 1:
            command = [self.mpiexec, "-n", str(self.n_ranks)] + command
        result = subprocess.run(command, cwd=directory, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=300,
                                env=environment_of(self.n_ranks))
        return result.stdout, result.returncode

    def run(self, name):
        """What is wrong with the answer to an input, and the answer."""
        base, text, arguments, code, words = self.all[name]
        with tempfile.TemporaryDirectory() as directory:
            with open(os.path.join(directory, "case.prm"), "w") as file:
                file.write("include %s\n%s\n" % (os.path.relpath(os.path.join(HERE, base), directory), text))
            output, found = self.start(arguments, directory)
        return find_faults(code, words, output, found), output


def main():
    program, mpiexec, n_ranks = os.path.abspath(sys.argv[1]), sys.argv[2], int(sys.argv[3])
    verbose = "--verbose" in sys.argv
    part, n_parts = map(int, sys.argv[sys.argv.index("--part") + 1].split("/")) if "--part" in sys.argv else (1, 1)
    inputs = Inputs(program, mpiexec, n_ranks, "--all" in sys.argv)
    names = inputs.names[part - 1::n_parts]
    n_wrong = 0
    # a start is mostly waiting; more at a time than cores would only wait for each other
    with concurrent.futures.ThreadPoolExecutor(2 if n_ranks == 1 else 1) as pool:
        for name, (faults, output) in zip(names, pool.map(inputs.run, names)):
            n_wrong += 1 if faults else 0
            if faults or verbose:
                print("%s: %s" % (name, "; ".join(faults) if faults else "as expected"))
                print("    " + output.strip()[:600].replace("\n", "\n    "), flush=True)
    print("%d of %d wrong inputs are reported well." % (len(names) - n_wrong, len(names)))
    return 1 if n_wrong else 0


if __name__ == "__main__":
    sys.exit(main())
