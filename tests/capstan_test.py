#!/usr/bin/env python3
"""A band that is drawn over a rigid cylinder, extrapolated to a membrane: Euler's and Eytelwein's exp(mu theta).

    capstan_test.py PROGRAM WORKING_DIRECTORY

The cases are tests/application/capstan_*.prm, each with two thicknesses of the band. A thickness of a hundredth of the
radius changes the ratio of the forces by 0.1 to 0.5 %; what is left after extrapolation is of the order t^2, and of the
strains of the bands.
"""
import math
import pathlib
import sys

from checkpoint_runs import Runs, check, failures
from program_runs import rows_of

CASES = pathlib.Path(__file__).resolve().parent / "application"
RADIUS = 100.
THICKNESSES = 1., 2.
TOLERANCE = 3e-4


def ratio_of(runs, name, thickness):
    """The force at the end that is drawn over the weight at the other, whose stress is 1."""
    directory = f"{name}-{thickness:g}"
    # the Checks of the case are for its own thickness
    checks = [f"Checks/{check}/Tolerance=1" for check in ("ratio of forces", "moment")]
    runs.run(directory, case=str(CASES / f"{name}.prm"), options=[f"Constants/t={thickness}", *checks])
    row = rows_of(runs.directory / directory / "reactions.csv")[-1]
    return math.hypot(float(row["drawn.force_x"]), float(row["drawn.force_y"])) / thickness


def test_case(runs, name, mu, degrees):
    angle = math.radians(degrees)
    exact = math.exp(mu * angle)
    ratios = [ratio_of(runs, name, thickness) for thickness in THICKNESSES]
    for thickness, ratio in zip(THICKNESSES, ratios):
        print(f"{name}: T2/T1 = {ratio:.7f} with t/R = {thickness / RADIUS:g}")
    # linear through both
    thin, thick = THICKNESSES
    membrane = (thick * ratios[0] - thin * ratios[1]) / (thick - thin)
    error = membrane / exact - 1.
    check(abs(error) < TOLERANCE, f"{name}: T2/T1 = {membrane:.7f} of a membrane, in closed form {exact:.7f} (by {error:.1e})")


def main():
    runs = Runs(sys.argv[1], pathlib.Path(sys.argv[2]))
    test_case(runs, "capstan_90_mu1", 0.1, 90.)
    test_case(runs, "capstan_90_mu3", 0.3, 90.)
    test_case(runs, "capstan_180_mu3", 0.3, 180.)
    print(f"{len(failures)} failed")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
