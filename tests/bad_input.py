#!/usr/bin/env python3
"""Wrong input has to end in one clear message, on any number of ranks.

Each case is application/data/plate.prm (or another) with some parameters
changed. The program has to exit with the expected code and to print, once,
the expected words, and nothing that looks like a crash.

usage: bad_input.py PROGRAM MPIEXEC N_RANKS [--verbose]
"""

import os
import re
import subprocess
import sys
import tempfile

HERE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "application", "data")
WRONG_INPUT, NO_CONVERGENCE, CHECK_FALLS_SHORT = 1, 2, 4
CRASH = ["backtrace", "segmentation", "signal", "aborted", "internal error", "terminate called", "an error occurred in line", "stacktrace"]

ONE_STEP = "subsection Load stepping\n set Initial step = 1\n set Minimum step = 0.9\nend\n"


def material(law, *lines):
    """The material of the block."""
    return "subsection Materials\n subsection matter\n set Law = %s\n %s\n end\nend\n" % (law, "\n ".join(lines))


# name: (file, text added below an include of it, exit code, words of the message)
CASES = {
    "unknown parameter": (
        "plate.prm", "subsection Contact\n subsection base\n set Fricton coefficient = 1\n end\nend",
        WRONG_INPUT, ["Fricton coefficient", "Did you mean 'Friction coefficient'", "case.prm:4"]),
    "unknown expert parameter": (
        "plate.prm", "subsection Contact\n subsection base\n set Facet overlp = 0\n end\nend",
        WRONG_INPUT, ["Facet overlp", "Did you mean 'Facet overlap'", "'Normals'"]),
    "unknown section": ("plate.prm", "subsection Algoritm\nend", WRONG_INPUT, ["Algoritm", "Did you mean 'Algorithm'"]),
    "not a number": ("plate.prm", "set Degree = two", WRONG_INPUT, ["Degree", "two"]),
    "unknown choice": ("plate.prm", "subsection Algorithm\n set Name = GMN\nend", WRONG_INPUT, ["Algorithm/Name", "GMN", "FPM"]),
    "subsection not closed": ("plate.prm", "subsection Mesh", WRONG_INPUT, ["Mesh", "'end'"]),
    "empty boundary id": (
        "plate.prm", "subsection Contact\n subsection base\n set Slave boundary = 7\n end\nend",
        WRONG_INPUT, ["Contact/base/Slave boundary", "7", "0, 1, 2, 3"]),
    "unknown body": (
        "plate.prm", "subsection Contact\n subsection base\n set Slave body = palte\n end\nend",
        WRONG_INPUT, ["Contact/base/Slave", "palte", "'plate'"]),
    "unknown material": (
        "plate.prm", "subsection Bodies\n subsection plate\n set Material = stel\n end\nend", WRONG_INPUT, ["stel", "'steel'"]),
    "slave and master overlap": (
        "plate.prm",
        "subsection Contact\n subsection base\n set Slave boundary = 1, 2\n set Master body = plate\n set Master boundary = 2\n end\nend",
        WRONG_INPUT, ["Contact/base", "slave", "master", "'plate'"]),
    "negative Poisson's ratio": (
        "plate.prm", "subsection Materials\n subsection steel\n set Poisson's ratio = -1.2\n end\nend",
        WRONG_INPUT, ["Poisson's ratio", "-1.2", "greater than -1 and less than 0.5"]),
    "zero modulus": (
        "plate.prm", "subsection Materials\n subsection steel\n set Young's modulus = 0\n end\nend",
        WRONG_INPUT, ["Young's modulus", "greater than 0"]),
    "missing mesh file": (
        "plate.prm", "subsection Bodies\n subsection plate\n set Generator =\n set Arguments =\n set Mesh file = nowhere.msh\n end\nend",
        WRONG_INPUT, ["nowhere.msh"]),
    "inverted cells": (
        "plate.prm", "subsection Bodies\n subsection plate\n set Coordinates = 40 - x; y\n end\nend", WRONG_INPUT, ["plate", "invert"]),
    "unknown generator": (
        "plate.prm", "subsection Bodies\n subsection plate\n set Generator = hyper_rectangel\n end\nend",
        WRONG_INPUT, ["hyper_rectangel", "Did you mean 'hyper_rectangle'"]),
    "wrong expression": (
        "plate.prm", "subsection Boundary conditions\n subsection top\n set Value = 50*q\n end\nend",
        WRONG_INPUT, ["Boundary conditions/top/Value", "50*q"]),
    "a displacement that is not a number": (
        "block.prm", material("linear elastic") + "subsection Boundary conditions\n subsection x1\n set Value = sqrt(-t); free; free\n end\nend",
        WRONG_INPUT, ["Boundary conditions/x1", "not a number", "time"]),
    "a load that is not a number": (
        "plate.prm", "subsection Boundary conditions\n subsection top\n set Value = 50*sqrt(-t)\n end\nend",
        WRONG_INPUT, ["Boundary conditions", "A load", "not a number", "time 1"]),
    "a gap offset that is not a number": (
        "plate.prm", "subsection Contact\n subsection base\n set Gap offset = sqrt(-t)\n end\nend",
        WRONG_INPUT, ["Contact/base/Gap offset", "not a number", "time 1"]),
    "fewer contact points than multipliers": (
        "plate.prm", "set Degree = 2\nsubsection Contact\n subsection base\n set Quadrature = Gauss\n set Quadrature order = 2\n end\nend",
        WRONG_INPUT, ["Contact/base/Quadrature", "Quadrature order", "2 contact points", "3 multipliers", "Multiplier space", "Degree"]),
    "fewer contact points than multipliers in 3D": (
        "plate_3d.prm", "set Degree = 2\nsubsection Contact\n subsection base\n set Quadrature = Newton-Cotes\n set Quadrature order = 1\n end\nend",
        WRONG_INPUT, ["Contact/base/Quadrature", "Quadrature order", "4 contact points", "9 multipliers"]),
    "GCP without nodal quadrature": (
        "plate.prm", "set Degree = 1\nsubsection Contact\n subsection base\n set Quadrature = Gauss\n end\nend\nsubsection Algorithm\n set Name = GCP\nend",
        WRONG_INPUT, ["Contact/base/Quadrature", "Gauss", "GCP", "nodal"]),
    "unsupported regularization": (
        "plate.prm", "subsection Contact\n subsection base\n set Quadrature = Gauss\n subsection Regularization\n set r_t status = 3\n set r_t law = 1\n end\n end\nend",
        WRONG_INPUT, ["r_t status", "r_t law"]),
    "questionable regularization": (
        "plate.prm", "subsection Contact\n subsection base\n subsection Regularization\n set r_t status = 3\n set r_t law = 1\n end\n end\nend\n"
        "subsection Output\n set Verbosity = progress\nend",
        0, ["Warning: 'Contact/base/Regularization/r_t status'"]),
    "body that nothing holds": ("unheld_block.prm", "", WRONG_INPUT, ["'block'", "translation along x"]),
    "output directory is a file": ("plate.prm", "subsection Output\n set Directory = case.prm\nend", WRONG_INPUT, ["Output/Directory", "case.prm"]),
    "unknown quantity in a check": (
        "patch_test.prm", "subsection Checks\n subsection a\n set Quantity = c.force_q\n set Expected = 1\n end\nend",
        WRONG_INPUT, ["c.force_q", "Did you mean 'c.force_"]),
    "F-bar with a law of small strains": (
        "block.prm", material("linear elastic", "set Element = F-bar"), WRONG_INPUT, ["Materials/matter/Element", "Take B-bar"]),
    "F-bar with quadratic elements": (
        "block.prm", material("Hencky", "set Element = F-bar") + "set Degree = 2", WRONG_INPUT, ["Materials/matter/Element", "Degree is 2"]),
    "hardening that softens": (
        "block.prm", material("small-strain plasticity", "set Hardening = linear", "set Hardening modulus = -1"),
        WRONG_INPUT, ["Materials/matter/Hardening modulus", "-1", "at least 0"]),
    "a step that turns cells inside out": (
        "block.prm", material("Simo-Miehe plasticity", "set Element = F-bar") + ONE_STEP
        + "subsection Boundary conditions\n subsection x1\n set Value = -1.5*t; free; free\n end\nend",
        NO_CONVERGENCE, ["The volume is not positive in body 'block' at the reference position ("]),
    "a check that falls short": (
        "patch_test.prm", "subsection Checks\n subsection a\n set Quantity = c.force_y\n set Expected = 26\n end\nend",
        CHECK_FALLS_SHORT, ["FALLS SHORT"]),
}


def find_faults(name, output, code):
    _, _, expected_code, words = CASES[name]
    faults = []
    if code != expected_code:
        faults.append("exit code %d instead of %d" % (code, expected_code))
    # mpirun's own report of the exit code follows the program's message
    text = re.split(r"\n-{20,}\n", output)[0]
    faults += ["'%s' is missing" % word for word in words if word not in text]
    if text.count("stickslip: ") > 1 or text.count("FALLS SHORT") > 1:
        faults.append("the message is printed more than once")
    faults += ["'%s' appears" % word for word in CRASH if word in text.lower()]
    return faults


def main():
    program, mpiexec, n_ranks = os.path.abspath(sys.argv[1]), sys.argv[2], int(sys.argv[3])
    verbose = "--verbose" in sys.argv
    n_wrong = 0
    for name, (base, addition, _, _) in CASES.items():
        with tempfile.TemporaryDirectory() as directory:
            include = os.path.relpath(os.path.join(HERE, base), directory)
            with open(os.path.join(directory, "case.prm"), "w") as file:
                file.write("include %s\n%s\n" % (include, addition))
            command = [program, "case.prm"]
            if n_ranks > 1:
                command = [mpiexec, "-n", str(n_ranks)] + command
            result = subprocess.run(
                command, cwd=directory, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=120)
        faults = find_faults(name, result.stdout, result.returncode)
        n_wrong += 1 if faults else 0
        if faults or verbose:
            print("%s: %s" % (name, "; ".join(faults) if faults else "as expected"))
            print("    " + result.stdout.strip()[:600].replace("\n", "\n    "))
    print("%d of %d wrong inputs are reported well." % (len(CASES) - n_wrong, len(CASES)))
    return 1 if n_wrong else 0


if __name__ == "__main__":
    sys.exit(main())
