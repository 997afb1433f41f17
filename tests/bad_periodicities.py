"""Wrong inputs: periodic boundaries and cyclic symmetry."""
from bad_words import WRONG_INPUT, body, own_condition, section


def held(*lines):
    return "subsection Boundary conditions\n subsection held\n set %s\n end\nend\n" % "\n set ".join(lines)


# as in bad_problems.py
CASES = {
    "periodic boundaries of tetrahedra": (
        "column_3d.prm", body("block", "Simplices = true") + body("plane", "Simplices = true"),
        WRONG_INPUT, ["Boundary conditions/", "periodic boundaries", "a model with tetrahedra"]),
    "periodic with one boundary": (
        "plate.prm", own_condition("Body = plate", "Boundary = 0", "Type = periodic", "Direction = x"), WRONG_INPUT, ["Boundary conditions/own", "'Second boundary'"]),
    "periodic boundaries that do not match": (
        "plate.prm", own_condition("Body = plate", "Boundary = 0", "Second boundary = 3", "Type = periodic", "Direction = x"), WRONG_INPUT, ["face to face", "10 coarse faces"]),
    "a sector that does not go into a full turn": (
        "rollers.prm", body("tube", "Arguments = 10 |1| 11.27 : 0 |12| 100") + body("ring", "Arguments = 11.35 |2, 4| 20 : 0 |12| 100")
        + own_condition("Body = tube", "Boundary = 2", "Second boundary = 3", "Type = cyclic symmetry"),
        WRONG_INPUT, ["Boundary conditions/own", "100 degrees apart", "180, 120, 90"]),
    "a sector that reaches its axis": (
        "plate.prm", own_condition("Body = plate", "Boundary = 2", "Second boundary = 0", "Type = cyclic symmetry"),
        WRONG_INPUT, ["Boundary conditions/own", "'plate' reaches the axis", "small hole"]),
    "a quarter beside a third": (
        "rollers.prm", body("tube", "Arguments = 10 |1| 11.27 : 0 |12| 90") + body("ring", "Arguments = 11.35 |2, 4| 20 : 0 |12| 120")
        + section("Boundary conditions", "x = 1").replace("set x = 1", "".join(
            f"subsection sides of {name}\n set Body = {name}\n set Type = cyclic symmetry\n set Boundary = 2\n set Second boundary = 3\n end\n"
            for name in ("tube", "ring"))),
        WRONG_INPUT, ["sides of tube and", "1/4", "1/3", "one cyclic symmetry"]),
    "two thirds as a sector": (
        "rollers.prm", body("tube", "Arguments = 10 |1| 11.27 : 0 |24| 240") + body("ring", "Arguments = 11.35 |2, 4| 20 : 0 |12| 90")
        + own_condition("Body = tube", "Boundary = 2", "Second boundary = 3", "Type = cyclic symmetry"),
        WRONG_INPUT, ["Boundary conditions/own", "240 degrees apart"]),
    "a displacement that is not that of all sectors": (
        "../cyclic_second_side.prm", held("Boundary = 0", "Components = Cartesian"),
        WRONG_INPUT, ["Boundary conditions/held is not the same on both sides", "at (1 0)", "at (0 1)", "'Components = cylindrical'"]),
    "two conditions that contradict each other over a period": (
        "../periodic_second_side.prm", own_condition("Body = strip", "Boundary = 0", "Value = 0.01*t; 0"),
        WRONG_INPUT, ["Boundary conditions/own and Boundary conditions/held contradict", "0.02 along the direction (0 1) at (2 ", "'Where'"]),
    "a reference point of one side of a sector": (
        "../cyclic_second_side.prm", held("Type = rigid motion", "Value =", "Components = Cartesian", "Rotation angle = free", "Rotation centre = 0, 0"),
        WRONG_INPUT, ["Boundary conditions/held holds the node (0 1), but not (1 0)", "Name boundaries that have both"]),
    "a reference point that moves all sectors along x": (
        "../cyclic_second_side.prm", held("Type = rigid motion", "Boundary = 0", "Value =", "Components = Cartesian", "Translation = free; 0"),
        WRONG_INPUT, ["Boundary conditions/held moves the node (0 1) otherwise than (1 0)", "rotation about it"]),
    "a reference point that turns what is repeated": (
        "../periodic_second_side.prm", held("Type = rigid motion", "Boundary = 3", "Value =", "Rotation angle = free", "Rotation centre = 0, 0"),
        WRONG_INPUT, ["Boundary conditions/held moves the node (2 1) otherwise than (0 1)", "no rotation"]),
}
