#!/usr/bin/env python3
"""Writes the case of the tube expansion: a .prm that runs on its own.

    python3 case.py SIZE [FRICTION [FILE.prm]]      # quick, rough, coarse, medium, full

One sector of 120 degrees with one roller; case(..., whole=True) is the whole tube.

Printed in the paper: radii, lengths of tube and sheet, materials but for the curve of
the sheet, 360 s in steps of 1 s. The rest is assumed (README.md).
"""
import sys

# Cells: round the circumference, through the tube's wall, radially in the sheet; along the axis
# below the rolled zone, in it and above it, and through the sheet. Steps in s.
SIZES = {
    "quick": {"around": 48, "wall": 1, "sheet": 2, "roller": 16, "axial": (1, 1, 1), "thickness": 1, "step": 3},
    "rough": {"around": 24, "wall": 1, "sheet": 3, "roller": 12, "axial": (2, 3, 2), "thickness": 2, "step": 5},
    "coarse": {"around": 48, "wall": 1, "sheet": 3, "roller": 16, "axial": (1, 2, 1), "thickness": 2, "step": 1},
    "medium": {"around": 48, "wall": 1, "sheet": 5, "roller": 16, "axial": (2, 5, 2), "thickness": 4, "step": 1},
    "full": {"around": 48, "wall": 2, "sheet": 7, "roller": 24, "axial": (5, 9, 6), "thickness": 6, "step": 1},
}

CONSTANTS = """\
# Lengths in mm, stresses in MPa, forces in N; the load time in s.
subsection Constants
  # printed
  set bore       = 11.6  # R2
  set rim        = 100   # R1
  set outer      = 11.27 # R3
  set inner      = 10    # R4
  set roller     = 2.8   # R5
  set length     = 70    # of the tube
  set thickness  = 12    # of the sheet
  # assumed
  set lower_face = 28    # of the sheet, above the lower end of the tube
  set overhang   = 2     # of the rollers, on both sides of the sheet
  set gap        = 0.05  # between rollers and tube at the start
  set feed       = 0.5   # of the rollers
  set fed        = 200   # the feed grows until then
  set held       = 330   # and is held until then
  set end        = 360   # rollers back
  set speed      = 1     # of the rollers round the axis, degrees per s
  set orbit      = inner - roller - gap
end

"""

MATERIALS = """\
# The tube's E_T = 2726 is read as the slope of the whole uniaxial curve, C = 1500 as
# Prager's constant of the back stress tensor. The curve of the sheet is not printed.
subsection Materials
  subsection tube
    set Law                  = small-strain plasticity
    set Strain measure       = Green-Lagrange
    set Young's modulus      = 179000
    set Poisson's ratio      = 0.3
    set Yield stress         = 335
    set Hardening            = linear
    set Hardening modulus    = 2726
    set Hardening modulus is = tangent modulus
    set Kinematic modulus    = 1500
    set Kinematic modulus is = Prager constant
  end
  subsection sheet
    set Law                      = small-strain plasticity
    set Strain measure           = Green-Lagrange
    set Young's modulus          = 204000
    set Poisson's ratio          = 0.3
    set Yield stress             = 450
    set Hardening                = Voce
    set Saturation stress        = 600
    set Reference plastic strain = 0.03
  end
end

"""

OUTPUT = """\
subsection Load stepping
  set End time        = {{end}}
  set Initial step    = {step}
  set Requested times = {{fed}}, {{held}}
end

subsection Output
  set Directory                = tube_{name}
  set Every n steps            = 10
  set Checkpoint every n steps = 5
  subsection Points
    subsection inner
      set Body           = tube
      set Position       = {{inner}}, 0, {{lower_face + thickness/2}}
      set Material state = true
    end
    subsection outer
      set Body          = tube
      set Position      = {{outer}}, 0, {{lower_face + thickness/2}}
      set Contact pair  = expansion
    end
    subsection bore
      set Body           = sheet
      set Position       = {{bore}}, 0, {{lower_face + thickness/2}}
      set Material state = true
    end
    subsection top
      set Body     = tube
      set Position = {{outer}}, 0, {{length}}
    end
  end
end
"""


# of the rollers over the time
FEED = "{feed}*min(t/{fed}, 1)*min(1, ({end} - t)/{end - held})"


def section(name, **settings):
    """A subsection of a subsection; '_' of a name stands for ' '."""
    width = max(map(len, settings))
    lines = [f"    set {key.replace('_', ' ').ljust(width)} = {value}" for key, value in settings.items()]
    return "\n".join([f"  subsection {name}", *lines, "  end"]) + "\n"


def together(name, *parts):
    return f"subsection {name}\n{''.join(parts)}end\n\n"


def start(i):
    """Where the axis of roller i is at the start."""
    return f"{{orbit*cos({120 * i}*pi/180)}}, {{orbit*sin({120 * i}*pi/180)}}, 0"


def bodies(size, rollers):
    below, zone, above = size["axial"]
    first, last = "{lower_face - overhang}", "{lower_face + thickness + overhang}"
    around = f"0 |{size['around']}| 360" if rollers == 3 else f"-60 |{size['around'] // 3}| 60"
    rolled = f"z > {first} && z < {last}"
    return together(
        "Bodies",
        # Cells become shorter towards the rolled zone, and smaller towards the bore.
        section("tube", Generator="graded_annular_sector",
                Arguments=f"{{inner}} |{size['wall']}| {{outer}} : {around} : 0 |{below}, 0.5| {first} |{zone}| {last} |{above}, 2| {{length}}",
                Boundary_ids=f"rolled: id == 0 && {rolled}; expanded: id == 1 && {rolled}", Material="tube"),
        section("sheet", Generator="graded_annular_sector",
                Arguments=f"{{bore}} |{size['sheet']}, 30| {{rim}} : {around} : {{lower_face}} |{size['thickness']}| {{lower_face + thickness}}",
                Material="sheet"),
        *(section(f"roller {i + 1}", Generator="graded_annular_sector",
                  Arguments=f"{{roller/2}}, {{roller}} : 0 |{size['roller']}| 360 : {first}, {last}",
                  Translation=start(i), Rigid="true") for i in range(rollers)))


def conditions(rollers):
    # The integral of the feed over time: a roller rolls on the tube if it turns by -orbit/roller of its way
    # round the axis, with the orbit that it has by then.
    passed = "{feed}*(min(t, {fed})^2/{2*fed} + max(t - {fed}, 0) - max(t - {held}, 0)^2/{2*(end - held)})"
    motions = []
    for i in range(rollers):
        angle = f"({120 * i} + {{speed}}*t)*{{pi/180}}"
        way = [f"({{orbit}} + {FEED})*{f}({angle}) - {{orbit*{f}({120 * i}*pi/180)}}" for f in ("cos", "sin")]
        motions.append(section(f"roller {i + 1}", Body=f"roller {i + 1}", Type="rigid motion",
                               Translation="; \\\n                          ".join(way) + "; 0",
                               Rotation_centre=start(i), Rotation_angle=f"-{{speed/roller}}*({{orbit}}*t + {passed})"))
    sides = [section(f"sides of the {body}", Body=body, Type="cyclic symmetry", Boundary=2, Second_boundary=3)
             for body in (("tube", "sheet") if rollers == 1 else ())]
    return together("Boundary conditions", section("rim", Body="sheet", Boundary=1, Value="0; 0; 0"),
                    section("end", Body="tube", Boundary=4, Value="0; 0; 0"), *sides, *motions)


def contact(friction, rollers):
    law = {"Friction": "Coulomb", "Friction_coefficient": f"{friction:g}"} if friction else {}
    return together("Contact",
                 section("expansion", Slave_body="tube", Slave_boundary="expanded", Master_body="sheet", Master_boundary=0, **law),
                 *(section(f"rolling {i + 1}", Slave_body="tube", Slave_boundary="rolled", Master_body=f"roller {i + 1}",
                           Master_boundary=1, **law) for i in range(rollers)))


def case(name, friction=0.3, whole=False):
    """The .prm of a size as text."""
    size = SIZES[name]
    rollers = 3 if whole else 1
    return (f"# Expansion of a tube in a tube sheet by three rollers (size {name}). Written by case.py.\n" + CONSTANTS
            + "set Title     = Tube expansion\nset Dimension = 3\nset Degree    = 2\n\n" + bodies(size, rollers) + MATERIALS
            + conditions(rollers) + contact(friction, rollers) + OUTPUT.format(name=name, step=size["step"]))


if __name__ == "__main__":
    if len(sys.argv) < 2 or sys.argv[1] not in SIZES:
        sys.exit(__doc__.strip())
    text = case(sys.argv[1], float(sys.argv[2]) if len(sys.argv) > 2 else 0.3)
    if len(sys.argv) > 3:
        with open(sys.argv[3], "w") as file:
            file.write(text)
    else:
        sys.stdout.write(text)
