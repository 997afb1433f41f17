#include <stickslip/contact/surface/tool_profile.h>

#include <stickslip/base/user_error.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace stickslip
{
  namespace
  {
    /// Roundoff: of angles, and of lengths over that of the profile.
    constexpr double profile_roundoff = 1e-9;



    Tensor<1, 2>
    to_the_left(const Tensor<1, 2> &t)
    {
      return Tensor<1, 2>({-t[1], t[0]});
    }



    double
    signed_angle(const Tensor<1, 2> &a, const Tensor<1, 2> &b)
    {
      return std::atan2(to_the_left(a) * b, a * b);
    }



    Point<2>
    mirrored(const Point<2> &p)
    {
      return Point<2>(-p[0], p[1]);
    }



    std::string
    text_of(const Point<2> &p)
    {
      return std::to_string(p[0]) + ", " + std::to_string(p[1]);
    }
  } // namespace



  /// Makes lines and arcs from the vertices of a polyline.
  class ProfileBuilder
  {
  public:
    ProfileBuilder(std::vector<ProfileVertex> given,
                   const bool                 closed,
                   const std::string         &path)
      : path(path)
      , vertices(std::move(given))
    {
      profile.closed = closed;
      if (vertices.size() < (closed ? 3 : 2))
        throw UserError(path + ": a " + (closed ? "closed " : "") +
                        "polyline needs " + (closed ? "three" : "two") +
                        " vertices at least.");
      if (!closed)
        add_mirror_images();
    }

    ToolProfile
    build()
    {
      const unsigned int n       = vertices.size();
      const unsigned int n_lines = profile.closed ? n : n - 1;
      for (unsigned int i = 0; i < n_lines; ++i)
        add_line_and_fillet(i);
      drop_mirror_images();
      if (profile.closed) // the fillet of the first vertex came last
        std::rotate(profile.segments.begin(),
                    profile.segments.end() - 1,
                    profile.segments.end());
      profile.segments.erase(std::remove_if(profile.segments.begin(),
                                            profile.segments.end(),
                                            [](const auto &segment) {
                                              return segment.length <= 0.;
                                            }),
                             profile.segments.end());
      return profile;
    }

  private:
    const std::string          path;
    std::vector<ProfileVertex> vertices;
    ToolProfile                profile;

    void
    add_mirror_images()
    {
      profile.starts_on_axis = is_on_axis(vertices.front());
      profile.ends_on_axis   = is_on_axis(vertices.back());
      if (profile.starts_on_axis)
        vertices.insert(vertices.begin(), {mirrored(vertices[1].place), 0.});
      if (profile.ends_on_axis)
        vertices.push_back({mirrored(vertices[vertices.size() - 2].place), 0.});
    }

    bool
    is_on_axis(const ProfileVertex &vertex) const
    {
      if (vertex.fillet == 0.)
        return false;
      if (vertex.place[0] != 0.)
        throw UserError(path + ": the end at " + text_of(vertex.place) +
                        " has a fillet, but does not lie on the axis.");
      return true;
    }

    const ProfileVertex &
    vertex(const unsigned int i) const
    {
      return vertices[i % vertices.size()];
    }

    Tensor<1, 2>
    direction(const unsigned int i) const
    {
      const Tensor<1, 2> d = vertex(i + 1).place - vertex(i).place;
      if (d.norm() == 0.)
        throw UserError(path + ": two neighbouring vertices are both at " +
                        text_of(vertex(i).place) + ".");
      return d / d.norm();
    }

    bool
    is_open_end(const unsigned int i) const
    {
      return !profile.closed && (i == 0 || i + 1 == vertices.size());
    }

    /// Angle by which the polyline turns at a vertex.
    double
    turn(const unsigned int i) const
    {
      return is_open_end(i)
               ? 0.
               : signed_angle(direction(i + vertices.size() - 1), direction(i));
    }

    /// What the fillet of a vertex takes from each of its lines [length].
    double
    setback(const unsigned int i) const
    {
      const double angle = std::abs(turn(i % vertices.size()));
      if (angle < profile_roundoff)
        return 0.;
      if (vertex(i).fillet <= 0. || angle > numbers::PI - profile_roundoff)
        throw UserError(path + ": the corner at " + text_of(vertex(i).place) +
                        " needs a fillet. A tool has no sharp corners, as its "
                        "normal has to be unique.");
      return vertex(i).fillet * std::tan(0.5 * angle);
    }

    /// Line @p i and the fillet at its end.
    void
    add_line_and_fillet(const unsigned int i)
    {
      const Tensor<1, 2> d = direction(i);
      const double length  = (vertex(i + 1).place - vertex(i).place).norm();
      const double before  = setback(i);
      const double after   = setback(i + 1);
      if (before + after > (1. + profile_roundoff) * length)
        throw UserError(
          path + ": the fillets at both ends of the line from " +
          text_of(vertex(i).place) + " to " + text_of(vertex(i + 1).place) +
          " take " + std::to_string(before + after) +
          " of it, but its length is " + std::to_string(length) + ".");
      ToolProfile::Segment line;
      line.origin    = vertex(i).place + before * d;
      line.direction = d;
      line.length    = std::max(0., length - before - after);
      if (line.length < profile_roundoff * length)
        line.length = 0.;
      profile.segments.push_back(line);
      add_fillet((i + 1) % vertices.size(), vertex(i + 1).place - after * d, d);
    }

    void
    add_fillet(const unsigned int  i,
               const Point<2>     &begin,
               const Tensor<1, 2> &d)
    {
      ToolProfile::Segment arc;
      const double         angle = turn(i);
      if (std::abs(angle) >= profile_roundoff)
        {
          arc.turning           = angle > 0. ? 1. : -1.;
          arc.radius            = vertices[i].fillet;
          const Tensor<1, 2> in = arc.turning * to_the_left(d);
          arc.origin            = begin + arc.radius * in;
          arc.start             = std::atan2(-in[1], -in[0]);
          arc.length            = arc.radius * std::abs(angle);
        }
      profile.segments.push_back(arc);
    }

    /// Of an arc around the axis only its half belongs to the profile.
    void
    drop_mirror_images()
    {
      auto &segments = profile.segments;
      if (profile.ends_on_axis)
        {
          segments.resize(segments.size() - 2); // an empty fillet follows
          segments.back().length *= 0.5;
        }
      if (profile.starts_on_axis)
        {
          segments.erase(segments.begin());
          auto &arc = segments.front();
          arc.length *= 0.5;
          if (arc.radius > 0.)
            arc.start += arc.turning * arc.length / arc.radius;
        }
    }
  };



  ToolProfile
  ToolProfile::polyline(const std::vector<ProfileVertex> &vertices,
                        const bool                        closed,
                        const std::string                &path)
  {
    return ProfileBuilder(vertices, closed, path).build();
  }



  ToolProfile
  ToolProfile::arc(const Point<2> &centre,
                   const double    radius,
                   const double    start,
                   const double    angle,
                   const bool      hollow)
  {
    Segment segment;
    segment.origin  = centre;
    segment.radius  = radius;
    segment.start   = hollow ? start + angle : start;
    segment.turning = hollow ? -1. : 1.;
    segment.length  = radius * angle;
    ToolProfile profile;
    profile.segments.push_back(segment);
    return profile;
  }



  ToolProfile
  ToolProfile::circle(const Point<2> &centre,
                      const double    radius,
                      const bool      hollow)
  {
    ToolProfile profile = arc(centre, radius, 0., 2. * numbers::PI, hollow);
    profile.closed      = true;
    return profile;
  }



  ToolProfile
  ToolProfile::half_circle(const Point<2> &centre,
                           const double    radius,
                           const bool      hollow)
  {
    ToolProfile profile =
      arc(centre, radius, -0.5 * numbers::PI, numbers::PI, hollow);
    profile.starts_on_axis = profile.ends_on_axis = true;
    return profile;
  }



  double
  ToolProfile::total_length() const
  {
    double sum = 0.;
    for (const auto &segment : segments)
      sum += segment.length;
    return sum;
  }



  ToolProfile::Place
  ToolProfile::evaluate(const unsigned int i, const double s) const
  {
    const Segment &segment = segments[i];
    Place          place;
    if (segment.radius == 0.)
      {
        place.x   = segment.origin + s * segment.direction;
        place.x_s = segment.direction;
        return place;
      }
    const double angle = segment.start + segment.turning * s / segment.radius;
    const Tensor<1, 2> out({std::cos(angle), std::sin(angle)});
    place.x    = segment.origin + segment.radius * out;
    place.x_s  = segment.turning * to_the_left(out);
    place.x_ss = -1. / segment.radius * out;
    return place;
  }



  ToolProfile::SegmentFoot
  ToolProfile::closest_on(const unsigned int i, const Point<2> &x) const
  {
    const Segment     &segment = segments[i];
    const Tensor<1, 2> r       = x - segment.origin;
    SegmentFoot        foot;
    if (segment.radius == 0.)
      foot.s = std::min(std::max(r * segment.direction, 0.), segment.length);
    else
      {
        foot.is_unique          = r.norm() > profile_roundoff * segment.radius;
        const double circle     = 2. * numbers::PI * segment.radius;
        const double from_start = segment.turning * segment.radius *
                                  (std::atan2(r[1], r[0]) - segment.start);
        foot.s = from_start - circle * std::floor(from_start / circle);
        if (foot.s > segment.length)
          foot.s =
            foot.s - segment.length < circle - foot.s ? segment.length : 0.;
      }
    foot.distance = x.distance(evaluate(i, foot.s).x);
    return foot;
  }



  ToolProfile::Foot
  ToolProfile::closest(const Point<2> &x) const
  {
    Foot        foot;
    SegmentFoot best;
    best.distance = std::numeric_limits<double>::infinity();
    for (unsigned int i = 0; i < segments.size(); ++i)
      {
        const SegmentFoot other = closest_on(i, x);
        if (other.distance < best.distance)
          {
            best         = other;
            foot.segment = i;
          }
      }
    foot.s     = best.s;
    foot.found = best.is_unique;
    const bool at_start =
      !closed && !starts_on_axis && foot.segment == 0 && foot.s == 0.;
    const bool at_end = !closed && !ends_on_axis &&
                        foot.segment + 1 == segments.size() &&
                        foot.s == segments.back().length;
    if (at_start || at_end)
      {
        const Place end = evaluate(foot.segment, foot.s);
        if (std::abs(end.x_s * (x - end.x)) > profile_roundoff * total_length())
          foot.found = false;
      }
    return foot;
  }
} // namespace stickslip
