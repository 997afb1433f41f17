"""Writes the press fit as an input of CalculiX, runs it and reads what it gives.

    write_input(mesh, directory / "press_fit.inp", TYPE)       # from the file that Gmsh has made (version 2.2)
    answer = read_answer(directory / "press_fit.dat")          # None if there is none

The 10-node tetrahedra, the materials, the supports and the overlap are those of
press_fit.prm until t = 1, without friction; TYPE is that of *CONTACT PAIR.
"""
import pathlib

# Gmsh has the nodes on the edges 3-4 and 2-4 the other way round.
TETRAHEDRON = (0, 1, 2, 3, 4, 5, 6, 7, 9, 8)
# The faces S1 to S4 by their vertices.
FACES = ((0, 1, 2), (0, 3, 1), (1, 3, 2), (2, 3, 0))
SUPPORTS = (("symmetry x", None, 1), ("symmetry y", None, 2), ("seat", "hub", 3), ("pushed", "shaft", 3))


class Mesh:
    """Nodes {number: coordinates}, cells {group: {number: nodes}}, facets {group: lists of nodes}."""

    def __init__(self, path):
        lines = iter(pathlib.Path(path).read_text().split("\n"))
        self.nodes, self.cells, self.facets, names = {}, {}, {}, {}
        for line in lines:
            if line == "$PhysicalNames":
                for _ in range(int(next(lines))):
                    dimension, number, name = next(lines).split(maxsplit=2)
                    names[int(dimension), int(number)] = name.strip('"')
            elif line == "$Nodes":
                for _ in range(int(next(lines))):
                    number, *x = next(lines).split()
                    self.nodes[int(number)] = x
            elif line == "$Elements":
                for _ in range(int(next(lines))):
                    number, kind, n_tags, *rest = map(int, next(lines).split())
                    self._add(number, kind, rest[0], rest[n_tags:], names)

    def _add(self, number, kind, group, nodes, names):
        if kind == 11:
            self.cells.setdefault(names[3, group], {})[number] = nodes
        elif kind == 9:
            self.facets.setdefault(names[2, group], []).append(nodes)

    def nodes_of(self, boundary, body=None):
        nodes = {node for facet in self.facets[boundary] for node in facet}
        return sorted(nodes & {node for cell in self.cells[body].values() for node in cell} if body else nodes)

    def faces_of(self, boundary, body):
        """Number of the cell and of its face for each facet."""
        facets = {frozenset(facet[:3]) for facet in self.facets[boundary]}
        return [(number, i + 1) for number, nodes in self.cells[body].items()
                for i, face in enumerate(FACES) if frozenset(nodes[j] for j in face) in facets]


def in_lines(numbers, per_line=12):
    return [", ".join(map(str, numbers[i:i + per_line])) for i in range(0, len(numbers), per_line)]


def write_input(mesh_file, path, kind):
    mesh = Mesh(mesh_file)
    lines = ["*NODE, NSET=all", *(f"{number}, {', '.join(x)}" for number, x in mesh.nodes.items())]
    for body, cells in mesh.cells.items():
        lines.append(f"*ELEMENT, TYPE=C3D10, ELSET={body}")
        lines += [f"{number}, {', '.join(str(nodes[i]) for i in TETRAHEDRON)}" for number, nodes in cells.items()]
    for boundary, body in (("hole", "hub"), ("fit", "shaft")):
        lines += [f"*SURFACE, NAME={boundary}", *(f"{cell}, S{face}" for cell, face in mesh.faces_of(boundary, body))]
    for name, numbers in (("hub_x", mesh.nodes_of("symmetry x", "hub")), ("rim", [rim_node(mesh)])):
        lines += [f"*NSET, NSET={name}", *in_lines(numbers)]
    lines += ["*MATERIAL, NAME=steel", "*ELASTIC", "210000, 0.3",
              *(f"*SOLID SECTION, ELSET={body}, MATERIAL=steel" for body in mesh.cells),
              "*SURFACE INTERACTION, NAME=fit", "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=HARD",
              f"*CONTACT PAIR, INTERACTION=fit, TYPE={kind}", "hole, fit", "*BOUNDARY"]
    for boundary, body, component in SUPPORTS:
        lines += [f"{node}, {component}, {component}" for node in mesh.nodes_of(boundary, body)]
    lines += ["*STEP", "*STATIC", "1., 1.", "*NODE PRINT, NSET=hub_x, TOTALS=ONLY", "RF", "*NODE PRINT, NSET=rim", "U",
              "*NODE FILE", "U", "*EL FILE", "S", "*CONTACT FILE", "CDIS, CSTR", "*END STEP"]
    path.write_text("\n".join(lines) + "\n")
    return 3 * len(mesh.nodes)


def rim_node(mesh):
    return next(number for number, x in mesh.nodes.items() if max(abs(float(a) - b) for a, b in zip(x, (35, 0, 20))) < 1e-6)


def read_answer(path):
    """Force across the fit (reaction of the hub at x = 0) and radial displacement of the rim, of the last increment."""
    force = displacement = None
    if not path.exists():
        return None
    lines = [line for line in path.read_text().split("\n") if line.strip()]
    for title, values in zip(lines, lines[1:]):
        if title.lstrip().startswith("total force"):
            force = abs(float(values.split()[0]))
        elif title.lstrip().startswith("displacements"):
            displacement = float(values.split()[1])
    return None if None in (force, displacement) else (force, displacement)
