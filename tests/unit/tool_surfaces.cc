// Surfaces of rigid tools: projections, normals and curvatures against closed
// forms, derivatives against differences.

#include "expect_error.h"
#include "print.h"

#include <stickslip/base/user_error.h>

#include <stickslip/contact/surface/tool_surface.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

using namespace stickslip;

namespace
{
  using numbers::PI;

  template <int dim>
  Tensor<1, dim>
  unit_normal(const typename ToolSurface<dim>::Place &place)
  {
    Tensor<1, dim> n;
    if constexpr (dim == 2)
      n = Tensor<1, 2>({-place.a[0][1], place.a[0][0]});
    else
      n = cross_product_3d(place.a[0], place.a[1]);
    return place.orientation * n / n.norm();
  }



  /// Gaussian and mean curvature, 2D: zero and half the curvature; positive
  /// where the tool is convex.
  template <int dim>
  std::array<double, 2>
  curvatures(const typename ToolSurface<dim>::Place &place)
  {
    const Tensor<1, dim> n = unit_normal<dim>(place);
    Tensor<2, dim - 1>   metric, second;
    for (unsigned int d = 0; d < dim - 1; ++d)
      for (unsigned int e = 0; e < dim - 1; ++e)
        {
          metric[d][e] = place.a[d] * place.a[e];
          second[d][e] = n * place.x_ab[d][e];
        }
    return {{dim == 2 ? 0. : determinant(second) / determinant(metric),
             0.5 * trace(invert(metric) * second)}};
  }



  /// What the closest point of x has to be.
  struct Expected
  {
    double depth    = 0.; ///< in the tool
    double gaussian = 0.;
    double mean     = 0.;
  };



  template <int dim>
  using ClosedForm = std::function<Expected(const Point<dim> &)>;



  /// Largest deviations over points: of the gap and of its gradient, which is
  /// the normal; of the curvatures; of the derivatives from differences.
  template <int dim>
  void
  test(const std::string             &name,
       const ToolSurface<dim>        &surface,
       const std::vector<Point<dim>> &points,
       const ClosedForm<dim>         &expected)
  {
    double       gap = 0., normal = 0., curvature = 0., derivative = 0.;
    bool         found = true;
    const double h     = 1e-6;
    for (const auto &x : points)
      {
        const auto foot            = surface.closest(x);
        found                      = found && foot.found;
        const auto           place = surface.evaluate(foot.chart, foot.xi);
        const Tensor<1, dim> n     = unit_normal<dim>(place);
        const Tensor<1, dim> r     = x - place.x;
        const Expected       e     = expected(x);
        gap =
          std::max({gap, std::abs(r * n - e.depth), (r - (r * n) * n).norm()});
        for (unsigned int c = 0; c < dim; ++c)
          {
            Point<dim> forward = x, backward = x;
            forward[c] += h;
            backward[c] -= h;
            normal = std::max(normal,
                              std::abs(n[c] - (expected(forward).depth -
                                               expected(backward).depth) /
                                                (2. * h)));
          }
        const auto of_surface = curvatures<dim>(place);
        curvature             = std::max({curvature,
                                          std::abs(of_surface[0] - e.gaussian),
                                          std::abs(of_surface[1] - e.mean)});
        for (unsigned int d = 0; d < dim - 1; ++d)
          {
            Point<dim - 1> forward = foot.xi, backward = foot.xi;
            forward[d] += h;
            backward[d] -= h;
            const auto after  = surface.evaluate(foot.chart, forward);
            const auto before = surface.evaluate(foot.chart, backward);
            derivative =
              std::max(derivative,
                       (place.a[d] - (after.x - before.x) / (2. * h)).norm());
            for (unsigned int b = 0; b < dim - 1; ++b)
              derivative = std::max(derivative,
                                    (place.x_ab[b][d] -
                                     (after.a[b] - before.a[b]) / (2. * h))
                                      .norm());
          }
      }
    print(name + ": " + std::to_string(points.size()) + " points");
    print("  all have a partner", found);
    print("  gaps within 1e-12", gap < 1e-12);
    print("  normals are gradients of the gap", normal < 1e-8);
    print("  curvatures within 1e-10", curvature < 1e-10);
    print("  derivatives are those of differences", derivative < 1e-8);
  }



  /// Points all around the origin, at distances between @p from and @p to.
  std::vector<Point<3>>
  points_around(const double from, const double to)
  {
    std::vector<Point<3>> points;
    for (unsigned int i = 0; i < 60; ++i)
      {
        const double height = 1. - 2. * (i + 0.5) / 60., angle = 2.4 * i;
        const double radius = std::sqrt(1. - height * height);
        points.push_back(
          (from + (to - from) * ((7 * i) % 60) / 59.) *
          Point<3>(radius * std::cos(angle), radius * std::sin(angle), height));
      }
    return points;
  }



  std::vector<Point<2>>
  points_around_2d(const double from, const double to)
  {
    std::vector<Point<2>> points;
    for (unsigned int i = 0; i < 60; ++i)
      points.push_back(
        (from + (to - from) * ((7 * i) % 60) / 59.) *
        Point<2>(std::cos(0.1 + 2.4 * i), std::sin(0.1 + 2.4 * i)));
    return points;
  }



  void
  test_outlines()
  {
    for (const bool hollow : {false, true})
      {
        const Point<2> centre(0.1, -0.2);
        const double   sign = hollow ? -1. : 1.;
        test<2>(hollow ? "circle, hollow" : "circle",
                ToolSurface<2>(ToolProfile::circle(centre, 1.3, hollow)),
                points_around_2d(0.8, 2.),
                [=](const Point<2> &x) {
                  return Expected{sign * (1.3 - x.distance(centre)),
                                  0.,
                                  sign * 0.5 / 1.3};
                });
      }

    // Distances from a box with rounded corners: those from a smaller one.
    const double a = 1., fillet = 0.3;
    const auto   square = ToolProfile::polyline({{{-a, -a}, fillet},
                                                 {{a, -a}, fillet},
                                                 {{a, a}, fillet},
                                                 {{-a, a}, fillet}},
                                              true,
                                              "square");
    test<2>("square with fillets",
            ToolSurface<2>(square),
            points_around_2d(0.9, 3.),
            [=](const Point<2> &x) {
              const double in  = a - fillet;
              const double q_x = std::abs(x[0]) - in, q_y = std::abs(x[1]) - in;
              return Expected{fillet -
                                std::hypot(std::max(q_x, 0.),
                                           std::max(q_y, 0.)) -
                                std::min(std::max(q_x, q_y), 0.),
                              0.,
                              q_x > 0. && q_y > 0. ? 0.5 / fillet : 0.};
            });
    print("  its length is that of lines and arcs",
          std::abs(square.total_length() -
                   (8. * (a - fillet) + 2. * PI * fillet)) < 1e-14);

    // The tool is everything but a quadrant.
    std::vector<Point<2>> in_corner;
    for (unsigned int i = 1; i < 8; ++i)
      for (unsigned int j = 1; j < 8; ++j)
        if (i != j)
          in_corner.emplace_back(0.11 * i, 0.11 * j);
    test<2>(
      "corner with a fillet",
      ToolSurface<2>(ToolProfile::polyline(
        {{{2., 0.}, 0.}, {{0., 0.}, 0.5}, {{0., 2.}, 0.}}, false, "corner")),
      in_corner,
      [](const Point<2> &x) {
        if (x[0] > 0.5 || x[1] > 0.5)
          return Expected{-std::min(x[0], x[1]), 0., 0.};
        return Expected{x.distance(Point<2>(0.5, 0.5)) - 0.5, 0., -1.};
      });
  }



  void
  test_solids()
  {
    ToolSweep sweep;
    sweep.origin      = Point<3>(0.1, 0.2, -0.1);
    sweep.axis        = Tensor<1, 3>({1., 2., 2.}) / 3.;
    sweep.first       = Tensor<1, 3>({2., 1., -2.}) / 3.;
    const auto height = [sweep](const Point<3> &x) {
      return (x - sweep.origin) * sweep.axis;
    };
    const auto radius = [sweep, height](const Point<3> &x) {
      return ((x - sweep.origin) - height(x) * sweep.axis).norm();
    };

    for (const bool hollow : {false, true})
      {
        const double sign   = hollow ? -1. : 1.;
        auto         points = points_around(0.7, 1.9);
        points.push_back(sweep.origin + 1.3 * sweep.axis); // over the poles
        points.push_back(sweep.origin - 0.9 * sweep.axis);
        test<3>(hollow ? "sphere, hollow" : "sphere",
                ToolSurface<3>(ToolProfile::half_circle({0., 0.}, 1.1, hollow),
                               sweep,
                               "sphere"),
                points,
                [=](const Point<3> &x) {
                  return Expected{sign * (1.1 - x.distance(sweep.origin)),
                                  1. / (1.1 * 1.1),
                                  sign / 1.1};
                });
        const auto torus_form = [=](const Point<3> &x) {
          const double from_ring = std::hypot(radius(x) - 1.4, height(x));
          const double cosine    = (radius(x) - 1.4) / from_ring;
          const double around    = cosine / (1.4 + 0.5 * cosine);
          return Expected{sign * (0.5 - from_ring),
                          around / 0.5,
                          sign * 0.5 * (1. / 0.5 + around)};
        };
        test<3>(hollow ? "torus, hollow" : "torus",
                ToolSurface<3>(ToolProfile::circle({1.4, 0.}, 0.5, hollow),
                               sweep,
                               "torus"),
                points_around(0.5, 2.5),
                torus_form);
      }

    sweep.kind = ToolSweep::Kind::extruded;
    test<3>("cylinder",
            ToolSurface<3>(ToolProfile::circle({0., 0.}, 0.6, false),
                           sweep,
                           "cylinder"),
            points_around(0.5, 2.),
            [=](const Point<3> &x) {
              return Expected{0.6 - radius(x), 0., 0.5 / 0.6};
            });
    test<3>("plane",
            ToolSurface<3>(
              ToolProfile::polyline({{{-9., 0.}}, {{9., 0.}}}, false, "plane"),
              sweep,
              "plane"),
            points_around(0.1, 2.),
            [=](const Point<3> &x) {
              return Expected{(x - sweep.origin) *
                                cross_product_3d(sweep.axis, sweep.first),
                              0.,
                              0.};
            });

    // A cone that opens upwards with a ball at its tip: half angle 0.4.
    sweep.kind         = ToolSweep::Kind::revolved;
    const double angle = 0.4, ball = 0.2, c = std::cos(angle),
                 s = std::sin(angle);
    const ToolSurface<3>  cone(ToolProfile::polyline({{{0., 0.}, ball},
                                                      {{6. * s, 6. * c}}},
                                                    false,
                                                    "cone"),
                              sweep,
                              "cone");
    std::vector<Point<3>> around_cone;
    for (const auto &x : points_around(0.2, 1.5))
      if (height(x) < 0. || radius(x) > 0.2)
        around_cone.push_back(x);
    around_cone.push_back(sweep.origin - 0.3 * sweep.axis);
    test<3>("cone with a round tip", cone, around_cone, [=](const Point<3> &x) {
      const double r = radius(x), h = height(x);
      const double up = h - ball / s; // over the centre of the ball
      if (up * c + r * s < 0.)
        return Expected{ball - std::hypot(r, up),
                        1. / (ball * ball),
                        1. / ball};
      const double along = r * s + h * c; // from the tip to the foot
      return Expected{h * s - r * c, 0., 0.5 * c / (along * s)};
    });
    ToolSweep      flat  = sweep;
    const Point<3> below = sweep.origin + 0.3 * sweep.first - sweep.axis;
    test<3>("punch with a flat face",
            ToolSurface<3>(
              ToolProfile::polyline({{{0., 0.}}, {{1., 0.}, 0.3}, {{1., 2.}}},
                                    false,
                                    "punch"),
              flat,
              "punch"),
            {below,
             sweep.origin - 0.2 * sweep.axis,
             below + 0.2 * sweep.axis,
             sweep.origin + 1.3 * sweep.first + 0.1 * sweep.axis,
             sweep.origin + 1.3 * sweep.first + 0.9 * sweep.axis},
            [=](const Point<3> &x) {
              const double r = radius(x), h = height(x);
              if (r < 0.7)
                return Expected{h, 0., 0.};
              if (h > 0.3)
                return Expected{1. - r, 0., 0.5};
              const double d      = std::hypot(r - 0.7, h - 0.3);
              const double cosine = (r - 0.7) / d;
              const double around = cosine / (0.7 + 0.3 * cosine);
              return Expected{0.3 - d, around / 0.3, 0.5 * (1. / 0.3 + around)};
            });
  }



  /// What lies beyond an end has no partner; what is at the end has one.
  void
  test_ends()
  {
    print("Ends");
    const auto line =
      ToolProfile::polyline({{{0., 0.}}, {{1., 0.}}}, false, "");
    const ToolSurface<2> edge(line);
    print("  at the end", edge.closest({1., 0.4}).found);
    print("  by roundoff behind it", edge.closest({1. + 1e-12, -0.4}).found);
    print("  none beyond it", !edge.closest({1.01, 0.4}).found);
    print("  none before the beginning", !edge.closest({-0.01, 0.4}).found);
    ToolSweep sweep;
    sweep.kind = ToolSweep::Kind::extruded;
    sweep.from = -1.;
    sweep.to   = 2.;
    const ToolSurface<3> cylinder(ToolProfile::circle({0., 0.}, 1., false),
                                  sweep,
                                  "");
    print("  at the end of a cylinder", cylinder.closest({1.2, 0., 2.}).found);
    print("  none beyond it", !cylinder.closest({1.2, 0., 2.01}).found);
    print("  none before it", !cylinder.closest({1.2, 0., -1.01}).found);
    print("  none on its axis", !cylinder.closest({0., 0., 1.}).found);
    // a groove around the axis
    sweep.kind = ToolSweep::Kind::revolved;
    const ToolSurface<3> groove(
      ToolProfile::polyline({{{2., -2.}}, {{1., -1.}, 1.}, {{2., 0.}}},
                            false,
                            ""),
      sweep,
      "");
    print("  none on the axis of a ring", !groove.closest({0., 0., -1.}).found);
    print("  but beside it", groove.closest({1e-3, 0., -1.}).found);
  }



  void
  test_errors()
  {
    print("Errors");
    const auto line = [](const std::vector<ProfileVertex> &vertices,
                         const bool                        closed = false) {
      expect_error([&] { ToolProfile::polyline(vertices, closed, "Profile"); });
    };
    line({{{0., 0.}}, {{1., 0.}}, {{1., 1.}}});
    line({{{0., 0.}}, {{1., 0.}, 0.7}, {{1., 1.}, 0.7}, {{2., 1.}}});
    line({{{0., 0.}}, {{0., 0.}, 0.1}, {{1., 1.}}});
    line({{{0., 0.}}, {{1., 0.}, 0.1}, {{0., 0.}}});
    line({{{0., 0.}}});
    line({{{0., 0.}, 1.}, {{1., 0.}, 1.}}, true);
    line({{{1., 0.}, 0.1}, {{2., 1.}}});
    expect_error([] {
      ToolSurface<3>(ToolProfile::circle({0.5, 0.}, 0.6, false), {}, "Sweep");
    });
    ToolSweep parallel;
    parallel.first = parallel.axis;
    expect_error([&] {
      ToolSurface<3>(ToolProfile::circle({2., 0.}, 0.6, false),
                     parallel,
                     "Sweep");
    });
    ToolSweep without;
    without.axis = Tensor<1, 3>();
    expect_error([&] {
      ToolSurface<3>(ToolProfile::circle({2., 0.}, 0.6, false),
                     without,
                     "Sweep");
    });
  }
} // namespace



int
main(int argc, char *argv[])
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_outlines();
  test_solids();
  test_ends();
  test_errors();
}
