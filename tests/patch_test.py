#!/usr/bin/env python3
"""The contact patch test against the errors that point-to-segment contact has.

Runs the program on application/data/patch_test.prm and patch_test_punch.prm
with each quadrature rule, reads lambda_n and u_y from the VTU files and
compares their largest relative errors with the table
application/data/patch_test_errors.csv (computed by an independent program).

usage: patch_test.py PROGRAM [--verbose]
"""

import base64
import csv
import os
import re
import struct
import subprocess
import sys
import tempfile
import zlib

HERE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "application", "data")
PRESSURE = 25.0
STRAIN_Y = -PRESSURE * (1.0 - 0.3**2) / 2000.0
CASES = {"equal width": "patch_test.prm", "punch": "patch_test_punch.prm"}
RULES = {
    "nodal": ("nodal", 2),
    "simpson": ("Simpson", 1),
    "gauss2": ("Gauss", 2),
    "gauss3": ("Gauss", 3),
    "gauss4": ("Gauss", 4),
    "gauss8": ("Gauss", 8),
}
# The table has to be met within this part of the error ...
TOLERANCE = 0.1
# ... except for what Newton's method and single precision output leave.
NOISE = 1e-6


def vtu_array(text, name):
    """One array of a VTU file as deal.II writes it: zlib, base64, Float32."""
    if name == "points":
        pattern = r"<Points>\s*<DataArray[^>]*>([^<]*)<"
    else:
        pattern = r'<DataArray type="Float32" Name="%s"[^>]*>([^<]*)<' % name
    encoded = re.search(pattern, text).group(1).strip()
    n_blocks = struct.unpack("<I", base64.b64decode(encoded[:8])[:4])[0]
    header_length = 4 * ((4 * (3 + n_blocks) + 2) // 3)
    sizes = struct.unpack("<%dI" % (3 + n_blocks), base64.b64decode(encoded[:header_length])[: 4 * (3 + n_blocks)])
    data = base64.b64decode(encoded[header_length:])
    values, begin = b"", 0
    for size in sizes[3:]:
        values += zlib.decompress(data[begin : begin + size])
        begin += size
    return struct.unpack("<%df" % (len(values) // 4), values)


def largest_errors(directory):
    """Largest relative errors of lambda_n and u_y of the last step."""
    with open(os.path.join(directory, "contact-0001.0.vtu")) as file:
        lambda_n = vtu_array(file.read(), "lambda_n")
    with open(os.path.join(directory, "solution-0001.0.vtu")) as file:
        text = file.read()
    y = vtu_array(text, "points")[1::3]
    u_y = vtu_array(text, "displacement")[1::3]
    error_u = max(abs(u - STRAIN_Y * height) for u, height in zip(u_y, y))
    largest_u = max(abs(STRAIN_Y * height) for height in y)
    return max(abs(value + PRESSURE) for value in lambda_n) / PRESSURE, error_u / largest_u


def run(program, directory, row):
    rule, order = RULES[row["rule"]]
    settings = {
        "Contact/c/Quadrature": rule,
        "Contact/c/Quadrature order": order,
        "Output/Format": "vtu",
        "Output/Grouped files": 1,
    }
    command = [program, os.path.join(HERE, CASES[row["case"]]), "--output-directory", directory]
    for name, value in settings.items():
        command += ["--set", "%s=%s" % (name, value)]
    result = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if result.returncode != 0:
        sys.exit("%s\nfailed with exit code %d:\n%s" % (" ".join(command), result.returncode, result.stdout))
    return largest_errors(directory)


def main():
    program, verbose = sys.argv[1], "--verbose" in sys.argv
    n_wrong = 0
    with open(os.path.join(HERE, "patch_test_errors.csv")) as file:
        rows = list(csv.DictReader(file))
    with tempfile.TemporaryDirectory() as directory:
        for row in rows:
            text = "%-12s %-8s" % (row["case"], row["rule"])
            holds = True
            for name, error in zip(("lambda", "uy"), run(program, directory, row)):
                known = float(row["max_rel_error_" + name])
                holds = holds and abs(error - known) <= TOLERANCE * known + NOISE
                text += "  %s %.3e (known: %.3e)" % (name, error, known)
            n_wrong += 0 if holds else 1
            if verbose or not holds:
                print(text + ("" if holds else "  FALLS SHORT"))
    print("%d of %d rows of the table hold." % (len(rows) - n_wrong, len(rows)))
    return 1 if n_wrong else 0


if __name__ == "__main__":
    sys.exit(main())
