#!/usr/bin/python3
"""The pressure of p1.prm beside Hertz' for the force of the run.

usage: pressure.py RESULTS...    (runs with --set "Output/Contact points=true")

Prints, per directory: Newton iterations, the force of the quarter, the pressure at the origin, the root mean square
error inside r < 0.6 a and the largest error at the rim (0.85 a < r < 1.15 a), over the largest pressure p0 of Hertz.
"""
import collections
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from benchmark import read_csv

RADIUS, MODULUS, POISSON = 50.0, 1000.0, 0.3

HertzErrors = collections.namedtuple("HertzErrors", "iterations quarter_force origin rms rim")


def hertz_errors(directory):
    """Errors of the pressure of a run over p0."""
    directory = pathlib.Path(directory)
    force = 4 * abs(read_csv(directory / "resultants.csv")["c.force_z"][-1])
    effective = MODULUS / (2 * (1 - POISSON**2))
    a = (3 * force * RADIUS / (4 * effective)) ** (1 / 3)
    p0 = 1.5 * force / (math.pi * a**2)
    nodes = {}  # a node has several contact points where they belong to faces
    points = read_csv(sorted(directory.glob("contact_points-*.csv"))[-1])
    for x, y, pressure in zip(points["reference_x"], points["reference_y"], points["pressure"]):
        nodes.setdefault((round(x, 9), round(y, 9)), []).append(pressure)
    profile = sorted((math.hypot(x, y), sum(p) / len(p)) for (x, y), p in nodes.items())
    errors = [(r / a, p / p0 - math.sqrt(max(0, 1 - (r / a) ** 2))) for r, p in profile]
    inside = [error**2 for r, error in errors if r < 0.6]
    rim = max((error for r, error in errors if 0.85 < r < 1.15), key=abs)
    iterations = int(sum(read_csv(directory / "statistics.csv")["newton_iterations"]))
    return HertzErrors(iterations, force / 4, errors[0][1], math.sqrt(sum(inside) / len(inside)), rim)


if __name__ == "__main__":
    for name in sys.argv[1:]:
        found = hertz_errors(name)
        print(f"{name}: {found.iterations} iterations, F/4 {found.quarter_force:.3f}, origin {100 * found.origin:+.2f} %, "
              f"rms {100 * found.rms:.2f} %, rim {found.rim:+.3f}")
