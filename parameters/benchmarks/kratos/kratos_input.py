"""Writes problem P1 of the scaling benchmark as an input of Kratos Multiphysics.

    write_input(directory, upper, lower)

leaves model.mdpa, materials.json and ProjectParameters.json in the directory: the bodies
of ../scaling/p1.prm with `upper` and `lower` cells per edge, the same supports, contact
of the flat side (slave) with the curved side (master), one load step.

Contact is the mortar formulation with dual multipliers and an augmented Lagrangian; its
parameters are computed by Kratos. The multipliers have components, since only these are
condensed before the linear solver (algebraic multigrid of 3 x 3 blocks) sees the matrix.
"""
import json

LENGTH = 10.0
RADIUS = 50.0
YOUNGS_MODULUS = 1000.0
POISSONS_RATIO = 0.3
APPROACH = 0.08
TOLERANCE = 1e-6  # relative, of the residual and of the linear solver


def graded(i, n):
    """Position of grid line i of n: small cells near 0."""
    t = i / n
    return LENGTH * (0.4 * t + 0.6 * t**3)


class Block:
    """Grid of n^3 hexahedra; nodes and cells are numbered from FIRST_NODE, FIRST_CELL."""

    def __init__(self, n, point, first_node, first_cell):
        self.n, self.point = n, point
        self.first_node, self.first_cell = first_node, first_cell
        self.number_of_nodes, self.number_of_cells = (n + 1) ** 3, n**3

    def node(self, i, j, k):
        return self.first_node + i + (self.n + 1) * (j + (self.n + 1) * k)

    def nodes(self):
        """Number and coordinates, in the order of the numbers."""
        lines = range(self.n + 1)
        for k in lines:
            for j in lines:
                for i in lines:
                    yield self.node(i, j, k), self.point(i, j, k)

    def cells(self):
        """Number and the eight nodes: the lower face counterclockwise, then the upper."""
        number = self.first_cell
        for k in range(self.n):
            for j in range(self.n):
                for i in range(self.n):
                    yield number, [self.node(*corner) for level in (k, k + 1) for corner in
                                   ((i, j, level), (i + 1, j, level), (i + 1, j + 1, level), (i, j + 1, level))]
                    number += 1

    def plane(self, axis, index):
        """Nodes of a grid plane normal to an axis."""
        lines = range(self.n + 1)
        for a in lines:
            for b in lines:
                position = [a, b]
                position.insert(axis, index)
                yield self.node(*position)

    def facets(self, k, upwards):
        """Four nodes of each facet of plane k, whose normal points up or down."""
        for j in range(self.n):
            for i in range(self.n):
                corners = [self.node(i, j, k), self.node(i + 1, j, k), self.node(i + 1, j + 1, k), self.node(i, j + 1, k)]
                yield corners if upwards else corners[::-1]


def bodies(n_upper, n_lower):
    def lower_point(i, j, k):
        return graded(i, n_lower), graded(j, n_lower), -graded(n_lower - k, n_lower)

    def upper_point(i, j, k):
        x, y = graded(i, n_upper), graded(j, n_upper)
        gap = (x * x + y * y) / (2 * RADIUS)
        return x, y, gap + (LENGTH - gap) * graded(k, n_upper) / LENGTH

    lower = Block(n_lower, lower_point, 1, 1)
    upper = Block(n_upper, upper_point, 1 + lower.number_of_nodes, 1 + lower.number_of_cells)
    return lower, upper


def write_mesh(path, lower, upper):
    with open(path, "w") as file:
        conditions = 0

        def write(text):
            file.write(text + "\n")

        def block(name, rows):
            write(f"Begin {name}")
            for row in rows:
                write(" ".join(map(str, row)))
            write(f"End {name.split()[0]}")

        def part(name, nodes, elements=(), conditions=()):
            write(f"Begin SubModelPart {name}")
            block("SubModelPartNodes", ([number] for number in nodes))
            block("SubModelPartElements", ([number] for number in elements))
            block("SubModelPartConditions", ([number] for number in conditions))
            write("End SubModelPart")

        def surface(name, body, k, upwards):
            """A sub model part with the facets of a plane, as conditions."""
            nonlocal conditions
            first = conditions + 1
            facets = list(body.facets(k, upwards))
            conditions += len(facets)
            block("Conditions SurfaceCondition3D4N", ([first + i, 0, *nodes] for i, nodes in enumerate(facets)))
            return name, list(body.plane(2, k)), (), range(first, conditions + 1)

        block("Properties 0", [])
        block("Nodes", ([number, *map(repr, x)] for body in (lower, upper) for number, x in body.nodes()))
        block("Elements SmallDisplacementElement3D8N", ([number, 0, *nodes] for body in (lower, upper) for number, nodes in body.cells()))
        surfaces = [surface("flat", lower, lower.n, True), surface("curved", upper, 0, False)]
        for name, body in (("lower", lower), ("upper", upper)):
            part(name, range(body.first_node, body.first_node + body.number_of_nodes),
                 range(body.first_cell, body.first_cell + body.number_of_cells))
        for arguments in surfaces:
            part(*arguments)
        part("bottom", lower.plane(2, 0))
        part("top", upper.plane(2, upper.n))
        for axis, name in enumerate("xy"):
            part(f"symmetry_{name}", [number for body in (lower, upper) for number in body.plane(axis, 0)])


def materials():
    law = {"constitutive_law": {"name": "LinearElastic3DLaw"},
           "Variables": {"YOUNG_MODULUS": YOUNGS_MODULUS, "POISSON_RATIO": POISSONS_RATIO, "DENSITY": 1.0},
           "Tables": {}}
    return {"properties": [{"model_part_name": f"Structure.{name}", "properties_id": number, "Material": law}
                           for number, name in enumerate(("lower", "upper"), 1)]}


def support(part, constrained, value):
    return {"python_module": "assign_vector_variable_process", "kratos_module": "KratosMultiphysics",
            "Parameters": {"model_part_name": f"Structure.{part}", "variable_name": "DISPLACEMENT",
                           "constrained": constrained, "value": value, "interval": [0.0, "End"]}}


def project_parameters():
    solver = {
        "solver_type": "Static",
        "model_part_name": "Structure",
        "domain_size": 3,
        "analysis_type": "non_linear",
        "echo_level": 0,
        "model_import_settings": {"input_type": "mdpa", "input_filename": "model"},
        "material_import_settings": {"materials_filename": "materials.json"},
        "time_stepping": {"time_step": 1.0},
        "compute_reactions": True,
        "move_mesh_flag": True,
        "max_iteration": 30,
        "convergence_criterion": "contact_residual_criterion",
        "residual_relative_tolerance": TOLERANCE,
        "residual_absolute_tolerance": 1e-20,
        "contact_settings": {
            "mortar_type": "ALMContactFrictionlessComponents",
            "contact_residual_relative_tolerance": TOLERANCE,
            "contact_residual_absolute_tolerance": 1e-20,
            "fallback_if_dual_lm_not_valid": False,
            "mixed_ulm_solver_parameters": {"check_dual_lm_condensation": False},
        },
        "linear_solver_settings": {"solver_type": "KratosMultiphysics.amgcl", "krylov_type": "lgmres", "block_size": 3, "tolerance": TOLERANCE, "verbosity": 0},
    }
    contact = {
        "python_module": "alm_contact_process",
        "kratos_module": "KratosMultiphysics.ContactStructuralMechanicsApplication",
        "process_name": "ALMContactProcess",
        "Parameters": {"model_part_name": "Structure", "contact_model_part": {"0": ["flat", "curved"]},
                       "assume_master_slave": {"0": ["flat"]}, "contact_type": "FrictionlessComponents"},
    }
    output = {
        "python_module": "vtk_output_process", "kratos_module": "KratosMultiphysics",
        "Parameters": {"model_part_name": "Structure", "file_format": "binary", "output_path": "vtk",
                       "output_sub_model_parts": False, "output_control_type": "step", "output_interval": 1,
                       "nodal_solution_step_data_variables": ["DISPLACEMENT", "REACTION"],
                       "nodal_data_value_variables": ["AUGMENTED_NORMAL_CONTACT_PRESSURE"]},
    }
    free, fixed = False, True
    supports = [
        support("bottom", [fixed, fixed, fixed], [0.0, 0.0, 0.0]),
        support("top", [fixed, fixed, fixed], [0.0, 0.0, -APPROACH]),
        support("symmetry_x", [fixed, free, free], [0.0, None, None]),
        support("symmetry_y", [free, fixed, free], [None, 0.0, None]),
    ]
    return {
        "problem_data": {"problem_name": "p1", "parallel_type": "OpenMP", "echo_level": 0, "start_time": 0.0, "end_time": 0.5},
        "solver_settings": solver,
        "processes": {"constraints_process_list": supports, "contact_process_list": [contact]},
        "output_processes": {"vtk_output": [output]},
    }


def write_input(directory, upper, lower):
    directory.mkdir(parents=True, exist_ok=True)
    lower_body, upper_body = bodies(upper, lower)
    write_mesh(directory / "model.mdpa", lower_body, upper_body)
    for name, contents in (("materials.json", materials()), ("ProjectParameters.json", project_parameters())):
        (directory / name).write_text(json.dumps(contents, indent=2) + "\n")
