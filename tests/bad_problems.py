"""Wrong inputs: the sections that say what is computed."""
from bad_words import (CHECK_FALLS_SHORT, HERE, NO_CONVERGENCE, ONE_STEP, WRONG_INPUT, blocks_held, body, condition,
                       interface, material, own_condition, pair, regularization, section, steel)

COARSE = body("plate", "Simplices = true", "Arguments = 0 |4| 40 : 0 |1| 1 : 0 |4| 40")


def rule(*lines):
    return "subsection Refinement\n subsection spot\n  set %s\n end\nend\n" % "\n  set ".join(lines)


# what is wrong: (file, text added below an include of it, exit code, words of the message)
CASES = {
    "unknown parameter": (
        "plate.prm", "subsection Contact\n subsection base\n set Fricton coefficient = 1\n end\nend",
        WRONG_INPUT, ["Fricton coefficient", "Did you mean 'Friction coefficient'", "case.prm:4"]),
    "unknown expert parameter": (
        "plate.prm", "subsection Contact\n subsection base\n set Facet overlp = 0\n end\nend",
        WRONG_INPUT, ["Facet overlp", "Did you mean 'Facet overlap'", "'Normals'"]),
    "unknown section": ("plate.prm", "subsection Algoritm\nend", WRONG_INPUT, ["Algoritm", "Did you mean 'Algorithm'"]),
    "not a number": ("plate.prm", "set Degree = two", WRONG_INPUT, ["Degree", "two"]),
    "unknown choice": ("plate.prm", "subsection Algorithm\n set Name = GMN\nend", WRONG_INPUT, ["Algorithm/Name", "GMN", "FPM"]),
    "subsection not closed": ("plate.prm", "subsection Mesh", WRONG_INPUT, ["Mesh", "'end'"]),
    "empty boundary id": (
        "plate.prm", "subsection Contact\n subsection base\n set Slave boundary = 7\n end\nend",
        WRONG_INPUT, ["Contact/base/Slave boundary", "7", "0, 1, 2, 3"]),
    "unknown body": (
        "plate.prm", "subsection Contact\n subsection base\n set Slave body = palte\n end\nend",
        WRONG_INPUT, ["Contact/base/Slave", "palte", "'plate'"]),
    "unknown material": (
        "plate.prm", "subsection Bodies\n subsection plate\n set Material = stel\n end\nend", WRONG_INPUT, ["stel", "'steel'"]),
    "slave and master overlap": (
        "plate.prm",
        "subsection Contact\n subsection base\n set Slave boundary = 1, 2\n set Master body = plate\n set Master boundary = 2\n end\nend",
        WRONG_INPUT, ["Contact/base/Quadrature = nodal", "slave and the master set share", "'plate'", "'Quadrature = segments'"]),
    "a surface that is tied to itself": (
        "plate.prm", pair("Slave boundary = 1, 2", "Master body = plate", "Master boundary = 2", "Quadrature = segments", "Law = tied",
                          "Friction = none", "Friction coefficient = 0"),
        WRONG_INPUT, ["Contact/base/Law = tied", "share a boundary of body 'plate'", "'Law = contact'"]),
    "closed gaps of a surface that meets itself": (
        "plate.prm", pair("Slave boundary = 1, 2", "Master body = plate", "Master boundary = 2", "Quadrature = segments",
                          "Initial gaps = closed", "Initial gap tolerance = 0.1"),
        WRONG_INPUT, ["Contact/base/Initial gaps = closed", "share a boundary of body 'plate'", "'as meshed'"]),
    "automatic self contact without automatic contact": (
        "plate.prm", section("Contact", "Automatic self contact = true"),
        WRONG_INPUT, ["Contact/Automatic self contact = true", "'Automatic = false'"]),
    "negative Poisson's ratio": (
        "plate.prm", "subsection Materials\n subsection steel\n set Poisson's ratio = -1.2\n end\nend",
        WRONG_INPUT, ["Poisson's ratio", "-1.2", "greater than -1 and less than 0.5"]),
    "zero modulus": (
        "plate.prm", "subsection Materials\n subsection steel\n set Young's modulus = 0\n end\nend",
        WRONG_INPUT, ["Young's modulus", "greater than 0"]),
    "missing mesh file": (
        "plate.prm", "subsection Bodies\n subsection plate\n set Generator =\n set Arguments =\n set Mesh file = nowhere.msh\n end\nend",
        WRONG_INPUT, ["nowhere.msh"]),
    "inverted cells": (
        "plate.prm", "subsection Bodies\n subsection plate\n set Coordinates = 40 - x; y\n end\nend", WRONG_INPUT, ["plate", "invert"]),
    "unknown generator": (
        "plate.prm", "subsection Bodies\n subsection plate\n set Generator = hyper_rectangel\n end\nend",
        WRONG_INPUT, ["hyper_rectangel", "Did you mean 'hyper_rectangle'"]),
    "wrong expression": (
        "plate.prm", "subsection Boundary conditions\n subsection top\n set Value = 50*q\n end\nend",
        WRONG_INPUT, ["Boundary conditions/top/Value", "50*q"]),
    "a displacement that is not a number": (
        "block.prm", material("linear elastic") + "subsection Boundary conditions\n subsection x1\n set Value = sqrt(-t); free; free\n end\nend",
        WRONG_INPUT, ["Boundary conditions/x1", "not a number", "time"]),
    "a load that is not a number": (
        "plate.prm", "subsection Boundary conditions\n subsection top\n set Value = 50*sqrt(-t)\n end\nend",
        WRONG_INPUT, ["Boundary conditions", "A load", "not a number", "time 1"]),
    "a gap offset that is not a number": (
        "plate.prm", "subsection Contact\n subsection base\n set Gap offset = sqrt(-t)\n end\nend",
        WRONG_INPUT, ["Contact/base/Gap offset", "not a number", "time 1"]),
    "HDF5 of different kinds of cells": (
        "plate.prm", body("plate", "Simplices = true") + section("Output", "Format = hdf5"),
        WRONG_INPUT, ["Output/Format = hdf5", "triangles and quadrilaterals", "'vtu'"]),
    "local refinement beside triangles": (
        "plate.prm", body("plate", "Simplices = true") + rule("First corner = 0, 0", "Second corner = 1, 1"),
        WRONG_INPUT, ["Refinement/spot", "triangles cannot be refined locally"]),
    "triangles that are cut again": (
        "plate.prm", body("plate", "Generator =", "Arguments =", "Mesh file = %s/triangle.msh" % HERE, "Simplices = true"),
        WRONG_INPUT, ["Bodies/plate/Simplices", "triangles already"]),
    "tetrahedra of degree 3": (
        "block.prm", material("linear elastic") + "set Degree = 3\n" + body("block", "Simplices = true"),
        WRONG_INPUT, ["Degree is 3", "tetrahedra", "degree 1 or 2"]),
    "quadratic multipliers on tetrahedra": (
        "plate_3d.prm", "set Degree = 2\n" + COARSE + body("base", "Simplices = true") + pair("Multiplier space = displacement trace"),
        WRONG_INPUT, ["Contact/base/Multiplier space", "vanish at its vertices", "'vertices'"]),
    "nodal contact of quadratic tetrahedra": (
        "plate_3d.prm", "set Degree = 2\n" + COARSE + body("base", "Simplices = true") + pair("Quadrature = nodal"),
        WRONG_INPUT, ["Contact/base/Quadrature", "degree 2", "'segments'"]),
    "Simpson's rule on tetrahedra": (
        "plate_3d.prm", COARSE + body("base", "Simplices = true") + pair("Quadrature = Simpson"),
        WRONG_INPUT, ["Contact/base/Quadrature", "Simpson", "segments, nodal, Gauss"]),
    "fewer contact points than multipliers": (
        "plate.prm", "set Degree = 2\nsubsection Contact\n subsection base\n set Quadrature = Gauss\n set Quadrature order = 2\n end\nend",
        WRONG_INPUT, ["Contact/base/Quadrature", "Quadrature order", "2 contact points", "3 multipliers", "Multiplier space", "Degree"]),
    "fewer contact points than multipliers in 3D": (
        "plate_3d.prm", "set Degree = 2\nsubsection Contact\n subsection base\n set Quadrature = Newton-Cotes\n set Quadrature order = 1\n end\nend",
        WRONG_INPUT, ["Contact/base/Quadrature", "Quadrature order", "4 contact points", "9 multipliers"]),
    "GCP without nodal quadrature": (
        "plate.prm", "set Degree = 1\nsubsection Contact\n subsection base\n set Quadrature = Gauss\n end\nend\nsubsection Algorithm\n set Name = GCP\nend",
        WRONG_INPUT, ["Contact/base/Quadrature", "Gauss", "GCP", "nodal"]),
    "unsupported regularization": (
        "plate.prm", "subsection Contact\n subsection base\n set Quadrature = Gauss\n subsection Regularization\n set r_t status = 3\n set r_t law = 1\n end\n end\nend",
        WRONG_INPUT, ["r_t status", "r_t law"]),
    "questionable regularization": (
        "plate.prm", "subsection Contact\n subsection base\n subsection Regularization\n set r_t status = 3\n set r_t law = 1\n end\n end\nend\n"
        "subsection Output\n set Verbosity = progress\nend",
        0, ["Warning: 'Contact/base/Regularization/r_t status'"]),
    "body that nothing holds": ("unheld_block.prm", "", WRONG_INPUT, ["'block'", "translation along x"]),
    "output directory is a file": ("plate.prm", "subsection Output\n set Directory = case.prm\nend", WRONG_INPUT, ["Output/Directory", "case.prm"]),
    "unknown quantity in a check": (
        "patch_test.prm", "subsection Checks\n subsection a\n set Quantity = c.force_q\n set Expected = 1\n end\nend",
        WRONG_INPUT, ["c.force_q", "Did you mean 'c.force_"]),
    "F-bar with a law of small strains": (
        "block.prm", material("linear elastic", "set Element = F-bar"), WRONG_INPUT, ["Materials/matter/Element", "Take B-bar"]),
    "F-bar with quadratic elements": (
        "block.prm", material("Hencky", "set Element = F-bar") + "set Degree = 2", WRONG_INPUT, ["Materials/matter/Element", "Degree is 2"]),
    "hardening that softens": (
        "block.prm", material("small-strain plasticity", "set Hardening = linear", "set Hardening modulus = -1"),
        WRONG_INPUT, ["Materials/matter/Hardening modulus", "-1", "at least 0"]),
    "a step that turns cells inside out": (
        "block.prm", material("Simo-Miehe plasticity", "set Element = F-bar") + ONE_STEP
        + "subsection Boundary conditions\n subsection x1\n set Value = -1.5*t; free; free\n end\nend",
        NO_CONVERGENCE, ["The volume is not positive in body 'block' at the reference position ("]),
    "a check that falls short": (
        "patch_test.prm", "subsection Checks\n subsection a\n set Quantity = c.force_y\n set Expected = 26\n end\nend",
        CHECK_FALLS_SHORT, ["FALLS SHORT"]),
    # ------------------------------------------------------------- bodies that nothing holds
    "bodies that contact alone joins": (
        "floating_blocks.prm", "", WRONG_INPUT, ["bodies 'lower', 'upper'", "translation along x", "rotation about z", "contact alone"]),
    "joined bodies free to slide together": (
        "floating_blocks.prm", condition("lower", 2, "Value = free; 0"), WRONG_INPUT, ["bodies 'lower', 'upper': translation along x"]),
    "a weakly held body": (
        "floating_blocks.prm", condition("lower", 2, "Value = 0; 0") + condition("upper", 3, "Type = traction", "Value = 0.1*t; -t")
        + condition("upper", 0, "Type = spring", "Stiffness = 1e-17") + ONE_STEP,
        NO_CONVERGENCE, ["Cause: weakly held body", "body 'upper': translation along x", "a stiffer spring"]),
    "a pair that never meets": (
        "floating_blocks.prm", condition("lower", 2, "Value = 0; 0") + condition("upper", 3, "Value = 0; t") + body("upper", "Translation = 0, 9, 0"),
        0, ["Warning: contact pair 'interface' has not acted", "Search distance"]),
    "a pair that is always open": (
        "floating_blocks.prm", blocks_held("Translation = 0, 0.3, 0"), 0, ["Warning: contact pair 'interface' has never touched"]),
    "meshes in two units of length": (
        "floating_blocks.prm", blocks_held("Arguments = 2, 2 : 0, 1000 : 1000, 2000 : true") + section("Output", "Verbosity = progress"),
        0, ["Warning: the surfaces of contact pair 'interface' can hardly meet", "size 1000", "size 1,", "same unit of length"]),
    "bodies far from each other": (
        "floating_blocks.prm", blocks_held("Translation = 0, 9, 0") + section("Output", "Verbosity = progress"),
        0, ["0 of 3 points of 'upper' have 'lower' opposite", "can hardly meet", "9 apart"]),
    "a press fit of facets that do not match": (
        "press_fit.prm", interface("Facets = flat", name="fit"), 0,
        ["Warning: contact pair 'fit': the cells do not match", "'Facets = curved' takes", "'Degree = 2' follows"]),
    "a body that turns, with a law of small strains": (
        "floating_blocks.prm", "".join(condition(body, boundary, "Type = displacement", "Value = x*(cos(0.2*t) - 1) - y*sin(0.2*t); x*sin(0.2*t) + y*(cos(0.2*t) - 1)")
                                       for body, boundary in (("lower", 2), ("upper", 3))) + section("Output", "Verbosity = progress"),
        0, ["Warning: body 'lower' has turned by 11 degrees", "'Materials/elastic/Law = linear elastic'"]),
    "a pair with slave and master exchanged": (
        "floating_blocks.prm", blocks_held("Translation = 0, 0.3, 0") + section("Output", "Verbosity = progress")
        + interface("Slave body = lower", "Slave boundary = 3", "Master body = upper", "Master boundary = 2", name="twice"),
        0, ["Warning: contact pairs 'interface' and 'twice' have the same surfaces"]),
    "a surface that is slave and master": (
        "floating_blocks.prm", blocks_held("Translation = 0, 0.3, 0") + section("Output", "Verbosity = progress")
        + interface("Slave body = lower", "Slave boundary = 3", "Master body = upper", "Master boundary = 1", name="other"),
        0, ["Warning: contact pairs 'interface' and 'other' share a surface that is slave of one and master of the other"]),
    "an overlap above the limit": (
        "floating_blocks.prm", blocks_held("Translation = 0, -0.2, 0") + interface("Largest initial overlap = 0.1"),
        WRONG_INPUT, ["Contact/interface/Largest initial overlap", "is 0.1", "'upper' and 'lower' overlap by 0.2"]),
    "closed gaps without a tolerance": (
        "floating_blocks.prm", interface("Initial gaps = closed"), WRONG_INPUT, ["Contact/interface/Initial gap tolerance", "larger than 0"]),
    "a tolerance of gaps as they are": (
        "floating_blocks.prm", interface("Initial gap tolerance = 1"), WRONG_INPUT, ["Contact/interface/Initial gap tolerance", "as meshed"]),
    # ------------------------------------------------------------- meshes
    "nodes that are there twice": (
        "unheld_block.prm", body("block", "Generator =", "Arguments =", f"Mesh file = {HERE}/cracked.msh")
        + condition("block", 2, "Value = 0; 0") + condition("block", 3, "Value = 0; 0"),
        0, ["Warning: Bodies/block: 1 face of its boundary, first at (0.5, 1), lie", "Merge the nodes"]),
    "coordinates that are not numbers": (
        "plate.prm", body("plate", "Coordinates = x; sqrt(y-1)"), WRONG_INPUT, ["Bodies/plate/Coordinates", "sqrt(y-1)", "not a finite number", "(0, 0)"]),
    "infinite coordinates": ("plate.prm", body("plate", "Coordinates = x/0; y"), WRONG_INPUT, ["Bodies/plate/Coordinates", "not a finite number"]),
    "one coordinate": ("plate.prm", body("plate", "Coordinates = x"), WRONG_INPUT, ["Bodies/plate/Coordinates", "1 expressions, expected 2"]),
    "coordinates with an unknown variable": ("plate.prm", body("plate", "Coordinates = x; w"), WRONG_INPUT, ["Bodies/plate/Coordinates", "w"]),
    "negative refinements": ("plate.prm", body("plate", "Refinements = -1"), WRONG_INPUT, ["Bodies/plate/Refinements", "-1"]),
    "scale zero": ("plate.prm", body("plate", "Scale = 0, 1"), WRONG_INPUT, ["Bodies/plate"]),
    "wrong arguments of a generator": ("plate.prm", body("base", "Arguments = one"), WRONG_INPUT, ["Bodies/base/Arguments", "'first corner' is missing"]),
    "a mesh file that is a directory": ("plate.prm", body("plate", "Generator =", "Arguments =", "Mesh file = ."), WRONG_INPUT, ["Bodies/plate/Mesh file"]),
    "a mesh file of text": ("plate.prm", body("plate", "Generator =", "Arguments =", "Mesh file = case.prm"), WRONG_INPUT, ["case.prm"]),
    "a boundary id that no face gets": ("plate.prm", body("plate", "Boundary ids = 7: x > 1000"), WRONG_INPUT, ["Bodies/plate/Boundary ids", "marks no face"]),
    # ------------------------------------------------------------- boundary conditions
    "negative boundary": ("plate.prm", condition("plate", "-2", "Value = 0; 0"), WRONG_INPUT, ["/Boundary", "'-2'", "0, 1, 2, 3"]),
    "negative slave boundary": ("plate.prm", pair("Slave boundary = -2"), WRONG_INPUT, ["Contact/base/Slave boundary", "'-2'", "0, 1, 2, 3"]),
    "boundary in words": ("plate.prm", condition("plate", "left", "Value = 0; 0"), WRONG_INPUT, ["/Boundary", "'left'", "0, 1, 2, 3"]),
    "boundary beyond all integers": ("plate.prm", condition("plate", "99999999999", "Value = 0; 0"), WRONG_INPUT, ["/Boundary"]),
    "a component too many": ("plate.prm", condition("plate", 1, "Value = 0; 0; 0"), WRONG_INPUT, ["/Value", "0; 0; 0"]),
    "a pressure of two components": ("plate.prm", condition("plate", 3, "Type = pressure", "Value = 1; 1"), WRONG_INPUT, ["/Value"]),
    "a negative spring": ("plate.prm", condition("plate", 3, "Type = spring", "Stiffness = -1"), WRONG_INPUT, ["/Stiffness", "-1"]),
    "a condition of an unknown type": ("plate.prm", condition("plate", 3, "Type = glue"), WRONG_INPUT, ["/Type", "glue", "spring"]),
    "a condition on no body": ("plate.prm", condition("", 3, "Value = 0; 0"), WRONG_INPUT, ["/Body"]),
    "a place that no node has": (
        "plate.prm", "subsection Boundary conditions\n subsection corner\n set Where = x > 1000\n end\nend", WRONG_INPUT, ["Boundary conditions/corner", "no component of any node"]),
    # ------------------------------------------------------------- contact and materials
    "negative friction": ("plate.prm", pair("Friction coefficient = -0.1"), WRONG_INPUT, ["Contact/base/Friction coefficient", "-0.1"]),
    "unknown quadrature": ("plate.prm", pair("Quadrature = Gaus"), WRONG_INPUT, ["Contact/base/Quadrature", "Gaus", "Gauss"]),
    "unknown law": ("plate.prm", "subsection Materials\n subsection steel\n set Law = steel\n end\nend", WRONG_INPUT, ["Materials/steel/Law", "steel"]),
    "incompressible": ("plate.prm", "subsection Materials\n subsection steel\n set Poisson's ratio = 0.5\n end\nend", WRONG_INPUT, ["Poisson's ratio", "0.5"]),
    "a modulus that is not a number": ("plate.prm", "subsection Materials\n subsection steel\n set Young's modulus = nan\n end\nend", WRONG_INPUT, ["Young's modulus"]),
    "an infinite modulus": ("plate.prm", "subsection Materials\n subsection steel\n set Young's modulus = inf\n end\nend", WRONG_INPUT, ["Young's modulus"]),
    # ------------------------------------------------------------- contact
    "Coulomb friction without a coefficient": ("plate.prm", pair("Friction coefficient = 0"), WRONG_INPUT, [
        "Contact/base/Friction coefficient", "larger than 0", "Friction = none"]),
    "a coefficient without friction": ("plate.prm", pair("Friction = none"), WRONG_INPUT, ["Contact/base/Friction coefficient", "Friction = none"]),
    "Tresca's law with a coefficient": ("plate.prm", pair("Friction = Tresca"), WRONG_INPUT, ["Contact/base/Friction coefficient", "Friction = Tresca"]),
    "a negative Tresca threshold": ("plate.prm", pair("Tresca threshold = -1"), WRONG_INPUT, ["Contact/base/Tresca threshold", "-1", ">= 0"]),
    "a pair without a slave": ("plate.prm", pair("Slave body ="), WRONG_INPUT, ["Contact/base/Slave body", "missing"]),
    "a pair without a master boundary": ("plate.prm", pair("Master boundary ="), WRONG_INPUT, ["Contact/base/Master boundary", "missing"]),
    "a negative search distance": ("plate.prm", pair("Search distance = -1"), WRONG_INPUT, ["Contact/base/Search distance", "-1", ">= 0"]),
    "quadrature of order 0": ("plate.prm", pair("Quadrature order = 0"), WRONG_INPUT, ["Contact/base/Quadrature order", "from 1 to 20"]),
    "quadrature of order 1000": ("plate.prm", pair("Quadrature order = 1000"), WRONG_INPUT, ["Contact/base/Quadrature order", "1000", "from 1 to 20"]),
    "a gap offset of an unknown variable": ("plate.prm", pair("Gap offset = q"), WRONG_INPUT, ["Contact/base/Gap offset", "'q'", "x,y,z,t"]),
    "a gap offset of two components": ("plate.prm", pair("Gap offset = 0; 1"), WRONG_INPUT, ["Contact/base/Gap offset", "1 component"]),
    "excluded boundaries that are not there": ("plate.prm", pair("Excluded boundaries = 77"), WRONG_INPUT, ["Contact/base/Excluded boundaries", "77", "0, 1, 2, 3"]),
    "excluded points of three coordinates": ("plate.prm", pair("Excluded points = 1,2,3"), WRONG_INPUT, ["Contact/base/Excluded points", "1,2,3", "2 numbers"]),
    "excluded points off the surface": ("plate.prm", pair("Excluded points = 1000,1000"), WRONG_INPUT, ["Contact/base/Excluded points", "1000,1000"]),
    "excluded points in words": ("plate.prm", pair("Excluded points = a,b"), WRONG_INPUT, ["Contact/base/Excluded points", "a,b"]),
    "a smoothing angle beyond 180": ("plate.prm", pair("Smoothing angle = 200"), WRONG_INPUT, ["Contact/base/Smoothing angle", "200", "from 0 to 180"]),
    "an unknown multiplier space": ("plate.prm", pair("Multiplier space = vertex"), WRONG_INPUT, ["Contact/base/Multiplier space", "vertex", "vertices"]),
    "a negative r_n": ("plate.prm", regularization("r_n = -1"), WRONG_INPUT, ["Contact/base/Regularization/r_n", "-1", "larger than 0"]),
    "r_n in words": ("plate.prm", regularization("r_n = big"), WRONG_INPUT, ["Contact/base/Regularization/r_n", "big", "automatic"]),
    "r_t that is not a number": ("plate.prm", regularization("r_t = nan"), WRONG_INPUT, ["Contact/base/Regularization/r_t", "nan"]),
    "plain regularization without numbers": ("plate.prm", regularization("Scale = plain"), WRONG_INPUT, ["Contact/base/Regularization", "'r_n'", "numbers"]),
    "a facet overlap of a whole facet": ("plate.prm", pair("Facet overlap = 1"), WRONG_INPUT, ["Contact/base/Facet overlap", "from 0 to 0.2"]),
    "the same surfaces in two pairs": (
        "plate.prm", "subsection Contact\n subsection twice\n set Slave body = plate\n set Slave boundary = 2\n set Master body = base\n set Master boundary = 3\n end\nend",
        WRONG_INPUT, ["'Contact/base' and 'Contact/twice'", "same slave and master surface"]),
    # ------------------------------------------------------------- bodies
    "regions of an unknown material": ("plate.prm", body("plate", "Material regions = gold: x > 3"), WRONG_INPUT, ["Bodies/plate/Material", "'gold'", "'steel'"]),
    "regions without cells": ("plate.prm", body("plate", "Material regions = steel: x > 3000"), WRONG_INPUT, ["Bodies/plate/Material regions", "no cell"]),
    "regions without a colon": ("plate.prm", body("plate", "Material regions = steel x > 3"), WRONG_INPUT, ["Bodies/plate/Material regions", "label: condition"]),
    "boundary ids without a colon": ("plate.prm", body("plate", "Boundary ids = 7 x > 1"), WRONG_INPUT, ["Bodies/plate/Boundary ids", "label: condition"]),
    "boundary ids of an unknown variable": ("plate.prm", body("plate", "Boundary ids = 7: w > 1"), WRONG_INPUT, ["Bodies/plate/Boundary ids", "w > 1"]),
    "a translation of two components in 3D": ("plate_3d.prm", body("plate", "Translation = 1, 2"), WRONG_INPUT, ["Bodies/plate/Translation", "expected 3", "found 2"]),
    "an axis without direction": (
        "plate_3d.prm", body("plate", "Rotation axis = 0, 0, 0", "Rotation angle = 30"), WRONG_INPUT, ["Bodies/plate/Rotation axis", "zero"]),
    "an infinite translation": ("plate.prm", body("plate", "Translation = inf, 0"), WRONG_INPUT, ["Bodies/plate/Translation", "inf, 0"]),
    "a translation beyond all digits": ("plate.prm", body("plate", "Translation = 1e300, 0"), WRONG_INPUT, ["Bodies/plate", "degenerate"]),
    "cells in a third direction": (
        "unheld_block.prm", body("block", "Arguments = 3, 2, 2 : 0, 0 : 1, 1"), WRONG_INPUT, ["Bodies/block/Arguments", "cells per direction", "'3, 2, 2'", "2 numbers"]),
    "no cells": ("unheld_block.prm", body("block", "Arguments = 0, 2 : 0, 0 : 1, 1"), WRONG_INPUT, ["Bodies/block/Arguments", "cells per direction", "at least 1"]),
    "a negative number of cells": (
        "unheld_block.prm", body("block", "Arguments = -1, 2 : 0, 0 : 1, 1"), WRONG_INPUT, ["Bodies/block/Arguments", "cells per direction", "'-1'", "at least 1"]),
    "a flat body": ("unheld_block.prm", body("block", "Arguments = 2, 2 : 0, 0 : 1, 0"), WRONG_INPUT, ["Bodies/block", "degenerate cell"]),
    "a corner that is not a number": ("unheld_block.prm", body("block", "Arguments = 2, 2 : 0, nan : 1, 1"), WRONG_INPUT, ["Bodies/block/Arguments", "nan"]),
    "an argument too many": ("unheld_block.prm", body("block", "Arguments = 2, 2 : 0, 0 : 1, 1 : true : 7"), WRONG_INPUT, ["Bodies/block/Arguments", "too many"]),
    "a ball of negative radius": (
        "unheld_block.prm", body("block", "Generator = hyper_ball", "Arguments = 0, 0 : -1"), WRONG_INPUT, ["Bodies/block/Arguments", "'radius' is '-1'", "greater than 0"]),
    "a shell turned inside out": (
        "unheld_block.prm", body("block", "Generator = hyper_shell", "Arguments = 0, 0 : 2 : 1"), WRONG_INPUT, ["Bodies/block/Arguments", "inner radius < outer radius", "2 and 1"]),
    "a sector turned inside out": (
        "unheld_block.prm", body("block", "Generator = annular_sector", "Arguments = 2 : 1 : 0 : 90 : 2 : 2"), WRONG_INPUT, ["Bodies/block/Arguments", "inner radius < outer radius"]),
    "graded positions that fall": ("plate.prm", body("plate", "Arguments = 1 |2| 0 : 0 |1| 1"), WRONG_INPUT, ["Bodies/plate/Arguments", "does not increase"]),
    "no shape": ("unheld_block.prm", body("block", "Generator =", "Arguments ="), WRONG_INPUT, ["Bodies/block", "'Generator'", "'Mesh file'"]),
    "two shapes": ("plate.prm", body("plate", "Mesh file = a.msh"), WRONG_INPUT, ["Bodies/plate", "'Generator", "'Mesh file", "Choose one"]),
    "coordinates in one point": ("plate.prm", body("plate", "Coordinates = 0; 0"), WRONG_INPUT, ["Bodies/plate", "320 of 320 cells"]),
    "coordinates that depend on time": ("plate.prm", body("plate", "Coordinates = x + t; y"), WRONG_INPUT, ["Bodies/plate/Coordinates", "x + t", "x,y"]),
    "a 2D case in 3D": ("plate.prm", "set Dimension = 3", WRONG_INPUT, ["Bodies/plate/Arguments", "'z positions' is missing"]),
    # ------------------------------------------------------------- boundary conditions
    "a traction on no boundary": ("plate.prm", own_condition("Body = plate", "Type = traction", "Value = 0; 1"), WRONG_INPUT, ["Boundary conditions/own/Boundary", "empty"]),
    "a pressure without value": ("plate.prm", own_condition("Body = plate", "Boundary = 1", "Type = pressure"), WRONG_INPUT, ["Boundary conditions/own/Value", "empty"]),
    "a free traction": (
        "plate.prm", own_condition("Body = plate", "Boundary = 3", "Type = traction", "Value = free; 1"), WRONG_INPUT, ["Boundary conditions/own/Value", "free"]),
    "a place that is no condition": ("plate.prm", own_condition("Body = plate", "Where = x >", "Value = 0; 0"), WRONG_INPUT, ["Boundary conditions/own/Where", "x >"]),
    "a place that depends on time": (
        "plate.prm", own_condition("Body = plate", "Where = t > 0", "Value = 0; 0"), WRONG_INPUT, ["Boundary conditions/own/Where", "t > 0", "x,y,z."]),
    "a place for a traction": (
        "plate.prm", own_condition("Body = plate", "Boundary = 3", "Type = traction", "Value = 0; 1", "Where = x > 3"), WRONG_INPUT, ["Boundary conditions/own/Where", "traction"]),
    "two displacements at one node": (
        "plate.prm", own_condition("Body = plate", "Boundary = 1", "Value = 1; free"), WRONG_INPUT, ["Boundary conditions/right", "Boundary conditions/own", "contradict"]),
    "a rotation by an unknown variable": (
        "plate.prm", own_condition("Body = base", "Type = rigid motion", "Rotation angle = q"), WRONG_INPUT, ["Boundary conditions/own/Rotation angle", "'q'"]),
    "a rigid motion of one component": (
        "plate.prm", own_condition("Body = base", "Type = rigid motion", "Translation = t"), WRONG_INPUT, ["Boundary conditions/own/Translation", "2 components"]),
    "a rigid motion about a point": (
        "plate.prm", own_condition("Body = base", "Type = rigid motion", "Rotation angle = t", "Rotation centre = 1"), WRONG_INPUT, ["Boundary conditions/own/Rotation centre", "'1'"]),
    "a rigid motion without axis": (
        "plate_3d.prm", own_condition("Body = base", "Type = rigid motion", "Rotation angle = t", "Rotation axis = 0, 0, 0"),
        WRONG_INPUT, ["Boundary conditions/own/Rotation axis", "no length"]),
    "a spring without stiffness": (
        "plate.prm", own_condition("Body = plate", "Boundary = 3", "Type = spring"), WRONG_INPUT, ["Boundary conditions/own/Stiffness", "greater than 0"]),
    "a spring of unknown direction": (
        "plate.prm", own_condition("Body = plate", "Boundary = 3", "Type = spring", "Stiffness = 1", "Direction = w"), WRONG_INPUT, ["Boundary conditions/own/Direction", "'w'"]),
    "rule of refinement without its lengths": (
        "plate.prm", rule("Type = contact", "Contact pair = base"),
        WRONG_INPUT, ["Refinement/spot/Distance is missing", "Type = contact"]),
    "rule of refinement with what it has no use for": (
        "plate.prm", rule("First corner = 0, 0", "Second corner = 1, 1", "Radius = 2"),
        WRONG_INPUT, ["Refinement/spot/Radius", "no use for it"]),
    "rule of refinement for an unknown pair": (
        "plate.prm", rule("Type = contact", "Contact pair = bse", "Distance = 1"),
        WRONG_INPUT, ["Refinement/spot/Contact pair", "'bse'", "Did you mean 'base'"]),
    "corner with too many coordinates": (
        "plate.prm", rule("First corner = 0, 0, 0", "Second corner = 1, 1, 1"),
        WRONG_INPUT, ["Refinement/spot/First corner has 3 coordinates", "2D"]),
    "rule of refinement that meets nothing": (
        "plate.prm", rule("First corner = 1000, 0", "Second corner = 1001, 1"),
        WRONG_INPUT, ["Refinement/spot refines nothing"]),
    "local refinement of triangles": (
        "plate.prm", body("plate", "Simplices = true") + body("base", "Simplices = true") +
        rule("First corner = 0, 0", "Second corner = 1, 1"),
        WRONG_INPUT, ["Refinement/spot", "triangles cannot be refined locally"]),
    "local refinement with METIS": (
        "plate.prm", section("Mesh", "Partitioner = METIS") +
        rule("First corner = 0, 0", "Second corner = 1, 1"),
        WRONG_INPUT, ["Refinement/spot", "METIS", "Take p4est"]),
    "local refinement of periodic bodies": (
        "column_3d.prm", rule("Type = condition", "Condition = 1"),
        WRONG_INPUT, ["Refinement/spot", "periodic boundaries", "not available"]),
    "friction with Gauss points where slave nodes hang": (
        "plate_3d.prm", pair("Quadrature = Gauss") + rule("Type = condition", "Condition = x < 15"),
        WRONG_INPUT, ["Contact/base/Quadrature = Gauss", "cells of different levels", "'segments' or 'nodal'"]),
    "more levels of refinement than fit": (
        "plate.prm", rule("Type = condition", "Condition = 1", "Levels = 12"),
        WRONG_INPUT, ["Refinement/spot/Levels = 12 makes at least", "cells", "free there"]),
    "an amplitude that nobody has made": (
        "plate.prm", own_condition("Body = plate", "Boundary = 3", "Type = pressure", "Value = 1", "Amplitude = rmap")
        + section("Amplitudes", "x = 1").replace("set x = 1", "subsection ramp\n set Table = 0: 0, 1: 1\n end"),
        WRONG_INPUT, ["Boundary conditions/own/Amplitude", "'rmap'", "Did you mean 'ramp'"]),
    "an amplitude without points": ("plate.prm", "subsection Amplitudes\n subsection a\n end\nend", WRONG_INPUT, ["Amplitudes/a", "'Table' or 'File'"]),
    "an amplitude with a table and a file": (
        "plate.prm", "subsection Amplitudes\n subsection a\n set Table = 0: 0, 1: 1\n set File = b.csv\n end\nend", WRONG_INPUT, ["Amplitudes/a", "not both"]),
    "an amplitude of the past": (
        "plate.prm", "subsection Amplitudes\n subsection a\n set Table = 0: 0, 1: 1, 0.5: 2\n end\nend", WRONG_INPUT, ["Amplitudes/a", "0.5 comes after 1"]),
    "an amplitude of no file": (
        "plate.prm", "subsection Amplitudes\n subsection a\n set File = no_such.csv\n end\nend", WRONG_INPUT, ["Amplitudes/a/File", "no_such.csv"]),
    "a file of text as amplitude": (
        "plate.prm", "subsection Amplitudes\n subsection a\n set File = case.prm\n end\nend", WRONG_INPUT, ["case.prm:", "numbers", "Amplitudes/a/File"]),
    "an amplitude that jumps when it is repeated": (
        "plate.prm", "subsection Amplitudes\n subsection a\n set Table = 0: 0, 1: 1\n set Repeat = true\n end\nend", WRONG_INPUT, ["Amplitudes/a/Repeat", "same"]),
    "an amplitude of a spring": (
        "plate.prm", own_condition("Body = plate", "Boundary = 3", "Type = spring", "Stiffness = 1", "Amplitude = a"), WRONG_INPUT, ["Boundary conditions/own/Amplitude", "spring"]),
    "a condition that never acts": (
        "plate.prm", own_condition("Body = plate", "Boundary = 3", "Type = pressure", "Value = 1", "Active from = 2", "Active until = 1"),
        WRONG_INPUT, ["Boundary conditions/own/Active until is 1", "never act"]),
    "a condition that acts from some day on": (
        "plate.prm", own_condition("Body = plate", "Boundary = 3", "Type = pressure", "Value = 1", "Active from = Monday"),
        WRONG_INPUT, ["Boundary conditions/own/Active from", "'Monday'"]),
    "a rigid body for a while": (
        "plate.prm", own_condition("Body = base", "Type = rigid motion", "Active until = 0.5"), WRONG_INPUT, ["Boundary conditions/own", "'base' is rigid", "Active until"]),
    "cylindrical components of a pressure": (
        "plate.prm", own_condition("Body = plate", "Boundary = 3", "Type = pressure", "Value = 1", "Components = cylindrical"), WRONG_INPUT, ["Boundary conditions/own/Components", "pressure"]),
    "a node on the axis": (
        "plate.prm", own_condition("Body = plate", "Boundary = 3", "Value = 0; free", "Components = cylindrical", "Rotation centre = 40, 40"), WRONG_INPUT, ["Boundary conditions/own", "axis"]),
    "an unknown constant": ("plate.prm", section("Constants", "width = 40") + "set Title = {widht}", WRONG_INPUT, ["'Title'", "{widht}".strip("{}"), "'width'"]),
    "half a brace": ("plate.prm", "set Title = {width", WRONG_INPUT, ["'Title'", "braces"]),
    "a constant that is no number": ("plate.prm", section("Constants", "width = wide"), WRONG_INPUT, ["Constants/width", "wide"]),
    "an infinite constant": ("plate.prm", section("Constants", "width = 1/0"), WRONG_INPUT, ["Constants/width", "finite"]),
    "a constant with a blank": ("plate.prm", section("Constants", "wide plate = 1"), WRONG_INPUT, ["Constants/wide plate", "letters"]),
    "a body force of one component": ("plate.prm", own_condition("Body = plate", "Type = body force", "Value = 1"), WRONG_INPUT, ["Boundary conditions/own/Value", "2 components"]),
    "a load on a rigid body": (
        "plate.prm", own_condition("Body = base", "Boundary = 3", "Type = pressure", "Value = 1"), WRONG_INPUT, ["Boundary conditions/own", "'base' is rigid"]),
    "an infinite load": ("plate.prm", "subsection Boundary conditions\n subsection top\n set Value = 1/0\n end\nend", WRONG_INPUT, ["A load", "not a number"]),
    "an expression without end": (
        "plate.prm", "subsection Boundary conditions\n subsection top\n set Value = sin(\n end\nend", WRONG_INPUT, ["Boundary conditions/top/Value", "sin("]),
    "half an if": (
        "plate.prm", "subsection Boundary conditions\n subsection top\n set Value = if(t<1, 50)\n end\nend", WRONG_INPUT, ["Boundary conditions/top/Value", "Too few parameters"]),
}
