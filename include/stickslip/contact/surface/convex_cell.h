#ifndef stickslip_contact_surface_convex_cell_h
#define stickslip_contact_surface_convex_cell_h

#include <deal.II/base/point.h>

#include <boost/container/small_vector.hpp>

#include <array>

namespace stickslip
{
  using namespace dealii;

  /// Corners of an interval (facedim = 1, two points) or of a convex polygon
  /// (facedim = 2), in the order of its boundary, either way round. Empty: the
  /// empty set.
  template <int facedim>
  using ConvexCell = boost::container::small_vector<Point<facedim>, 8>;

  /// Corners of an interval or a triangle.
  template <int facedim>
  using Simplex = std::array<Point<facedim>, facedim + 1>;

  /// Length or area (never negative).
  template <int facedim>
  double
  measure(const ConvexCell<facedim> &cell);

  template <int facedim>
  double
  measure(const Simplex<facedim> &simplex);

  /**
   * Intersection of two convex cells; empty if its measure vanishes. Polygons
   * by clipping with one edge after the other (Sutherland and Hodgman, Comm.
   * ACM 17, 1974).
   */
  template <int facedim>
  ConvexCell<facedim>
  intersection(const ConvexCell<facedim> &a, const ConvexCell<facedim> &b);

  /// The cell cut into simplices, all with the corner 0.
  template <int facedim>
  boost::container::small_vector<Simplex<facedim>, 6>
  simplices(const ConvexCell<facedim> &cell);
} // namespace stickslip

#endif
