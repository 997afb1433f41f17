#!/usr/bin/env python3
"""Every benchmark starts: its options are printed, so that what it imports is there.

    benchmarks_test.py SOURCE_DIRECTORY

Benchmarks take minutes to hours and are not part of the suite; a name that was changed
in a file that several of them share is noticed here.
"""
import pathlib
import subprocess
import sys

benchmarks = sorted((pathlib.Path(sys.argv[1]) / "parameters" / "benchmarks").glob("*/run"))
failures = []
for benchmark in benchmarks:
    # The interpreter of scripts/bench.
    run = subprocess.run(["/usr/bin/python3", "-B", str(benchmark), "--help"], capture_output=True, text=True)
    if run.returncode or "--quick" not in run.stdout:
        failures.append(f"{benchmark.parent.name} does not start: {(run.stderr.strip().splitlines() or ['no options'])[-1]}")
print("\n".join(failures + [f"{len(benchmarks)} benchmarks, {len(failures)} failures"]))
sys.exit(1 if failures or not benchmarks else 0)
