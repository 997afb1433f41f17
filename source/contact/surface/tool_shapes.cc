#include <stickslip/contact/surface/tool_shapes.h>

#include <stickslip/base/axes_across.h>
#include <stickslip/base/user_error.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace stickslip
{
  namespace
  {
    void
    check_positive(const double       value,
                   const std::string &what,
                   const std::string &path)
    {
      if (!(value > 0.) || !std::isfinite(value))
        throw UserError(path + ": the " + what + " of the tool is " +
                        std::to_string(value) + ", but has to be positive.");
    }



    void
    check_at_most(const double       value,
                  const double       bound,
                  const std::string &what,
                  const std::string &path)
    {
      if (value > bound)
        throw UserError(path + ": the " + what + " of the tool is " +
                        std::to_string(value) + ", but may be " +
                        std::to_string(bound) + " at most.");
    }



    ToolSweep
    around_axis(const Point<3> &origin, const Tensor<1, 3> &axis)
    {
      ToolSweep sweep;
      sweep.origin = origin;
      sweep.axis   = axis;
      sweep.first  = axes_across(axis)[0];
      return sweep;
    }



    ToolProfile
    segment_between(const Point<2>    &from,
                    const Point<2>    &to,
                    const std::string &path)
    {
      return ToolProfile::polyline({{from, 0.}, {to, 0.}}, false, path);
    }
  } // namespace



  template <int dim>
  ToolSurface<dim>
  make_plane(const Point<dim>     &centre,
             const Tensor<1, dim> &outward,
             const double          size,
             const std::string    &path)
  {
    check_positive(size, "size", path);
    check_positive(outward.norm(), "outward direction's length", path);
    if constexpr (dim == 2)
      {
        // with the tool on the left
        const Tensor<1, 2> along =
          0.5 * size / outward.norm() * Tensor<1, 2>({-outward[1], outward[0]});
        return ToolSurface<2>(
          segment_between(centre - along, centre + along, path));
      }
    else
      {
        // so that axis x first is into the tool
        ToolSweep sweep;
        sweep.kind   = ToolSweep::Kind::extruded;
        sweep.origin = centre;
        sweep.first  = axes_across(outward)[0];
        sweep.axis   = cross_product_3d(outward, sweep.first);
        sweep.from   = -0.5 * size;
        sweep.to     = 0.5 * size;
        return ToolSurface<3>(segment_between(Point<2>(-0.5 * size, 0.),
                                              Point<2>(0.5 * size, 0.),
                                              path),
                              sweep,
                              path);
      }
  }



  ToolSurface<2>
  make_circle(const Point<2>    &centre,
              const double       radius,
              const ToolSide     side,
              const std::string &path)
  {
    check_positive(radius, "radius", path);
    return ToolSurface<2>(
      ToolProfile::circle(centre, radius, side == ToolSide::around));
  }



  ToolSurface<3>
  make_cylinder(const Point<3>     &centre,
                const Tensor<1, 3> &axis,
                const double        radius,
                const double        length,
                const ToolSide      side,
                const std::string  &path)
  {
    check_positive(radius, "radius", path);
    check_positive(length, "length", path);
    const Point<2> below(radius, -0.5 * length), above(radius, 0.5 * length);
    return ToolSurface<3>(side == ToolSide::inside
                            ? segment_between(below, above, path)
                            : segment_between(above, below, path),
                          around_axis(centre, axis),
                          path);
  }



  ToolSurface<3>
  make_rounded_cylinder(const Point<3>     &centre,
                        const Tensor<1, 3> &axis,
                        const double        radius,
                        const double        length,
                        const double        edge_radius,
                        const std::string  &path)
  {
    check_positive(radius, "radius", path);
    check_positive(length, "length", path);
    check_positive(edge_radius, "edge radius", path);
    check_at_most(edge_radius,
                  std::min(radius, 0.5 * length),
                  "edge radius",
                  path);
    const double half = 0.5 * length;
    return ToolSurface<3>(
      ToolProfile::polyline({{Point<2>(0., -half), 0.},
                             {Point<2>(radius, -half), edge_radius},
                             {Point<2>(radius, half), edge_radius},
                             {Point<2>(0., half), 0.}},
                            false,
                            path),
      around_axis(centre, axis),
      path);
  }



  ToolSurface<3>
  make_sphere(const Point<3>    &centre,
              const double       radius,
              const ToolSide     side,
              const std::string &path)
  {
    check_positive(radius, "radius", path);
    return ToolSurface<3>(ToolProfile::half_circle(Point<2>(),
                                                   radius,
                                                   side == ToolSide::around),
                          around_axis(centre, Tensor<1, 3>({0., 0., 1.})),
                          path);
  }



  ToolSurface<3>
  make_cone(const Point<3>     &tip,
            const Tensor<1, 3> &axis,
            const double        half_angle,
            const double        height,
            const double        tip_radius,
            const std::string  &path)
  {
    check_positive(height, "height", path);
    check_positive(tip_radius, "tip radius", path);
    if (!(half_angle > 0. && half_angle < 90.))
      throw UserError(path + ": the half angle of a cone is " +
                      std::to_string(half_angle) +
                      " degrees, but has to be between 0 and 90.");
    const double angle = half_angle * numbers::PI / 180.;
    const double slope = std::tan(angle);
    check_at_most(tip_radius,
                  height * slope / std::cos(angle), // no line is left
                  "tip radius",
                  path);
    return ToolSurface<3>(
      ToolProfile::polyline({{Point<2>(), tip_radius},
                             {Point<2>(slope * height, height), 0.}},
                            false,
                            path),
      around_axis(tip, axis),
      path);
  }



  ToolSurface<3>
  make_torus(const Point<3>     &centre,
             const Tensor<1, 3> &axis,
             const double        radius,
             const double        tube_radius,
             const ToolSide      side,
             const std::string  &path)
  {
    check_positive(radius, "radius", path);
    check_positive(tube_radius, "tube radius", path);
    check_at_most(tube_radius, radius, "tube radius", path);
    return ToolSurface<3>(ToolProfile::circle(Point<2>(radius, 0.),
                                              tube_radius,
                                              side == ToolSide::around),
                          around_axis(centre, axis),
                          path);
  }

  template ToolSurface<2>
  make_plane(const Point<2> &,
             const Tensor<1, 2> &,
             const double,
             const std::string &);
  template ToolSurface<3>
  make_plane(const Point<3> &,
             const Tensor<1, 3> &,
             const double,
             const std::string &);
} // namespace stickslip
