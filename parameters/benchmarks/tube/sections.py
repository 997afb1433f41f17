#!/usr/bin/env python3
"""Writes the expansion of the tube without rollers: a mandrel that widens.

    python3 sections.py plane | r-z [FILE.prm]

Geometry, materials and feed are those of case.py. `plane` is a quarter of the section
in plane strain, `r-z` the whole length as bodies of revolution. The mandrel is as long
as the rollers; all of its surface is moved outwards by the feed, without friction.
"""
import sys

from case import CONSTANTS, FEED, MATERIALS, OUTPUT, section, together

MODELS = ("plane", "r-z")
# Radial cells of the tube and of the sheet (graded), of the plane model and of the other one; along the axis as in
# case.py; round a quarter.
WALL, SHEET, AXIAL, QUARTER = 4, "12, 30", (10, 24, 10), 24
MANDREL = "{inner - gap - 1}", "{inner - gap}"

MANDREL_MATERIAL = """\
  subsection mandrel
    set Law             = linear elastic
    set Young's modulus = 200000
    set Poisson's ratio = 0.3
  end
"""


def plane():
    """Bodies, conditions and axes of the quarter."""
    round_it = f"0 |{QUARTER}| 90"
    bodies = {"tube": f"{{inner}} |{WALL}| {{outer}} : {round_it}", "sheet": f"{{bore}} |{SHEET}| {{rim}} : {round_it}",
              "mandrel": f"{MANDREL[0]} |1| {MANDREL[1]} : {round_it}"}
    cut = [section(f"{body} {side}", Body=body, Boundary=side, Type="symmetry") for body in ("tube", "sheet") for side in (2, 3)]
    feed = "; ".join(f"{FEED}*{axis}/sqrt(x*x + y*y)" for axis in "xy")
    return (together("Bodies", *(section(name, Generator="graded_annular_sector", Arguments=arguments, Material=name)
                              for name, arguments in bodies.items())),
            [*cut, section("rim", Body="sheet", Boundary=1, Value="0; 0"),
             section("feed", Body="mandrel", Boundary="0, 1, 2, 3", Value=feed)])


def r_z():
    """The same of the bodies of revolution: x is the radius, y the axis."""
    below, zone, above = AXIAL
    first, last = "{lower_face - overhang}", "{lower_face + thickness + overhang}"
    along = f"0 |{below}, 0.3| {first} |{zone}| {last} |{above}, 3| {{length}}"
    bodies = {"tube": f"{{inner}} |{WALL}| {{outer}} : {along}",
              "sheet": f"{{bore}} |{SHEET}| {{rim}} : {{lower_face}} |18| {{lower_face + thickness}}",
              "mandrel": f"{MANDREL[0]} |1| {MANDREL[1]} : {first} |{zone}| {last}"}
    rolled = f"y > {first} && y < {last}"
    ids = {"tube": {"Boundary_ids": f"rolled: id == 0 && {rolled}; expanded: id == 1 && {rolled}"}}
    return ("set Axisymmetric = true\n\n"
            + together("Bodies", *(section(name, Generator="graded_hyper_rectangle", Arguments=arguments, Material=name, **ids.get(name, {}))
                                for name, arguments in bodies.items())),
            [section("rim", Body="sheet", Boundary=1, Value="0; 0"), section("end", Body="tube", Boundary=2, Value="0; 0"),
             section("feed", Body="mandrel", Boundary="0, 1, 2, 3", Value=f"{FEED}; 0")])


def case(model):
    """The .prm of a model as text."""
    bodies, conditions = {"plane": plane, "r-z": r_z}[model]()
    faces = ("0", "1") if model == "plane" else ("rolled", "expanded")
    contact = together("Contact",
                    section("expansion", Slave_body="tube", Slave_boundary=faces[1], Master_body="sheet", Master_boundary=0),
                    section("mandrel", Slave_body="tube", Slave_boundary=faces[0], Master_body="mandrel", Master_boundary=1))
    height = "0" if model == "plane" else "{lower_face + thickness/2}"
    output = OUTPUT.format(name=model.replace("-", ""), step=5).replace("0, {lower_face + thickness/2}", height)
    output = output.replace("{outer}, 0, {length}", "{outer}, " + ("0" if model == "plane" else "{length}"))
    return (f"# Expansion of a tube in a tube sheet by a mandrel ({model}). Written by sections.py.\n" + CONSTANTS
            + "set Title     = Tube expansion, a section\nset Dimension = 2\nset Degree    = 2\n" + bodies
            + MATERIALS.replace("subsection Materials\n", "subsection Materials\n" + MANDREL_MATERIAL)
            + together("Boundary conditions", *conditions) + contact + output)


if __name__ == "__main__":
    if len(sys.argv) < 2 or sys.argv[1] not in MODELS:
        sys.exit(__doc__.strip())
    text = case(sys.argv[1])
    if len(sys.argv) > 2:
        with open(sys.argv[2], "w") as file:
            file.write(text)
    else:
        sys.stdout.write(text)
