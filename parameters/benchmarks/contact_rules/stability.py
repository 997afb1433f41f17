#!/usr/bin/python3
"""Inf-sup constants of multiplier spaces and contact rules on a line of slave edges.

usage: stability.py

beta is the least of sup_v b(lambda, v) / (|lambda| |v|) over the multipliers, in L2 norms of the slave surface: v is a
displacement there, b the virtual work of the rule (theory.md, section 7). Shown for 8 and 64 edges, with ends that
are free, and with supported ends whose nodes carry no multiplier. Zero: multipliers that no displacement sees.
"""
import numpy


def shapes(degree, x):
    """Values of the shape functions of an edge, [node][point]."""
    x = numpy.asarray(x)
    if degree == 1:
        return numpy.array([1 - x, x])
    return numpy.array([(1 - x) * (1 - 2 * x), 4 * x * (1 - x), x * (2 * x - 1)])


def gauss(n):
    x, w = numpy.polynomial.legendre.leggauss(n)
    return (x + 1) / 2, w / 2


def newton_cotes(n):
    """n intervals: weights that integrate the interpolant."""
    x = numpy.linspace(0, 1, n + 1)
    return x, numpy.linalg.solve(numpy.vander(x, increasing=True).T, 1 / numpy.arange(1, n + 2))


def on_edge(degree, multiplier_degree, rule):
    """b on an edge of length 1: [multiplier node][displacement node]."""
    x, w = gauss(6)
    if rule.startswith("segments"):
        phi = shapes(multiplier_degree, x)
        if rule.endswith("dual"):  # psi_j = a_jk phi_k with int psi_j phi_k = delta_jk int phi_k
            phi = numpy.diag(phi @ w) @ numpy.linalg.inv((phi * w) @ phi.T) @ phi
        return (phi * w) @ shapes(degree, x).T
    if rule == "nodal":
        x = numpy.linspace(0, 1, multiplier_degree + 1)
        w = shapes(multiplier_degree, gauss(6)[0]) @ gauss(6)[1]
    elif rule.startswith("Gauss"):
        x, w = gauss(int(rule.split()[1]))
    else:
        x, w = newton_cotes(int(rule.split()[1]))
    return (shapes(multiplier_degree, x) * w) @ shapes(degree, x).T


def assembled(n, row_degree, column_degree, local):
    """Sum over n edges of length 1/n."""
    result = numpy.zeros((n * row_degree + 1, n * column_degree + 1))
    for edge in range(n):
        rows, columns = edge * row_degree, edge * column_degree
        result[rows:rows + row_degree + 1, columns:columns + column_degree + 1] += local / n
    return result


def mass(n, degree):
    x, w = gauss(6)
    return assembled(n, degree, degree, (shapes(degree, x) * w) @ shapes(degree, x).T)


def root_inverse(matrix):
    values, vectors = numpy.linalg.eigh(matrix)
    return vectors @ numpy.diag(values**-0.5) @ vectors.T


def inf_sup(n, degree, multiplier_degree, rule, supported):
    b = assembled(n, multiplier_degree, degree, on_edge(degree, multiplier_degree, rule))
    m_lambda, m_v = mass(n, multiplier_degree), mass(n, degree)
    if supported:  # the neighbours of an end take over its function: that of the sum of both
        extend = numpy.zeros((len(m_lambda) - 2, len(m_lambda)))
        extend[:, 1:-1] = numpy.eye(len(m_lambda) - 2)
        extend[0, 0] = extend[-1, -1] = 1
        b, m_lambda, m_v = extend @ b[:, 1:-1], extend @ m_lambda @ extend.T, m_v[1:-1, 1:-1]
    singular = numpy.linalg.svd(root_inverse(m_lambda) @ b @ root_inverse(m_v), compute_uv=False)
    return singular[-1] if len(b) <= b.shape[1] else 0.0


print(f"{'displacement, multipliers, rule':44}    free: 8    64 edges    supported: 8    64 edges")
for degree, multiplier_degree, name in ((1, 1, "Q1, trace"), (2, 2, "Q2, trace"), (2, 1, "Q2, vertices (P2-P1)")):
    for rule in ("segments dual", "segments standard", "nodal", "Gauss 1", "Gauss 2", "Gauss 3", "Newton-Cotes 2", "Newton-Cotes 4"):
        found = [inf_sup(n, degree, multiplier_degree, rule, supported) for supported in (False, True) for n in (8, 64)]
        print(f"{name + ', ' + rule:44}" + "".join(f"{max(0.0, beta):12.3f}" for beta in found))
