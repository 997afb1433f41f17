"""Wrong inputs: how it is computed, what is written, the parameter file itself, the command line."""
from bad_words import CHECK_FALLS_SHORT, NO_CONVERGENCE, ONE_STEP, STOPPED, WRONG_INPUT, algorithm, body, check, point, section

# what is wrong: (file, text added below an include of it, exit code, words of the message)
CASES = {
    # ------------------------------------------------------------- load stepping, algorithm, solver, output
    "a time that ends before it begins": ("plate.prm", section("Load stepping", "End time = -1"), WRONG_INPUT, ["Load stepping/End time", "larger than 0"]),
    "a step of zero": ("plate.prm", section("Load stepping", "Initial step = 0"), WRONG_INPUT, ["Load stepping/Initial step", "larger than 0"]),
    "a tolerance of contact changes of zero": (
        "plate.prm", section("Load stepping", "Contact change tolerance = 0"), WRONG_INPUT, ["Contact change tolerance", "'0'", "1e-09"]),
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
    "an endless run": ("plate.prm", section("Load stepping", "End time = inf"), WRONG_INPUT, ["Load stepping/End time", "inf"]),
    "a maximum below the step": (
        "plate.prm", section("Load stepping", "Initial step = 0.5", "Maximum step = 0.1"), WRONG_INPUT, ["Load stepping/Maximum step", "0.1", "Initial step", "0.5"]),
    "a requested time before the start": (
        "plate.prm", section("Load stepping", "Requested times = -1"), WRONG_INPUT, ["Load stepping/Requested times", "has -1", "End time", "is 1"]),
    "requested times in words": ("plate.prm", section("Load stepping", "Requested times = soon"), WRONG_INPUT, ["Load stepping/Requested times", "soon"]),
    "steps that shrink": ("plate.prm", section("Load stepping", "Growth factor = 0.5"), WRONG_INPUT, ["Load stepping/Growth factor", "0.5"]),
    "cuts that do not cut": ("plate.prm", section("Load stepping", "Cut factor = 1"), WRONG_INPUT, ["Load stepping/Cut factor", "0.99"]),
    "negative stabilization": (
        "plate.prm", "subsection Load stepping\n subsection Stabilization\n set Factor = -1\n end\nend", WRONG_INPUT, ["Load stepping/Stabilization/Factor", "-1"]),
    "no Newton iterations": ("plate.prm", algorithm("Newton", "Max iterations = 0"), WRONG_INPUT, ["Algorithm/Newton/Max iterations", ">= 1"]),
    "a tolerance of zero": (
        "plate.prm", algorithm("Newton", "Equilibrium tolerance = 0") + section("Algorithm", "Name = GNM") + ONE_STEP,
        NO_CONVERGENCE, ["Newton: no convergence in", "tolerance 0"]),
    "an unknown line search": ("plate.prm", algorithm("Newton", "Line search = golden"), WRONG_INPUT, ["Algorithm/Newton/Line search", "golden", "automatic | none"]),
    "a treatment that the algorithm has not": (
        "plate.prm", algorithm("Geometry", "Treatment = fixed point"), WRONG_INPUT, ["Algorithm/Geometry/Treatment", "fixed point", "automatic", "Name = custom"]),
    "an unknown treatment": ("plate.prm", algorithm("Geometry", "Treatment = frozen"), WRONG_INPUT, ["Algorithm/Geometry/Treatment", "frozen", "fixed point"]),
    "a linear tolerance of one": ("plate.prm", section("Linear solver", "Relative tolerance = 1"), WRONG_INPUT, ["Linear solver/Relative tolerance", "0.1"]),
    "a size in words": ("plate.prm", section("Linear solver", "Largest direct system = many"), WRONG_INPUT, ["Linear solver/Largest direct system", "many", "automatic"]),
    "no linear iterations": ("plate.prm", section("Linear solver", "Maximum iterations = 0"), WRONG_INPUT, ["Linear solver/Maximum iterations"]),
    "a point of no body": ("plate.prm", point("Position = 0, 0"), WRONG_INPUT, ["Output/Points/Q/Body"]),
    "a point of an unknown body": ("plate.prm", point("Body = plat", "Position = 0, 0"), WRONG_INPUT, ["Output/Points/Q/Body", "Did you mean 'plate'"]),
    "a point without position": ("plate.prm", point("Body = plate"), WRONG_INPUT, ["Output/Points/Q/Position", "0 coordinates"]),
    "a point that is not a number": ("plate.prm", point("Body = plate", "Position = nan, 0"), WRONG_INPUT, ["Output/Points/Q/Position", "nan, 0"]),
    "a negative number of files": ("plate.prm", section("Output", "Grouped files = -1"), WRONG_INPUT, ["Output/Grouped files", "-1"]),
    "a directory that cannot be": ("plate.prm", section("Output", "Directory = /proc/nothing"), WRONG_INPUT, ["Output/Directory", "/proc/nothing"]),
    "an unknown verbosity": ("plate.prm", section("Output", "Verbosity = loud"), WRONG_INPUT, ["Output/Verbosity", "loud", "quiet"]),
    # ------------------------------------------------------------- checks
    "a check of nothing": ("plate.prm", check("Expected = 1"), WRONG_INPUT, ["Checks/a/Quantity", "missing"]),
    "a check with a negative tolerance": ("plate.prm", check("Quantity = A_x", "Expected = 1", "Tolerance = -1"), WRONG_INPUT, ["Checks/a/Tolerance", "-1"]),
    "a check relative to zero": ("plate.prm", check("Quantity = A_x"), WRONG_INPUT, ["Checks/a/Expected", "Tolerance type = absolute"]),
    "a check of an unknown type": ("plate.prm", check("Quantity = A_x", "Expected = 1", "Tolerance type = both"), WRONG_INPUT, ["Checks/a/Tolerance type", "both"]),
    "an expression with an unknown name": (
        "patch_test.prm", check("Quantity = c.force_y / c.area", "Expected = 1"), WRONG_INPUT, ["Checks/a/Quantity", "'c.area'", "c.contact_area"]),
    "an expression that is none": ("patch_test.prm", check("Quantity = c.force_y *", "Expected = 1"), WRONG_INPUT, ["Checks/a/Quantity", "Unexpected end"]),
    "a check of the largest of one": (
        "patch_test.prm", check("Quantity = max(2, 3)*max(abs(c.force_y))", "Expected = 1"), WRONG_INPUT,
        ["Checks/a/Quantity", "'max(abs(c.force_y))'", "Value = maximum"]),
    "a check at no time": ("patch_test.prm", check("Quantity = c.force_y", "Value = at a time", "Expected = 1"), WRONG_INPUT, ["Checks/a/Time", "greater than 0"]),
    "a check at a time that no step has": (
        "patch_test.prm", check("Quantity = c.force_y", "Value = at a time", "Time = 0.3", "Expected = 1"), WRONG_INPUT, ["Checks/a/Time", "0.3", "no step"]),
    "a time that no check needs": ("patch_test.prm", check("Quantity = c.force_y", "Time = 1", "Expected = 1"), WRONG_INPUT, ["Checks/a/Time", "Value = at a time"]),
    "a check that falls short, silently": (
        "patch_test.prm", check("Quantity = c.force_y", "Expected = 26") + section("Output", "Verbosity = quiet"), CHECK_FALLS_SHORT, ["Check 'a': c.force_y = 25", "expected 26", "FALLS SHORT"]),
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
    "two thousand sections": ("plate.prm", "subsection a\n" * 2000 + "end\n" * 2000, WRONG_INPUT, ["unknown subsection 'a'"]),
    "an unknown parameter twenty thousand times": (
        "plate.prm", "\n".join("set X%d = 1" % i for i in range(20000)), WRONG_INPUT, ["unknown parameter 'X0'", "characters ...]"]),
    "an include of a directory": ("plate.prm", "include .", WRONG_INPUT, ["'.' is a directory"]),
    "an include of a program": ("plate.prm", "include /bin/true", WRONG_INPUT, ["/bin/true:1", "zero byte"]),
    "a section without a name": ("plate.prm", "subsection\nend", WRONG_INPUT, ["case.prm:2", "'subsection' needs a name"]),
    "an end with more words": ("plate.prm", "subsection Mesh\nend of mesh\nend", WRONG_INPUT, ["'end of mesh'", "Did you mean 'end'"]),
    "half a degree": ("plate.prm", "set Degree = 1.5", WRONG_INPUT, ["Degree", "1.5", "from 1 to 6"]),
    "a degree beyond all integers": ("plate.prm", "set Degree = 99999999999999999999", WRONG_INPUT, ["Degree", "from 1 to 6"]),
}

# what is wrong: (arguments, words of the message); exit code 1
COMMAND_LINES = {
    "an unknown option": (["--foo"], ["'--foo'", "--validate"]),
    "two parameter files": (["case.prm", "other.prm"], ["Two parameter files", "'other.prm'"]),
    "a parameter file that is not there": (["no.prm"], ["'no.prm' cannot be opened"]),
    "a directory as parameter file": (["."], ["'.' is a directory"]),
    "nothing": ([], ["No parameter file", "--help"]),
    "--set without a word": (["case.prm", "--set"], ["'--set' needs"]),
    "--set without a value": (["case.prm", "--set", "Degree"], ["'Degree' has no '='"]),
    "--set without a name": (["case.prm", "--set", "=2"], ["--set '=2'"]),
    "--set of an unknown parameter": (["case.prm", "--set", "Degre=2"], ["--set", "'Degre'", "Did you mean 'Degree'"]),
    "--set of a wrong value": (["case.prm", "--set", "Degree=9"], ["--set", "'Degree' is '9'", "from 1 to 6"]),
    "--restart without a checkpoint": (["case.prm", "--restart", "nowhere"], ["--restart", "no checkpoint in 'nowhere'"]),
    "--restart latest without a run": (["case.prm", "--restart", "latest"], ["--restart", "no checkpoint", "Checkpoint every n steps"]),
    "--output-directory without a name": (["case.prm", "--output-directory"], ["'--output-directory' needs a directory"]),
    "an unknown format of parameters": (["--print-parameters", "xml"], ["'xml'", "'markdown'"]),
    "--diagnose of no run": (["--diagnose", "."], ["--diagnose", "no run in '.'"]),
    "--inspect-mesh of no file": (["--inspect-mesh", "no.msh"], ["--inspect-mesh", "'no.msh' cannot be read"]),
    "--inspect-mesh of a parameter file": (["--inspect-mesh", "case.prm"], ["--inspect-mesh", "'case.prm'", "msh, inp"]),
}
