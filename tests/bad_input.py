#!/usr/bin/env python3
"""Wrong input has to end in one clear message, on any number of ranks.

Each case is application/data/plate.prm (or another) with some parameters
changed. The program has to exit with the expected code and to print, once,
the expected words, and nothing that looks like a crash.

usage: bad_input.py PROGRAM MPIEXEC N_RANKS [--verbose]
"""

import concurrent.futures
import os
import re
import subprocess
import sys
import tempfile

from program_runs import environment_of

HERE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "application", "data")
WRONG_INPUT, NO_CONVERGENCE, CHECK_FALLS_SHORT, STOPPED = 1, 2, 4, 5
CRASH = ["backtrace", "segmentation", "signal", "aborted", "internal error", "terminate called", "an error occurred in line", "stacktrace"]

ONE_STEP = "subsection Load stepping\n set Initial step = 1\n set Minimum step = 0.9\nend\n"


def material(law, *lines):
    """The material of the block."""
    return "subsection Materials\n subsection matter\n set Law = %s\n %s\n end\nend\n" % (law, "\n ".join(lines))


def section(name, *lines):
    return "subsection %s\n set %s\nend\n" % (name, "\n set ".join(lines))


def body(name, *lines):
    return "subsection Bodies\n subsection %s\n set %s\n end\nend\n" % (name, "\n set ".join(lines))


def condition(body_name, boundary, *lines):
    """Another condition."""
    name = "%s on %s of %s" % (lines[0].replace("=", "").split(";")[0], boundary, body_name)
    return "subsection Boundary conditions\n subsection %s\n set Body = %s\n set Boundary = %s\n set %s\n end\nend\n" % (
        name, body_name, boundary, "\n set ".join(lines))


def pair(*lines):
    """The pair of the plate."""
    return "subsection Contact\n subsection base\n set %s\n end\nend\n" % "\n set ".join(lines)


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
    # ------------------------------------------------------------- bodies that nothing holds
    "bodies that contact alone joins": (
        "floating_blocks.prm", "", WRONG_INPUT, ["bodies 'lower', 'upper'", "translation along x", "rotation about z", "contact alone"]),
    "joined bodies free to slide together": (
        "floating_blocks.prm", condition("lower", 2, "Value = free; 0"), WRONG_INPUT, ["bodies 'lower', 'upper': translation along x"]),
    "a weakly held body": (
        "floating_blocks.prm", condition("lower", 2, "Value = 0; 0") + condition("upper", 3, "Type = traction", "Value = 0.1*t; -t")
        + condition("upper", 0, "Type = spring", "Stiffness = 1e-17") + ONE_STEP,
        NO_CONVERGENCE, ["Cause: weakly held body", "body 'upper': translation along x", "a stiffer spring"]),
    "a pair that never meets": (
        "floating_blocks.prm", condition("lower", 2, "Value = 0; 0") + condition("upper", 3, "Value = 0; t") + body("upper", "Translation = 0, 9, 0"),
        0, ["Warning: contact pair 'interface' has not acted", "Search distance"]),
    # ------------------------------------------------------------- meshes
    "nodes that are there twice": (
        "unheld_block.prm", body("block", "Generator =", "Arguments =", f"Mesh file = {HERE}/cracked.msh")
        + condition("block", 2, "Value = 0; 0") + condition("block", 3, "Value = 0; 0"),
        0, ["Warning: Bodies/block: 1 face of its boundary, first at (0.5, 1), lie", "Merge the nodes"]),
    "coordinates that are not numbers": (
        "plate.prm", body("plate", "Coordinates = x; sqrt(y-1)"), WRONG_INPUT, ["Bodies/plate/Coordinates", "sqrt(y-1)", "not a finite number", "(0, 0)"]),
    "infinite coordinates": ("plate.prm", body("plate", "Coordinates = x/0; y"), WRONG_INPUT, ["Bodies/plate/Coordinates", "not a finite number"]),
    "one coordinate": ("plate.prm", body("plate", "Coordinates = x"), WRONG_INPUT, ["Bodies/plate/Coordinates", "1 expressions, expected 2"]),
    "coordinates with an unknown variable": ("plate.prm", body("plate", "Coordinates = x; w"), WRONG_INPUT, ["Bodies/plate/Coordinates", "w"]),
    "negative refinements": ("plate.prm", body("plate", "Refinements = -1"), WRONG_INPUT, ["Bodies/plate/Refinements", "-1"]),
    "scale zero": ("plate.prm", body("plate", "Scale = 0, 1"), WRONG_INPUT, ["Bodies/plate"]),
    "wrong arguments of a generator": ("plate.prm", body("base", "Arguments = one"), WRONG_INPUT, ["Bodies/base/Arguments", "'first corner' is missing"]),
    "a mesh file that is a directory": ("plate.prm", body("plate", "Generator =", "Arguments =", "Mesh file = ."), WRONG_INPUT, ["Bodies/plate/Mesh file"]),
    "a mesh file of text": ("plate.prm", body("plate", "Generator =", "Arguments =", "Mesh file = case.prm"), WRONG_INPUT, ["case.prm"]),
    "a boundary id that no face gets": ("plate.prm", body("plate", "Boundary ids = 7: x > 1000"), WRONG_INPUT, ["Bodies/plate/Boundary ids", "marks no face"]),
    # ------------------------------------------------------------- boundary conditions
    "negative boundary": ("plate.prm", condition("plate", "-2", "Value = 0; 0"), WRONG_INPUT, ["/Boundary", "'-2'", "0, 1, 2, 3"]),
    "negative slave boundary": ("plate.prm", pair("Slave boundary = -2"), WRONG_INPUT, ["Contact/base/Slave boundary", "'-2'", "0, 1, 2, 3"]),
    "boundary in words": ("plate.prm", condition("plate", "left", "Value = 0; 0"), WRONG_INPUT, ["/Boundary", "'left'", "0, 1, 2, 3"]),
    "boundary beyond all integers": ("plate.prm", condition("plate", "99999999999", "Value = 0; 0"), WRONG_INPUT, ["/Boundary"]),
    "a component too many": ("plate.prm", condition("plate", 1, "Value = 0; 0; 0"), WRONG_INPUT, ["/Value", "0; 0; 0"]),
    "a pressure of two components": ("plate.prm", condition("plate", 3, "Type = pressure", "Value = 1; 1"), WRONG_INPUT, ["/Value"]),
    "a negative spring": ("plate.prm", condition("plate", 3, "Type = spring", "Stiffness = -1"), WRONG_INPUT, ["/Stiffness", "-1"]),
    "a condition of an unknown type": ("plate.prm", condition("plate", 3, "Type = glue"), WRONG_INPUT, ["/Type", "glue", "spring"]),
    "a condition on no body": ("plate.prm", condition("", 3, "Value = 0; 0"), WRONG_INPUT, ["/Body"]),
    "a place that no node has": (
        "plate.prm", "subsection Boundary conditions\n subsection corner\n set Where = x > 1000\n end\nend", WRONG_INPUT, ["Boundary conditions/corner", "no component of any node"]),
    # ------------------------------------------------------------- load stepping, output, solver
    "a time that ends before it begins": ("plate.prm", section("Load stepping", "End time = -1"), WRONG_INPUT, ["Load stepping/End time", "larger than 0"]),
    "a step of zero": ("plate.prm", section("Load stepping", "Initial step = 0"), WRONG_INPUT, ["Load stepping/Initial step", "larger than 0"]),
    "a minimum above the step": (
        "plate.prm", section("Load stepping", "Initial step = 0.1", "Minimum step = 0.2"), WRONG_INPUT, ["Load stepping/Minimum step", "Initial step"]),
    "a requested time after the end": ("plate.prm", section("Load stepping", "Requested times = 2"), WRONG_INPUT, ["Load stepping/Requested times"]),
    "a time limit without unit": ("plate.prm", section("Output", "Stop after = 30"), WRONG_INPUT, ["Output/Stop after", "30", "3 h", "hours:minutes:seconds"]),
    "an ambiguous time limit": ("plate.prm", section("Output", "Stop after = 12:30"), WRONG_INPUT, ["Output/Stop after", "12:30"]),
    "a time limit in words": ("plate.prm", section("Output", "Stop after = tomorrow"), WRONG_INPUT, ["Output/Stop after", "tomorrow"]),
    "a time limit that is over": ("plate.prm", section("Output", "Stop after = 0 s"), STOPPED, ["Output/Stop after", "--restart latest"]),
    "checkpoints at negative intervals": ("plate.prm", section("Output", "Checkpoint every n steps = -1"), WRONG_INPUT, ["Checkpoint every n steps", "-1"]),
    "perhaps a checkpoint at the end": ("plate.prm", section("Output", "Checkpoint at the end = perhaps"), WRONG_INPUT, ["Checkpoint at the end", "perhaps"]),
    "no output directory": ("plate.prm", section("Output", "Directory ="), WRONG_INPUT, ["Output/Directory", "a name is needed"]),
    "an unknown format": ("plate.prm", section("Output", "Format = vtk"), WRONG_INPUT, ["Output/Format", "vtk", "hdf5"]),
    "fields every zero steps": ("plate.prm", section("Output", "Every n steps = 0"), WRONG_INPUT, ["Output/Every n steps", "0"]),
    "a point outside of its body": (
        "plate.prm", "subsection Output\n subsection Points\n subsection A\n set Position = 100, 100\n end\n end\nend",
        WRONG_INPUT, ["Output/Points/A/Position", "(100 100)"]),
    "a point with three coordinates in 2D": (
        "plate.prm", "subsection Output\n subsection Points\n subsection A\n set Position = 0, 0, 0\n end\n end\nend",
        WRONG_INPUT, ["Output/Points/A/Position", "3 coordinates", "2 dimensions"]),
    "an unknown solver": ("plate.prm", section("Linear solver", "Name = LU"), WRONG_INPUT, ["Linear solver/Name", "LU", "MUMPS"]),
    "a tolerance that is negative": (
        "plate.prm", "subsection Algorithm\n subsection Newton\n set Equilibrium tolerance = -1\n end\nend", WRONG_INPUT, ["Equilibrium tolerance", "-1"]),
    "dimension four": ("plate.prm", "set Dimension = 4", WRONG_INPUT, ["Dimension", "4"]),
    "degree zero": ("plate.prm", "set Degree = 0", WRONG_INPUT, ["Degree", "0"]),
    # ------------------------------------------------------------- contact and materials
    "negative friction": ("plate.prm", pair("Friction coefficient = -0.1"), WRONG_INPUT, ["Contact/base/Friction coefficient", "-0.1"]),
    "unknown quadrature": ("plate.prm", pair("Quadrature = Gaus"), WRONG_INPUT, ["Contact/base/Quadrature", "Gaus", "Gauss"]),
    "unknown law": ("plate.prm", "subsection Materials\n subsection steel\n set Law = steel\n end\nend", WRONG_INPUT, ["Materials/steel/Law", "steel"]),
    "incompressible": ("plate.prm", "subsection Materials\n subsection steel\n set Poisson's ratio = 0.5\n end\nend", WRONG_INPUT, ["Poisson's ratio", "0.5"]),
    "a modulus that is not a number": ("plate.prm", "subsection Materials\n subsection steel\n set Young's modulus = nan\n end\nend", WRONG_INPUT, ["Young's modulus"]),
    "an infinite modulus": ("plate.prm", "subsection Materials\n subsection steel\n set Young's modulus = inf\n end\nend", WRONG_INPUT, ["Young's modulus"]),
    # ------------------------------------------------------------- the file
    "a value of a million characters": ("plate.prm", body("plate", "Material = " + "m" * 1000000), WRONG_INPUT, ["Bodies/plate/Material", "characters ...]", "'steel'"]),
    "an expression of a million characters": (
        "plate.prm", "subsection Boundary conditions\n subsection top\n set Value = " + "1+" * 500000 + "1\n end\nend",
        WRONG_INPUT, ["Boundary conditions/top/Value", "characters ...]"]),
    "a section of a million characters": ("plate.prm", "subsection " + "s" * 1000000 + "\nend", WRONG_INPUT, ["unknown subsection", "characters ...]"]),
    "an include of a million characters": ("plate.prm", "include " + "f" * 1000000, WRONG_INPUT, ["cannot be opened", "characters ...]"]),
    "a file that includes itself": ("plate.prm", "include case.prm", WRONG_INPUT, ["case.prm", "includes itself"]),
    "an include that is not there": ("plate.prm", "include no.prm", WRONG_INPUT, ["no.prm", "cannot be opened"]),
    "an end too many": ("plate.prm", "end", WRONG_INPUT, ["'end' without an open subsection"]),
    "a parameter set twice": ("plate.prm", "set Degree = 1\nset Degree = 2", WRONG_INPUT, ["Degree", "already set"]),
    "a line that is no statement": ("plate.prm", "Degree = 1", WRONG_INPUT, ["case.prm:2", "Degree = 1"]),
    "set without a value": ("plate.prm", "set Degree", WRONG_INPUT, ["set Degree", "lacks a '='"]),
    "set without a name": ("plate.prm", "set = 1", WRONG_INPUT, ["lacks the name"]),
    "a path as a name": ("plate.prm", "set Output/Directory = a", WRONG_INPUT, ["must not contain '/'"]),
    "a dot in a name": ("plate.prm", body("plate.1", "Material = steel"), WRONG_INPUT, ["'plate.1' must not contain '.'"]),
    "a slash in a name": ("plate.prm", body("plate/1", "Material = steel"), WRONG_INPUT, ["'plate/1' must not contain '/'"]),
    "bytes that are no text": ("plate.prm", "set D\x01\x02 = 1", WRONG_INPUT, ["unknown parameter"]),
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
    if len(text) > 25000:
        faults.append("the message has %d characters" % len(text))
    return faults


def run(program, mpiexec, n_ranks, name):
    """What the program prints about a wrong input, and its exit code."""
    base, addition, _, _ = CASES[name]
    with tempfile.TemporaryDirectory() as directory:
        with open(os.path.join(directory, "case.prm"), "w") as file:
            file.write("include %s\n%s\n" % (os.path.relpath(os.path.join(HERE, base), directory), addition))
        command = [program, "case.prm"]
        if n_ranks > 1:
            command = [mpiexec, "-n", str(n_ranks)] + command
        result = subprocess.run(command, cwd=directory, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=300,
                                env=environment_of(n_ranks))
    return result.stdout, result.returncode


def main():
    program, mpiexec, n_ranks = os.path.abspath(sys.argv[1]), sys.argv[2], int(sys.argv[3])
    verbose = "--verbose" in sys.argv
    n_wrong = 0
    # a start is mostly waiting; more at a time than cores would only wait for each other
    with concurrent.futures.ThreadPoolExecutor(2 if n_ranks == 1 else 1) as pool:
        for name, (output, code) in zip(CASES, pool.map(lambda name: run(program, mpiexec, n_ranks, name), CASES)):
            faults = find_faults(name, output, code)
            n_wrong += 1 if faults else 0
            if faults or verbose:
                print("%s: %s" % (name, "; ".join(faults) if faults else "as expected"))
                print("    " + output.strip()[:600].replace("\n", "\n    "), flush=True)
    print("%d of %d wrong inputs are reported well." % (len(CASES) - n_wrong, len(CASES)))
    return 1 if n_wrong else 0


if __name__ == "__main__":
    sys.exit(main())
