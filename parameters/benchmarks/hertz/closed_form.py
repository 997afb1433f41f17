"""The closed forms that hertz/run compares with. Lengths, moduli: any units."""
import math

import numpy


class LineContact:
    """Hertz: a cylinder on a half space, force P per length."""

    def __init__(self, radius, force, young_1, young_2, poisson_1, poisson_2):
        self.modulus = 1 / ((1 - poisson_1**2) / young_1 + (1 - poisson_2**2) / young_2)
        self.half_width = math.sqrt(4 * force * radius / (math.pi * self.modulus))
        self.peak = 2 * force / (math.pi * self.half_width)

    def pressure(self, x):
        return self.peak * self._ellipse(x, self.half_width)

    def stick_width(self, share):
        """Half of the zone that sticks under the tangential force share * friction coefficient * P (Cattaneo)."""
        return self.half_width * math.sqrt(1 - share)

    def traction(self, x, share, friction_coefficient):
        """Tangential, of the same case, equal materials (Cattaneo, Mindlin)."""
        stick = self.stick_width(share)
        rest = stick / self.half_width * self._ellipse(x, stick)
        return friction_coefficient * self.peak * (self._ellipse(x, self.half_width) - rest)

    @staticmethod
    def _ellipse(x, half_width):
        return numpy.sqrt(numpy.maximum(0.0, 1 - (x / half_width) ** 2))


class RingOnDisc:
    """
    Ring inner < r < outer on a full disc of the same material, no friction,
    plane strain, pressure p + alpha cos 2 theta at r = outer. Uniform part:
    plane hydrostatic stress -p everywhere. Second harmonic, from the Airy
    function phi(r) cos 2 theta with

        ring  phi = A r^2 + B r^4 + C r^-2 + D,     disc  phi = E r^2 + F r^4:

    six conditions: at r = outer sigma_rr = -alpha, sigma_rt = 0; at r = inner
    sigma_rt = 0 on both sides, sigma_rr and u_r continuous.
    """

    POWERS = (2, 4, -2, 0)

    def __init__(self, inner, outer, young, poisson, pressure, amplitude):
        self.inner, self.pressure = inner, pressure
        self.shear = young / (2 * (1 + poisson))
        self.kappa = 3 - 4 * poisson  # plane strain
        self.uniform = -pressure * (self.kappa - 1) / (4 * self.shear)  # u_r / r

        def column(m, r):
            """sigma_rr, sigma_rt, 2 G u_r of phi = r^m."""
            return (m - 4) * r ** (m - 2), 2 * (m - 1) * r ** (m - 2), self._displacement(m, r)[0]

        # Unknowns A, B, C, D, E, F.
        matrix, rhs = numpy.zeros((6, 6)), numpy.zeros(6)
        for i, m in enumerate(self.POWERS):
            matrix[0, i], matrix[1, i], _ = column(m, outer)
            rr, rt, u = column(m, inner)
            matrix[2, i], matrix[4, i], matrix[5, i] = rt, rr, u
            if i < 2:
                matrix[3, 4 + i], matrix[4, 4 + i], matrix[5, 4 + i] = rt, -rr, -u
        rhs[0] = -amplitude
        scale = abs(matrix).max(axis=1)
        constants = numpy.linalg.solve(matrix / scale[:, None], rhs / scale)
        self.ring, self.disc = constants[:4], constants[4:]
        self.contact_amplitude = -sum(c * column(m, inner)[0] for c, m in zip(self.ring, self.POWERS))

    def _displacement(self, m, r):
        """2 G (u_r / cos 2 theta, u_theta / sin 2 theta) of phi = r^m (Michell)."""
        k = self.kappa
        return {2: (-2 * r, 2 * r), 4: ((k - 3) * r**3, (k + 3) * r**3),
                -2: (2 / r**3, 2 / r**3), 0: ((k + 1) / r, -(k - 1) / r)}[m]

    def contact_pressure(self, x):
        theta = numpy.arctan2(x[:, 1], x[:, 0])
        return self.pressure + self.contact_amplitude * numpy.cos(2 * theta)

    def polar(self, r, in_ring):
        """u_r = uniform + a cos 2 theta, u_theta = b sin 2 theta: (uniform, a, b)."""
        constants = self.ring if in_ring else self.disc
        a = sum(c * self._displacement(m, r)[0] for c, m in zip(constants, self.POWERS))
        b = sum(c * self._displacement(m, r)[1] for c, m in zip(constants, self.POWERS))
        return self.uniform * r, a / (2 * self.shear), b / (2 * self.shear)

    def displacement(self, x, in_ring):
        """(m, 2) at the points x (m, 2)."""
        r, theta = numpy.hypot(x[:, 0], x[:, 1]), numpy.arctan2(x[:, 1], x[:, 0])
        uniform, a, b = self.polar(numpy.maximum(r, 1e-12), in_ring)
        radial, hoop = uniform + a * numpy.cos(2 * theta), b * numpy.sin(2 * theta)
        return numpy.stack([radial * numpy.cos(theta) - hoop * numpy.sin(theta),
                            radial * numpy.sin(theta) + hoop * numpy.cos(theta)], axis=1)

    def gradient(self, x, in_ring):
        """(m, 2, 2)"""
        return differences(lambda y: self.displacement(y, in_ring), x)


class Spheres:
    """
    A shell interface < r < outer on a hollow core inner < r < interface, without
    friction, under the pressure p at r = outer (Lame): in each of them u_r = A r +
    B/r^2 and sigma_rr = E A/(1 - 2 nu) - 2 E B/((1 + nu) r^3).
    """

    def __init__(self, inner, interface, outer, young_inside, young_outside, poisson, pressure):
        def stress(young, r):
            return young * numpy.array([1 / (1 - 2 * poisson), -2 / ((1 + poisson) * r**3)])

        def both(inside, outside):
            return numpy.concatenate([inside, outside])

        motion, nothing = numpy.array([interface, interface**-2]), numpy.zeros(2)
        matrix = numpy.array([both(stress(young_inside, inner), nothing), both(nothing, stress(young_outside, outer)),
                              both(motion, -motion),
                              both(stress(young_inside, interface), -stress(young_outside, interface))])
        scale = abs(matrix).max(axis=1)
        constants = numpy.linalg.solve(matrix / scale[:, None], numpy.array([0, -pressure, 0, 0]) / scale)
        self.inside, self.outside = constants[:2], constants[2:]
        self.interface_pressure = -stress(young_inside, interface) @ self.inside

    def contact_pressure(self, x):
        return numpy.full(len(x), self.interface_pressure)

    def displacement(self, x, outside):
        """(m, 3) at the points x (m, 3)."""
        a, b = self.outside if outside else self.inside
        return x * (a + b / numpy.linalg.norm(x, axis=1, keepdims=True) ** 3)

    def gradient(self, x, outside):
        """(m, 3, 3)"""
        return differences(lambda y: self.displacement(y, outside), x)


def differences(field, x, step=1e-4):
    """Gradient of field at x (m, n) by central differences of fourth order: (m, components, n)."""
    columns = []
    for shift in step * numpy.eye(x.shape[1]):
        u = [field(x + n * shift) for n in (-2, -1, 1, 2)]
        columns.append((u[0] - 8 * u[1] + 8 * u[2] - u[3]) / (12 * step))
    return numpy.stack(columns, axis=2)
