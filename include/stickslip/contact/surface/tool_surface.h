#ifndef stickslip_contact_surface_tool_surface_h
#define stickslip_contact_surface_tool_surface_h

#include <stickslip/contact/surface/tool_profile.h>

#include <array>
#include <limits>
#include <string>

namespace stickslip
{
  /// Where the plane of a profile is in space, and what it sweeps over.
  struct ToolSweep
  {
    enum class Kind
    {
      extruded, ///< along the axis, which is normal to the profile's plane
      revolved  ///< around the axis; the profile is (radius, height)
    };

    Kind         kind = Kind::revolved;
    Point<3>     origin;
    Tensor<1, 3> axis{{0., 0., 1.}};
    /// The profile's first direction; its second one is axis x first
    /// (extruded) or the axis (revolved). Only its part normal to the axis
    /// counts.
    Tensor<1, 3> first{{1., 0., 0.}};
    /// Between which heights over the origin it is extruded [length].
    double from = -std::numeric_limits<double>::infinity();
    double to   = std::numeric_limits<double>::infinity();
  };



  /**
   * The surface of a rigid tool, in the place where it was given: a profile
   * (2D), or what a profile is extruded or revolved to (3D). It has no facets:
   * positions and their derivatives are closed forms. Charts are regions of it
   * with smooth coordinates xi: the segments of the profile, in 3D with charts
   * of their own around poles, where arc length and angle are no coordinates.
   */
  template <int dim>
  class ToolSurface
  {
  public:
    /// A point of the surface, and which way is into the tool.
    struct Place
    {
      Point<dim>                                               x;
      std::array<Tensor<1, dim>, dim - 1>                      a; ///< x,alpha
      std::array<std::array<Tensor<1, dim>, dim - 1>, dim - 1> x_ab;
      /// Makes orientation * surface_normal(a) point into the tool.
      double orientation = 1.;
    };

    /// The closest point of the surface.
    struct Foot
    {
      bool           found = false; ///< it exists, and is not on an open end
      unsigned int   chart = 0;
      Point<dim - 1> xi;
    };

    /// 3D. Throws UserError (same on all ranks) with the name @p path of
    /// the parameter if axis and first direction do not make a frame, or if a
    /// profile to be revolved reaches over the axis.
    ToolSurface(const ToolProfile &profile,
                const ToolSweep   &sweep,
                const std::string &path);

    /// 2D: the profile itself.
    explicit ToolSurface(const ToolProfile &profile);

    /**
     * The closest point of @p x. A point beyond an open end of the profile, or
     * beyond the heights of an extruded one, has none, nor has one that is as
     * close to several (the centre of an arc).
     */
    Foot
    closest(const Point<dim> &x) const;

    /// @p xi may lie outside of the chart, which then goes on as it is.
    Place
    evaluate(const unsigned int chart, const Point<dim - 1> &xi) const;

    const ToolProfile &
    outline() const
    {
      return profile;
    }

    /// The chart of a segment of the outline whose coordinates are the arc
    /// length and, in 3D, the height or the angle [radian].
    static unsigned int
    first_chart(const unsigned int segment)
    {
      return charts_per_segment * segment;
    }

    bool
    is_revolved() const
    {
      return sweep.kind == ToolSweep::Kind::revolved;
    }

    /// Range of that second coordinate.
    std::array<double, 2>
    across_range() const;

  private:
    static constexpr unsigned int charts_per_segment = dim == 2 ? 1 : 3;

    ToolProfile profile;
    ToolSweep   sweep;
    /// The profile's two directions and, if it is extruded, the axis; if it is
    /// revolved the axis is the second one.
    std::array<Tensor<1, 3>, 3> frame;

    Tensor<1, 3>
    in_frame(const double c0, const double c1, const double c2) const
    {
      return c0 * frame[0] + c1 * frame[1] + c2 * frame[2];
    }

    bool
    crosses_axis() const;

    /// A chart near the axis: radial distances up to here; 0: none.
    double
    polar_radius(const unsigned int segment) const;

    Foot
    closest_extruded(const std::array<double, 3> &c) const;

    Foot
    closest_revolved(const std::array<double, 3> &c) const;

    Place
    evaluate_extruded(const unsigned int segment, const Point<2> &xi) const;

    Place
    evaluate_revolved(const unsigned int segment, const Point<2> &xi) const;

    /// xi are the two coordinates normal to the axis.
    Place
    evaluate_polar(const unsigned int segment,
                   const unsigned int region,
                   const Point<2>    &xi) const;
  };
} // namespace stickslip

#endif
