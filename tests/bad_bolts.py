"""Wrong inputs about the pretension of bolts: see bad_input.py."""
from bad_words import WRONG_INPUT, body, own_condition, section

BAR = "../pretension_bar.prm"


def bolt(*lines):
    """The cut of the bar."""
    return "subsection Boundary conditions\n subsection bolt\n set %s\n end\nend\n" % "\n set ".join(lines)


CASES = {
    "a pretension without a force": (BAR, bolt("Force ="), WRONG_INPUT, ["Boundary conditions/bolt/Force", "is empty", "'pretension' needs it"]),
    "a pretension with a direction": (
        BAR, bolt("Direction = y"), WRONG_INPUT, ["Boundary conditions/bolt/Direction", "'pretension' has no use"]),
    "a pretension that begins": (
        BAR, bolt("Active from = 1"), WRONG_INPUT, ["Boundary conditions/bolt/Active from", "'pretension' has no use"]),
    "a pretension without a second boundary": (
        BAR, bolt("Second boundary ="), WRONG_INPUT, ["Boundary conditions/bolt/Second boundary", "is empty"]),
    "a time of locking that is no number": (
        BAR, bolt("Locked from = soon"), WRONG_INPUT, ["Boundary conditions/bolt/Locked from", "'soon'", "number or empty"]),
    "a displacement that is locked": (
        BAR, own_condition("Body = upper", "Boundary = 3", "Value = 0; 0", "Locked from = 1"),
        WRONG_INPUT, ["Boundary conditions/own/Locked from", "'displacement' has no use"]),
    "a bolt that is locked at the start": (BAR, bolt("Locked from = 0"), WRONG_INPUT, ["Boundary conditions/bolt/Locked from is 0", "greater than 0"]),
    "a bolt that is locked at no time": (BAR, bolt("Locked from = nan"), WRONG_INPUT, ["Boundary conditions/bolt/Locked from is nan", "greater than 0"]),
    "a cut that is named twice": (
        BAR, own_condition("Type = pretension", "Body = lower", "Boundary = 3", "Second body = upper", "Second boundary = 2", "Force = 1"),
        WRONG_INPUT, ["Boundary conditions/bolt", "Boundary conditions/own", "nodes in common"]),
    "a cut that is named from both sides": (
        BAR, own_condition("Type = pretension", "Body = upper", "Boundary = 2", "Second body = lower", "Second boundary = 3", "Force = 1"),
        WRONG_INPUT, ["Boundary conditions/bolt", "Boundary conditions/own", "nodes in common"]),
    "a cut that a displacement holds in its plane": (
        "../pretension_hanging_nodes.prm", "".join(own_condition("Body = " + name, "Value = %s*t; free" % value).replace("own", "own" + name)
                                                   for name, value in (("lower", 0), ("upper", 0.3))),
        WRONG_INPUT, ["Boundary conditions/own", "no symmetry, holds the node", "Boundary conditions/bolt"]),
    "a cut that a symmetry holds for a time": (
        BAR, "".join(own_condition("Body = " + name, "Boundary = 0", "Type = symmetry", "Active until = 0.5").replace("own", "own" + name)
                     for name in ("lower", "upper")),
        WRONG_INPUT, ["Boundary conditions/own", "for a time only, the node", "Boundary conditions/bolt"]),
    "an unknown second body": (BAR, bolt("Second body = uper"), WRONG_INPUT, ["Boundary conditions/bolt/Second body", "'uper'", "'upper'"]),
    "a cut with one side": (
        BAR, bolt("Second body =", "Second boundary = 3"), WRONG_INPUT, ["Boundary conditions/bolt", "'Second boundary' are the same"]),
    "a cut through meshes that differ": (
        BAR, body("upper", "Arguments = 4, 5 : 0, 4 : 1, 10 : true"),
        WRONG_INPUT, ["Boundary conditions/bolt", "no node of 'Boundary' is at the node", "the same mesh"]),
    "a cut with more nodes on one side": (
        BAR, body("upper", "Arguments = 2, 5 : 0, 4 : 0.666666666666666667, 10 : true"),
        WRONG_INPUT, ["Boundary conditions/bolt", "do not have the same nodes", "the same mesh"]),
    "a cut whose sides are apart": (
        BAR, body("upper", "Translation = 0, 0.01"), WRONG_INPUT, ["Boundary conditions/bolt", "no node of 'Boundary' is at the node"]),
    "a cut that is not plane": (
        BAR, bolt("Boundary = 1, 3"), WRONG_INPUT, ["Boundary conditions/bolt", "not on one plane"]),
    "a cut that a condition holds along the bolt": (
        BAR, own_condition("Body = lower", "Boundary = 3", "Value = free; 0"),
        WRONG_INPUT, ["Boundary conditions/own", "holds, along the bolt, the node", "Boundary conditions/bolt", "'Where'"]),
    "a cut that a condition holds on one side": (
        BAR, own_condition("Body = upper", "Boundary = 0", "Type = symmetry"),
        WRONG_INPUT, ["Boundary conditions/bolt", "another condition holds the node", "on one side of the cut only"]),
    "a cut whose nodes follow a point": (
        BAR, own_condition("Body = upper", "Boundary = 1", "Type = rigid motion", "Translation = free; free", "Where = y < 8"),
        WRONG_INPUT, ["Boundary conditions/own", "couples the node", "Boundary conditions/bolt"]),
    "a cut whose nodes are all held": (
        BAR, "".join(own_condition("Body = " + name, "Boundary = 0, 1", "Type = symmetry").replace("own", "own" + name) for name in ("lower", "upper"))
        + "".join(body(name, "Arguments = 1, 2 : 0, %s : 1, %s : true" % ends) for name, ends in (("lower", (0, 4)), ("upper", (4, 10)))) + "set Degree = 1\n",
        WRONG_INPUT, ["Boundary conditions/bolt", "other conditions hold all nodes"]),
    "a bolt that is rigid": (
        BAR, body("upper", "Rigid = true", "Material =") + "subsection Boundary conditions\n subsection head\n set Type = rigid motion\n"
        " set Value =\n set Boundary =\n end\nend\n",
        WRONG_INPUT, ["Boundary conditions/bolt", "'upper' is rigid", "deformable"]),
    "a bolt half of which hangs in the air": (
        BAR, body("other", "Generator = subdivided_hyper_rectangle", "Arguments = 1, 1 : 0, 20 : 1, 21 : true", "Material = soft")
        + "subsection Boundary conditions\n subsection head\n set Body = other\n end\nend\n",
        WRONG_INPUT, ["Boundary conditions/bolt", "'upper'", "neither contact nor another condition"]),
    "a cut along the axis of a bolt of revolution": (
        BAR, "set Axisymmetric = true\n" + body("lower", "Rotation angle = 0") + body("upper", "Rotation angle = 0", "Translation = 1, -4")
        + bolt("Boundary = 1", "Second boundary = 0")
        + body("lower", "Arguments = 3, 5 : 0, 0 : 1, 6 : true"),
        WRONG_INPUT, ["Boundary conditions/bolt", "across the axis"]),
    "a cut in a mesh that is adapted": (
        BAR, section("Adaptation", "Estimator = Kelly"), WRONG_INPUT, ["Adaptation/Estimator = Kelly", "Boundary conditions/bolt", "same mesh"]),
}
