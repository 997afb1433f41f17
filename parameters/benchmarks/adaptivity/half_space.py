"""Errors of computed contact against half spaces, for the forces of the run; relative, profiles in L2."""
import math

import numpy
from closed_form import LineContact
from fields import read_fields

STICK, SLIP = 2, 3  # of the field `status`


def surface_of(result):
    return read_fields(sorted(result.directory.glob("contact-*.pvtu"))[-1])


def l2_error(surface, field, exact, square):
    """`square` is that of the exact field's norm."""
    return math.sqrt(surface.integrate(lambda x, value, gradient: (value(field) - exact(x)) ** 2, 6) / square)


def ellipse(x, radius):
    return numpy.sqrt(numpy.maximum(0, 1 - (x[:, 0] ** 2 + x[:, 1] ** 2) / radius**2))


def ring_integral(field, radius):
    """Of the square of a field that depends on the distance from the origin only, times that distance."""
    r = numpy.linspace(0, radius, 20001)
    return numpy.mean(field(numpy.stack([r, 0 * r], axis=1)) ** 2 * r) * radius


def of_ball(result, modulus, radius, part, friction_coefficient=0):
    """A ball of which the model has the given part: largest pressure, size of the contact, profile; with friction that of
    the traction of Mindlin, who leaves out what is across the force (of the order of Poisson's ratio)."""
    force = abs(result.last("resultants.csv", "spot.normal_force_z")) / part
    a = (0.75 * force * radius / modulus) ** (1 / 3)
    p0 = 1.5 * force / (math.pi * a**2)
    surface = surface_of(result)
    square = part * math.pi / 2 * (p0 * a) ** 2
    size = math.sqrt(result.last("resultants.csv", "spot.contact_area") / part / math.pi)
    errors = {"force": force, "largest pressure": surface["pressure"].max() / p0 - 1, "size": size / a - 1,
              "profile": l2_error(surface, "pressure", lambda x: p0 * ellipse(x, a), square)}
    if friction_coefficient:
        share = abs(result.last("resultants.csv", "spot.friction_force_x")) / part / (friction_coefficient * force)
        stick = a * (1 - share) ** (1 / 3)
        sticks = surface["status"] == STICK
        rim = surface.points[sticks]
        found = max(numpy.hypot(rim[:, 0], rim[:, 1]))
        surface.point_data["traction_x"] = abs(surface["tangential_traction"][:, 0]) / friction_coefficient
        traction = lambda x: p0 * (ellipse(x, a) - stick / a * ellipse(x, stick))
        errors |= {"stick zone": found / stick - 1,
                   "traction": l2_error(surface, "traction_x", traction, part * 2 * math.pi * ring_integral(traction, a))}
    return errors


def of_cylinder(result, young, poisson, radius, part):
    force = abs(result.last("resultants.csv", "line.normal_force_y")) / part
    exact = LineContact(radius, force, young, young, poisson, poisson)
    surface = surface_of(result)
    size = result.last("resultants.csv", "line.contact_area") / (2 * part)
    square = part * 4 / 3 * exact.peak**2 * exact.half_width
    return {"force": force, "largest pressure": surface["pressure"].max() / exact.peak - 1, "size": size / exact.half_width - 1,
            "profile": l2_error(surface, "pressure", lambda x: exact.pressure(x[:, 0]), square)}


def of_pushed_cylinder(result, young, poisson, radius, friction_coefficient):
    """Cattaneo and Mindlin: as of_cylinder, and what sticks and the tangential traction."""
    errors = of_cylinder(result, young, poisson, radius, 1)
    exact = LineContact(radius, errors["force"], young, young, poisson, poisson)
    share = abs(result.last("resultants.csv", "line.friction_force_x")) / (friction_coefficient * errors["force"])
    surface = surface_of(result)
    traction = lambda x: exact.traction(x, share, friction_coefficient)
    ends = numpy.linspace(-exact.half_width, exact.half_width, 20001)
    square = numpy.mean(traction(ends) ** 2) * 2 * exact.half_width
    surface.point_data["traction_x"] = abs(surface["tangential_traction"][:, 0])
    return {**errors, "stick zone": stick_width(surface) / exact.stick_width(share) - 1,
            "traction": l2_error(surface, "traction_x", lambda x: traction(x[:, 0]), square)}


def stick_width(surface):
    """Half of what sticks: on both sides it ends half-way to the next slipping node."""
    x, status = surface.points[:, 0], surface["status"]
    widths = []
    for place in (x, -x):
        last = place[status == STICK].max()
        beyond = place[(status == SLIP) & (place >= last)]
        widths.append((last + beyond.min()) / 2)
    return sum(widths) / 2
