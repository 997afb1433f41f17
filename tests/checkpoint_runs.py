"""What the tests of checkpoints have in common: a case whose result depends on the path, runs of it, comparisons.

A block is pressed on another and dragged over it with friction; beside them a third one is in plastic flow. Compared
are the tables of all steps and every number of the checkpoint at the end (nodal values, multipliers, slip, pairing).
"""
import re
import shutil
import struct
import subprocess

from program_runs import environment_of, fresh_directory, rows_of

CASE = """
set Dimension = 2
subsection Bodies
  subsection lower
    set Generator = subdivided_hyper_rectangle
    set Arguments = 13, 4 : 0, 0 : 4, 1 : true
    set Material = soft
  end
  subsection upper
    set Generator = subdivided_hyper_rectangle
    set Arguments = 6, 3 : 0.5, 1 : 2, 1.8 : true
    set Material = soft
  end
  subsection metal
    set Generator = subdivided_hyper_rectangle
    set Arguments = 4, 3 : 5, 0 : 6, 1 : true
    set Material = plastic
  end
end
subsection Materials
  subsection soft
    set Law = St Venant-Kirchhoff
    set Young's modulus = 100
    set Poisson's ratio = 0.3
  end
  subsection plastic
    set Law = Simo-Miehe plasticity
    set Young's modulus = 100
    set Poisson's ratio = 0.3
    set Yield stress = 1
    set Hardening = linear
    set Hardening modulus = 20
  end
end
subsection Boundary conditions
  subsection base
    set Body = metal
    set Boundary = 2
    set Value = 0; 0
  end
  subsection stamp
    set Body = metal
    set Boundary = 3
    set Value = 0.04*max(t-2, 0) - 0.08*max(t-4, 0); -0.03*min(t, 5)
  end
  subsection foundation
    set Body = lower
    set Boundary = 2
    set Value = 0; 0
  end
  subsection drag
    set Body = upper
    set Boundary = 3
    set Value = 0.15*max(t-1, 0) - 0.3*max(t-4, 0); -0.02*min(t, 1)
  end
end
subsection Contact
  subsection interface
    set Slave body = upper
    set Slave boundary = 2
    set Master body = lower
    set Master boundary = 3
    set Friction = Coulomb
    set Friction coefficient = 0.3
  end
end
subsection Load stepping
  set End time = 6
  set Initial step = 1
  set Minimum step = 1
end
subsection Output
  set Verbosity = results
  set Every n steps = 100
  set Checkpoint every n steps = 1
  subsection Points
    subsection A
      set Body = upper
      set Position = 0.5, 1
    end
    subsection B
      set Body = upper
      set Position = 2, 1.8
    end
  end
end
"""
TOLERANCE = 1e-10
TABLES = {"points.csv": None, "resultants.csv": None,
          "statistics.csv": ["step", "time", "external_work", "friction_work"]}
failures = []


def check(holds, what):
    print(("passed  " if holds else "FAILED  ") + what, flush=True)
    if not holds:
        failures.append(what)


class Runs:
    def __init__(self, program, directory):
        self.program = program
        self.directory = fresh_directory(directory)
        (directory / "case.prm").write_text(CASE)

    def run(self, name, n_ranks=1, restart=None, options=(), exit_code=0, case="case.prm"):
        """Runs the case; returns all that was printed."""
        command = ["mpirun", "-np", str(n_ranks)] if n_ranks > 1 else []
        command += [self.program, case, "--output-directory", name]
        for option in options:
            command += ["--set", option]
        if restart:
            command += ["--restart", restart]
        result = subprocess.run(command, cwd=self.directory, env=environment_of(n_ranks), stdout=subprocess.PIPE,
                                stderr=subprocess.STDOUT, text=True)
        # mpirun frames its own messages in dashes
        printed = re.sub(r"^-{20,}\n.*?^-{20,}\n", "", result.stdout, flags=re.DOTALL | re.MULTILINE)
        if result.returncode != exit_code:
            check(False, f"{name}: exit code {result.returncode} instead of {exit_code}\n{printed}")
        return printed

    def copy(self, source, target):
        shutil.copytree(self.directory / source, self.directory / target)


def differences_of_tables(a, b):
    """Names of the columns that differ in any row."""
    result = []
    for name, columns in TABLES.items():
        tables = [rows_of(d / name) for d in (a, b)]
        if not tables[0] or len(tables[0]) != len(tables[1]) or tables[0][0].keys() != tables[1][0].keys():
            result.append(f"{name}: rows or columns")
            continue
        columns = columns or list(tables[0][0])
        rows = [[[float(row[c]) for c in columns] for row in table] for table in tables]
        # The components of a vector share their scale.
        families = [c[:-2] if c[-2:] in ("_x", "_y") else c for c in columns]
        scale = {}
        for row in rows[0]:
            for family, value in zip(families, row):
                scale[family] = max(scale.get(family, 0.), abs(value))
        for i, c in enumerate(columns):
            worst = max(abs(p[i] - q[i]) for p, q in zip(*rows))
            if not worst <= TOLERANCE * scale[families[i]]:
                result.append(f"{name} {c} by {worst:.1e}")
    return result


def read_checkpoint(directory):
    """The records of all cells: {cell: numbers}."""
    slot = directory / (directory / "checkpoint.latest").read_text().strip()
    cells = {}
    for path in slot.glob("cells.*"):
        data = path.read_bytes()
        n_cells = struct.unpack_from("=Q", data, len(data) - 24)[0]
        start = 0
        for i in range(n_cells):
            *cell, end, _ = struct.unpack_from("=4I2Q", data, len(data) - 32 * (n_cells - i + 1))
            cells[tuple(cell)] = struct.unpack_from(f"={end - start}d", data, 24 + 8 * start)
            start = end
    return cells


def differences_of_checkpoints(a, b, n_nodes=4, only_nodal=False):
    """What differs between the states at the end; a cell has N_NODES nodes, or N_NODES(cell) if cells are of two kinds.
    ONLY_NODAL: of displacements and forces."""
    a, b = read_checkpoint(a), read_checkpoint(b)
    if a.keys() != b.keys() or any(len(a[cell]) != len(b[cell]) for cell in a):
        return ["the cells"]
    # Each record begins with displacement, forces, contact forces and rate of the nodes in two directions.
    n_nodal = {cell: 4 * 2 * (n_nodes(cell) if callable(n_nodes) else n_nodes) for cell in a}

    def key(cell, i):
        return ("nodal", i % 4) if i < n_nodal[cell] else (len(a[cell]), i)

    scale = {}
    for cell, record in a.items():
        for i, value in enumerate(record):
            scale[key(cell, i)] = max(scale.get(key(cell, i), 0.), abs(value))
    return [f"number {i} of cell {cell}: {p!r}, {q!r}" for cell in a for i, (p, q) in enumerate(zip(a[cell], b[cell]))
            if (i < n_nodal[cell] or not only_nodal) and not abs(p - q) <= TOLERANCE * scale[key(cell, i)]]


def compare(runs, name, reference="uninterrupted", n_nodes=4, only_nodal=False):
    paths = runs.directory / reference, runs.directory / name
    differences = differences_of_tables(*paths) + differences_of_checkpoints(*paths, n_nodes, only_nodal)
    check(not differences, f"{name} is like {reference}" + "".join("\n    " + d for d in differences[:10]))
