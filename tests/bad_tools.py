"""Wrong inputs: rigid tools without facets."""
from bad_words import WRONG_INPUT, body, pair

# as in bad_problems.py
CASES = {
    "a tool of negative radius": (
        "plate.prm", body("base", "Generator = tool_circle", "Arguments = 0, 0 : -1"), WRONG_INPUT, ["Bodies/base/Arguments", "'radius' is '-1'", "greater than 0"]),
    "a tool without size": (
        "plate.prm", body("base", "Generator = tool_polyline", "Arguments = 0, 0"), WRONG_INPUT, ["Bodies/base/Arguments", "no size"]),
    "a side that a tool has not": (
        "plate.prm", body("base", "Generator = tool_circle", "Arguments = 0, -9 : 9 : outside") + pair("Master boundary = all"),
        WRONG_INPUT, ["Bodies/base/Arguments", "'outside' is no side", "inside, around"]),
    "a corner of a tool without fillet": (
        "plate.prm", body("base", "Generator = tool_polyline", "Arguments = 40, 0; 0, 0; 0, -9 : false") + pair("Master boundary = all"),
        WRONG_INPUT, ["Bodies/base/Arguments", "fillet"]),
    "a tool that is drawn by expressions": (
        "plate.prm", body("base", "Generator = tool_circle", "Arguments = 0, -9 : 9", "Coordinates = x; 2*y"),
        WRONG_INPUT, ["Bodies/base/Coordinates", "tool_circle"]),
    "a tool as slave": (
        "plate.prm", body("base", "Generator = tool_circle", "Arguments = 0, -9 : 9")
        + pair("Slave body = base", "Slave boundary = all", "Master body = plate", "Master boundary = 2"),
        WRONG_INPUT, ["Contact/base/Slave body = base", "no contact points"]),
    "a cylinder in the plane": (
        "plate.prm", body("base", "Generator = tool_cylinder", "Arguments = 0, 0, 0 : 0, 0, 1 : 1 : 1"),
        WRONG_INPUT, ["Bodies/base/Generator", "'tool_cylinder' exists only in 3D"]),
}
