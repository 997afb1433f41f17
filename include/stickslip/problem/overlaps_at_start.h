#ifndef stickslip_problem_overlaps_at_start_h
#define stickslip_problem_overlaps_at_start_h

#include <stickslip/problem/contact_at_start.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace stickslip
{
  /// What is looked for in the overlaps at points of this rank.
  template <int dim>
  struct Extremes
  {
    double     overlap = 0.;
    double     nearest = std::numeric_limits<double>::lowest(); ///< <= 0
    Point<dim> overlap_at, gap_at;

    unsigned int n_open = 0;

    void
    add(double depth, const Point<dim> &x)
    {
      // gaps below this fraction of a position are roundoff
      constexpr double smallest_gap_seen = 1e-12;
      if (std::abs(depth) < smallest_gap_seen * x.norm())
        depth = 0.;
      if (depth > overlap)
        {
          overlap    = depth;
          overlap_at = x;
        }
      if (depth <= 0.)
        ++n_open;
      if (depth <= 0. && depth > nearest)
        {
          nearest = depth;
          gap_at  = x;
        }
    }

    void
    take_gaps(const Extremes<dim> &other)
    {
      n_open += other.n_open;
      if (other.nearest <= nearest)
        return;
      nearest = other.nearest;
      gap_at  = other.gap_at;
    }
  };



  /**
   * The overlaps of the faces of @p pair, which has segments, at its
   * integration points: averages around nodes have one of h^2/(12 R) where a
   * smooth round surface just touches, as dual functions change sign. Sets
   * facet_ripple of @p start, and what belongs to it. Collective.
   */
  template <int dim>
  Extremes<dim>
  look_at_segments(const ContactPair<dim> &pair,
                   const MPI_Comm         &communicator,
                   ContactAtStart<dim>    &start);
} // namespace stickslip

#endif
