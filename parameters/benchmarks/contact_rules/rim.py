#!/usr/bin/python3
"""What the nodal pressures of Hertz' contact could be at best on the mesh of a run, at its rim and in the L2 norm.

usage: rim.py RESULTS...    (runs of ../scaling/p1.prm with --set "Output/Contact points=true")

Prints, per directory, the root mean square of the errors at nodes with r < 0.6 a, the largest at those with 0.85 a < r
< 1.15 a and the error in the L2 norm of the nodal values, over Hertz' for the force of the run: of the averages of
Hertz' own pressure (weighted with shape functions), of its best linear approximation, of the multipliers of the run,
and of these with one step that takes the averaging back.
"""
import math
import pathlib
import sys

import numpy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from benchmark import read_csv

RADIUS, MODULUS, POISSON = 50.0, 1000.0, 0.3
N_POINTS = 40  # of Gauss, per edge and direction: the pressure has a vertical tangent


def grid_of(points):
    """Coordinates of the nodes along an axis and the pressures, [x][y]."""
    pressures = {}
    for x, y, pressure in zip(points["reference_x"], points["reference_y"], points["pressure"]):
        pressures[round(x, 6), round(y, 6)] = pressure
    axis = sorted({x for x, _ in pressures})
    return numpy.array(axis), numpy.array([[pressures[x, y] for y in axis] for x in axis])


def shape_functions(axis):
    """Places, weights and values [node][place] of the linear shape functions along an axis."""
    gauss, weights = numpy.polynomial.legendre.leggauss(N_POINTS)
    xi, lengths = (gauss + 1) / 2, numpy.diff(axis)
    places = (axis[:-1, None] + lengths[:, None] * xi).ravel()
    values = numpy.zeros((len(axis), len(places)))
    for edge in range(len(lengths)):
        part = slice(edge * N_POINTS, (edge + 1) * N_POINTS)
        values[edge, part], values[edge + 1, part] = 1 - xi, xi
    return places, (lengths[:, None] * weights / 2).ravel(), values


def report(directory):
    directory = pathlib.Path(directory)
    axis, multipliers = grid_of(read_csv(sorted(directory.glob("contact_points-*.csv"))[-1]))
    force = 4 * abs(read_csv(directory / "resultants.csv")["c.force_z"][-1])
    a = (3 * force * RADIUS / (4 * MODULUS / (2 * (1 - POISSON**2)))) ** (1 / 3)
    p0 = 1.5 * force / (math.pi * a**2)
    hertz = lambda x: p0 * numpy.sqrt(numpy.maximum(1 - (x[:, None] ** 2 + x[None] ** 2) / a**2, 0))

    places, weights, values = shape_functions(axis)
    mass = (values * weights) @ values.T
    area = numpy.outer(mass.sum(1), mass.sum(1))
    loads = (values * weights) @ hertz(places) @ (values * weights).T
    average = mass / mass.sum(1)[:, None]
    inverse = numpy.linalg.inv(mass)

    exact, r = hertz(axis), numpy.hypot(axis[:, None], axis[None])
    inside, rim = r < 0.6 * a, (r > 0.85 * a) & (r < 1.15 * a)
    print(f"{directory}: {len(axis)} x {len(axis)} nodes, a = {a:.4f}, p0 = {p0:.3f}")
    for name, nodal in (("averages of Hertz' pressure", loads / area), ("its best approximation", inverse @ loads @ inverse.T),
                        ("multipliers", multipliers),
                        ("averaging taken back", numpy.maximum(2 * multipliers - average @ multipliers @ average.T, 0))):
        error = nodal - exact
        norm = math.sqrt((area * error**2).sum() / (area * exact**2).sum())
        rms = math.sqrt((error[inside] ** 2).mean())
        print(f"  {name:28} rms {100 * rms / p0:.2f} %, rim {abs(error[rim]).max() / p0:.3f} p0, L2 {100 * norm:.1f} %, "
              f"integral {100 * ((area * nodal).sum() / (force / 4) - 1):+.1f} %")


for name in sys.argv[1:]:
    report(name)
