// Tools with names: depths of points against closed forms, where they end, and
// the areas of their pictures.

#include "expect_error.h"
#include "print.h"

#include <stickslip/base/user_error.h>

#include <stickslip/contact/surface/tool_shapes.h>
#include <stickslip/contact/surface/tool_tessellation.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

using namespace stickslip;

namespace
{
  using numbers::PI;

  /// How deep x is in the tool; -1000: it has no partner.
  template <int dim>
  double
  depth(const ToolSurface<dim> &surface, const Point<dim> &x)
  {
    const auto foot = surface.closest(x);
    if (!foot.found)
      return -1000.;
    const auto     place = surface.evaluate(foot.chart, foot.xi);
    Tensor<1, dim> n;
    if constexpr (dim == 2)
      n = Tensor<1, 2>({-place.a[0][1], place.a[0][0]});
    else
      n = cross_product_3d(place.a[0], place.a[1]);
    return (x - place.x) * n * place.orientation / n.norm();
  }



  template <int dim>
  void
  test_depth(const std::string      &name,
             const ToolSurface<dim> &surface,
             const Point<dim>       &x,
             const double            expected)
  {
    print("  " + name, std::abs(depth(surface, x) - expected) < 1e-12);
  }



  template <int dim>
  void
  test_end(const std::string      &name,
           const ToolSurface<dim> &surface,
           const Point<dim>       &x)
  {
    print("  nothing " + name, depth(surface, x) == -1000.);
  }



  /// Area of the picture (2D: length) over that of the surface, which flat
  /// cells approach from below with the square of their size, and whether its
  /// points lie on the surface.
  template <int dim>
  void
  test_picture(const ToolSurface<dim> &surface, const double area)
  {
    double coarse = 0., fine = 0., off = 0.;
    for (const unsigned int n : {60, 120})
      {
        const auto picture = tessellate(surface, n);
        double     sum     = 0.;
        for (const auto &cell : picture.cells)
          {
            const auto edge = [&](const unsigned int from,
                                  const unsigned int to) {
              return picture.points[cell[to]] - picture.points[cell[from]];
            };
            if constexpr (dim == 2)
              sum += edge(0, 1).norm();
            else
              sum += 0.5 * cross_product_3d(edge(0, 2), edge(1, 3)).norm();
          }
        for (const auto &point : picture.points)
          if (depth(surface, point) != -1000.)
            off = std::max(off, std::abs(depth(surface, point)));
        coarse = fine;
        fine   = sum;
      }
    const double error = std::abs(fine / area - 1.);
    print("  its picture lies on it", off < 1e-12);
    print("  and has its area",
          error < 1e-3 && error < 0.3 * std::abs(coarse / area - 1.) + 1e-14);
  }



  void
  test_plane_shapes()
  {
    const Point<2>     at(1., 2.);
    const Tensor<1, 2> outward({0., 3.});
    print("Plane, 2D");
    const auto line = make_plane<2>(at, outward, 4., "");
    test_depth("outside", line, {2., 2.5}, -0.5);
    test_depth("inside", line, {0., 1.9}, 0.1);
    test_end("beyond its end", line, {3.1, 1.9});
    test_picture(line, 4.);
    print("Circle");
    const auto shaft = make_circle(at, 0.5, ToolSide::inside, "");
    test_depth("inside", shaft, {1.3, 2.4}, 0.);
    test_depth("outside", shaft, {1.6, 2.8}, -0.5);
    test_picture(shaft, PI);
    const auto bush = make_circle(at, 0.5, ToolSide::around, "");
    test_depth("in a bush", bush, {1., 2.2}, -0.3);
    test_depth("in its wall", bush, {1.6, 2.8}, 0.5);
  }



  void
  test_solid_shapes()
  {
    const Point<3>     at(1., 2., 3.);
    const Tensor<1, 3> axis({0., 2., 0.});
    const auto         place =
      [&](const double radius, const double height, const double angle) {
        return at +
               Tensor<1, 3>(
                 {radius * std::cos(angle), height, radius * std::sin(angle)});
      };
    print("Plane");
    const auto plane = make_plane<3>(at, axis, 4., "");
    test_depth("outside", plane, at + Tensor<1, 3>({1., 0.5, 1.}), -0.5);
    test_depth("inside", plane, at + Tensor<1, 3>({-1., -0.1, 0.}), 0.1);
    test_end("beyond one edge", plane, at + Tensor<1, 3>({2.1, -0.1, 0.}));
    test_end("beyond another", plane, at + Tensor<1, 3>({0., -0.1, -2.1}));
    test_picture(plane, 16.);

    print("Cylinder");
    const auto shaft = make_cylinder(at, axis, 0.5, 2., ToolSide::inside, "");
    test_depth("inside", shaft, place(0.3, 0.9, 1.), 0.2);
    test_depth("outside", shaft, place(0.7, -0.9, 4.), -0.2);
    test_end("beyond its end", shaft, place(0.3, 1.1, 2.));
    test_picture(shaft, 2. * PI * 0.5 * 2.);
    const auto bush = make_cylinder(at, axis, 0.5, 2., ToolSide::around, "");
    test_depth("in a bush", bush, place(0.3, 0.9, 1.), -0.2);
    test_depth("in its wall", bush, place(0.7, -0.9, 4.), 0.2);

    print("Rounded cylinder");
    const auto punch = make_rounded_cylinder(at, axis, 0.5, 2., 0.1, "");
    test_depth("below it", punch, place(0.2, -1.3, 5.), -0.3);
    test_depth("above it, on the axis", punch, place(0., 1.2, 0.), -0.2);
    test_depth("over its edge",
               punch,
               place(0.7, 1.3, 5.),
               0.1 - std::hypot(0.3, 0.4));
    test_depth("beside it", punch, place(0.6, 0.3, 3.), -0.1);
    test_depth("inside", punch, place(0.45, 0.3, 3.), 0.05);
    // two ends, the side, two quarters of a torus
    test_picture(punch,
                 2. * PI * 0.4 * 0.4 + 2. * PI * 0.5 * 1.8 +
                   2. * (PI * PI * 0.1 * 0.4 + 2. * PI * 0.1 * 0.1));

    print("Sphere");
    const auto ball = make_sphere(at, 0.5, ToolSide::inside, "");
    test_depth("inside", ball, place(0.3, 0.1, 1.), 0.5 - std::sqrt(0.1));
    test_depth("over its pole", ball, at + Tensor<1, 3>({0., 0., 0.7}), -0.2);
    test_picture(ball, PI);
    const auto socket = make_sphere(at, 0.5, ToolSide::around, "");
    test_depth("in a socket", socket, place(0.3, 0.4, 2.), 0.);
    test_depth("in its wall", socket, place(0., -0.8, 2.), 0.3);

    print("Cone");
    const auto   cone    = make_cone(at, axis, 45., 2., 0.1, "");
    const double to_ball = 0.1 * std::sqrt(2.); // from the sharp tip
    test_depth("inside", cone, place(0.4, 0.6, 1.), 0.1 * std::sqrt(2.));
    test_depth("outside", cone, place(0.6, 0.4, 1.), -0.1 * std::sqrt(2.));
    test_depth("at its tip", cone, place(0., -0.2, 0.), -0.1 - to_ball);
    test_end("beyond its end", cone, place(2.1, 2.2, 1.));
    // without the tip, with its cap
    const double removed = 0.1; // length of the line up to the ball
    test_picture(cone,
                 PI * (8. - removed * removed) / std::sqrt(2.) +
                   2. * PI * 0.1 * 0.1 * (1. - std::sqrt(0.5)));

    print("Torus");
    const auto ring = make_torus(at, axis, 0.6, 0.2, ToolSide::inside, "");
    test_depth("inside", ring, place(0.7, 0., 1.), 0.1);
    test_depth("outside", ring, place(0.9, 0.4, 1.), -0.3);
    test_depth("through its hole", ring, place(0.1, 0., 4.), -0.3);
    test_picture(ring, 4. * PI * PI * 0.6 * 0.2);
    const auto groove = make_torus(at, axis, 0.6, 0.2, ToolSide::around, "");
    test_depth("in a groove", groove, place(0.7, 0., 1.), -0.1);
  }



  void
  test_errors()
  {
    print("Errors");
    const Tensor<1, 3> axis({0., 0., 1.});
    expect_error([] { make_circle({}, 0., ToolSide::inside, "Radius"); });
    expect_error(
      [] { make_plane<2>({}, Tensor<1, 2>(), 1., "Outward direction"); });
    expect_error([&] { make_plane<3>({}, axis, -1., "Size"); });
    expect_error([&] {
      make_cylinder({}, Tensor<1, 3>(), 1., 1., ToolSide::inside, "Axis");
    });
    expect_error(
      [&] { make_rounded_cylinder({}, axis, 1., 1., 0.6, "Edge radius"); });
    expect_error([&] { make_cone({}, axis, 95., 1., 0.1, "Half angle"); });
    expect_error([&] { make_cone({}, axis, 45., 1., 2., "Tip radius"); });
    expect_error(
      [&] { make_torus({}, axis, 1., 1.2, ToolSide::inside, "Tube radius"); });
  }
} // namespace



int
main(int argc, char *argv[])
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_plane_shapes();
  test_solid_shapes();
  test_errors();
}
