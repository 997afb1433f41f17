#include <stickslip/contact/surface/convex_cell.h>

#include <algorithm>
#include <cmath>

namespace stickslip
{
  namespace
  {
    /// z component of (b - a) x (c - a).
    double
    turn(const Point<2> &a, const Point<2> &b, const Point<2> &c)
    {
      return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    }



    double
    signed_area(const ConvexCell<2> &polygon)
    {
      double twice = 0.;
      for (unsigned int i = 2; i < polygon.size(); ++i)
        twice += turn(polygon[0], polygon[i - 1], polygon[i]);
      return 0.5 * twice;
    }



    /// The part of @p polygon to the left of the line from @p a to @p b.
    ConvexCell<2>
    left_part(const ConvexCell<2> &polygon,
              const Point<2>      &a,
              const Point<2>      &b)
    {
      ConvexCell<2> part;
      if (polygon.empty())
        return part;
      double d_p = turn(a, b, polygon[0]);
      for (unsigned int i = 0; i < polygon.size(); ++i)
        {
          const bool      is_last = i + 1 == polygon.size();
          const Point<2> &p       = polygon[i];
          const Point<2> &q       = polygon[is_last ? 0 : i + 1];
          const double    d_q     = turn(a, b, q);
          if (d_p >= 0.)
            part.push_back(p);
          if ((d_p > 0. && d_q < 0.) || (d_p < 0. && d_q > 0.))
            part.push_back(p + d_p / (d_p - d_q) * (q - p));
          d_p = d_q;
        }
      return part;
    }
  } // namespace



  template <int facedim>
  double
  measure(const ConvexCell<facedim> &cell)
  {
    if constexpr (facedim == 1)
      return cell.empty() ? 0. : std::abs(cell[1][0] - cell[0][0]);
    else
      return std::abs(signed_area(cell));
  }



  template <int facedim>
  double
  measure(const Simplex<facedim> &simplex)
  {
    if constexpr (facedim == 1)
      return std::abs(simplex[1][0] - simplex[0][0]);
    else
      return 0.5 * std::abs(turn(simplex[0], simplex[1], simplex[2]));
  }



  template <int facedim>
  ConvexCell<facedim>
  intersection(const ConvexCell<facedim> &a, const ConvexCell<facedim> &b)
  {
    if (a.empty() || b.empty())
      return {};
    ConvexCell<facedim> common;
    if constexpr (facedim == 1)
      common = {Point<1>(std::max(std::min(a[0][0], a[1][0]),
                                  std::min(b[0][0], b[1][0]))),
                Point<1>(std::min(std::max(a[0][0], a[1][0]),
                                  std::max(b[0][0], b[1][0])))};
    else
      {
        common                  = a;
        const bool     reversed = signed_area(b) < 0.;
        const unsigned n        = b.size();
        for (unsigned int i = 0; i < n && !common.empty(); ++i)
          common = left_part(common,
                             b[reversed ? (i + 1) % n : i],
                             b[reversed ? i : (i + 1) % n]);
      }
    if constexpr (facedim == 1)
      return common[0][0] < common[1][0] ? common : ConvexCell<facedim>();
    else
      return common.size() > 2 && measure<facedim>(common) > 0.
               ? common
               : ConvexCell<facedim>();
  }



  template <int facedim>
  boost::container::small_vector<Simplex<facedim>, 6>
  simplices(const ConvexCell<facedim> &cell)
  {
    boost::container::small_vector<Simplex<facedim>, 6> result;
    if constexpr (facedim == 1)
      {
        if (!cell.empty())
          result.push_back({{cell[0], cell[1]}});
      }
    else
      for (unsigned int i = 2; i < cell.size(); ++i)
        result.push_back({{cell[0], cell[i - 1], cell[i]}});
    return result;
  }

#define INSTANTIATE(facedim)                                                  \
  template double              measure<facedim>(const ConvexCell<facedim> &); \
  template double              measure<facedim>(const Simplex<facedim> &);    \
  template ConvexCell<facedim> intersection(const ConvexCell<facedim> &,      \
                                            const ConvexCell<facedim> &);     \
  template boost::container::small_vector<Simplex<facedim>, 6> simplices(     \
    const ConvexCell<facedim> &);
  INSTANTIATE(1)
  INSTANTIATE(2)
#undef INSTANTIATE
} // namespace stickslip
