#!/usr/bin/env python3
"""Broken meshes and parameter files have to end in one clear message, on any number of ranks:
exit code 1, the expected words, no stack trace and no text of a library. On several ranks
every fourth is tried.

usage: bad_meshes.py PROGRAM MPIEXEC N_RANKS [--all] [--verbose]
       --all: every input on several ranks, too
"""

import concurrent.futures
import os
import re
import subprocess
import sys
import tempfile

import mesh_files as good

CRASH = ["backtrace", "segmentation", "signal", "aborted", "internal error", "terminate called", "an error occurred in line", "stacktrace",
         "deal.ii", "dealii", "bad_alloc", "exception", "exc"]
CASE = """set Dimension = 2
subsection Bodies
  subsection block
    set Mesh file = %s
    set Material = steel
  end
end
subsection Materials
  subsection steel
    set Young's modulus = 100
    set Poisson's ratio = 0.3
  end
end
subsection Boundary conditions
  subsection base
    set Body = block
    set Boundary = foot
    set Value = 0; 0
  end
end
"""
GENERATED = CASE.replace("set Mesh file = %s", "set Generator = subdivided_hyper_rectangle\nset Arguments = 2, 2 : 0, 0 : 1, 1 : true").replace("foot", "2")
MSH, MSH41, INP, VTK, UCD = (t.decode() for t in (good.gmsh22(), good.gmsh41(), good.abaqus(), good.vtk(), good.ucd()))
BINARY, VTU = good.gmsh41(True), good.vtu().decode()
TRIANGLES = MSH.replace("5 3 2 1 1 1 2 3 4", "5 2 2 1 1 1 2 3")


def changed(text, old, new):
    """OLD must be there, or the case tests nothing."""
    assert old in text, old
    return text.replace(old, new, 1)



def curved(left):
    """A unit square of 8 nodes, that of its left side at LEFT."""
    nodes = ["0 0", "1 0", "1 1", "0 1", "0.5 0", "1 0.5", "0.5 1", left]
    return ("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n1 5 \"foot\"\n$EndPhysicalNames\n$Nodes\n8\n"
            + "".join("%d %s 0\n" % (i + 1, x) for i, x in enumerate(nodes))
            + "$EndNodes\n$Elements\n2\n1 8 2 5 5 1 2 5\n2 16 2 1 1 1 2 3 4 5 6 7 8\n$EndElements\n")


# A second square beside it has the vertices 2 and 3, but a node of its own between them.
TWO_CURVED = changed(curved("0.1 0.5"), "$Nodes\n8\n", "$Nodes\n9\n9 2 0 0\n10 2 1 0\n11 1.5 0 0\n12 2 0.5 0\n13 1.5 1 0\n14 1.1 0.5 0\n")
TWO_CURVED = changed(TWO_CURVED, "$Nodes\n9\n", "$Nodes\n14\n")
TWO_CURVED = changed(changed(TWO_CURVED, "$Elements\n2\n", "$Elements\n3\n"), "$EndElements", "3 16 2 1 1 2 9 10 3 11 12 13 14\n$EndElements")

# what is wrong: (file name, contents, words of the message)
MESHES = {
    "empty": ("a.msh", "", ["a.msh", "is empty"]),
    "blank": ("a.msh", " \n\n\t", ["is empty"]),
    "unknown extension": ("a.stl", "solid", ["Mesh format", "a.stl", "known: msh, inp", "meshio convert"]),
    "no Gmsh file": ("a.msh", "hello world\n", ["line 1", "'hello'", "$MeshFormat"]),
    "unknown version": ("a.msh", changed(MSH, "2.2 0 8", "3.0 0 8"), ["line 2", "version 3.0", "2.0 to 2.2, 4.0 and 4.1"]),
    "no number of nodes": ("a.msh", changed(MSH, "$Nodes\n8", "$Nodes\nx"), ["line 13", "'x'", "number of nodes"]),
    "more nodes than there are": ("a.msh", changed(MSH, "$Nodes\n8", "$Nodes\n9"), ["line 22", "'$EndNodes'", "number of a node"]),
    "millions of nodes": ("a.msh", changed(MSH, "$Nodes\n8", "$Nodes\n999999999"), ["999999999", "more than the rest of the file can hold"]),
    "a negative number": ("a.msh", changed(MSH, "$Nodes\n8", "$Nodes\n-8"), ["line 13", "-8", "negative"]),
    "a coordinate is no number": ("a.msh", changed(MSH, "2 1 0 0", "2 1,5 0 0"), ["line 15", "'1,5'", "coordinate"]),
    "a coordinate is nan": ("a.msh", changed(MSH, "2 1 0 0", "2 nan 0 0"), ["line 15", "'nan'", "finite number"]),
    "a coordinate is huge": ("a.msh", changed(MSH, "2 1 0 0", "2 1e999 0 0"), ["line 15", "1e999", "finite number"]),
    "a node twice": ("a.msh", changed(MSH, "\n2 1 0 0", "\n1 1 0 0"), ["line 15", "two nodes 1"]),
    "a node is missing": ("a.msh", changed(MSH, "5 3 2 1 1 1 2 3 4", "5 3 2 1 1 1 2 3 44"), ["line 29", "element 5", "node 44", "not there"]),
    "a collapsed cell": ("a.msh", changed(MSH, "5 3 2 1 1 1 2 3 4", "5 3 2 1 1 1 2 3 3"), ["line 29", "element 5", "twice"]),
    "an unknown type of element": ("a.msh", changed(TRIANGLES, "5 2 2 1 1", "5 26 2 1 1").replace("6 3 2", "6 26 2"), ["no mesh for a 2D case", "Gmsh's type 26"]),
    "cut within the nodes": ("a.msh", MSH[:285], ["the file ends", "is expected"]),
    "cut before the elements": ("a.msh", MSH[:MSH.index("$Elements")], ["no section $Elements", "incomplete"]),
    "no name in quotation marks": ("a.msh", changed(MSH, '"foot"', "foot"), ["quotation marks", "line 8"]),
    "triangles": ("a.msh", TRIANGLES, ["1 3-node triangles, 1 4-node quadrilaterals among 2 cells", "of one kind", "RecombineAll"]),
    "a cell inside out": ("a.msh", curved("1.6 0.5"), ["Bodies/block", "inside out at", "Jacobian determinant", "vertices (0, 0)", "1 of 1 cells"]),
    "a missing node": ("a.msh", changed(curved("0.6 0.5"), " 5 6 7 8\n", " 5 6 7\n"), ["line 22", "element 2 has 7 nodes; 8-node quadrilaterals have 8"]),
    "a node that is not there": ("a.msh", changed(curved("0.6 0.5"), " 5 6 7 8\n", " 5 6 7 0\n"), ["line 22", "element 2", "node 0", "not there"]),
    "different nodes of one edge": ("a.msh", TWO_CURVED, ["fit together", "the same vertices of a side", "(1.1, 0.5)", "(1, 0.5)"]),
    "Abaqus with a missing node of the second order": ("a.inp", "*NODE\n1, 0, 0\n2, 1, 0\n3, 0, 1\n4, 0.5, 0\n5, 0.5, 0.5\n*ELEMENT, TYPE=CPE6\n1, 1, 2, 3, 4, 5\n",
                                                       ["line 8", "element 1 of the type CPE6 has 5 nodes; 6 are expected"]),
    "tetrahedra": ("a.msh", changed(MSH, "5 3 2 1 1 1 2 3 4", "5 4 2 1 1 1 2 3 4"), ["2D case", "1 4-node tetrahedra", "Dimension = 3"]),
    "only lines": ("a.msh", changed(MSH, "5 3 2 1 1 1 2 3 4", "5 1 2 1 1 1 2").replace("6 3 2 2 2 5 6 7 8", "6 1 2 2 2 5 6"), ["is made of", "2-node lines"]),
    "not plane": ("a.msh", changed(MSH, "3 1 1 0", "3 1 1 0.5"), ["z from 0", "0.5", "plane"]),
    "an inverted cell": ("a.msh", changed(MSH, "3 1 1 0", "3 0.1 0.1 0"), ["inverted cell"]),
    "three cells at one edge": ("a.msh", changed(MSH, "6 3 2 2 2 5 6 7 8", "6 3 2 2 2 2 6 7 3").replace("$Elements\n6", "$Elements\n7").replace(
        "$EndElements", "7 3 2 2 2 2 5 8 3\n$EndElements"), ["3 cells with a common face", "(1 0 0)"]),
    "binary 4.0": ("a.msh", b"$MeshFormat\n4 1 8\n\1\0\0\0\n", ["version 4.0", "Save it as version 4.1"]),
    "binary, cut": ("a.msh", BINARY[:-60], ["the file ends", "is expected"]),
    "binary, other byte order": ("a.msh", BINARY.replace(b"\1\0\0\0", b"\0\0\0\1", 1), ["byte order"]),
    "binary, nonsense": ("a.msh", BINARY[:450] + b"\xff" * 200, ["a.msh"]),
    "partitioned": ("a.msh", changed(MSH41, "$Entities", "$PartitionedEntities\n"), ["partitioned"]),
    "no end of a section": ("a.msh", MSH41 + "$Periodic\n1\n", ["$Periodic", "$EndPeriodic"]),
    "UTF-16": ("a.msh", MSH.encode("utf-16"), ["UTF-16", "iconv"]),
    "zero bytes": ("a.inp", b"*NODE\n1, 0\0, 0\n", ["line 2", "zero byte"]),
    "wrong name of a boundary": ("a.msh", changed(MSH, '"foot"', '"feet"'), ["Boundary conditions/base/Boundary", "'foot'", "'feet'"]),
    "Abaqus without nodes": ("a.inp", "*HEADING\n*ELEMENT, TYPE=CPS4\n", ["no *NODE"]),
    "Abaqus without a type": ("a.inp", changed(INP, "*Element, type=CPS4", "*Element"), ["*ELEMENT needs TYPE=..."]),
    "Abaqus with a missing node": ("a.inp", changed(INP, "1, 1,2,3,4", "1, 1,2,3,44"), ["line 14", "element 1", "node 44"]),
    "Abaqus with a short element": ("a.inp", changed(INP, "1, 1,2,3,4", "1, 1,2,3"), ["line 14", "has 3 nodes; 4 are expected"]),
    "Abaqus with a word": ("a.inp", changed(INP, "2, 1, 0", "2, one, 0"), ["line 6", "'one'", "coordinate"]),
    "Abaqus with an unknown set": ("a.inp", changed(INP, "\n1, S2", "\nnowhere, S2"), ["'inner'", "'nowhere'", "not there"]),
    "Abaqus with an unknown side": ("a.inp", changed(INP, "\n1, S2", "\n1, S9"), ["'S9'", "S1 to S4"]),
    "Abaqus with *NGEN": ("a.inp", changed(INP, "*Element", "*NGEN\n1, 2\n*Element"), ["*NGEN is not supported", "line 13"]),
    "Abaqus with *INCLUDE": ("a.inp", "*INCLUDE, INPUT=other.inp\n", ["*INCLUDE is not supported", "line 1"]),
    "Abaqus with an unknown part": ("a.inp", changed(good.abaqus_cae().decode(), "part=square", "part=sqare"), ["'sqare'", "not there"]),
    "Abaqus with tetrahedra": ("a.inp", changed(INP, "type=CPS4", "type=C3D4"), ["1 4-node tetrahedra", "Dimension = 3"]),
    "VTK of another kind": ("a.vtk", changed(VTK, "UNSTRUCTURED_GRID", "POLYDATA"), ["line 4", "'POLYDATA'", "UNSTRUCTURED_GRID"]),
    "VTK with a missing point": ("a.vtk", changed(VTK, "4 0 1 2 3", "4 0 1 2 33"), ["cell 4", "not there"]),
    "VTK without types": ("a.vtk", VTK[:VTK.index("CELL_TYPES")], ["no cells"]),
    "VTU that is cut": ("a.vtu", VTU[:VTU.index("types") - 20], ["a.vtu"]),
    "VTU with another compressor": ("a.vtu", changed(VTU, '0.1"', '0.1" compressor="vtkLZ4DataCompressor"'), ["vtkLZ4DataCompressor", "vtkZLibDataCompressor"]),
    "VTU with broken data": ("a.vtu", good.vtu("binary", True).replace(b"eJx", b"eJy"), ["a.vtu", "compressed data"]),
    "UCD with an unknown type": ("a.ucd", changed(UCD, "quad", "quod"), ["'quod'", "quad"]),
    "UCD that is cut": ("a.ucd", UCD[:60], ["the file ends", "coordinate of a vertex"]),
    "a directory": ("folder/", "", ["cannot be read"]),
}


def in_case(old, new):
    return changed(CASE % "good.msh", old, new)


PARAMETERS = {
    "unknown group": (in_case("good.msh", "good.msh\nset Mesh group = left pat"), ["Mesh group", "'left pat'", "Did you mean 'left part'"]),
    "group without a file": (changed(GENERATED, "set Material", "set Mesh group = a\nset Material"), ["Mesh group", "without a 'Mesh file'"]),
    "group of faces": (in_case("good.msh", "good.msh\nset Mesh group = foot"), ["Mesh group", "'foot'", "'left part' (1)"]),
    "condition with an unknown group": (in_case("good.msh", "good.msh\nset Boundary ids = top: in fot"), ["Boundary ids", "Did you mean 'foot'"]),
    "a label that is none": (in_case("good.msh", "good.msh\nset Boundary ids = -1: y > 0"), ["Boundary ids", "'-1'"]),
    "3D": (in_case("Dimension = 2", "Dimension = 3"), ["no mesh for a 3D case", "4-node quadrilaterals", "Dimension = 2"]),
    "12 refinements of a body": (changed(GENERATED, "set Material", "set Refinements = 12\nset Material").replace("2, 2 :", "64, 64 :"), [
        "Bodies/block/Refinements", "68719476736 cells", "free there", "What fits at most"]),
    "12 global refinements": (GENERATED.replace("2, 2 :", "64, 64 :") + "subsection Mesh\nset Global refinements = 12\nend\n", [
        "Mesh/Global refinements", "68719476736 cells", "TB", "free there"]),
    "12 global refinements, METIS": (GENERATED.replace("2, 2 :", "64, 64 :") + "subsection Mesh\nset Partitioner = METIS\nset Global refinements = 12\nend\n", [
        "Mesh/Global refinements", "68719476736 cells"]),
    "a generator with too many cells": (changed(GENERATED, "2, 2 :", "1000000, 1000000 :"), ["Bodies/block/Arguments", "1000000000000 cells", "free there"]),
    "a graded line with too many cells": (changed(GENERATED, "subdivided_hyper_rectangle\nset Arguments = 2, 2 : 0, 0 : 1, 1 : true",
                                                  "graded_hyper_rectangle\nset Arguments = 0 |999999999| 1 : 0 |999| 1"), ["Bodies/block/Arguments", "998999999001 cells"]),
    "Latin-1": (in_case("subsection Materials", "set Title = gepr\xfcft\nsubsection Materials").encode("latin-1"), ["case.prm:8", "gepr\xfcft", "UTF-8", "Latin-1"]),
    "UTF-16": ((CASE % "good.msh").encode("utf-16"), ["UTF-16", "UTF-8"]),
    "zero byte": ((CASE % "good.msh").encode() + b"\0", ["zero byte"]),
    "a mesh as parameter file": (MSH, ["case.prm:1", "cannot understand"]),
    "a binary mesh as parameter file": (BINARY, ["case.prm:1"]),
    "a name that is not closed": (in_case("subsection base", "subsection base\nsubsection"), ["subsection", "needs a name"]),
}

# these have to work
WORKING = {
    "CRLF": (CASE % "good.msh").replace("\n", "\r\n").encode(),
    "byte order mark": b"\xef\xbb\xbf" + (CASE % "good.msh").encode(),
    "Latin-1 in a comment": ("# gepr\xfcft\n" + CASE % "good.msh").encode("latin-1"),
    "UTF-8 names": (CASE % "good.msh").replace("block", "Kl\xf6tzchen").encode(),
    "ids": (CASE % "good.msh").replace("foot", "5, inner, 7").encode(),
}


def faults_of(output, code, expected_code, words):
    faults = [] if code == expected_code else ["exit code %d instead of %d" % (code, expected_code)]
    text = re.split(r"\n-{20,}\n", output)[0] # mpirun's own report
    faults += ["'%s' is missing" % word for word in words if word not in text]
    if text.count("stickslip: ") > 1:
        faults.append("the message is printed more than once")
    faults += ["'%s' appears" % word for word in CRASH if re.search(r"\b%s\b" % re.escape(word), text.lower())]
    return faults


def write(path, contents):
    with open(path, "wb") as file:
        file.write(contents.encode() if isinstance(contents, str) else contents)


def run(program, mpiexec, n_ranks, directory):
    command = [program, "--validate", "case.prm"]
    if n_ranks > 1:
        command = [mpiexec, "-n", str(n_ranks)] + command
    return subprocess.run(command, cwd=directory, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=120, check=False)


def try_case(program, mpiexec, n_ranks, prm, mesh_name, mesh, expected_code, words):
    with tempfile.TemporaryDirectory() as directory:
        if mesh_name.endswith("/"):
            os.mkdir(os.path.join(directory, mesh_name))
        else:
            write(os.path.join(directory, mesh_name), mesh)
        write(os.path.join(directory, "case.prm"), prm)
        result = run(program, mpiexec, n_ranks, directory)
    output = result.stdout.decode(errors="replace")
    return faults_of(output, result.returncode, expected_code, words), output


def main():
    program, mpiexec, n_ranks = os.path.abspath(sys.argv[1]), sys.argv[2], int(sys.argv[3])
    verbose = "--verbose" in sys.argv
    cases = {"mesh, " + name: (CASE % file, file, contents, 1, words) for name, (file, contents, words) in MESHES.items()}
    cases.update({"parameters, " + name: (prm, "good.msh", MSH, 1, words) for name, (prm, words) in PARAMETERS.items()})
    cases.update({"works, " + name: (prm, "good.msh", MSH, 0, []) for name, prm in WORKING.items()})
    if n_ranks > 1 and "--all" not in sys.argv:
        cases = dict(list(cases.items())[::4])
    n_wrong = 0
    with concurrent.futures.ThreadPoolExecutor(1 if n_ranks > 1 else 2) as pool:
        results = {name: pool.submit(try_case, program, mpiexec, n_ranks, *case) for name, case in cases.items()}
        for name, future in results.items():
            faults, output = future.result()
            n_wrong += 1 if faults else 0
            if faults or verbose:
                print("%s: %s" % (name, "; ".join(faults) if faults else "as expected"))
                print("    " + output.strip()[:600].replace("\n", "\n    "))
    print("%d of %d inputs are treated well." % (len(cases) - n_wrong, len(cases)))
    return 1 if n_wrong else 0


if __name__ == "__main__":
    sys.exit(main())
