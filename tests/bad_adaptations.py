"""Wrong inputs about adapted meshes: see bad_input.py."""
from bad_words import WRONG_INPUT, material


def adaptation(*lines):
    return "subsection Adaptation\n set %s\nend\n" % "\n set ".join(lines)


CASES = {
    "unknown error estimator": (
        "plate.prm", adaptation("Estimator = Keley"), WRONG_INPUT, ["Adaptation/Estimator", "Keley", "recovery", "none"]),
    "cells to refine and to coarsen": (
        "plate.prm", adaptation("Estimator = Kelly", "Refine fraction = 0.7", "Coarsen fraction = 0.4"),
        WRONG_INPUT, ["Adaptation/Coarsen fraction", "0.4", "'Refine fraction' = 0.7", "0.3"]),
    "least levels above most levels": (
        "plate.prm", adaptation("Estimator = Kelly", "Least levels = 4"),
        WRONG_INPUT, ["Adaptation/Least levels", "4", "'Most levels' = 3"]),
    "estimator with a distance that it has no use for": (
        "plate.prm", adaptation("Estimator = Kelly", "Distance = 1"), WRONG_INPUT, ["Adaptation/Distance", "Kelly", "no use for it"]),
    "contact zone without contact": (
        "block.prm", material("linear elastic") + adaptation("Estimator = contact zone"),
        WRONG_INPUT, ["Adaptation/Estimator", "contact zone", "no contact", "'residual'"]),
    "a surface that meets itself on a mesh that is adapted": (
        "plate.prm", "subsection Contact\n subsection base\n set Slave boundary = 1, 2\n set Master body = plate\n set Master boundary = 2\n"
        " set Quadrature = segments\n end\nend\n" + adaptation("Estimator = Kelly"),
        WRONG_INPUT, ["Adaptation/Estimator", "Contact/base", "share a boundary", "'Refinement'"]),
    "METIS for meshes that are adapted": (
        "plate.prm", "subsection Mesh\n set Partitioner = METIS\nend\n" + adaptation("Estimator = Kelly"),
        WRONG_INPUT, ["Adaptation/Estimator = Kelly", "METIS", "p4est"]),
    "triangles that are to be adapted": (
        "plate.prm", "subsection Bodies\n subsection plate\n  set Simplices = true\n end\n"
        " subsection base\n  set Simplices = true\n end\nend\n" + adaptation("Estimator = recovery"),
        WRONG_INPUT, ["Adaptation/Estimator = recovery", "triangles cannot be refined locally"]),
    "residual estimator for bodies of revolution": (
        "plate.prm", "set Axisymmetric = true\n" + adaptation("Estimator = residual"),
        WRONG_INPUT, ["Adaptation/Estimator = residual", "Axisymmetric", "'recovery'"]),
}
