"""Errors of a run of rings.prm against the closed form."""
import math

import numpy

from fields import read_fields


def last_step(result, name):
    """The file of the last step."""
    return sorted(path for path in result.directory.glob(f"{name}-*.pvtu"))[-1]


def ring_errors(result, exact):
    """Relative: displacement L2, gradient L2 (energy), pressure L2."""
    solution = read_fields(last_step(result, "solution"))
    sums = numpy.zeros(4)
    for body, in_ring in ((0, False), (1, True)):
        part = solution.in_body(body)
        integrals = (
            lambda x, v, g: ((v("displacement")[:, :2] - exact.displacement(x, in_ring)) ** 2).sum(axis=1),
            lambda x, v, g: (exact.displacement(x, in_ring) ** 2).sum(axis=1),
            lambda x, v, g: ((g("displacement")[:, :2] - exact.gradient(x, in_ring)) ** 2).sum(axis=(1, 2)),
            lambda x, v, g: (exact.gradient(x, in_ring) ** 2).sum(axis=(1, 2)),
        )
        sums += [part.integrate(integral) for integral in integrals]
    surface = read_fields(last_step(result, "contact"))
    wrong = surface.integrate_line(lambda x, p: (p - exact.contact_pressure(x)) ** 2, ["pressure"])
    right = surface.integrate_line(lambda x, p: exact.contact_pressure(x) ** 2, ["pressure"])
    return math.sqrt(sums[0] / sums[1]), math.sqrt(sums[2] / sums[3]), math.sqrt(wrong / right)
