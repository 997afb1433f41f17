#include <stickslip/contact/surface/tool_surface.h>

#include <stickslip/base/user_error.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace stickslip
{
  namespace
  {
    /// Lengths over that of the profile that are roundoff.
    constexpr double surface_roundoff = 1e-9;

    /// The chart around a pole reaches so far over the radius of the arc: where
    /// its slope is 1, and the other chart is as good.
    constexpr double polar_share = 0.7;

    /// The charts of a segment: region of the surface that it is revolved to.
    constexpr unsigned int away_from_axis = 0;
    constexpr unsigned int lower_pole     = 1; ///< of an arc; that of a line
    constexpr unsigned int upper_pole     = 2;
  } // namespace



  template <int dim>
  ToolSurface<dim>::ToolSurface(const ToolProfile &profile,
                                const ToolSweep   &sweep,
                                const std::string &path)
    : profile(profile)
    , sweep(sweep)
  {
    const double axis_length = sweep.axis.norm();
    if (!(axis_length > 0.))
      throw UserError(path + ": the axis of a tool must not be zero.");
    const Tensor<1, 3> axis  = sweep.axis / axis_length;
    const Tensor<1, 3> first = sweep.first - (sweep.first * axis) * axis;
    if (!(first.norm() > surface_roundoff * sweep.first.norm()))
      throw UserError(path +
                      ": the first direction of a tool's profile must "
                      "not be zero or along its axis.");
    const Tensor<1, 3> e    = first / first.norm();
    const Tensor<1, 3> side = cross_product_3d(axis, e);
    if (!is_revolved())
      frame = {{e, side, axis}};
    else
      {
        if (crosses_axis())
          throw UserError(path +
                          ": a profile that is revolved must stay on "
                          "one side of the axis: its first coordinate, "
                          "the radius, must not be negative.");
        frame = {{e, axis, side}};
      }
  }



  template <int dim>
  ToolSurface<dim>::ToolSurface(const ToolProfile &profile)
    : profile(profile)
  {
    Assert(dim == 2, ExcMessage("3D tools need a sweep."));
  }



  template <int dim>
  std::array<double, 2>
  ToolSurface<dim>::across_range() const
  {
    if (is_revolved())
      return {{0., 2. * numbers::PI}};
    return {{sweep.from, sweep.to}};
  }



  template <int dim>
  bool
  ToolSurface<dim>::crosses_axis() const
  {
    const double roundoff = surface_roundoff * profile.total_length();
    for (unsigned int i = 0; i < profile.n_segments(); ++i)
      {
        const double length = profile.length(i);
        double       least  = std::min(profile.evaluate(i, 0.).x[0],
                                profile.evaluate(i, length).x[0]);
        if (profile.radius(i) > 0.)
          {
            // the leftmost point of the circle, if the arc has it
            const Point<2> left =
              profile.centre(i) - Tensor<1, 2>({profile.radius(i), 0.});
            const auto foot = profile.closest(left);
            if (foot.segment == i)
              least = std::min(least, profile.evaluate(i, foot.s).x[0]);
          }
        if (least < -roundoff)
          return true;
      }
    return false;
  }



  template <int dim>
  double
  ToolSurface<dim>::polar_radius(const unsigned int segment) const
  {
    const double roundoff = surface_roundoff * profile.total_length();
    if (profile.radius(segment) > 0.)
      return std::abs(profile.centre(segment)[0]) < roundoff
               ? polar_share * profile.radius(segment)
               : 0.;
    const auto start = profile.evaluate(segment, 0.);
    return std::abs(start.x_s[1]) < surface_roundoff
             ? std::numeric_limits<double>::infinity()
             : 0.;
  }



  template <int dim>
  typename ToolSurface<dim>::Foot
  ToolSurface<dim>::closest(const Point<dim> &x) const
  {
    if constexpr (dim == 2)
      {
        const auto foot = profile.closest(x);
        return {foot.found, foot.segment, Point<1>(foot.s)};
      }
    else
      {
        const Tensor<1, 3>          r = x - sweep.origin;
        const std::array<double, 3> c = {
          {r * frame[0], r * frame[1], r * frame[2]}};
        return is_revolved() ? closest_revolved(c) : closest_extruded(c);
      }
  }



  template <int dim>
  typename ToolSurface<dim>::Foot
  ToolSurface<dim>::closest_extruded(const std::array<double, 3> &c) const
  {
    Foot foot;
    if constexpr (dim == 3)
      {
        const double roundoff = surface_roundoff * profile.total_length();
        const auto   in_plane = profile.closest(Point<2>(c[0], c[1]));
        foot.found = in_plane.found && c[2] > sweep.from - roundoff &&
                     c[2] < sweep.to + roundoff;
        foot.chart = first_chart(in_plane.segment);
        foot.xi    = Point<2>(in_plane.s, c[2]);
      }
    return foot;
  }



  template <int dim>
  typename ToolSurface<dim>::Foot
  ToolSurface<dim>::closest_revolved(const std::array<double, 3> &c) const
  {
    Foot foot;
    if constexpr (dim == 3)
      {
        const double radius   = std::hypot(c[0], c[2]);
        const auto   in_plane = profile.closest(Point<2>(radius, c[1]));
        const double at = profile.evaluate(in_plane.segment, in_plane.s).x[0];
        const double roundoff = surface_roundoff * profile.total_length();
        // all around a point on the axis is as close, but for a pole
        foot.found = in_plane.found && (radius > roundoff || at <= roundoff);
        foot.chart = first_chart(in_plane.segment);
        if (at < polar_radius(in_plane.segment))
          {
            // the foot of a point on the axis is the pole
            const double scale    = radius > 0. ? at / radius : 0.;
            const bool   is_above = profile.radius(in_plane.segment) > 0. &&
                                  c[1] > profile.centre(in_plane.segment)[1];
            foot.chart += is_above ? upper_pole : lower_pole;
            foot.xi = Point<2>(scale * c[0], scale * c[2]);
          }
        else
          {
            // c[2] is along axis x first, against which the angle is counted
            foot.xi = Point<2>(in_plane.s, std::atan2(c[2], c[0]));
          }
      }
    return foot;
  }



  template <int dim>
  typename ToolSurface<dim>::Place
  ToolSurface<dim>::evaluate(const unsigned int    chart,
                             const Point<dim - 1> &xi) const
  {
    const unsigned int segment = chart / charts_per_segment;
    if constexpr (dim == 2)
      {
        const auto at = profile.evaluate(segment, xi[0]);
        Place      place;
        place.x          = at.x;
        place.a[0]       = at.x_s;
        place.x_ab[0][0] = at.x_ss;
        return place;
      }
    else
      {
        if (!is_revolved())
          return evaluate_extruded(segment, xi);
        const unsigned int region = chart % charts_per_segment;
        return region == away_from_axis ? evaluate_revolved(segment, xi)
                                        : evaluate_polar(segment, region, xi);
      }
  }



  template <int dim>
  typename ToolSurface<dim>::Place
  ToolSurface<dim>::evaluate_extruded(const unsigned int segment,
                                      const Point<2>    &xi) const
  {
    Place place;
    if constexpr (dim == 3)
      {
        const auto at     = profile.evaluate(segment, xi[0]);
        place.x           = sweep.origin + in_frame(at.x[0], at.x[1], xi[1]);
        place.a[0]        = in_frame(at.x_s[0], at.x_s[1], 0.);
        place.a[1]        = frame[2];
        place.x_ab[0][0]  = in_frame(at.x_ss[0], at.x_ss[1], 0.);
        place.orientation = -1.; // t x axis is to the right of t
      }
    return place;
  }



  template <int dim>
  typename ToolSurface<dim>::Place
  ToolSurface<dim>::evaluate_revolved(const unsigned int segment,
                                      const Point<2>    &xi) const
  {
    Place place;
    if constexpr (dim == 3)
      {
        const auto   at = profile.evaluate(segment, xi[0]);
        const double c = std::cos(xi[1]), s = std::sin(xi[1]);
        // (radius, height) and around the axis
        const auto along = [&](const double radial, const double height) {
          return in_frame(radial * c, height, radial * s);
        };
        const Tensor<1, 3> around = in_frame(-s, 0., c);
        place.x                   = sweep.origin + along(at.x[0], at.x[1]);
        place.a[0]                = along(at.x_s[0], at.x_s[1]);
        place.a[1]                = at.x[0] * around;
        place.x_ab[0][0]          = along(at.x_ss[0], at.x_ss[1]);
        place.x_ab[0][1] = place.x_ab[1][0] = at.x_s[0] * around;
        place.x_ab[1][1]                    = along(-at.x[0], 0.);
      }
    return place;
  }



  template <int dim>
  typename ToolSurface<dim>::Place
  ToolSurface<dim>::evaluate_polar(const unsigned int segment,
                                   const unsigned int region,
                                   const Point<2>    &xi) const
  {
    Place place;
    if constexpr (dim == 3)
      {
        // height h(xi) over a plane normal to the axis
        const double radius = profile.radius(segment);
        double       height = profile.evaluate(segment, 0.).x[1];
        Tensor<1, 2> h_a;
        Tensor<2, 2> h_ab;
        if (radius > 0.)
          {
            const double side = region == upper_pole ? 1. : -1.;
            const double q    = std::sqrt(radius * radius - xi.square());
            height            = profile.centre(segment)[1] + side * q;
            h_a               = -side / q * Tensor<1, 2>(xi);
            h_ab              = -side / q *
                   (unit_symmetric_tensor<2>() + outer_product(h_a, h_a));
            place.orientation =
              profile.is_counterclockwise(segment) ? -side : side;
          }
        else
          place.orientation = profile.evaluate(segment, 0.).x_s[0];
        place.x = sweep.origin + in_frame(xi[0], height, xi[1]);
        for (unsigned int d = 0; d < 2; ++d)
          {
            place.a[d] = in_frame(d == 0, h_a[d], d == 1);
            for (unsigned int e = 0; e < 2; ++e)
              place.x_ab[d][e] = in_frame(0., h_ab[d][e], 0.);
          }
      }
    return place;
  }

  template class ToolSurface<2>;
  template class ToolSurface<3>;
} // namespace stickslip
