#!/usr/bin/env python3
"""The pressure of p1.prm beside Hertz' for the force of the run.

usage: pressure.py RESULTS...    (runs with --set "Output/Contact points=true")

Prints, per directory: Newton iterations, the force of the quarter, the pressure at the origin, the root mean square
error inside r < 0.6 a and the largest error at the rim (0.85 a < r < 1.15 a), over the largest pressure p0 of Hertz.
"""
import collections
import csv
import math
import pathlib
import sys

RADIUS, MODULUS, POISSON = 50.0, 1000.0, 0.3

HertzErrors = collections.namedtuple("HertzErrors", "iterations quarter_force origin rms rim")


def rows_of(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file, skipinitialspace=True))


def hertz_errors(directory):
    """Errors of the pressure of a run over p0."""
    directory = pathlib.Path(directory)
    force = 4 * abs(float(rows_of(directory / "resultants.csv")[-1]["c.force_z"]))
    effective = MODULUS / (2 * (1 - POISSON**2))
    a = (3 * force * RADIUS / (4 * effective)) ** (1 / 3)
    p0 = 1.5 * force / (math.pi * a**2)
    nodes = {}  # a node has several contact points where they belong to faces
    for row in rows_of(sorted(directory.glob("contact_points-*.csv"))[-1]):
        x, y = float(row["reference_x"]), float(row["reference_y"])
        nodes.setdefault((round(x, 9), round(y, 9)), []).append(float(row["pressure"]))
    profile = sorted((math.hypot(x, y), sum(p) / len(p)) for (x, y), p in nodes.items())
    errors = [(r / a, p / p0 - math.sqrt(max(0, 1 - (r / a) ** 2))) for r, p in profile]
    inside = [error**2 for r, error in errors if r < 0.6]
    rim = max((error for r, error in errors if 0.85 < r < 1.15), key=abs)
    iterations = sum(int(row["newton_iterations"]) for row in rows_of(directory / "statistics.csv"))
    return HertzErrors(iterations, force / 4, errors[0][1], math.sqrt(sum(inside) / len(inside)), rim)


if __name__ == "__main__":
    for name in sys.argv[1:]:
        found = hertz_errors(name)
        print(f"{name}: {found.iterations} iterations, F/4 {found.quarter_force:.3f}, origin {100 * found.origin:+.2f} %, "
              f"rms {100 * found.rms:.2f} %, rim {found.rim:+.3f}")
