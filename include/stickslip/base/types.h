#ifndef stickslip_base_types_h
#define stickslip_base_types_h

#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/block_sparsity_pattern.h>
#include <deal.II/lac/trilinos_block_sparse_matrix.h>
#include <deal.II/lac/trilinos_parallel_block_vector.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/trilinos_sparsity_pattern.h>
#include <deal.II/lac/trilinos_vector.h>

namespace stickslip
{
  using namespace dealii;

  /**
   * Names of the distributed linear algebra objects. This is the only place
   * that says which backend stands behind them (today deal.II's Epetra-backed
   * Trilinos wrappers), so that a Tpetra-backed build needs a second version
   * of this file and nothing else.
   */
  namespace LA
  {
    using Vector               = TrilinosWrappers::MPI::Vector;
    using BlockVector          = TrilinosWrappers::MPI::BlockVector;
    using SparseMatrix         = TrilinosWrappers::SparseMatrix;
    using BlockSparseMatrix    = TrilinosWrappers::BlockSparseMatrix;
    using SparsityPattern      = TrilinosWrappers::SparsityPattern;
    using BlockSparsityPattern = TrilinosWrappers::BlockSparsityPattern;
  } // namespace LA

  /// Constraints on the degrees of freedom of a field.
  using Constraints = AffineConstraints<double>;
} // namespace stickslip

#endif
