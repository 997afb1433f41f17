"""Wrong inputs about constitutive laws: see bad_input.py."""
from bad_words import HERE, WRONG_INPUT, body, material, own_condition, pair, plastic, section, steel

# as in bad_problems.py
CASES = {
    "a rubber without stiffness": ("block.prm", material("hyperelastic", "set C10 = 0"), WRONG_INPUT, ["Materials/matter/C10 + C01", "greater than 0"]),
    "a negative bulk modulus": ("block.prm", material("hyperelastic", "set Bulk modulus = -1"), WRONG_INPUT, ["Materials/matter/Bulk modulus", "-1"]),
    "a yield stress of zero": ("block.prm", plastic("Yield stress = 0"), WRONG_INPUT, ["Materials/matter/Yield stress", "greater than 0"]),
    "a hardening table that falls": (
        "block.prm", plastic("Hardening = tabulated", "Hardening table = 0 : 10, 0.1 : 5"), WRONG_INPUT, ["Materials/matter/Hardening table", "0.1 : 5 follows 0 : 10"]),
    "a hardening table without points": ("block.prm", plastic("Hardening = tabulated"), WRONG_INPUT, ["Materials/matter/Hardening table", "empty"]),
    "a hardening table of words": ("block.prm", plastic("Hardening = tabulated", "Hardening table = a : b"), WRONG_INPUT, ["Hardening table", "a : b"]),
    "a hardening table that is not sorted": (
        "block.prm", plastic("Hardening = tabulated", "Hardening table = 0 : 10, 0.2 : 15, 0.1 : 20"), WRONG_INPUT, ["Hardening table", "have to grow"]),
    "a hardening table that begins late": (
        "block.prm", plastic("Hardening = tabulated", "Hardening table = 0.1 : 10, 0.2 : 15"), WRONG_INPUT, ["Hardening table", "has to be 0"]),
    "a hardening exponent above one": ("block.prm", plastic("Hardening = power", "Hardening exponent = 2"), WRONG_INPUT, ["Hardening exponent", "between 0 and 1"]),
    "a reference strain of zero": (
        "block.prm", plastic("Hardening = Voce", "Reference plastic strain = 0"), WRONG_INPUT, ["Reference plastic strain", "greater than 0"]),
    "a negative kinematic modulus": ("block.prm", plastic("Kinematic modulus = -1"), WRONG_INPUT, ["Kinematic modulus", "at least 0"]),
    "a back stress without recovery": (
        "block.prm", plastic("Back stresses = 10 : 100, 5 : 0"), WRONG_INPUT, ["Materials/matter/Back stresses", "5 : 0", "'Kinematic modulus'"]),
    "a back stress without its recovery": ("block.prm", plastic("Back stresses = 10"), WRONG_INPUT, ["Back stresses", "10"]),
    "too many back stresses": (
        "block.prm", material("Hencky plasticity", "set Back stresses = " + ", ".join(9 * ["1 : 1"])), WRONG_INPUT, ["Back stresses", "at most 8"]),
    "back stresses of a law without": (
        "block.prm", material("Simo-Miehe plasticity", "set Back stresses = 1 : 1"), WRONG_INPUT, ["Back stresses", "Materials/matter"]),
    "a curve that kinematic hardening leaves": (
        "block.prm", plastic("Hardening = tabulated", "Hardening table = 0 : 10, 0.1 : 11", "Hardening table ordinate = uniaxial stress", "Kinematic modulus = 20"),
        WRONG_INPUT, ["Materials/matter/Hardening table", "0.1 : 11 follows 0 : 10", "kinematic hardening alone"]),
    "a hardening table of no file": (
        "block.prm", plastic("Hardening = tabulated", "Hardening table file = nowhere.csv"), WRONG_INPUT, ["Materials/matter/Hardening table file", "nowhere.csv", "opened"]),
    "a file of text as hardening table": (
        "block.prm", plastic("Hardening = tabulated", "Hardening table file = %s/triangle.msh" % HERE),
        WRONG_INPUT, ["triangle.msh:", "at least 2 numbers", "Materials/matter/Hardening table file"]),
    "a hardening table and a file": (
        "block.prm", plastic("Hardening = tabulated", "Hardening table = 0 : 10", "Hardening table file = nowhere.csv"),
        WRONG_INPUT, ["Materials/matter", "not both"]),
    "a tangent modulus above Young's": (
        "block.prm", plastic("Hardening = linear", "Hardening modulus = 5", "Hardening modulus is = tangent modulus"),
        WRONG_INPUT, ["Hardening modulus", "less than Young's modulus"]),
    "plane stress in 3D": ("block.prm", material("linear elastic", "set Plane stress = true"), WRONG_INPUT, ["Materials/matter/Plane stress", "Dimension is 3"]),
    "plane stress of bodies of revolution": (
        "unheld_block.prm", "set Axisymmetric = true\n" + body("block", "Material = matter") + material("linear elastic", "set Plane stress = true"),
        WRONG_INPUT, ["Materials/matter/Plane stress", "Axisymmetric"]),
    "bodies of revolution in 3D": ("block.prm", "set Axisymmetric = true", WRONG_INPUT, ["Axisymmetric", "Dimension is 3"]),
    "a negative radius": ("plate.prm", "set Axisymmetric = true", WRONG_INPUT, ["Bodies/base", "x = -10", "the radius"]),
    "multipliers without area on the axis": (
        "plate.prm", "set Axisymmetric = true\nset Degree = 2\n" + body("base", "Arguments = 1, 1 : 0, -10 : 50, 0 : true")
        + pair("Quadrature = segments", "Multiplier space = displacement trace"),
        WRONG_INPUT, ["Contact/base/Multiplier space", "axis", "'automatic'"]),
    "a rigid body that leaves its axis": (
        "plate.prm", "set Axisymmetric = true\n" + body("base", "Arguments = 1, 1 : 0, -10 : 50, 0 : true")
        + own_condition("Body = base", "Type = rigid motion", "Translation = t; 0"),
        WRONG_INPUT, ["Boundary conditions/own/Translation", "'t; 0'", "along y"]),
    "B-bar with a law of large strains": ("block.prm", material("Hencky", "set Element = B-bar"), WRONG_INPUT, ["Materials/matter/Element", "Take F-bar"]),
    "a parameter of another law": ("plate.prm", steel("Yield stress = 1"), WRONG_INPUT, ["Materials/steel/Yield stress", "Poisson's ratio"]),
    "a decimal comma": ("plate.prm", steel("Young's modulus = 1,3e5"), WRONG_INPUT, ["Materials/steel/Young's modulus", "1,3e5", "a number"]),
    "a product as a number": ("plate.prm", steel("Young's modulus = 2*3"), WRONG_INPUT, ["Materials/steel/Young's modulus", "2*3"]),
    "perhaps plane stress": ("plate.prm", steel("Plane stress = maybe"), WRONG_INPUT, ["Materials/steel/Plane stress", "maybe", "true or false"]),
    "a body without material": ("plate.prm", body("plate", "Material ="), WRONG_INPUT, ["Bodies/plate/Material", "section of 'Materials'"]),
}
