#include <stickslip/contact/surface/segment_quadrature.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>

namespace stickslip
{
  namespace
  {
    /// Of the length of a diagonal or an edge: the exact rules for affine cells
    /// leave errors of its square.
    constexpr double tolerance = 1e-5;



    /// Points per direction that are exact for products of two shape functions,
    /// which have degree 2 p on triangles and 4 p in a plane. In the parameter
    /// of a curved slave edge the place opposite has degree p, and a shape
    /// function there p^2. The radius of a body of revolution adds its own
    /// degree, and one to where the points are opposite, in the derivatives.
    template <int dim>
    unsigned int
    exact_order(const FaceShape<dim> &slave,
                const FaceShape<dim> &master,
                const CrossSection   &cross_section)
    {
      const unsigned int p = slave.degree();
      if (dim == 2)
        {
          const unsigned int degree =
            p + p * p + (cross_section.is_axisymmetric ? p + 1 : 0);
          return degree / 2 + 1;
        }
      const bool are_triangles = slave.is_triangle() && master.is_triangle();
      return are_triangles ? p + 1 : 2 * p + 1;
    }



    template <int dim>
    bool
    is_quadratic_triangle(const FaceShape<dim> &shape)
    {
      return shape.is_triangle() && shape.degree() > 1;
    }



    template <int dim>
    Quadrature<dim - 1>
    simplex_quadrature(const unsigned int order, const unsigned int wanted)
    {
      constexpr unsigned int largest = 7; // that deal.II has for triangles
      if constexpr (dim == 2)
        return QGauss<1>(std::max(order, wanted));
      else
        return QWitherdenVincentSimplex<2>(
          std::min(largest, std::max(order, wanted)));
    }



    /// True if @p cell of @p cells is a triangle or nearly a parallelogram; an
    /// interval, if all of them have its length (which those of an edge of
    /// degree 3 and more never have).
    template <int facedim, typename Cells>
    bool
    is_affine(const ConvexCell<facedim> &cell, const Cells &cells)
    {
      if constexpr (facedim == 1)
        {
          const auto length = [](const ConvexCell<1> &c) {
            return std::abs(c[1][0] - c[0][0]);
          };
          return std::all_of(cells.begin(), cells.end(), [&](const auto &c) {
            return std::abs(length(c) - length(cell)) <
                   tolerance * length(cell);
          });
        }
      else
        return cell.size() == 3 ||
               ((cell[0] - cell[1]) + (cell[2] - cell[3])).norm() <
                 tolerance * (cell[2] - cell[0]).norm();
    }
  } // namespace



  template <int dim>
  SegmentQuadrature<dim>::SegmentQuadrature(const FaceShape<dim> &slave_shape,
                                            const FaceShape<dim> &master_shape,
                                            const unsigned int    order,
                                            const CrossSection   &cross_section)
    : parametric(dim == 2 && slave_shape.degree() > 1)
    , is_never_exact(is_quadratic_triangle<dim>(slave_shape) ||
                     is_quadratic_triangle<dim>(master_shape))
    , exact_rule(simplex_quadrature<dim>(
        exact_order<dim>(slave_shape, master_shape, cross_section),
        order))
    , other_rule(simplex_quadrature<dim>(
        exact_order<dim>(slave_shape, master_shape, cross_section) + 2,
        order))
  {}



  template <int dim>
  const Quadrature<dim - 1> &
  SegmentQuadrature<dim>::rule(const ProjectedFace<dim> &slave,
                               const unsigned int        i,
                               const ProjectedFace<dim> &master,
                               const unsigned int        j) const
  {
    const bool is_exact =
      !is_never_exact &&
      (dim == 2 || is_affine<dim - 1>(slave.cells[i], slave.cells)) &&
      is_affine<dim - 1>(master.cells[j], master.cells);
    return is_exact ? exact_rule : other_rule;
  }

#define INSTANTIATE(dim) template class SegmentQuadrature<dim>;
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
