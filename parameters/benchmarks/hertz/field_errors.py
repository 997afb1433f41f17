"""Errors of a run of two concentric bodies against the closed form."""
import math

import numpy

from fields import read_fields


def last_step(result, name):
    """The file of the last step."""
    return sorted(path for path in result.directory.glob(f"{name}-*.pvtu"))[-1]


POINTS = 6  # of Gauss on a slave face


def field_errors(result, exact):
    """Relative: displacement L2, gradient L2 (energy), pressure L2; body 0 is inside."""
    solution = read_fields(last_step(result, "solution"))
    sums = numpy.zeros(4)
    for body, outside in ((0, False), (1, True)):
        part = solution.in_body(body)
        integrals = (
            lambda x, v, g: ((v("displacement")[:, :x.shape[1]] - exact.displacement(x, outside)) ** 2).sum(axis=1),
            lambda x, v, g: (exact.displacement(x, outside) ** 2).sum(axis=1),
            lambda x, v, g: ((g("displacement")[:, :x.shape[1]] - exact.gradient(x, outside)) ** 2).sum(axis=(1, 2)),
            lambda x, v, g: (exact.gradient(x, outside) ** 2).sum(axis=(1, 2)),
        )
        sums += [part.integrate(integral) for integral in integrals]
    surface = read_fields(last_step(result, "contact"))
    wrong = surface.integrate(lambda x, v, g: (v("pressure") - exact.contact_pressure(x)) ** 2, POINTS)
    right = surface.integrate(lambda x, v, g: exact.contact_pressure(x) ** 2, POINTS)
    return math.sqrt(sums[0] / sums[1]), math.sqrt(sums[2] / sums[3]), math.sqrt(wrong / right)
