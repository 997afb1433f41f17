#ifndef stickslip_solid_linear_stiffness_h
#define stickslip_solid_linear_stiffness_h

#include <stickslip/base/types.h>

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/hp/fe_collection.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/sparsity_pattern.h>
#include <deal.II/lac/vector.h>

#include <array>
#include <functional>
#include <vector>

namespace stickslip
{
  /**
   * Stiffness of cells that never changes, as one symmetric matrix K with
   * blocks of dim x dim entries for the nodes of the owned cells, of which the
   * upper triangle is stored. Constraints are not in it: they are applied when
   * forces K u or K itself are added to something global. Nothing here
   * communicates.
   */
  template <int dim>
  class LinearStiffness
  {
  public:
    using CellIterator = typename DoFHandler<dim>::active_cell_iterator;

    /// Writes the stiffness of a cell, which is symmetric, in the cell's
    /// numbering.
    using CellStiffness =
      std::function<void(const CellIterator &, FullMatrix<double> &)>;

    /// Sums up @p stiffness_of the @p cells, whose elements are dim equal
    /// scalar ones.
    void
    assemble(const hp::FECollection<dim>     &elements,
             const std::vector<CellIterator> &cells,
             const CellStiffness             &stiffness_of);

    /// Adds K u to @p internal. @p u is ghosted, @p geometric is condensed.
    void
    add_forces(const LA::Vector  &u,
               const Constraints &geometric,
               LA::Vector        &internal) const;

    /**
     * Adds K to @p matrix and -K u to @p rhs with all @p constraints of the
     * increment eliminated, as AffineConstraints::distribute_local_to_global()
     * does for cells: constrained rows get the diagonal of K.
     */
    void
    add_tangent(const LA::Vector  &u,
                const Constraints &constraints,
                LA::SparseMatrix  &matrix,
                LA::Vector        &rhs) const;

  private:
    std::vector<types::global_dof_index> dofs; ///< [node * dim + component]
    SparsityPattern     blocks; ///< by node; columns from the diagonal on
    std::vector<double> values; ///< [block * dim^2 + row * dim + column]

    /// A block left of the diagonal: the transpose of a stored one.
    struct Mirrored
    {
      unsigned int column, block;
    };
    std::vector<std::size_t> mirrored_begins; ///< by node
    std::vector<Mirrored>    mirrored;

    /// The degrees of freedom of the nodes of a cell.
    using CellNodes = std::vector<std::array<unsigned int, dim>>;

    /// @p local has them for each kind of cells.
    void
    number_nodes(const std::vector<CellNodes>    &local,
                 const std::vector<CellIterator> &cells);

    /// Finds the blocks left of the diagonal.
    void
    find_mirrored();

    void
    vmult(Vector<double> &y, const Vector<double> &x) const;
  };
} // namespace stickslip

#endif
