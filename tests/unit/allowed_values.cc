// What a parameter may be, in words, for each kind of pattern: deal.II's
// descriptions of patterns are texts, and another version may write others.

#include <deal.II/base/patterns.h>

#include <stickslip/base/allowed_values.h>

#include <iostream>
#include <string>
#include <utility>
#include <vector>

using namespace dealii;
using namespace stickslip;

void
test(const std::string &declaration, const Patterns::PatternBase &pattern)
{
  const std::string description = pattern.description();
  std::cout << declaration << " -> " << allowed_values_of_pattern(description);
  for (const std::string &name : choices_of_pattern(description))
    std::cout << " [" << name << ']';
  std::cout << std::endl;
}

int
main()
{
  using namespace Patterns;
  test("Integer()", Integer());
  test("Integer(0)", Integer(0));
  test("Integer(-3)", Integer(-3));
  test("Integer(min, 7)", Integer(Integer::min_int_value, 7));
  test("Integer(2, 3)", Integer(2, 3));
  test("Integer(2, 2)", Integer(2, 2));

  test("Double()", Double());
  test("Double(0)", Double(0.));
  test("Double(1e-14, 0.1)", Double(1e-14, 0.1));
  test("Double(1e-6, 1e6)", Double(1e-6, 1e6));
  test("Double(min, -0.5)", Double(Double::min_double_value, -0.5));

  test("Bool()", Bool());
  test("Anything()", Anything());
  test("FileName()", FileName());
  test("DirectoryName()", DirectoryName());

  test("Selection(a)", Selection("a"));
  test("Selection(none|tangent modulus|r_n)",
       Selection("none|tangent modulus|r_n"));
  test("MultipleSelection(x|y)", MultipleSelection("x|y"));

  test("List(Double())", List(Double()));
  test("List(Integer(0), 1)", List(Integer(0), 1));
  test("List(Double(0), 1, 3)", List(Double(0.), 1, 3));
  test("List(Double(), 3, 3, ;)", List(Double(), 3, 3, ";"));
  test("List(Selection(x|y), 0, 2)", List(Selection("x|y"), 0, 2));
  test("List(List(Double(0), 2, 2), 1, 4, ;)",
       List(List(Double(0.), 2, 2), 1, 4, ";"));
  test("a table",
       *Tools::Convert<std::vector<std::pair<double, double>>>::to_pattern());
  test("Map(Anything, Double)", Map(Anything(), Double()));
}
