"""Every class has a name of its own. Two of one name in two headers, or outside of
unnamed namespaces of two source files, compile and link as if they were one: the
program then runs the functions of either for both.

    check_names.py SOURCE_DIRECTORY     prints the violations; exit code 1 if there are any
    check_names.py --self-test
"""
import pathlib
import re
import sys

from check_instantiations import ANONYMOUS

# A definition in the namespace stickslip itself: indented by two.
DEFINITION = re.compile(r"^  (?:struct|class) (\w+)(?: final)?(?:\s*:(?!:)[^;{]*)?\s*\{", re.MULTILINE)


def violations(files):
    """Of {name of the file: text}."""
    places = {}
    for path, text in sorted(files.items()):
        for name in DEFINITION.findall(ANONYMOUS.sub("", text)):
            places.setdefault(name, []).append(path)
    return [f"{name} is defined in {' and '.join(paths)}" for name, paths in places.items() if len(set(paths)) > 1]


SAMPLE = """namespace stickslip
{
  namespace
  {
    struct Own
    {};
  } // namespace

  template <int dim>
  struct Shared : Base<dim>
  {};

  struct Declared;
}
"""


def self_test():
    found = violations({"a.h": SAMPLE, "b.cc": SAMPLE})
    assert found == ["Shared is defined in a.h and b.cc"], found
    assert not violations({"a.h": SAMPLE}), "one file"
    print("self-test: good")


if __name__ == "__main__":
    if sys.argv[1:] == ["--self-test"]:
        self_test()
        sys.exit(0)
    root = pathlib.Path(sys.argv[1])
    found = violations({str(path.relative_to(root)): path.read_text()
                        for folder in ("include", "source") for path in (root / folder).rglob("*") if path.suffix in (".h", ".cc")})
    print("\n".join(found + [f"{len(found)} violations"]))
    sys.exit(1 if found else 0)
