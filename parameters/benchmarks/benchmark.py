"""What benchmark scripts share: run the program, read its tables, compare.

A benchmark is a directory parameters/benchmarks/NAME with README.md (its first
line is what scripts/bench lists), .prm files, reference data and a Python
program `run`:

    #!/usr/bin/env python3
    import os, sys
    sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
    from benchmark import Benchmark

    benchmark = Benchmark("hertz")
    result = benchmark.run("hertz.prm", "coarse", {"Mesh/Global refinements": 1})
    benchmark.check("contact force", result.last("resultants.csv", "cylinder_force_y"), -35000., 1e-8)
    with benchmark.plot("pressure.png") as axes:
        axes.plot(x, p, label="ours")
    benchmark.finish()

Every number goes to OUTPUT/comparison.csv, every plot to OUTPUT/*.png, where
OUTPUT is $BENCH_OUTPUT, or build/bench/NAME.
"""
import argparse
import contextlib
import csv
import math
import os
import pathlib
import shutil
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "scripts"))
from stickslip import Table
from stickslip.running import Usage, command_of, environment, measure, variables_of


INTERRUPTED = 5  # exit code of a run that saves its state because its time is up


def read_csv(path):
    """Columns of a CSV file with a header: {name: list}; numbers where possible."""
    return Table.read(path).lists()


class Result:
    """Output directory and log of one run."""

    def __init__(self, directory, log, usage):
        self.directory = directory
        self.log = log
        self.seconds = usage.seconds
        self.cpu_seconds = usage.cpu_seconds  # of all ranks
        self.peak_mebibytes = usage.peak_mebibytes  # of the largest rank
        self.exit_code = usage.exit_code
        self.is_out_of_time = usage.is_out_of_time
        self.is_interrupted = usage.exit_code == INTERRUPTED  # its state is saved

    @property
    def converged(self):
        return self.exit_code == 0

    def table(self, name):
        """Columns of NAME (statistics.csv, points.csv, resultants.csv, ...)."""
        return read_csv(self.directory / name)

    def column(self, table, name):
        columns = self.table(table)
        if name not in columns:
            raise SystemExit(f"{self.directory / table} has no column '{name}'; it has: {', '.join(columns)}")
        return columns[name]

    def last(self, table, column):
        return self.column(table, column)[-1]

    def total(self, table, column):
        return math.fsum(self.column(table, column))


class Benchmark:
    def __init__(self, name, description="", options=None):
        """
        Reads the command line: --quick, --ranks N, --keep and OPTIONS of the
        benchmark's own, {"--name": arguments of argparse}.
        """
        parser = argparse.ArgumentParser(prog=f"scripts/bench {name}", description=description)
        parser.add_argument("--quick", action="store_true", help="a smaller version, for continuous integration")
        parser.add_argument("--ranks", type=int, default=2, help="MPI ranks of each run (2)")
        parser.add_argument("--keep", action="store_true", help="reuse runs that an earlier call has finished")
        for option, arguments in (options or {}).items():
            parser.add_argument(option, **arguments)
        self.options = parser.parse_args()
        self.name = name
        self.quick = self.options.quick
        self.directory = ROOT / "parameters" / "benchmarks" / name
        self.program = os.environ.get("STICKSLIP", str(ROOT / "build" / "stickslip"))
        self.output = pathlib.Path(os.environ.get("BENCH_OUTPUT", ROOT / "build" / "bench" / name))
        self.output.mkdir(parents=True, exist_ok=True)
        self.rows = []
        self.failures = []
        if not os.access(self.program, os.X_OK):
            raise SystemExit(f"The program {self.program} is missing; call scripts/bench {name}, which builds it.")

    # ---------------------------------------------------------------- running
    def run(self, parameter_file, label, overrides=None, ranks=None, may_fail=False, timeout=None, variables=None, goes_on=False):
        """
        Runs PARAMETER_FILE (of the benchmark's directory) into OUTPUT/label with
        overrides {"Section/Name": value}. A run that fails ends the benchmark,
        unless may_fail: then the caller looks at result.converged. `variables` are
        added to the environment. `goes_on`: a run that an earlier call has begun with
        the same input is continued from its checkpoint.
        """
        directory = self.output / label
        log = directory / "log.txt"
        ranks = ranks or self.options.ranks
        command = command_of(self.directory / parameter_file, directory, overrides or {}, ranks, self.program)

        # What is reused has been computed by the same program from the same input.
        inputs = [pathlib.Path(self.program), self.directory / parameter_file]
        fingerprint = "\n".join(command + [f"{path} {path.stat().st_mtime_ns}" for path in inputs])
        stamp = directory / ".finished"
        spent = directory / ".usage"
        if self.options.keep and spent.exists() and stamp.exists() and stamp.read_text() == fingerprint:
            cpu_seconds, peak_mebibytes = map(float, spent.read_text().split())
            return Result(directory, log.read_text(), Usage(0, 0.0, cpu_seconds, peak_mebibytes))

        # Another program may continue a run, and other output or a later end do not matter.
        begun = directory / ".begun"
        case = inputs[1].read_text() + "".join(f"\n{name}={value}" for name, value in (overrides or {}).items()
                                               if not name.startswith(("Output/", "Load stepping/")))
        earlier = (0.0, 0.0)
        if goes_on and (directory / "checkpoint.latest").exists() and begun.exists() and begun.read_text() == case:
            command += ["--restart", "latest"]
            if spent.exists():
                earlier = tuple(map(float, spent.read_text().split()))
        else:
            shutil.rmtree(directory, ignore_errors=True)
            directory.mkdir(parents=True)
            begun.write_text(case)
        usage = measure(command, log, self.directory, {**variables_of(ranks), **(variables or {})}, timeout)
        usage = usage._replace(cpu_seconds=usage.cpu_seconds + earlier[0], peak_mebibytes=max(usage.peak_mebibytes, earlier[1]))
        spent.write_text(f"{usage.cpu_seconds} {usage.peak_mebibytes}")
        solved = usage.exit_code == 0
        if solved:
            stamp.write_text(fingerprint)
        print(f"  {label}: {'solved' if solved else 'interrupted' if usage.exit_code == INTERRUPTED else 'failed'} in {usage.seconds:.1f} s "
              f"({usage.cpu_seconds:.1f} s of user CPU, {usage.peak_mebibytes:.0f} MiB)", flush=True)
        if not solved and not may_fail:
            sys.stdout.write("".join(f"    {line}\n" for line in log.read_text().split("\n")[-15:]))
            self.fail(f"the run '{label}' failed (log: {log})")
            self.finish()
        return Result(directory, log.read_text(), usage)

    # -------------------------------------------------------------- comparing
    def check(self, quantity, ours, reference, tolerance, kind="relative"):
        """
        kind: "relative" or "absolute" difference within tolerance; "below":
        ours <= reference (1 + tolerance); "above": ours >= reference (1 - tolerance).
        """
        difference = ours - reference
        if kind == "relative":
            error = abs(difference) / abs(reference) if reference != 0 else abs(ours)
        elif kind == "absolute":
            error = abs(difference)
        elif kind in ("below", "above"):
            excess = difference if kind == "below" else -difference
            error = max(excess, 0.0) / abs(reference) if reference != 0 else max(excess, 0.0)
        else:
            raise ValueError(kind)
        holds = error <= tolerance  # false for NaN
        self.rows.append((quantity, ours, reference, error, tolerance, kind, holds))
        if not holds:
            self.fail(f"{quantity} is {ours:.9g} instead of {reference:.9g}")
        return holds

    def check_true(self, statement, holds):
        """A statement without a number."""
        self.rows.append((statement, float(bool(holds)), 1.0, 0.0 if holds else 1.0, 0.0, "true", bool(holds)))
        if not holds:
            self.fail(f"not true: {statement}")
        return holds

    def report(self, quantity, ours, reference=math.nan):
        """A number that is shown but not judged."""
        self.rows.append((quantity, ours, reference, math.nan, math.nan, "shown", True))

    def fail(self, what):
        self.failures.append(what)

    # ----------------------------------------------------------------- output
    def write_csv(self, name, header, rows):
        with open(self.output / name, "w", newline="") as file:
            writer = csv.writer(file)
            writer.writerow(header)
            writer.writerows(rows)

    @contextlib.contextmanager
    def plot(self, name, xlabel="", ylabel="", title="", **subplot_options):
        """Axes to draw on; written to OUTPUT/name at the end of the with block."""
        import matplotlib

        matplotlib.use("Agg")
        from matplotlib import pyplot

        figure, axes = pyplot.subplots(**{"figsize": (7, 5), "constrained_layout": True, **subplot_options})
        yield axes
        if hasattr(axes, "set_xlabel"):
            axes.set(xlabel=xlabel, ylabel=ylabel, title=title)
            if axes.get_legend_handles_labels()[1]:
                axes.legend()
        figure.savefig(self.output / name, dpi=130)
        pyplot.close(figure)

    def print_table(self):
        def number(x):
            return "" if math.isnan(x) else f"{x:.9g}"

        header = ("quantity", "ours", "reference", "difference", "tolerance", "")
        lines = [header]
        for quantity, ours, reference, error, tolerance, kind, holds in self.rows:
            if kind == "true":
                lines.append((quantity, "yes" if ours else "no", "yes", "", "", "ok" if holds else "FAILS"))
            else:
                verdict = "" if kind == "shown" else ("ok" if holds else "FAILS")
                difference = "" if math.isnan(error) else f"{error:.1e}"
                unit = {"relative": " rel", "absolute": " abs", "below": " at most", "above": " at least"}.get(kind, "")
                allowed = "" if math.isnan(tolerance) else f"{tolerance:.1e}{unit}"
                lines.append((quantity, number(ours), number(reference), difference, allowed, verdict))
        widths = [max(len(line[i]) for line in lines) for i in range(len(header))]
        print()
        for line in lines:
            print("  ".join([line[0].ljust(widths[0])] + [line[i].rjust(widths[i]) for i in range(1, 6)]).rstrip())
        print()

    def finish(self):
        """Table, comparison.csv, where the files are, verdict; ends the program."""
        if not self.rows and not self.failures:
            self.fail("nothing was compared")
        if self.rows:
            self.print_table()
        names = ("quantity", "ours", "reference", "difference", "tolerance", "kind", "holds")
        self.write_csv("comparison.csv", names, self.rows)
        print(f"Tables and plots: {self.output}")
        if self.failures:
            more = f" (and {len(self.failures) - 1} more)" if len(self.failures) > 1 else ""
            print(f"{self.name}: falls short: {self.failures[0]}{more}")
        else:
            print(f"{self.name}: holds")
        sys.stdout.flush()
        sys.exit(1 if self.failures else 0)
