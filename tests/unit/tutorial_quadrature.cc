// A contact quadrature: what a rule has to fulfil. The manual shows these
// functions (doc/developers.md).

#include <stickslip/base/user_error.h>

#include <stickslip/contact/surface/contact_quadrature.h>

#include <deal.II/base/quadrature_lib.h>

#include <cmath>
#include <iostream>
#include <string>

using namespace stickslip;

namespace
{
  // [rule]
  /// Midpoints of @p n equal intervals per direction.
  template <int facedim>
  Quadrature<facedim>
  midpoints(const unsigned int n)
  {
    return QIterated<facedim>(QMidpoint<1>(), n);
  }
  // [end of rule]



  // [check]
  /// A law at points without weight would hold nowhere, and forces need the
  /// area of the face and the mean of linear pressures.
  template <int facedim>
  bool
  is_a_contact_rule(const Quadrature<facedim> &rule)
  {
    double area = 0., mean = 0.;
    for (unsigned int q = 0; q < rule.size(); ++q)
      {
        if (!(rule.weight(q) > 0.))
          return false;
        area += rule.weight(q);
        mean += rule.weight(q) * rule.point(q)[0];
      }
    return std::abs(area - 1.) < 1e-12 && std::abs(mean - 0.5) < 1e-12;
  }
  // [end of check]



  template <int facedim>
  void
  test(const unsigned int n)
  {
    std::cout << facedim << "D faces, " << n << " per direction: "
              << (is_a_contact_rule(midpoints<facedim>(n)) ? "a rule" : "NO")
              << ", ";
    try
      {
        check_multipliers_are_determined(midpoints<facedim>(n),
                                         FaceShape<facedim + 1>(1),
                                         "Contact/pair");
        std::cout << "enough points\n";
      }
    catch (const UserError &error)
      {
        std::cout << error.what() << '\n';
      }
  }
} // namespace



int
main()
{
  for (const unsigned int n : {1, 2, 5})
    {
      test<1>(n);
      test<2>(n);
    }
  std::cout << "negative weights: "
            << (is_a_contact_rule(
                  Quadrature<1>({Point<1>(0.), Point<1>(0.5), Point<1>(1.)},
                                {0.75, -0.5, 0.75}))
                  ? "ACCEPTED"
                  : "refused")
            << '\n';
}
