// The rounded corners of the contact law: their derivatives against
// differences, what they become where the width vanishes, that nothing is lost
// in roundoff far from the corner; and the increment of Lambda that follows
// from the linearized friction force.

#include <stickslip/contact/assembly/linearized_friction.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>
#include <vector>

using namespace stickslip;

namespace
{
  void
  print(const std::string &text, const bool holds)
  {
    std::cout << text << ": " << (holds ? "yes" : "NO") << std::endl;
  }



  void
  test_negative_part()
  {
    const double h           = 1e-6;
    double       slope_error = 0., corner_error = 0., product_error = 0.;
    for (const double width : {1e-3, 0.1, 10.})
      for (const double g : {-50., -1., -1e-3, 0., 1e-4, 0.3, 40.})
        {
          const auto [value, slope] = negative_part(g, g <= 0., width);
          slope_error =
            std::max(slope_error,
                     std::abs((negative_part(g + h, false, width).value -
                               negative_part(g - h, false, width).value) /
                                (2. * h) -
                              slope));
          // at most half a width below the corner
          corner_error = std::max({corner_error,
                                   value - std::min(g, 0.),
                                   std::min(g, 0.) - 0.5 * width - value});
          // lambda = value, r d = value - g: a fourth of the squared width
          product_error =
            std::max(product_error,
                     std::abs(value * negative_part(-g, false, width).value /
                                (0.25 * width * width) -
                              1.));
        }
    print("min(g, 0): slope", slope_error < 1e-6);
    print("  between the corner and half a width below it",
          corner_error < 1e-15);
    print("  pressure times gap is a fourth of the squared width",
          product_error < 1e-12);
    const auto sharp = negative_part(-2., true, 0.);
    print("  sharp",
          sharp.value == -2. && sharp.slope == 1. &&
            negative_part(-2., false, 0.).value == 0. &&
            negative_part(3., true, 0.).value == 3.);
  }



  template <int dim>
  void
  test_disc()
  {
    const double h           = 1e-6;
    double       slope_error = 0., longest = 0., sharp_error = 0.;
    for (const double width : {1e-2, 1., 30.})
      for (const double length : {0., 1e-14, 0.3, 0.999, 1., 1.2, 50.})
        {
          Tensor<1, dim> g;
          g[0]           = 0.8 * length;
          g[dim - 1]     = -0.6 * length;
          const auto now = disc_projection(g, false, width);
          longest        = std::max(longest, now.T.norm());
          for (unsigned int d = 0; d < dim; ++d)
            {
              Tensor<1, dim> step;
              step[d] = h;
              const Tensor<1, dim> slope =
                (disc_projection(g + step, false, width).T -
                 disc_projection(g - step, false, width).T) /
                (2. * h);
              slope_error =
                std::max(slope_error,
                         (slope - now.derivative * (step / h)).norm());
            }
          const auto sharp = disc_projection(g, length <= 1., 0.);
          sharp_error =
            std::max(sharp_error,
                     (disc_projection(g, false, 1e-9).T - sharp.T).norm());
        }
    std::cout << dim << "D, ";
    print("projection on the disc: slope", slope_error < 1e-5);
    print("  never longer than one", longest < 1.);
    print("  sharp where the width vanishes", sharp_error < 1e-8);
  }



  /// A node with the force s0 T0; the increments change pressure and Lambda by
  /// factors.
  void
  test_linearized_friction()
  {
    const double          mu = 0.5, weight = 0.7;
    LinearizedFriction<2> friction;
    IndexSet              owned(4);
    owned.add_range(0, 4);
    friction.reinit(owned, MPI_COMM_SELF);
    ContactPoint<2> point;
    point.geometry.weight = weight;
    ContactEvaluation<2> state;
    state.response.threshold             = mu * 0.01;
    state.response.friction_direction[0] = 0.4;
    state.kinematics.tau[0][0]           = 1.;
    Tensor<2, 1> turned;
    turned[0][0] = -1.;
    friction.add_point(0, mu, point, turned, state);
    friction.compress();

    const std::vector<MultiplierNode> nodes = {{0, 0, 0}, {0, 0, 2}};
    LA::Vector multipliers(owned, MPI_COMM_SELF), increment(multipliers);
    // the node's Lambda has the other sign
    multipliers(0) = -0.01;
    multipliers(1) = -0.3;
    increment(0)   = -7.99;
    increment(1)   = -500.;
    increment(2) = increment(3) = 5.;
    const double s0 = mu * 0.01, T0 = -0.4, s = mu * 8.;
    const double linearized = s0 * (-500.3) + T0 * (s - s0);
    friction.convert_increment(nodes, multipliers, increment);
    print("linearized friction: the force is that of the linear solve",
          std::abs(s * (multipliers(1) + increment(1)) - linearized) < 1e-12);
    print("  a node without friction is left alone", increment(3) == 5.);
    increment(0) = 1.;
    increment(1) = 2.;
    friction.convert_increment(nodes, multipliers, increment);
    print("  and one that opens", increment(1) == 2.);
  }
} // namespace



int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_negative_part();
  test_disc<2>();
  test_disc<3>();
  test_linearized_friction();
}
