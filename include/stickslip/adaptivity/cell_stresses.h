#ifndef stickslip_adaptivity_cell_stresses_h
#define stickslip_adaptivity_cell_stresses_h

#include <stickslip/problem/contact_problem.h>

#include <deal.II/base/quadrature.h>
#include <deal.II/base/tensor.h>

#include <deal.II/fe/fe.h>

#include <deal.II/lac/full_matrix.h>

#include <memory>
#include <vector>

namespace stickslip
{
  /// Which stress.
  enum class StressMeasure
  {
    nominal, ///< first Piola-Kirchhoff, per undeformed area
    cauchy
  };

  /**
   * The stresses of the cells of this rank and of their neighbours on others,
   * cell by cell as polynomials: those that go through the values at the
   * points of cell_quadrature(), where the laws are evaluated, of the degree of
   * the displacements (simplices: least squares, one degree less). On
   * undistorted cells with a linear law they are the stresses of the
   * displacements. So the traces on faces and the divergence of stresses that
   * depend on the history of points are known, too.
   */
  template <int dim>
  class CellStresses
  {
  public:
    /// In the present state of @p problem, with the accepted history.
    /// Collective.
    CellStresses(ContactProblem<dim> &problem, const StressMeasure measure);

    /// The space of the polynomials: scalar, discontinuous.
    const FiniteElement<dim> &
    space() const
    {
      return *element;
    }

    /// Nodal values in space() of a deformable cell that is not artificial;
    /// empty for rigid bodies.
    template <typename CellIterator>
    const std::vector<Tensor<2, 3>> &
    of(const CellIterator &cell) const
    {
      return nodal_values[cell->active_cell_index()];
    }

  private:
    std::unique_ptr<FiniteElement<dim>>    element;
    std::vector<std::vector<Tensor<2, 3>>> nodal_values;
  };
} // namespace stickslip

#endif
