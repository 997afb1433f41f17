"""Every function template that a source file defines for others, and every
class template with members there, is instantiated in it. Files that are compiled
together find what one of them leaves out; by itself the file would not link.

    check_instantiations.py SOURCE_DIRECTORY     prints the violations; exit code 1 if there are any
    check_instantiations.py --self-test
"""
import pathlib
import re
import sys

ANONYMOUS = re.compile(r"^( *)namespace\n\1\{\n.*?^\1\} // namespace\n", re.MULTILINE | re.DOTALL)
DEFINITION = re.compile(r"^  template <(?:int|const int) \w+[^>]*>\n(?:  [^\n;{]*\n)*?  ([\w:<>, ]*?\b\w+)\(", re.MULTILINE)
INSTANTIATION = re.compile(r"^(?: *|#define \w+\(\w+\) )template (?!<)[^;]*", re.MULTILINE)


def violations(text):
    """Names that are defined as templates and not instantiated."""
    text = ANONYMOUS.sub("", text)
    instantiated = " ".join(INSTANTIATION.findall(text))
    names = []
    for defined in DEFINITION.findall(text):
        member = re.fullmatch(r"(?:.*\s)?(\w+)(<[^>]*>)?::~?\w+", defined, re.DOTALL)
        name = member[1] if member else defined.split()[-1]
        if member and (not member[2] or re.search(rf": {name}<", text)):
            continue  # a template in a class, or the base of a class of this file: used where it is
        if name not in names and not re.search(rf"\b{name}\b", instantiated):
            names.append(name)
    return names


SAMPLE = """namespace stickslip
{
  namespace
  {
    template <int dim>
    double
    own(const Point<dim> &p)
    {}
  } // namespace

  template <int dim>
  std::vector<double>
  seen(const Point<dim> &p)
  {}

  template <int dim>
  double
  forgotten(const Point<dim> &p)
  {}

  template <int dim>
  double
  Lost<dim>::member() const
  {}

  template <int dim>
  Known<dim>::Known(const int a)
  {}

#define INSTANTIATE(dim) \\
  template std::vector<double> seen( \\
    const Point<dim> &);
  INSTANTIATE(2)
  template class Known<2>;
}
"""


def main():
    if sys.argv[1:] == ["--self-test"]:
        found = violations(SAMPLE)
        print(found)
        sys.exit(found != ["forgotten", "Lost"])
    n = 0
    root = pathlib.Path(sys.argv[1])
    for path in sorted((root / "source").rglob("*.cc")):
        for name in violations(path.read_text()):
            print(f"{path.relative_to(root)}: {name} is not instantiated")
            n += 1
    print(f"{n} violations")
    sys.exit(n > 0)


if __name__ == "__main__":
    main()
