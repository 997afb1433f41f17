#!/usr/bin/env python3
"""Mutates meshes (mesh_files.py) and a parameter file at random and looks whether the program ends
well: exit code 0 or 1, one message at most, no stack trace. No test of ctest: run it by hand.

usage: fuzz_meshes.py PROGRAM [NUMBER [SEED]]
"""

import collections
import os
import random
import shutil
import subprocess
import sys
import tempfile

import bad_meshes
import mesh_files

WORDS = [b"0", b"-1", b"1e308", b"nan", b"99999999999999999999", b"2147483648", b"$End", b"*", b",", b"\n", b"\0", b"\xff", b" ", b"<", b"'", b"x"]


def mutated(contents, rng):
    data = bytearray(contents)
    for _ in range(rng.choice((1, 1, 1, 2, 5))):
        place, kind = rng.randrange(len(data) + 1), rng.randrange(6)
        if kind == 0:  # change a byte
            data[place:place + 1] = bytes([rng.randrange(256)])
        elif kind == 1:  # cut something out
            del data[place:place + rng.choice((1, 3, 20, 200))]
        elif kind == 2:  # end here
            del data[place:]
        elif kind == 3:  # repeat something
            data[place:place] = data[place:place + rng.choice((1, 10, 100))]
        elif kind == 4:  # another word
            data[place:place + rng.choice((0, 1, 2, 4))] = rng.choice(WORDS)
        else:  # another line
            lines = data.split(b"\n")
            i, j = rng.randrange(len(lines)), rng.randrange(len(lines))
            lines[i], lines[j] = lines[j], lines[i]
            data = bytearray(b"\n".join(lines))
        if not data:
            break
    return bytes(data)


def main():
    program = os.path.abspath(sys.argv[1])
    number = int(sys.argv[2]) if len(sys.argv) > 2 else 1000
    rng = random.Random(int(sys.argv[3]) if len(sys.argv) > 3 else 1)
    inputs = {name: contents for name, (contents, _) in mesh_files.ALL.items()}
    inputs["case.prm"] = (bad_meshes.CASE % "good.msh").encode()
    codes, kept = collections.Counter(), tempfile.mkdtemp(prefix="fuzz-")
    n_wrong = 0
    with tempfile.TemporaryDirectory() as directory:
        with open(os.path.join(directory, "good.msh"), "wb") as file:
            file.write(mesh_files.gmsh22())
        for i in range(number):
            name = rng.choice(sorted(inputs))
            path = os.path.join(directory, name)
            with open(path, "wb") as file:
                file.write(mutated(inputs[name], rng))
            is_case = name.endswith(".prm")
            if not is_case:
                with open(os.path.join(directory, "mesh.prm"), "w") as file:
                    file.write(bad_meshes.CASE % name)
            command = [program, "--validate", name if is_case else "mesh.prm"] if is_case or i % 2 else [program, "--inspect-mesh", name]
            try:
                result = subprocess.run(command, cwd=directory, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=60, check=False)
                output, code = result.stdout.decode(errors="replace"), result.returncode
            except subprocess.TimeoutExpired:
                output, code = "", "no end within a minute"
            codes[code] += 1
            faults = bad_meshes.faults_of(output, code if code != 0 else 1, 1, [])
            if faults:
                n_wrong += 1
                copy = os.path.join(kept, "%d-%s" % (i, name))
                shutil.copy(path, copy)
                print("%s (%s): %s\n    %s" % (copy, command[1], "; ".join(faults), output.strip()[:400].replace("\n", "\n    ")))
    print("%d of %d inputs ended badly; exit codes: %s" % (n_wrong, number, dict(codes)))
    if not n_wrong:
        os.rmdir(kept)
    return 1 if n_wrong else 0


if __name__ == "__main__":
    sys.exit(main())
