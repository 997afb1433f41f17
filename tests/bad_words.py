"""Sections of parameter files, for the tables of wrong inputs."""
import os

HERE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "application", "data")
WRONG_INPUT, NO_CONVERGENCE, CHECK_FALLS_SHORT, STOPPED = 1, 2, 4, 5

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


def interface(*lines, name="interface"):
    """The pair of the floating blocks."""
    return "subsection Contact\n subsection %s\n set %s\n end\nend\n" % (name, "\n set ".join(lines))


def blocks_held(*upper):
    """The floating blocks, both held; what else there is about the upper one."""
    return condition("lower", 2, "Value = 0; 0") + condition("upper", 3, "Value = 0; 0") + body("upper", *upper)


def regularization(*lines):
    """Of the pair of the plate."""
    return "subsection Contact\n subsection base\n subsection Regularization\n set %s\n end\n end\nend\n" % "\n set ".join(lines)


def own_condition(*lines):
    return "subsection Boundary conditions\n subsection own\n set %s\n end\nend\n" % "\n set ".join(lines)


def own_plate(*lines):
    """The motion of the rigid plate."""
    return "subsection Boundary conditions\n subsection load\n set %s\n end\nend\n" % "\n set ".join(lines)


def steel(*lines):
    """The material of the plate."""
    return "subsection Materials\n subsection steel\n set %s\n end\nend\n" % "\n set ".join(lines)


def plastic(*lines):
    """The material of the block."""
    return material("small-strain plasticity", *("set " + line for line in lines))


def algorithm(section_name, *lines):
    return "subsection Algorithm\n subsection %s\n set %s\n end\nend\n" % (section_name, "\n set ".join(lines))


def point(*lines):
    return "subsection Output\n subsection Points\n subsection Q\n set %s\n end\n end\nend\n" % "\n set ".join(lines)


def check(*lines):
    return "subsection Checks\n subsection a\n set %s\n end\nend\n" % "\n set ".join(lines)
