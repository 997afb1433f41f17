#!/usr/bin/python3
"""The Python package (scripts/stickslip): runs it starts, tables and fields that it reads.

    python_test.py PROGRAM SOURCE_DIRECTORY WORKING_DIRECTORY

Numbers are held against the files, read here with csv, and against what meshio or
VTK's integration of the fields says; errors have to be those that the page promises.
"""
import csv
import importlib.util
import os
import pathlib
import subprocess
import sys

sys.dont_write_bytecode = True
from program_runs import fresh_directory

program, source = os.path.abspath(sys.argv[1]), pathlib.Path(sys.argv[2]).resolve()
sys.path.insert(0, str(source / "scripts"))
os.environ["STICKSLIP"] = program

import numpy as np

import stickslip

failures = []


def check(holds, what):
    print(("passed  " if holds else "FAILED  ") + what, flush=True)
    if not holds:
        failures.append(what)


def error_of(function, kind):
    """The error of this kind that the call throws, or None."""
    try:
        function()
    except kind as error:
        return error
    return None


def has(module):
    return importlib.util.find_spec(module) is not None


BLOCK = {
    "Dimension": 2,
    "Bodies": {"block": {"Generator": "hyper_cube", "Arguments": "0 : 2 : true", "Refinements": 1, "Material": "steel"}},
    "Materials": {"steel": {"Law": "linear elastic", "Young's modulus": 100, "Poisson's ratio": 0}},
    "Boundary conditions": {"foot": {"Body": "block", "Boundary": 2, "Value": "free; 0"},
                            "side": {"Body": "block", "Boundary": 0, "Value": "0; free"},
                            "top": {"Body": "block", "Boundary": 3, "Value": "free; -0.1*t"}},
    "Load stepping/Initial step": 0.25,
    "Load stepping/Requested times": [0.5, 1],
    "Output": {"Points": {"A": {"Body": "block", "Position": (2, 2)}}, "Verbosity": "quiet", "Deformed": False},
}


def test_run():
    """A bar without lateral contraction: u_y of its top is prescribed, the force is E u/h times its width."""
    results = stickslip.run(BLOCK, directory="bar", ranks=2)
    check(results.exit_code == 0 and results.log.state == "done" and results.n_steps == 4, f"bar: four steps, {results.n_steps}")
    check(np.allclose(results.points["A_y"], -0.1 * results.points["time"], atol=1e-14), "bar: displacement of the top")
    check(np.allclose(results.points["A_x"], 0, atol=1e-12), "bar: no lateral contraction")
    check(np.allclose(results.reactions["top.force_y"], -100 * 0.1 * results.points["time"], rtol=1e-10), "bar: force of the top")
    check(results.parameters.get("Load stepping/Requested times") == "0.5, 1", "bar: a list becomes a list")
    check(results.dimension == 2 and results.pairs == [], "bar: dimension, no pairs")
    other = stickslip.run(BLOCK, {"Materials/steel/Poisson's ratio": 0.25}, directory="wide", **{"Output/Deformed": True})
    check(abs(other.points.last("A_x") - 2 * 0.05 * 0.25 / 0.75) < 1e-10, "bar: settings, plane strain u_x = nu/(1-nu) u_y/h w")
    check(other.parameters.get("Output/Deformed") == "true", "bar: a keyword replaces a value")


def test_tables():
    text = "subsection Output\n subsection Contact lines\n subsection edge\n" \
           "  set Contact pair = interface\n  set From = 5, 6\n  set To = 12, 6\n  set Points = 141\n end\n end\nend\n"
    pathlib.Path("blocks.prm").write_text(f"include {source}/parameters/two_blocks.prm\n{text}")
    results = stickslip.run("blocks.prm", {"Output/Contact points": True}, directory="blocks")
    for name in ("statistics", "resultants", "points"):
        with open(f"blocks/{name}.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        table = getattr(results, name)
        same = all([str(value) for value in table[column]] == [row[column] for row in rows] if table[column].dtype.kind == "U"
                   else table[column].tolist() == [float(row[column]) for row in rows] for column in rows[0])
        check(list(table) == list(rows[0]) and table.n_rows == len(rows) and same, f"{name}.csv: {table.n_rows} rows, all numbers")
    n_iterations = sum(attempt.n_iterations for attempt in results.log.attempts if attempt.failure is None)
    check(n_iterations == results.total("newton_iterations") > 0, "iterations of the log are those of the table")
    points = results.contact_points(results.n_steps)
    force = (points["pressure"] * points["reference_weight"]).sum()
    normal = np.hypot(results.resultants.last("interface.normal_force_x"), results.resultants.last("interface.normal_force_y"))
    check(abs(force / normal - 1) < 1e-3, f"contact points: their pressures give the normal force, {force:.6g} is {normal:.6g}")
    edge = results.table("line_edge.csv")
    last = edge["step"] == results.n_steps
    integral = np.trapz(edge["pressure"][last], edge["distance"][last])
    check(last.sum() == 141 and edge.n_rows == 141 * results.n_steps, "a line: a row per point and step")
    check(abs(integral / normal - 1) < 5e-3, f"a line: its pressure gives the normal force, {integral:.6g} is {normal:.6g}")
    if has("pandas"):
        check(results.statistics.pandas()["newton_iterations"].sum() == results.total("newton_iterations"), "a table as pandas.DataFrame")
    else:
        error = error_of(results.statistics.pandas, stickslip.ResultsError)
        check(error is not None and "python3-pandas" in str(error), "without pandas: what to install")
        print("skipped pandas: it is not installed")

    text = pathlib.Path("blocks/statistics.csv").read_text()
    pathlib.Path("cut.csv").write_text(text[: text.rstrip("\n").rfind("\n") + 12])
    check(stickslip.Table.read("cut.csv", only_whole_rows=True).n_rows == results.n_steps - 1, "a row that is not written to its end")
    pathlib.Path("odd.csv").write_text('# of another program\na, b,c\n1,,"x, y"\n2.5,7,\n')
    odd = stickslip.Table.read("odd.csv")
    check(odd["a"].tolist() == [1, 2.5] and np.isnan(odd["b"][0]) and odd["c"].tolist() == ["x, y", ""], "comments, quotes, empty cells")
    check(odd.lists() == {"a": [1, 2.5], "b": ["", 7], "c": ["x, y", ""]}, "a table as lists")
    check(odd.total("b") == 7 and odd.total("d") == 0, "sums")
    error = error_of(lambda: odd["d"], KeyError)
    check(error is not None and "no column 'd'; there are: a, b, c" in str(error), f"an unknown column: {error}")


def simplex_volumes(points, cells):
    """With the sign of their orientation."""
    edges = points[cells[:, 1:]] - points[cells[:, :1]]
    if edges.shape[1] == 2:
        return np.cross(edges[:, 0], edges[:, 1])[:, 2] / 2
    return np.linalg.det(edges) / 6


def free_surface(points, cells):
    """The area of the faces that one cell has; nan if some have more than two."""
    dim = cells.shape[1] - 1
    faces = np.concatenate([np.delete(cells, i, axis=1) for i in range(dim + 1)])
    corners = np.round(points[faces], 9) + 0.
    keys = np.array([sorted(map(tuple, face)) for face in corners]).reshape(len(faces), -1)
    _, first, counts = np.unique(keys, axis=0, return_index=True, return_counts=True)
    edges = points[faces[first, 1:]] - points[faces[first, :1]]
    areas = np.linalg.norm(edges[:, 0] if dim == 2 else np.cross(edges[:, 0], edges[:, 1]) / 2, axis=1)
    return areas[counts == 1].sum() if counts.max() == 2 else np.nan


def test_simplices():
    """Triangles and tetrahedra of degree 2 are written as linear ones, which fill the body."""
    block_3d = {"Dimension": 3, "Boundary conditions/foot/Value": "free; 0; 0", "Boundary conditions/side/Value": "0; free; free",
                "Boundary conditions/top/Value": "free; -0.1*t; free", "Output/Points/A/Position": (2, 2, 2)}
    formats = ["vtu", "hdf5"] if has("h5py") else ["vtu"]
    for dim, case, kind, n_cut, n_parts in ((2, {}, 5, 32, 4), (3, block_3d, 10, 192, 8)):
        for degree, form in ((degree, form) for degree in (1, 2) for form in formats):
            grid = stickslip.run(BLOCK, {**case, "Bodies/block/Simplices": True, "Output/Format": form}, Degree=degree,
                                 directory="simplices").bodies.steps[-1].arrays()
            volumes = simplex_volumes(grid.points, grid.cells[0][1])
            name = f"simplices, {dim}D, degree {degree}, {form}: "
            check([k for k, _ in grid.cells] == [kind] and len(volumes) == n_cut * (n_parts if degree == 2 else 1), name + "cells")
            check(volumes.min() > 0 and abs(volumes.sum() - 2**dim) < 1e-6, name + f"they fill the block, {volumes.sum()}")
            surface = free_surface(grid.points, grid.cells[0][1])
            check(abs(surface - dim * 2**dim) < 1e-6, name + f"they fit together, {surface}")
            check(np.allclose(grid.point_data["displacement"][:, 1], -0.05 * grid.points[:, 1]), name + "displacement is -0.05 y")


def test_fields():
    if not has("vtk"):
        error = error_of(stickslip.Results("bar").bodies.steps[-1].vtk, stickslip.ResultsError)
        check(error is not None and "python3-vtk9" in str(error), f"without VTK: what to install ({error})")
        print("skipped fields: VTK is not installed")
        return
    bar = stickslip.Results("bar").bodies
    check([step.number for step in bar.steps] == [1, 2, 3, 4] and bar.at_step(3).time == 0.75 and bar.at_step(5) is None, "steps of the fields")
    grid = bar.steps[-1].arrays()
    check(sum(len(nodes) for _, nodes in grid.cells) == 4 and len(grid.points) == 16, "bar: the cells of both ranks")
    check(np.allclose(grid.point_data["displacement"][:, 1], -0.05 * grid.points[:, 1]), "bar: displacement is -0.05 y")
    hdf5 = stickslip.run(BLOCK, {"Output/Format": "hdf5"}, directory="hdf5").bodies.steps[-1].arrays() if has("h5py") else grid
    check(np.allclose(hdf5.point_data["displacement"][:, 1], -0.05 * hdf5.points[:, 1]) and sum(len(n) for _, n in hdf5.cells) == 4, "HDF5")
    curved = stickslip.run(BLOCK, Degree=2, directory="curved").bodies.steps[-1]
    kinds = {kind for kind, _ in curved.arrays().cells}
    check(kinds == {70}, f"degree 2: Lagrange quadrilaterals, {kinds}")
    if has("meshio"):
        mesh = curved.meshio()
        check([(block.type, block.data.shape) for block in mesh.cells] == [("VTK_LAGRANGE_QUADRILATERAL", (4, 9))], "meshio: cells")
        check(np.allclose(mesh.point_data["displacement"][:, 1], -0.05 * mesh.points[:, 1]), "meshio: point data")
    else:
        error = error_of(curved.meshio, stickslip.ResultsError)
        check(error is not None and "pip install meshio" in str(error), "without meshio: what to install")
    if has("pyvista"):
        check(curved.pyvista().n_cells == 4 and "displacement" in curved.pyvista().point_data, "pyvista")
    else:
        error = error_of(curved.pyvista, stickslip.ResultsError)
        check(error is not None and "pip install pyvista" in str(error), "without pyvista: what to install")


def test_refused():
    error = error_of(lambda: stickslip.run(BLOCK, Degre=2, directory="wrong"), stickslip.RunError)
    check(error is not None and error.exit_code == 1 and "Did you mean 'Degree'" in str(error) and error.results is None, f"wrong input: {error}")
    falls = {"Checks": {"a": {"Quantity": "A_y", "Expected": 1}}, "Output/Verbosity": "results"}
    error = error_of(lambda: stickslip.run({**BLOCK, **falls}, directory="short"), stickslip.RunError)
    check(error is not None and error.exit_code == 4 and "check failed" in str(error) and "FALLS SHORT" in str(error) and error.results.n_steps == 4, f"a check: {error}")
    results = stickslip.run({**BLOCK, **falls}, directory="short", check=False)
    check(results.exit_code == 4 and results.n_steps == 4, "a check that falls short, with check=False")
    turned = {"Boundary conditions/top/Value": "free; -3*t", "Materials/steel/Law": "neo-Hookean", "Load stepping/Minimum step": 0.25}
    error = error_of(lambda: stickslip.run(BLOCK, turned, directory="turned", ranks=2), stickslip.RunError)
    check(error is not None and error.exit_code == 2 and error.results.log.state == "stopped", f"no convergence: {str(error)[:120]}")
    error = error_of(lambda: stickslip.run(BLOCK, {"Load stepping/Initial step": 1e-5, "Load stepping/Minimum step": 1e-6}, directory="long", timeout=20), stickslip.RunError)
    check(error is not None and "out of time" in str(error) and error.results.n_steps > 0
          and pathlib.Path("long/checkpoint.latest").exists(), "a timeout leaves a checkpoint")
    for call, words in ((lambda: stickslip.Results("nowhere"), "'nowhere' is not a directory"),
                        (lambda: stickslip.Results("."), "not the output directory of a run"),
                        (lambda: stickslip.Results("bar").contact_points(1), "'Output/Contact points'"),
                        (lambda: stickslip.run("no.prm"), "cannot be read"),
                        (lambda: stickslip.run(BLOCK, ranks=0), "ranks is 0")):
        error = error_of(call, stickslip.StickslipError)
        check(error is not None and words in str(error), f"{error}")


def test_install():
    """pip install ./scripts: what the package needs comes with it."""
    copy = pathlib.Path("copy")
    subprocess.run(["cp", "-r", source / "scripts", copy], check=True)
    result = subprocess.run([sys.executable, "-m", "pip", "install", "--quiet", "--no-deps", "--no-build-isolation", "--target", "installed", "./copy"],
                            capture_output=True, text=True)
    if result.returncode != 0 and ("No module named" in result.stderr or "setuptools" in result.stderr):
        print("skipped the installation: pip, setuptools or wheel are not there")
        return
    check(result.returncode == 0, f"pip install {result.stderr.strip()[-200:]}")
    code = "import stickslip, sys; r = stickslip.Results('bar'); print(r.n_steps, 'installed' in stickslip.__file__, len(stickslip.running.environment()) > 3)"
    result = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, env={**os.environ, "PYTHONPATH": "installed"})
    check(result.stdout.split() == ["4", "True", "True"], f"the installed package: {result.stdout}{result.stderr}".strip())


os.chdir(fresh_directory(sys.argv[3]))
for test in (test_run, test_tables, test_fields, test_simplices, test_refused, test_install):
    test()
print(f"{len(failures)} checks failed")
sys.exit(1 if failures else 0)
