#!/usr/bin/env python3
"""Steps that end where contact is made or lost: 'Locate contact changes' against the times that the motion gives.

    contact_changes_test.py PROGRAM WORKING_DIRECTORY

A block goes down over a gap, is pressed and goes up again; a punch with a round end goes down. Until they touch, bodies
only move, so the times are exact.
"""
import pathlib
import sys

from checkpoint_runs import Runs, check, failures
from program_runs import rows_of

YOUNG, POISSON = 1000., 0.3
STEP = 0.25
TOLERANCE = 1e-3  # of STEP
DEPTH = 0.01      # how far the block goes down until t = 1
GAP = 0.3 * DEPTH


def case(top, shape, quadrature):
    """A body 2 x 1 above a floor, moved along y by TOP; its top may move along x, its middle may not."""
    return f"""
set Dimension = 2
subsection Bodies
  subsection body
    set Generator = subdivided_hyper_rectangle
    set Arguments = 16, 4 : -1, 0 : 1, 1 : true
    set Coordinates = {shape}
    set Material = matter
  end
  subsection floor
    set Generator = subdivided_hyper_rectangle
    set Arguments = 8, 1 : -2, -1 : 2, 0 : true
    set Translation = 0, {-GAP}
    set Rigid = true
  end
end
subsection Materials
  subsection matter
    set Law = linear elastic
    set Young's modulus = {YOUNG}
    set Poisson's ratio = {POISSON}
  end
end
subsection Boundary conditions
  subsection top
    set Body = body
    set Boundary = 3
    set Value = free; {top}
  end
  subsection middle
    set Body = body
    set Value = 0; free
    set Where = abs(x) < 1e-6
  end
end
subsection Contact
  subsection gap
    set Slave body = body
    set Slave boundary = 2
    set Master body = floor
    set Master boundary = 3
    set Quadrature = {quadrature}
  end
end
subsection Load stepping
  set Initial step = {STEP}
  set Locate contact changes = true
  set Contact change tolerance = {TOLERANCE}
end
subsection Output
  set Verbosity = results
  set Every n steps = 1000
end
"""


def steps_of(runs, name):
    """[(time, closed points, force on the body along y)] of all steps."""
    return [(float(row["time"]), float(row["gap.closed_points"]), float(row["gap.force_y"]))
            for row in rows_of(runs.directory / name / "resultants.csv")]


def check_time(name, steps, exact, closes):
    """The first step from EXACT on ends there, and is the first in which contact is other than before."""
    n = next(i for i, (time, _, _) in enumerate(steps) if time >= exact)
    late = steps[n][0] - exact
    check(late <= TOLERANCE * STEP * (1 + 1e-9), f"{name}: a step ends {late:.2e} after t = {exact}")
    check((steps[n][1] > 0) == closes and (steps[n - 1][1] > 0) != closes,
          f"{name}: {steps[n - 1][1]:.0f} closed points before, {steps[n][1]:.0f} after")
    if n + 2 < len(steps):
        size = steps[n + 1][0] - steps[n][0]
        check(size > 0.5 * STEP, f"{name}: the next step is as large as without ({size:.3g})")


def test_block(runs):
    """Pressed at t = 0.3, let go at 1.7; in between p = E/(1 - nu^2) times the strain."""
    text = case(f"-{DEPTH}*min(t, 2 - t)", "x; y", "segments").replace("set Initial", "set End time = 2\n  set Requested times = 1\n  set Initial")
    (runs.directory / "block.prm").write_text(text)
    runs.run("block", case="block.prm")
    steps = steps_of(runs, "block")
    check_time("block", steps, 0.3, True)
    check_time("block", steps, 1.7, False)
    for time, _, force in steps:
        expected = max(2 * YOUNG / (1 - POISSON**2) * (DEPTH * min(time, 2 - time) - GAP), 0.)
        check(abs(force - expected) < 1e-8 * YOUNG * DEPTH, f"block: force {force:.6g} at t = {time:.6g}, exact {expected:.6g}")
    # the same times on other numbers of ranks and after a restart in the middle
    runs.run("block-2", 2, case="block.prm")
    runs.run("block-half", case="block.prm", options=["Load stepping/End time=1"])
    runs.run("block-half", case="block.prm", restart="latest")
    for name in ("block-2", "block-half"):
        other = steps_of(runs, name)
        check(len(other) == len(steps) and all(abs(p - q) < 1e-9 for a, b in zip(steps, other) for p, q in zip(a, b)),
              f"{name}: the steps of block ({len(other)} and {len(steps)})")
    runs.run("plain", case="block.prm", options=["Load stepping/Locate contact changes=false"])
    plain = steps_of(runs, "plain")
    check([time for time, _, _ in plain] == [STEP * (i + 1) for i in range(8)], "without it the steps are those of the parameters")


def test_punch(runs):
    """The lowest node touches when the top has gone down by the gap."""
    speed = 2 * GAP
    (runs.directory / "punch.prm").write_text(case(f"-{speed}*t", "x; y + 0.05*(1 - y)*x^2", "nodal"))
    runs.run("punch", case="punch.prm", options=["Load stepping/Initial step=0.4", "Load stepping/Contact change tolerance=0.000625"])
    steps = steps_of(runs, "punch")
    check_time("punch", steps, 0.5, True)
    first = next(closed for _, closed, _ in steps if closed > 0)
    check(first == 2, f"punch: {first:.0f} points are closed then, those of the two faces at the lowest node")
    check(steps[-1][1] > 1, f"punch: {steps[-1][1]:.0f} points are closed at the end")


def main():
    runs = Runs(sys.argv[1], pathlib.Path(sys.argv[2]))
    test_block(runs)
    test_punch(runs)
    print(f"{len(failures)} failed")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
