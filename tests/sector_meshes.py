"""Writes meshes of the second order of quarter rings: in 2D, and extruded along z in 3D.

A mesh is (points, cells, faces): nodes lie on a lattice of radii, angles (and heights) with two steps per cell; a cell
is a list of nodes (from 1) in VTK's order, faces are (number of the boundary, nodes) with 1 inner, 2 outer, 3 y = 0,
4 x = 0, 5 bottom, 6 top. All nodes lie on the circles, or, in straight meshes, in the middle of their vertices.
"""

import itertools
import math

# Corners of a unit cell in VTK's order, then pairs and groups of corners whose middle the other nodes are.
QUADRILATERAL = [(0, 0), (1, 0), (1, 1), (0, 1)]
HEXAHEDRON = [(x, y, z) for z in (0, 1) for x, y in QUADRILATERAL]
MIDDLES = {
    "QUAD": [(0, 1), (1, 2), (2, 3), (3, 0), (0, 1, 2, 3)],
    "TRI": [(0, 1), (1, 2), (2, 0)],
    "TET": [(0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3)],
    "HEX": [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7),
            (0, 4, 7, 3), (1, 2, 6, 5), (0, 1, 5, 4), (3, 7, 6, 2), (0, 3, 2, 1), (4, 5, 6, 7), tuple(range(8))],
    "LINE": [(0, 1)],
}
# kind: cells, number of nodes, faces, number of their nodes
KINDS = {"QUAD8": ("QUAD", 8, "LINE", 3), "QUAD9": ("QUAD", 9, "LINE", 3), "TRI6": ("TRI", 6, "LINE", 3),
         "HEX20": ("HEX", 20, "QUAD", 8), "HEX27": ("HEX", 27, "QUAD", 9), "TET10": ("TET", 10, "TRI", 6)}
GMSH_TYPES = {("LINE", 3): 8, ("TRI", 6): 9, ("QUAD", 9): 10, ("QUAD", 8): 16, ("TET", 10): 11, ("HEX", 20): 17, ("HEX", 27): 12}
VTK_TYPES = {("LINE", 3): 21, ("TRI", 6): 22, ("QUAD", 9): 28, ("QUAD", 8): 23, ("TET", 10): 24, ("HEX", 20): 25, ("HEX", 27): 29}
# The place in VTK's list of each node of Gmsh's; of others both are the same.
GMSH_ORDERS = {
    ("TET", 10): [0, 1, 2, 3, 4, 5, 6, 7, 9, 8],
    ("HEX", 20): [0, 1, 2, 3, 4, 5, 6, 7, 8, 11, 16, 9, 17, 10, 18, 19, 12, 15, 13, 14],
    ("HEX", 27): [0, 1, 2, 3, 4, 5, 6, 7, 8, 11, 16, 9, 17, 10, 18, 19, 12, 15, 13, 14, 24, 22, 20, 21, 23, 25, 26],
}
ABAQUS_ORDERS = {("HEX", 27): list(range(20)) + [26, 24, 25, 22, 21, 23, 20]}
BOUNDARIES = {1: "inner", 2: "outer", 3: "x axis", 4: "y axis", 5: "bottom", 6: "top"}


def middle(corners):
    return tuple(sum(c[d] for c in corners) // len(corners) for d in range(len(corners[0])))


def nodes_of(shape, corners, n_nodes):
    """Lattice points of an element with these corners (lattice points, two steps apart)."""
    return (list(corners) + [middle([corners[v] for v in group]) for group in MIDDLES[shape]])[:n_nodes]


def parts_of(shape, corners):
    """What a lattice cell is cut into."""
    if shape in ("QUAD", "HEX"):
        return [corners]
    by_place = dict(zip(QUADRILATERAL if len(corners) == 4 else HEXAHEDRON, corners))
    dim = len(corners[0])
    parts = []
    for order in itertools.permutations(range(dim)):
        place, path = [0] * dim, [by_place[(0,) * dim]]
        for d in order:
            place[d] = 1
            path.append(by_place[tuple(place)])
        parts.append(path)
    return parts


def sides_of(shape, cell):
    groups = {"TRI": MIDDLES["TRI"], "QUAD": MIDDLES["QUAD"][:4], "TET": list(itertools.combinations(range(4), 3)), "HEX": MIDDLES["HEX"][12:18]}
    return [[cell[v] for v in group] for group in groups[shape]]


def sector(kind, radii, n_radial, n_angular, height=None, n_axial=1, straight=False):
    """RADII (inner, outer); 3D with a HEIGHT."""
    shape, n_nodes, face_shape, n_face_nodes = KINDS[kind]
    n = [n_radial, n_angular] + ([n_axial] if height else [])

    def place(p):
        r = radii[0] + (radii[1] - radii[0]) * p[0] / (2 * n_radial)
        angle = math.pi / 2 * p[1] / (2 * n_angular)
        x = (r * math.cos(angle), r * math.sin(angle)) if 0 < p[1] < 2 * n_angular else (r, 0.) if p[1] == 0 else (0., r)
        return (*x, height * p[2] / (2 * n_axial) if height else 0.)

    points, numbers, cells, faces = [], {}, [], []

    def number(p, corners):
        if p not in numbers:
            places = [place(q) for q in (corners if straight else [p])]
            points.append(tuple(sum(x) / len(places) for x in zip(*places)))
            numbers[p] = len(points)
        return numbers[p]

    def element(shape, corners, n_nodes):
        groups = [(v,) for v in range(len(corners))] + MIDDLES[shape]
        return [number(p, [corners[v] for v in group]) for p, group in zip(nodes_of(shape, corners, n_nodes), groups)]

    for base in itertools.product(*(range(k) for k in reversed(n))):
        low = tuple(reversed(base))
        corners = [tuple(2 * (a + b) for a, b in zip(low, c)) for c in (HEXAHEDRON if height else QUADRILATERAL)]
        for part in parts_of(shape, corners):
            cells.append(element(shape, part, n_nodes))
            for side in sides_of(shape, part):
                for d, k in enumerate(n):
                    for end, value in ((0, 0), (1, 2 * k)):
                        if all(p[d] == value for p in side):
                            faces.append((1 + 2 * d + end, element(face_shape, side, n_face_nodes)))
    return points, cells, faces


def ordered(nodes, order):
    return [nodes[i] for i in order] if order else nodes


def gmsh(kind, *parts):
    """PARTS are (name of the body, mesh); boundaries are called "NAME inner" and so on."""
    shape, n_nodes, face_shape, n_face_nodes = KINDS[kind]
    dim = 3 if shape in ("TET", "HEX") else 2
    names, nodes, elements, n_points = [], [], [], 0
    for part, (name, (points, cells, faces)) in enumerate(parts):
        names.append('%d %d "%s"' % (dim, part + 1, name))
        used = sorted({boundary for boundary, _ in faces})
        names += ['%d %d "%s %s"' % (dim - 1, 10 * (part + 1) + b, name, BOUNDARIES[b]) for b in used]
        nodes += ["%d %.16g %.16g %.16g" % (n_points + i + 1, *p) for i, p in enumerate(points)]
        for boundary, face in faces:
            elements.append((GMSH_TYPES[face_shape, n_face_nodes], 10 * (part + 1) + boundary, face, n_points))
        for cell in cells:
            elements.append((GMSH_TYPES[shape, n_nodes], part + 1, ordered(cell, GMSH_ORDERS.get((shape, n_nodes))), n_points))
        n_points += len(points)
    lines = ["%d %d 2 %d %d %s" % (i + 1, code, group, group, " ".join(str(n + first) for n in ns))
             for i, (code, group, ns, first) in enumerate(elements)]
    return "\n".join(["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames", str(len(names)), *names, "$EndPhysicalNames",
                      "$Nodes", str(len(nodes)), *nodes, "$EndNodes", "$Elements", str(len(lines)), *lines, "$EndElements", ""])


def abaqus(kind, mesh):
    """Boundaries are node sets."""
    types = {"QUAD8": "CPE8", "QUAD9": "CPE9", "TRI6": "CPE6", "HEX20": "C3D20", "HEX27": "C3D27", "TET10": "C3D10"}
    shape, n_nodes = KINDS[kind][:2]
    points, cells, faces = mesh
    text = "*NODE\n" + "".join("%d, %.16g, %.16g, %.16g\n" % (i + 1, *p) for i, p in enumerate(points)) + "*ELEMENT, TYPE=%s\n" % types[kind]
    for i, cell in enumerate(cells):
        entries = [str(n) for n in [i + 1] + ordered(cell, ABAQUS_ORDERS.get((shape, n_nodes)))]
        rows = [entries[k:k + 16] for k in range(0, len(entries), 16)]
        text += ",\n".join(", ".join(row) for row in rows) + "\n"
    for boundary in sorted({b for b, _ in faces}):
        members = sorted({n for b, face in faces if b == boundary for n in face})
        text += "*NSET, NSET=%s\n" % BOUNDARIES[boundary] + "".join("%d\n" % n for n in members)
    return text


def vtk(kind, mesh):
    """Boundaries are cells with the boundary's number as material."""
    shape, n_nodes, face_shape, n_face_nodes = KINDS[kind]
    points, cells, faces = mesh
    elements = [(VTK_TYPES[face_shape, n_face_nodes], b, face) for b, face in faces] + [(VTK_TYPES[shape, n_nodes], 0, c) for c in cells]
    return ("# vtk DataFile Version 3.0\nsector\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS %d double\n" % len(points)
            + "".join("%.16g %.16g %.16g\n" % p for p in points)
            + "CELLS %d %d\n" % (len(elements), sum(len(ns) + 1 for _, _, ns in elements))
            + "".join("%d %s\n" % (len(ns), " ".join(str(n - 1) for n in ns)) for _, _, ns in elements)
            + "CELL_TYPES %d\n" % len(elements) + "".join("%d\n" % code for code, _, _ in elements)
            + "CELL_DATA %d\nSCALARS MaterialID int 1\nLOOKUP_TABLE default\n" % len(elements)
            + "".join("%d\n" % b for _, b, _ in elements))
