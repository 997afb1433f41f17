"""What the checks of the project's texts have in common: their command line."""
import pathlib
import sys


def run_check(documentation, violations, self_test):
    """`violations` of a root directory, or `self_test` with --self-test: both give messages; any is a failure."""
    if len(sys.argv) != 2:
        sys.exit(documentation)
    found = self_test() if sys.argv[1] == "--self-test" else list(violations(pathlib.Path(sys.argv[1])))
    for message in found:
        print(message)
    print(f"{len(found)} violations")
    sys.exit(1 if found else 0)
