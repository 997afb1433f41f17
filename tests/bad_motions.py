"""Wrong inputs about rigid motions with free components: see bad_input.py."""
from bad_words import WRONG_INPUT, own_condition, own_plate

CASES = {
    "a force along a component that is held": (
        "rigid_plate.prm", own_plate("Force = 1; -5"),
        WRONG_INPUT, ["Boundary conditions/load/Force", "component 1", "is 1 ", "'Translation'", "'free'"]),
    "a force on a body that is held": (
        "rigid_plate.prm", own_plate("Translation = 0; -t"),
        WRONG_INPUT, ["Boundary conditions/load/Force", "no component of 'Translation' is 'free'"]),
    "a torque against a rotation that is held": (
        "rigid_plate.prm", own_plate("Rotation angle = 0", "Torque = 3"),
        WRONG_INPUT, ["Boundary conditions/load/Torque", "'Rotation angle'", "'free'"]),
    "a free rotation without a point": (
        "rigid_plate.prm", own_plate("Rotation centre ="),
        WRONG_INPUT, ["Boundary conditions/load/Rotation centre", "free rotation", "'Force'"]),
    "a force with too many components": (
        "rigid_plate.prm", own_plate("Force = 0; -5; 0"),
        WRONG_INPUT, ["Boundary conditions/load/Force", "0; -5; 0", "2 components"]),
    "a negative spring at a point": (
        "rigid_plate.prm", own_plate("Rotation stiffness = -1"),
        WRONG_INPUT, ["Boundary conditions/load/Rotation stiffness", "-1", "not negative"]),
    "a force in a pressure": (
        "rigid_plate.prm", own_condition("Body = column", "Boundary = 1", "Type = pressure", "Value = 1", "Force = 1; 0"),
        WRONG_INPUT, ["Boundary conditions/own/Force", "'pressure' has no use"]),
    "a distributed force without a force": (
        "rigid_plate.prm", own_condition("Body = column", "Boundary = 1", "Type = distributed force"),
        WRONG_INPUT, ["Boundary conditions/own/Force", "is empty", "'distributed force' needs it"]),
    "a distributed force with a value": (
        "rigid_plate.prm", own_condition("Body = column", "Boundary = 1", "Type = distributed force", "Force = 1; 0", "Value = 1; 0"),
        WRONG_INPUT, ["Boundary conditions/own/Value", "'distributed force' has no use"]),
    "a distributed force on a whole body": (
        "rigid_plate.prm", own_condition("Body = column", "Type = distributed force", "Force = 1; 0"),
        WRONG_INPUT, ["Boundary conditions/own/Boundary", "is empty"]),
    "a distributed torque with two components": (
        "rigid_plate.prm", own_condition("Body = column", "Boundary = 1", "Type = distributed force", "Torque = 1; 0"),
        WRONG_INPUT, ["Boundary conditions/own/Torque", "1; 0", "1 component"]),
    "a distributed force along the radius of a body of revolution": (
        "../pretension_axisymmetric.prm", own_condition("Body = upper", "Boundary = 3", "Type = distributed force", "Force = 1; 2"),
        WRONG_INPUT, ["Boundary conditions/own/Force", "1; 2", "radius"]),
    "a distributed torque on a body of revolution": (
        "../pretension_axisymmetric.prm", own_condition("Body = upper", "Boundary = 3", "Type = distributed force", "Torque = 2"),
        WRONG_INPUT, ["Boundary conditions/own/Torque", "nothing can rotate"]),
    "two conditions on a driven rigid body": (
        "rigid_plate.prm", own_condition("Body = plate", "Type = rigid motion"),
        WRONG_INPUT, ["Boundary conditions/load", "Boundary conditions/own", "'plate' is rigid", "one condition"]),
    "a rigid plate that nothing holds": (
        "rigid_plate.prm", own_plate("Translation = free; free") + "subsection Contact\n subsection c\n set Master body = column\n"
        " set Master boundary = 0\n end\nend\n",
        WRONG_INPUT, ["'plate'", "translation along x", "held by no boundary condition"]),
    "a coupled boundary that another condition holds": (
        "rigid_plate.prm", own_condition("Body = column", "Boundary = 0", "Type = rigid motion", "Rotation angle = free", "Rotation centre = 0, 6"),
        WRONG_INPUT, ["Boundary conditions/base", "Boundary conditions/own", "leaves free to move", "'Where'"]),
    "a node that follows two points": (
        "rigid_plate.prm", own_condition("Body = column", "Boundary = 0", "Type = rigid motion", "Translation = free; 0", "Where = y > 1")
        + own_condition("Body = column", "Boundary = 3", "Type = rigid motion", "Translation = free; 0").replace("own", "other"),
        WRONG_INPUT, ["Boundary conditions/own", "Boundary conditions/other", "another point"]),
}
