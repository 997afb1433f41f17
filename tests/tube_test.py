#!/usr/bin/env python3
"""Thick tubes as bodies of revolution, as a plane quarter and as a sector in space: one problem, three models.

    tube_test.py PROGRAM WORKING_DIRECTORY

Each model is compared with the closed form and with the others: a tube under inner pressure (Lame), the same tube in full
plastic flow, two rings that are shrunk onto one another. The ends are held: plane strain.
"""
import math
import pathlib
import sys

from checkpoint_runs import Runs, check, failures
from program_runs import rows_of

A, C, B = 1., 1.5, 2.  # radii: hole, joint of the rings, outside
LENGTH = 0.5           # of what is modelled of the tube
YOUNG, POISSON = 1000., 0.3
PRESSURE = 10.
OVERLAP = 1e-4         # of the rings; the law is linear, the contact is not: relative errors are of this order
YIELD_STRESS = 1.
RADIAL = 16            # cells between A and B
ANGLES = {"quarter": (0, 90), "sector": (20, 50)}
MODELS = ("revolution", *ANGLES)
GAUSS = 0.5 - math.sqrt(0.15)  # the first of three points of [0, 1]


ELASTIC = "    set Law = linear elastic\n"
PLASTIC = f"""    set Law = small-strain plasticity
    set Yield stress = {YIELD_STRESS}
"""


def settings_of(model, law):
    """Head of a case: the model and the material."""
    return f"""
set Dimension = {3 if model == "sector" else 2}
set Axisymmetric = {"true" if model == "revolution" else "false"}
set Degree = 2
subsection Materials
  subsection matter
{law}    set Young's modulus = {YOUNG}
    set Poisson's ratio = {POISSON}
  end
end
subsection Algorithm
  subsection Newton
    set Equilibrium tolerance = 1e-9
  end
end
"""


def ring(model, name, inner, outer, cells):
    """A body between two radii; 0 and 1 are its boundaries inside and outside, and its cuts and ends are held."""
    if model == "revolution":
        generator = "subdivided_hyper_rectangle"
        arguments = f"{cells}, 1 : {inner!r}, 0 : {outer!r}, {LENGTH} : true"
    else:
        first, last = ANGLES[model]
        generator = "annular_sector"
        arguments = f"{inner!r} : {outer!r} : {first} : {last} : {cells} : {16 if model == 'quarter' else 6}"
        arguments += f" : {LENGTH} : 1" if model == "sector" else ""
    return f"""
subsection Bodies
  subsection {name}
    set Generator = {generator}
    set Arguments = {arguments}
    set Material = matter
  end
end
subsection Boundary conditions
""" + "".join(f"""  subsection {name} {boundary}
    set Body = {name}
    set Boundary = {boundary}
    set Type = symmetry
  end
""" for boundary in ((2, 3, 4, 5) if model == "sector" else (2, 3))) + "end\n"


def point_of(model, radius):
    """Of the middle of the model: a node."""
    if model == "revolution":
        return f"{radius!r}, {LENGTH / 2}"
    angle = math.radians(sum(ANGLES[model]) / 2)
    return f"{radius * math.cos(angle)!r}, {radius * math.sin(angle)!r}" + (f", {LENGTH / 2}" if model == "sector" else "")


def output_of(model, points):
    """POINTS is {name: (body, radius)}."""
    return "subsection Output\n  set Verbosity = results\n  set Every n steps = 1000\n  subsection Points\n" + "".join(
        f"""    subsection {name}
      set Body = {body}
      set Position = {point_of(model, radius)}
      set Material state = true
    end
""" for name, (body, radius) in points.items()) + "  end\nend\n"


def radial(model, row, name):
    """The radial displacement of a point."""
    angle = 0. if model == "revolution" else math.radians(sum(ANGLES[model]) / 2)
    across = 0. if model == "revolution" else float(row[f"{name}_y"])
    return math.cos(angle) * float(row[f"{name}_x"]) + math.sin(angle) * across


def mises(row, name):
    s = {c: float(row[f"{name}.cauchy_stress_{c}"]) for c in ("xx", "yy", "zz", "xy")}
    s.update({c: float(row.get(f"{name}.cauchy_stress_{c}", 0)) for c in ("yz", "xz")})
    return math.sqrt(((s["xx"] - s["yy"])**2 + (s["yy"] - s["zz"])**2 + (s["zz"] - s["xx"])**2) / 2
                     + 3 * (s["xy"]**2 + s["yz"]**2 + s["xz"]**2))


def last_row(runs, name, table):
    return rows_of(runs.directory / name / table)[-1]


def force_over_pressure(model, radius):
    """What a unit of pressure on a cylinder is as a force along x."""
    if model == "revolution":
        return 2 * math.pi * radius * LENGTH
    first, last = (math.radians(angle) for angle in ANGLES[model])
    return radius * (math.sin(last) - math.sin(first)) * (LENGTH if model == "sector" else 1.)


def compare(what, values, exact, tolerance, likeness):
    """VALUES by model, with the closed form and with the first model's."""
    for model, value in values.items():
        error = abs(value / exact - 1.)
        check(error < tolerance, f"{what}, {model}: {value:.10g}, in closed form {exact:.10g} (by {error:.1e})")
    reference = values[MODELS[0]]
    for model in MODELS[1:]:
        error = abs(values[model] / reference - 1.)
        check(error < likeness, f"{what}, {model}: as by the first model (by {error:.1e})")


def run(runs, name, model, text, n_ranks=1, law=ELASTIC):
    case = f"{name}-{model}.prm"
    (runs.directory / case).write_text(settings_of(model, law) + text)
    return runs.run(f"{name}-{model}" + (f"-{n_ranks}" if n_ranks > 1 else ""), n_ranks, case=case)


def test_pressure(runs):
    """Lame: u = p a^2 (1 + nu)/(E (b^2 - a^2)) ((1 - 2 nu) r + b^2/r), here u(a) = 0.0190666667, u(b) = 0.0121333333."""
    factor = PRESSURE * A**2 / (B**2 - A**2)

    def exact(r):
        return (1 + POISSON) / YOUNG * factor * ((1 - 2 * POISSON) * r + B**2 / r)

    check(abs(exact(A) - .0190666667) < 1e-10 and abs(exact(B) - .0121333333) < 1e-10, "the closed form")
    rows = {}
    for model in MODELS:
        load = f"""
subsection Boundary conditions
  subsection inside
    set Body = tube
    set Boundary = 0
    set Type = pressure
    set Value = {PRESSURE}*t
  end
end
"""
        text = ring(model, "tube", A, B, RADIAL) + load + output_of(model, {"inner": ("tube", A), "outer": ("tube", B)})
        run(runs, "tube", model, text)
        rows[model] = last_row(runs, f"tube-{model}", "points.csv")
    for name, radius in (("inner", A), ("outer", B)):
        compare(f"displacement {name}", {m: radial(m, row, name) for m, row in rows.items()}, exact(radius), 5e-6, 5e-6)
    # at the integration point nearest to the hole
    r = A + GAUSS * (B - A) / RADIAL
    difference = factor * 2 * B**2 / r**2  # hoop minus radial stress
    middle = factor * (1 - 2 * POISSON)    # their mean minus the axial stress
    stress = math.sqrt(0.75 * difference**2 + middle**2)
    compare("stress at the hole", {m: mises(row, "inner") for m, row in rows.items()}, stress, 1e-3, 1e-3)


def test_flow(runs):
    """All of the tube is plastic: p = 2/sqrt(3) sigma_y ln(b/a)."""
    pressures = {}
    for model in MODELS:
        free = "; ".join(["free"] * (2 if model == "sector" else 1))
        components = "" if model == "revolution" else "    set Components = cylindrical\n"
        text = ring(model, "tube", A, B, RADIAL) + f"""
subsection Boundary conditions
  subsection inside
    set Body = tube
    set Boundary = 0
{components}    set Value = 0.02*t; {free}
  end
end
subsection Load stepping
  set Initial step = 0.1
end
""" + output_of(model, {})
        run(runs, "flow", model, text, law=PLASTIC)
        row = last_row(runs, f"flow-{model}", "reactions.csv")
        pressures[model] = float(row["inside.force_x"]) / force_over_pressure(model, A)
    compare("limit pressure", pressures, 2 / math.sqrt(3) * YIELD_STRESS * math.log(B / A), 1e-3, 2e-4)


def values_of_rings(runs, model, name):
    row = last_row(runs, name, "resultants.csv")
    values = {"pressure": float(row["joint.max_pressure"]),
              "force at the joint": float(row["joint.force_x"]) / force_over_pressure(model, C)}
    row = last_row(runs, name, "points.csv")
    for place in ("outside", "inside"):
        values[f"displacement {place}"] = radial(model, row, place)
    return values


def test_rings(runs):
    """Shrunk rings of one material: p = E'/2 d/c (c^2 - a^2) (b^2 - c^2) / (c^2 (b^2 - a^2)), E' = E/(1 - nu^2)."""
    plane = YOUNG / (1 - POISSON**2)
    pressure = plane / 2 * OVERLAP / C * (C**2 - A**2) * (B**2 - C**2) / (C**2 * (B**2 - A**2))
    outside = (1 + POISSON) / YOUNG * pressure * C**2 / (B**2 - C**2) * 2 * (1 - POISSON) * B
    inside = -(1 + POISSON) / YOUNG * pressure * C**2 / (C**2 - A**2) * 2 * (1 - POISSON) * A
    values = {}
    for model in MODELS:
        text = ring(model, "outer", C, B, RADIAL // 2) + ring(model, "inner", A, C + OVERLAP, RADIAL // 2) + """
subsection Contact
  subsection joint
    set Slave body = outer
    set Slave boundary = 0
    set Master body = inner
    set Master boundary = 1
  end
end
""" + output_of(model, {"outside": ("outer", B), "inside": ("inner", A)})
        of_ranks = []
        for n_ranks in (1, 2):
            run(runs, "rings", model, text, n_ranks)
            of_ranks.append(values_of_rings(runs, model, f"rings-{model}" + ("-2" if n_ranks == 2 else "")))
        worst = max(abs(a / b - 1.) for a, b in zip(*(found.values() for found in of_ranks)))
        check(worst < 1e-9, f"rings, {model}: the same on 2 ranks (by {worst:.1e})")
        for what, value in of_ranks[0].items():
            values.setdefault(what, {})[model] = value
    # pressure at a point is as good as the mesh
    compare("pressure at the joint", values.pop("pressure"), pressure, 1e-3, 1e-3)
    for (what, found), exact in zip(values.items(), (pressure, outside, inside)):
        compare(what, found, exact, 2 * OVERLAP, 1e-6)


def main():
    runs = Runs(sys.argv[1], pathlib.Path(sys.argv[2]))
    for test in (test_pressure, test_flow, test_rings):
        test(runs)
    print(f"{len(failures)} failed")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
