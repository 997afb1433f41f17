#!/usr/bin/env python3
"""The same mesh in all formats (mesh_files.py) has to be read as the same, and a case has to find
its bodies and boundaries by names, or by numbers where a format has no names.

usage: mesh_formats.py PROGRAM [--verbose]
"""

import json
import os
import subprocess
import sys
import tempfile

import mesh_files

CASE = """
set Dimension = 2
subsection Bodies
  subsection left
    set Mesh file = %(file)s
    set Mesh group = %(left)s
    set Material = steel
  end
  subsection right
    set Mesh file = %(file)s
    set Mesh group = %(right)s
    set Material = steel
  end
end
subsection Materials
  subsection steel
    set Law = linear elastic
    set Young's modulus = 100
    set Poisson's ratio = 0
  end
end
subsection Boundary conditions
  subsection left foot
    set Body = left
    set Boundary = %(foot)s
    set Value = 0.1*t*(1 - x); 0
  end
  subsection right foot
    set Body = right
    set Boundary = %(foot)s
    set Value = -0.1*t*(x - 1); 0
  end
end
subsection Contact
  subsection touch
    set Slave body = left
    set Slave boundary = %(inner)s
    set Master body = right
    set Master boundary = %(outer)s
    set Excluded boundaries = %(foot)s
  end
end
subsection Output
  set Verbosity = results
end
"""
NAMES = {name.split()[0]: name for name in mesh_files.NAMES.values()}
NUMBERS = {name.split()[0]: str(key[1]) for key, name in mesh_files.NAMES.items()}


def run(program, *arguments):
    return subprocess.run([program, *arguments], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=120)


def faults_of_inspection(program, file, has_names):
    result = run(program, "--inspect-mesh", file, "json")
    if result.returncode != 0:
        return [result.stdout.strip()]
    mesh = json.loads(result.stdout)
    faults = []

    def expect(what, found, expected):
        if found != expected:
            faults.append("%s: %s instead of %s" % (what, found, expected))

    expect("dimension", mesh["dimension"], 2)
    expect("bodies", sorted((b["cells"], b["box"]) for b in mesh["bodies"]),
           [(1, [[0, 0], [1, 1]]), (1, [[1, 0], [2, 1]])])
    expect("gaps", [(p["gap"], p["matching nodes"]) for p in mesh["near surfaces"]], [(0, True)])
    expect("inverted cells", mesh["inverted cells"], 0)
    boxes = {g["name"] if has_names else g["number"]: g["box"] for g in mesh["groups"]}
    for (dimension, number), name in mesh_files.NAMES.items():
        nodes = [n for d, g, ns in mesh_files.ELEMENTS if (d, g) == (dimension, number) for n in ns]
        xs, ys = zip(*(mesh_files.POINTS[n - 1] for n in nodes))
        expect(name, boxes.get(name if has_names else number), [[min(xs), min(ys)], [max(xs), max(ys)]])
    return faults


# a wedge and a pyramid: no cells of bodies, but a user may have them, and looks why
SINGLE_CELLS = {
    "wedge.inp": ("*NODE\n1,0,0,0\n2,1,0,0\n3,0,1,0\n4,0,0,2\n5,1,0,2\n6,0,1,2\n*ELEMENT,TYPE=C3D6,ELSET=A\n1,1,2,3,4,5,6\n", 1, 2),
    "pyramid.inp": ("*NODE\n1,0,0,0\n2,1,0,0\n3,1,1,0\n4,0,1,0\n5,0.5,0.5,3\n*ELEMENT,TYPE=C3D5,ELSET=A\n1,1,2,3,4,5\n", 1, 9.5 ** 0.5),
}


def faults_of_single_cell(program, name):
    contents, shortest, longest = SINGLE_CELLS[name]
    with open(name, "w") as file:
        file.write(contents)
    result = run(program, "--inspect-mesh", name, "json")
    if result.returncode != 0:
        return [result.stdout.strip()]
    mesh = json.loads(result.stdout)
    edges = [mesh["shortest edge"], mesh["longest edge"]]
    is_right = abs(edges[0] - shortest) < 1e-6 and abs(edges[1] - longest) < 1e-6 and mesh["inverted cells"] == 0
    return [] if is_right else ["edges %s instead of %s, inverted cells %s" % (edges, [shortest, longest], mesh["inverted cells"])]


def result_of_case(program, file, has_names):
    with open("case.prm", "w") as case:
        case.write(CASE % dict(NAMES if has_names else NUMBERS, file=file))
    return run(program, "case.prm").stdout


def converted_files():
    """The mesh in formats that meshio writes, read back; none without meshio."""
    try:
        import meshio
    except ImportError:
        print("meshio is not installed: its files and the documented conversion are not tried.")
        return {}
    files = {}
    for name, options in {"meshio.vtu": {}, "meshio.vtk": {}, "meshio.inp": {}, "meshio.msh": {"file_format": "gmsh22", "binary": False}}.items():
        mesh = meshio.read("v22.msh")
        mesh.cell_sets = {}
        meshio.write(name, mesh, **options)
        files[name] = name.endswith(".msh")
    subprocess.run([sys.executable, "-m", "meshio._cli", "--version"], check=False, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    files.pop("meshio.inp")  # it has no groups without cell sets; see that it is read
    if run(program_path(), "--inspect-mesh", "meshio.inp").returncode != 0:
        files["meshio.inp"] = False
    return files


def program_path():
    return os.path.abspath(sys.argv[1])


def main():
    program, verbose = program_path(), "--verbose" in sys.argv
    n_wrong, reference = 0, None
    with tempfile.TemporaryDirectory() as directory:
        os.chdir(directory)
        for name, (contents, _) in mesh_files.ALL.items():
            with open(name, "wb") as file:
                file.write(contents)
        files = {name: has_names for name, (_, has_names) in mesh_files.ALL.items()}
        files.update(converted_files())
        for name, has_names in files.items():
            faults = faults_of_inspection(program, name, has_names)
            result = result_of_case(program, name, has_names)
            if reference is None:
                reference = result
                if "touch.force_x" not in result:
                    faults.append(result.strip())
            elif result != reference:
                faults.append("the case has other results:\n" + result.strip())
            n_wrong += 1 if faults else 0
            if faults or verbose:
                print("%s: %s" % (name, "; ".join(faults) if faults else "as expected"))
        for name in SINGLE_CELLS:
            faults = faults_of_single_cell(program, name)
            n_wrong += 1 if faults else 0
            if faults or verbose:
                print("%s: %s" % (name, "; ".join(faults) if faults else "as expected"))
        os.chdir("/")
    n_files = len(files) + len(SINGLE_CELLS)
    print("%d of %d files are read well." % (n_files - n_wrong, n_files))
    return 1 if n_wrong else 0


if __name__ == "__main__":
    sys.exit(main())
