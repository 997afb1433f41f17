#!/usr/bin/env python3
"""Installs the program, moves it, and uses what is there.

    install_test.py SOURCE_DIRECTORY BUILD_DIRECTORY WORKING_DIRECTORY

The moved program runs an example; a program of tests/own_law, outside of the
source tree, finds the library (find_package) and runs a case with its own law; the
Debian package holds a program that runs.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys

from program_runs import fresh_directory

failures = []


def check(holds, what):
    print(("passed  " if holds else "FAILED  ") + what, flush=True)
    if not holds:
        failures.append(what)


def run(*command, **options):
    return subprocess.run([str(word) for word in command], capture_output=True, text=True, **options)


def check_run(result, what):
    check(result.returncode == 0, f"{what} {(result.stdout + result.stderr)[-2000:] if result.returncode else ''}")
    return result.returncode == 0


def check_program(prefix):
    version = run(prefix / "bin" / "stickslip", "--version").stdout
    check(version.startswith("stickslip ") and "deal.II" in version, f"--version: {version.strip()}")
    if (source / ".git").exists() and shutil.which("git"):
        log = run("git", "-C", source, "log", "-1", "--format=%h", "--abbrev=9", "--", "source", "include", "CMakeLists.txt")
        check(log.returncode != 0 or f"commit {log.stdout.strip()}" in version, f"it names the commit {log.stdout.strip()}")
    case = prefix / "share" / "stickslip" / "parameters" / "examples" / "roller.prm"
    check_run(run(prefix / "bin" / "stickslip", case, "--output-directory", working / "roller"), "an installed example runs")


def check_library(prefix):
    texts = {file: file.read_text() for file in (prefix / "lib").rglob("*.cmake")}
    # not within a longer path: the project's directory may be /stickslip
    places = re.compile("|".join(rf"(?<![\w.${{}}/-]){re.escape(str(place))}(?![\w-])" for place in (source, build, working)))
    check(texts and not any(places.search(text) for text in texts.values()),
          "no file of the package names a directory of this machine")
    project = working / "own_law"
    shutil.copytree(source / "tests" / "own_law", project)
    if not (check_run(run("cmake", "-S", project, "-B", project / "build", "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                          f"-DCMAKE_PREFIX_PATH={prefix}"), "find_package(stickslip)")
            and check_run(run("cmake", "--build", project / "build"), "a program of its own is built")):
        return
    own_law = project / "build" / "own_law"
    check_run(run(own_law, project / "own_law.prm", cwd=working), "its law gives the closed form")
    negative = run(own_law, project / "own_law.prm", "--set", "Materials/foam/Shear modulus=-1", "--validate")
    check(negative.returncode == 1 and "Materials/foam/Shear modulus" in negative.stderr, "it refuses what its law refuses")
    unknown = run(prefix / "bin" / "stickslip", project / "own_law.prm", "--validate")
    check(unknown.returncode == 1 and "Blatz-Ko" in unknown.stderr, "the other program does not know it")


def check_debian_package():
    if not (shutil.which("dpkg-shlibdeps") and shutil.which("file")):
        print("skipped the Debian package: no dpkg-shlibdeps or no file (apt-get install dpkg-dev file)")
        return
    packages = working / "packages"
    if not check_run(run("cpack", "-G", "DEB", "-B", packages, cwd=build), "cpack -G DEB"):
        return
    package = next(packages.glob("*.deb"))
    depends = run("dpkg-deb", "--field", package, "Depends").stdout
    check("libdeal.ii" in depends and "openmpi" in depends, f"it depends on {depends[:60].strip()}...")
    check_run(run("dpkg-deb", "--extract", package, working / "extracted"), f"{package.name} is a package")
    check_run(run(working / "extracted" / "usr" / "bin" / "stickslip", "--version"), "its program runs")


source, build = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
working = fresh_directory(sys.argv[3]).resolve()
os.environ.pop("DESTDIR", None)
if check_run(run("cmake", "--install", build, "--prefix", working / "there"), "cmake --install"):
    moved = working / "elsewhere"
    (working / "there").rename(moved)
    check_program(moved)
    check_library(moved)
    check_debian_package()
sys.exit(1 if failures else 0)
