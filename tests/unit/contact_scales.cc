// The six regularization parameters of contact points, and the directions along
// which constraints leave them no slip, against numbers made by hand: k = 1 /
// (1/10 + 2/40) = 20/3, friction coefficient 0.5, faces of length 1.

#include "planted_contact.h"

#include <stickslip/contact/assembly/contact_scales.h>

#include <cmath>
#include <iostream>
#include <map>
#include <string>

using namespace stickslip;

namespace
{
  const std::string coulomb =
    "set Friction = Coulomb\nset Friction coefficient = 0.5\n";



  /// The six, r_n first, at each x where there are points.
  void
  print_scales(const std::string &title, PlantedContact &contact)
  {
    std::cout << title << '\n';
    std::map<double, const ContactPoint<2> *> at;
    for (const auto &point : contact.points())
      at.emplace(point.geometry.reference_position[0], &point);
    for (const auto &[x, point] : at)
      {
        const Regularization &r = point->regularization;
        std::cout << "  x = " << x << ": k "
                  << contact_stiffness(contact.pair(), *point) << ", r_n "
                  << r.r_n_status << ' ' << r.r_n_augmentation << ' '
                  << r.r_n_law << ", r_t " << r.r_t_status << ' '
                  << r.r_t_augmentation << ' ' << r.r_t_law
                  << ", stick before the first pressure "
                  << point->scales.initial_stick << '\n';
      }
  }



  std::string
  regularization(const std::string &text)
  {
    return "subsection Regularization\n" + text + "end\n";
  }



  /// Pressures 8, 0.04, 0; open.
  double
  falling(const double x)
  {
    return x < 0.5 ? -8. : x < 1.5 ? -0.04 : x < 2.5 ? 0. : 1.;
  }



  void
  test_scales()
  {
    const std::string nodal = "set Quadrature = nodal\n" + coulomb;
    {
      // s = 0.5 x 1e-3 x k: the strain that is expected
      PlantedContact contact(two_blocks(nodal));
      print_scales("automatic, no pressure yet: k/s = 2000", contact);
      // a strain of 1e-12 is 3.3e-12
      contact.press([](const double) { return -6e-12; });
      print_scales("pressures of roundoff: the same", contact);
      // s = 4, 0.02; at least a hundredth of the largest
      contact.press(falling);
      print_scales("s = 4, then 0.04: k/s = 5/3, 500/3", contact);
    }
    {
      PlantedContact contact(two_blocks(nodal, "", 2));
      print_scales("without a partner at x = 3: k = 10 there", contact);
    }
    {
      PlantedContact contact(two_blocks(
        "set Quadrature = Gauss\nset Quadrature order = 2\n" + coulomb));
      contact.press([](const double) { return -8.; });
      print_scales("Gauss, s = 4: k/100 and k/s/4", contact);
    }
    {
      PlantedContact contact(
        two_blocks("set Quadrature = nodal\nset Friction = Tresca\n"
                   "set Tresca threshold = 2\n"));
      print_scales("Tresca, s = 2, no pressure: k/s = 10/3", contact);
    }
    {
      PlantedContact contact(
        two_blocks(nodal + regularization("set Scale = bound\n")));
      contact.press(falling);
      print_scales("bound: 100 M = 1000, 10 mu M = 50", contact);
    }
    {
      PlantedContact contact(two_blocks(
        nodal + regularization("set Scale = plain\nset r_n = 7\nset r_t = 9\n"
                               "set r_n status = 1\nset r_n augmentation = 2\n"
                               "set r_t augmentation = 5\nset r_t law = 6\n")));
      contact.press(falling);
      print_scales("plain: 1 2 7, 9 5 6", contact);
    }
    {
      PlantedContact contact(
        two_blocks(nodal + regularization("set r_n = 3\nset r_t law = 0.5\n")));
      contact.press([](const double) { return -8.; });
      print_scales("factors 3 and, of one, 1/2", contact);
    }
    {
      // open or closed by lambda_n + 100 x 0.06, Coulomb's threshold from
      // lambda_n + k 0.06: at x = 1 open, although the threshold would be 2
      PlantedContact contact(two_blocks(
        nodal + "set Gap offset = 0.06\n" +
        regularization("set r_n status = 15\nset r_n augmentation = 1\n")));
      contact.press([](const double x) { return x < 0.5 ? -8.4 : -4.4; });
      print_scales("s = 4; open with a gap: not 2, k/s = 5/3, 500/3", contact);
    }
  }



  std::string
  prescribe(const std::string &body,
            const std::string &boundary,
            const std::string &value)
  {
    return "subsection " + body + "\nset Body = " + body +
           "\nset Boundary = " + boundary + "\nset Value = " + value +
           "\nend\n";
  }



  void
  print_directions(const std::string &title,
                   const std::string &boundary_conditions)
  {
    PlantedContact contact(
      two_blocks("set Quadrature = nodal\n" + coulomb, boundary_conditions));
    contact.press([](const double) { return -1.; });
    std::map<double, std::string> at;
    for (const auto &point : contact.points())
      {
        std::string text;
        for (const auto &t : point.restrained.directions)
          text += std::abs(t[0]) > 1. - 1e-12 ? " x" : " other";
        at[point.geometry.reference_position[0]] =
          text.empty() ? " none" : text;
      }
    std::cout << "  " << title << ':';
    for (const auto &[x, text] : at)
      std::cout << text;
    std::cout << '\n';
  }



  void
  test_restrained_directions()
  {
    std::cout << "Restrained directions at x = 0, 1, 2, 3\n";
    print_directions("no constraints", "");
    print_directions("one body only", prescribe("upper", "0", "0; free"));
    print_directions("symmetry plane x = 0",
                     prescribe("upper", "0", "0; free") +
                       prescribe("lower", "0", "0; free"));
    print_directions("the plane moves with both bodies",
                     prescribe("upper", "0", "0.1; free") +
                       prescribe("lower", "0", "0.1; free"));
    print_directions("one moves against the other",
                     prescribe("upper", "0", "0.1; free") +
                       prescribe("lower", "0", "0; free"));
    print_directions("normal to the contact",
                     prescribe("upper", "0", "free; 0") +
                       prescribe("lower", "0", "free; 0"));
    print_directions("u_x = 0 on the surfaces",
                     prescribe("upper", "2", "0; free") +
                       prescribe("lower", "3", "0; free"));
  }
} // namespace



int
main(int argc, char *argv[])
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_scales();
  test_restrained_directions();
}
