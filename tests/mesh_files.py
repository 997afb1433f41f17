"""Writes one small mesh in many formats: two unit squares side by side that share no node,
[0, 1] x [0, 1] ("left part", group 1) and [1, 2] x [0, 1] ("right part", group 2), with the
boundaries "foot" (y = 0 of both, group 5), "inner" and "outer" (the sides where they touch, 6 and 7)."""

import base64
import struct
import zlib

POINTS = [(0, 0), (1, 0), (1, 1), (0, 1), (1, 0), (2, 0), (2, 1), (1, 1)]
NAMES = {(2, 1): "left part", (2, 2): "right part", (1, 5): "foot", (1, 6): "inner", (1, 7): "outer"}
# dimension, group, nodes from 1
ELEMENTS = [(1, 5, (1, 2)), (1, 5, (5, 6)), (1, 6, (2, 3)), (1, 7, (5, 8)), (2, 1, (1, 2, 3, 4)), (2, 2, (5, 6, 7, 8))]
GMSH_TYPE = {1: 1, 2: 3}
VTK_TYPE = {1: 3, 2: 9}


def physical_names():
    lines = ['%d %d "%s"' % (key[0], key[1], name) for key, name in NAMES.items()]
    return "$PhysicalNames\n%d\n%s\n$EndPhysicalNames\n" % (len(lines), "\n".join(lines))


def gmsh22():
    nodes = ["%d %g %g 0" % (i + 1, x, y) for i, (x, y) in enumerate(POINTS)]
    elements = ["%d %d 2 %d %d %s" % (i + 1, GMSH_TYPE[d], g, g, " ".join(map(str, n))) for i, (d, g, n) in enumerate(ELEMENTS)]
    return ("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n" + physical_names() + "$Nodes\n%d\n%s\n$EndNodes\n" % (len(nodes), "\n".join(nodes))
            + "$Elements\n%d\n%s\n$EndElements\n" % (len(elements), "\n".join(elements))).encode()


def gmsh22_binary():
    data = b"$MeshFormat\n2.2 1 8\n" + struct.pack("<i", 1) + b"\n$EndMeshFormat\n" + physical_names().encode()
    data += b"$Nodes\n%d\n" % len(POINTS)
    for i, (x, y) in enumerate(POINTS):
        data += struct.pack("<iddd", i + 1, x, y, 0)
    data += b"\n$EndNodes\n$Elements\n%d\n" % len(ELEMENTS)
    for i, (d, g, n) in enumerate(ELEMENTS):
        data += struct.pack("<iii", GMSH_TYPE[d], 1, 2) + struct.pack("<iii", i + 1, g, g) + struct.pack("<%di" % len(n), *n)
    return data + b"\n$EndElements\n"


def gmsh41(binary=False):
    """The same numbers as text and binary: i is an int, s a size_t, d a double."""
    def put(kinds, *values):
        if binary:
            return struct.pack("<" + kinds.replace("s", "Q"), *values)
        return (" ".join("%g" % v if k == "d" else "%d" % v for k, v in zip(kinds, values)) + "\n").encode()

    groups = sorted(NAMES)
    curves, surfaces = [g for d, g in groups if d == 1], [g for d, g in groups if d == 2]
    data = b"$MeshFormat\n4.1 %d 8\n" % binary + (struct.pack("<i", 1) + b"\n" if binary else b"") + b"$EndMeshFormat\n"
    data += physical_names().encode() + b"$Entities\n" + put("ssss", 0, len(curves), len(surfaces), 0)
    for g in curves + surfaces:
        data += put("iddddddsis", g, 0, 0, 0, 2, 1, 0, 1, g, 0)
    data += (b"\n" if binary else b"") + b"$EndEntities\n$Nodes\n" + put("ssss", 1, len(POINTS), 1, len(POINTS))
    data += put("iiis", 2, 1, 0, len(POINTS))
    data += b"".join(put("s", i + 1) for i in range(len(POINTS))) + b"".join(put("ddd", x, y, 0) for x, y in POINTS)
    data += (b"\n" if binary else b"") + b"$EndNodes\n$Elements\n" + put("ssss", len(ELEMENTS), len(ELEMENTS), 1, len(ELEMENTS))
    for i, (d, g, n) in enumerate(ELEMENTS):
        data += put("iiis", d, g, GMSH_TYPE[d], 1) + put("s" * (1 + len(n)), i + 1, *n)
    return data + (b"\n" if binary else b"") + b"$EndElements\n"


def abaqus():
    """Flat, no keyword after the last line; a surface, a set of 2-node elements and a node set."""
    nodes = "\n".join("%d, %g, %g" % (i + 1, x, y) for i, (x, y) in enumerate(POINTS))
    return ("*Heading\n two squares\n** a comment\n*NODE\n%s\n*Element, type=CPS4, elset=\"left part\"\n1, 1,2,3,4\n"
            "*ELEMENT, TYPE=CPS4R,\n ELSET=right part\n2, 5, 6,\n 7, 8\n*ELEMENT, TYPE=T2D2, ELSET=outer\n3, 5, 8\n"
            "*SURFACE, NAME=inner\n1, S2\n*NSET, NSET=foot\n1, 2, 5, 6" % nodes).encode()


def abaqus_cae():
    """As CAE writes it: one part, two instances, sets and surfaces of the assembly."""
    return b"""*Heading
*Part, name=square
*Node
      1,           0.,           0.
      2,           1.,           0.
      3,           1.,           1.
      4,           0.,           1.
*Element, type=CPE4
1, 1, 2, 3, 4
*End Part
*Assembly, name=Assembly
*Instance, name="left part", part=square
*End Instance
*Instance, name="right part", part=square
1., 0., 0.
*End Instance
*Node
      1, 5., 5., 0.
*Nset, nset=point, internal
1,
*Elset, elset=_inner_S2, internal, instance="left part"
 1,
*Surface, type=ELEMENT, name=inner
_inner_S2, S2
*Elset, elset=_outer_S4, internal, instance="right part", generate
 1, 1, 1
*Surface, type=ELEMENT, name=outer
_outer_S4, S4
*Nset, nset=foot, instance="left part"
 1, 2
*Nset, nset=foot, instance="right part", generate
 1, 2, 1
*End Assembly
*Material, name=steel
*Elastic
210000., 0.3
*Step, name=one
*Static
0.1, 1.
*End Step
"""


def vtk(binary=False):
    def put(kind, values):
        if binary:
            return struct.pack(">%d%s" % (len(values), kind), *values) + b"\n"
        return (" ".join("%g" % v for v in values) + "\n").encode()

    cells = [v for _, _, n in ELEMENTS for v in (len(n), *(i - 1 for i in n))]
    return (b"# vtk DataFile Version 3.0\ntwo squares\n" + (b"BINARY" if binary else b"ASCII") + b"\nDATASET UNSTRUCTURED_GRID\n"
            + b"POINTS %d double\n" % len(POINTS) + put("d", [c for x, y in POINTS for c in (x, y, 0)])
            + b"CELLS %d %d\n" % (len(ELEMENTS), len(cells)) + put("i", cells)
            + b"CELL_TYPES %d\n" % len(ELEMENTS) + put("i", [VTK_TYPE[d] for d, _, _ in ELEMENTS])
            + b"CELL_DATA %d\nSCALARS MaterialID int 1\nLOOKUP_TABLE default\n" % len(ELEMENTS)
            + put("i", [g for _, g, _ in ELEMENTS]))


def vtu(form="ascii", compressed=False):
    appended = [b""]

    def array(name, kind, values, components=1):
        code = {"Float64": "d", "Int64": "q", "UInt8": "B", "Int32": "i"}[kind]
        tag = '<DataArray type="%s" Name="%s" NumberOfComponents="%d" format="%s"' % (kind, name, components, form)
        if form == "ascii":
            return tag + ">" + " ".join("%g" % v for v in values) + "</DataArray>\n"
        raw = struct.pack("<%d%s" % (len(values), code), *values)
        if compressed:
            packed = zlib.compress(raw)
            head = struct.pack("<4I", 1, len(raw), 0, len(packed))
            text = base64.b64encode(head) + base64.b64encode(packed)
        else:
            text = base64.b64encode(struct.pack("<I", len(raw)) + raw)
        if form == "appended":
            text = struct.pack("<I", len(raw)) + raw
            offset, appended[0] = len(appended[0]), appended[0] + text
            return tag + ' offset="%d"/>\n' % offset
        return tag + ">" + text.decode() + "</DataArray>\n"

    nodes = [i - 1 for _, _, n in ELEMENTS for i in n]
    ends = [sum(len(e[2]) for e in ELEMENTS[:i + 1]) for i in range(len(ELEMENTS))]
    body = ('<?xml version="1.0"?>\n<VTKFile type="UnstructuredGrid" version="0.1" byte_order="LittleEndian"%s>\n<UnstructuredGrid>\n'
            % (' compressor="vtkZLibDataCompressor"' if compressed else "")
            + '<Piece NumberOfPoints="%d" NumberOfCells="%d">\n<CellData>\n' % (len(POINTS), len(ELEMENTS))
            + array("gmsh:physical", "Int32", [g for _, g, _ in ELEMENTS]) + "</CellData>\n<Points>\n"
            + array("Points", "Float64", [c for x, y in POINTS for c in (x, y, 0)], 3) + "</Points>\n<Cells>\n"
            + array("connectivity", "Int64", nodes) + array("offsets", "Int64", ends)
            + array("types", "UInt8", [VTK_TYPE[d] for d, _, _ in ELEMENTS])
            + "</Cells>\n</Piece>\n</UnstructuredGrid>\n").encode()
    if form == "appended":
        body += b'<AppendedData encoding="raw">\n_' + appended[0] + b"\n</AppendedData>\n"
    return body + b"</VTKFile>\n"


def ucd():
    kinds = {1: "line", 2: "quad"}
    return ("# two squares\n%d %d 0 0 0\n" % (len(POINTS), len(ELEMENTS))
            + "".join("%d %g %g 0\n" % (i + 1, x, y) for i, (x, y) in enumerate(POINTS))
            + "".join("%d %d %s %s\n" % (i + 1, g, kinds[d], " ".join(map(str, n))) for i, (d, g, n) in enumerate(ELEMENTS))).encode()


# file name: (contents, are there names)
ALL = {
    "v22.msh": (gmsh22(), True),
    "v22_binary.msh": (gmsh22_binary(), True),
    "v41.msh": (gmsh41(), True),
    "v41_binary.msh": (gmsh41(True), True),
    "crlf.msh": (gmsh22().replace(b"\n", b"\r\n"), True),
    "mark.msh": (b"\xef\xbb\xbf" + gmsh41(), True),
    "flat.inp": (abaqus(), True),
    "crlf.inp": (abaqus().replace(b"\n", b"\r\n"), True),
    "latin1.inp": (b"*HEADING\n gepr\xfcft\n" + abaqus(), True),
    "cae.inp": (abaqus_cae(), True),
    "text.vtk": (vtk(), False),
    "binary.vtk": (vtk(True), False),
    "text.vtu": (vtu(), False),
    "base64.vtu": (vtu("binary"), False),
    "compressed.vtu": (vtu("binary", True), False),
    "appended.vtu": (vtu("appended"), False),
    "text.ucd": (ucd(), False),
}
