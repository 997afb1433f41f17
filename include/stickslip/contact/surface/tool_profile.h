#ifndef stickslip_contact_surface_tool_profile_h
#define stickslip_contact_surface_tool_profile_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <string>
#include <vector>

namespace stickslip
{
  using namespace dealii;

  /// A corner of a polyline, rounded with a radius [length].
  struct ProfileVertex
  {
    Point<2> place;
    double   fillet = 0.;
  };



  /**
   * The outline of a rigid tool in a plane: straight lines and arcs that join
   * without corners. Who walks along it has the tool on the left. Points of it
   * are named by the number of a segment and the arc length from its beginning.
   */
  class ToolProfile
  {
  public:
    /// A point of the outline with derivatives with respect to the arc length.
    struct Place
    {
      Point<2>     x;
      Tensor<1, 2> x_s;  ///< unit tangent
      Tensor<1, 2> x_ss; ///< [1/length]
    };

    /// The point of the outline that is closest to a given one.
    struct Foot
    {
      bool         found   = false; ///< it exists, and is no open end
      unsigned int segment = 0;
      double       s       = 0.;
    };

    /**
     * A polyline with rounded corners, @p closed or with two open ends. An end
     * with a fillet is one on the axis x = 0 of a body of revolution, where the
     * profile meets its mirror image. Throws UserError (same on all ranks) with
     * the name @p path of the parameter if a corner has no fillet or too large
     * a one, or if neighbouring vertices coincide.
     */
    static ToolProfile
    polyline(const std::vector<ProfileVertex> &vertices,
             const bool                        closed,
             const std::string                &path);

    /// The tool is within the circle or, if @p hollow, around it.
    static ToolProfile
    circle(const Point<2> &centre, const double radius, const bool hollow);

    /// The half circle with x >= 0, for a body of revolution.
    static ToolProfile
    half_circle(const Point<2> &centre, const double radius, const bool hollow);

    unsigned int
    n_segments() const
    {
      return segments.size();
    }

    /// @p s may lie outside of the segment, which then goes on as it is.
    Place
    evaluate(const unsigned int segment, const double s) const;

    /// Closest point; that of a point beyond an open end is not found, nor that
    /// of the centre of an arc.
    Foot
    closest(const Point<2> &x) const;

    double
    length(const unsigned int segment) const
    {
      return segments[segment].length;
    }

    double
    total_length() const;

    /// Radius of an arc [length]; 0: a line.
    double
    radius(const unsigned int segment) const
    {
      return segments[segment].radius;
    }

    /// Where an arc has its centre.
    const Point<2> &
    centre(const unsigned int segment) const
    {
      return segments[segment].origin;
    }

    /// Of an arc: the tool is on the side of its centre.
    bool
    is_counterclockwise(const unsigned int segment) const
    {
      return segments[segment].turning > 0.;
    }

  private:
    struct Segment
    {
      Point<2>     origin;       ///< beginning of a line, centre of an arc
      Tensor<1, 2> direction;    ///< of a line
      double       radius  = 0.; ///< of an arc
      double       start   = 0.; ///< angle of an arc's beginning
      double       turning = 1.; ///< counterclockwise or -1
      double       length  = 0.;
    };

    /// Foot on one segment, which may be its end.
    struct SegmentFoot
    {
      double s         = 0.;
      double distance  = 0.;
      bool   is_unique = true;
    };

    SegmentFoot
    closest_on(const unsigned int segment, const Point<2> &x) const;

    static ToolProfile
    arc(const Point<2> &centre,
        const double    radius,
        const double    start,
        const double    angle,
        const bool      hollow);

    std::vector<Segment> segments;
    bool                 closed = false;
    /// Ends on the axis are no ends of the surface.
    bool starts_on_axis = false;
    bool ends_on_axis   = false;

    friend class ProfileBuilder;
  };
} // namespace stickslip

#endif
