// Intersections of intervals and convex polygons: against known areas; those of
// any quadrilaterals against sums over the parts of one of them.

#include "print.h"

#include <stickslip/contact/surface/convex_cell.h>


#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace stickslip;

namespace
{
  /// A convex quadrilateral: corners near those of a turned and moved square.
  ConvexCell<2>
  quadrilateral(const unsigned int k)
  {
    const double  turn = 1.7 * k;
    ConvexCell<2> cell;
    for (unsigned int i = 0; i < 4; ++i)
      {
        const double angle =
          turn + 0.5 * numbers::PI * i + 0.3 * std::sin(3. * k + i);
        cell.emplace_back(std::cos(angle) + 0.9 * std::sin(2. * k),
                          std::sin(angle) + 0.9 * std::cos(5. * k));
      }
    return cell;
  }



  /// Intersections with skew tiles that cover the plane around the origin.
  double
  sum_over_tiles(const ConvexCell<2> &cell)
  {
    const Tensor<1, 2> a({0.4, 0.1}), b({-0.15, 0.45});
    double             sum = 0.;
    for (int i = -12; i < 12; ++i)
      for (int j = -12; j < 12; ++j)
        {
          const Point<2> corner(double(i) * a + double(j) * b);
          sum += measure<2>(
            intersection<2>(cell,
                            {corner, corner + a, corner + a + b, corner + b}));
        }
    return sum;
  }



  void
  test_intervals()
  {
    const ConvexCell<1> a = {Point<1>(0.), Point<1>(2.)};
    print("interval in interval: " +
          std::to_string(
            measure<1>(intersection<1>(a, {Point<1>(1.5), Point<1>(0.5)}))));
    print("overlap: " + std::to_string(measure<1>(
                          intersection<1>(a, {Point<1>(1.5), Point<1>(3.)}))));
    print("touching", intersection<1>(a, {Point<1>(2.), Point<1>(3.)}).empty());
    print("apart", intersection<1>(a, {Point<1>(4.), Point<1>(3.)}).empty());
  }



  void
  test_polygons()
  {
    const ConvexCell<2> square   = {{0., 0.}, {1., 0.}, {1., 1.}, {0., 1.}};
    const ConvexCell<2> reversed = {{0.5, 0.5},
                                    {0.5, 1.5},
                                    {1.5, 1.5},
                                    {1.5, 0.5}};
    print("a quarter of a square: " +
          std::to_string(measure<2>(intersection<2>(square, reversed))));
    print("the square in itself: " +
          std::to_string(measure<2>(intersection<2>(square, square))));
    print("a common edge only",
          intersection<2>(square, {{1., 0.}, {2., 0.}, {2., 1.}, {1., 1.}})
            .empty());
    print("apart",
          intersection<2>(square, {{3., 0.}, {4., 0.}, {4., 1.}}).empty());

    double       parts = 0., reverse = 0., tiles = 0.;
    unsigned int n_common = 0;
    for (unsigned int i = 0; i < 40; ++i)
      {
        const auto a = quadrilateral(i);
        tiles = std::max(tiles, std::abs(sum_over_tiles(a) - measure<2>(a)));
        for (unsigned int j = 0; j < 40; ++j)
          {
            const auto   b    = quadrilateral(100 + j);
            const double area = measure<2>(intersection<2>(a, b));
            n_common += area > 0. ? 1 : 0;
            double sum = 0.;
            for (const auto &triangle : simplices<2>(b))
              sum += measure<2>(intersection<2>(
                a, ConvexCell<2>(triangle.begin(), triangle.end())));
            parts = std::max(parts, std::abs(sum - area));
            reverse =
              std::max(reverse,
                       std::abs(area - measure<2>(intersection<2>(b, a))));
          }
      }
    print("pairs with an intersection: " + std::to_string(n_common));
    print("intersections with triangles make up those with polygons",
          parts < 1e-12);
    print("either way round", reverse < 1e-12);
    print("tiles of the plane make up the polygons", tiles < 1e-12);
  }
} // namespace



int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_intervals();
  test_polygons();
}
