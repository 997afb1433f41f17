#include <stickslip/base/no_convergence.h>
#include <stickslip/base/short_message.h>

#include <stickslip/linear_solvers/displacement_multigrid.h>

namespace stickslip
{
  void
  DisplacementMultigrid::clear()
  {
    hierarchy.clear();
    fine_smoother.clear();
  }



  void
  DisplacementMultigrid::reinit(const LA::SparseMatrix       &matrix,
                                const BlockSystemDescription &description)
  {
    fine_matrix     = &matrix;
    prolongation    = description.prolongation;
    near_null_space = description.near_null_space;
    clear();
    try
      {
        if (!prolongation)
          {
            hierarchy.initialize(matrix,
                                 description.n_components,
                                 near_null_space->n_vectors,
                                 near_null_space->values.data());
            return;
          }
        LA::SparseMatrix product;
        matrix.mmult(product, *prolongation);
        prolongation->Tmmult(coarse_matrix, product);
        hierarchy.initialize(coarse_matrix,
                             description.n_components,
                             near_null_space->n_vectors,
                             near_null_space->values.data());
        fine_smoother.initialize(matrix);
      }
    catch (const std::exception &error)
      {
        throw NoConvergence("Linear solver (block AMG)",
                            "no multigrid hierarchy of this matrix: " +
                              short_message(error),
                            FailureCause::linear_solver);
      }
    const IndexSet fine         = matrix.locally_owned_range_indices();
    const IndexSet coarse       = coarse_matrix.locally_owned_range_indices();
    const MPI_Comm communicator = matrix.get_mpi_communicator();
    residual.reinit(fine, communicator);
    correction.reinit(fine, communicator);
    coarse_residual.reinit(coarse, communicator);
    coarse_correction.reinit(coarse, communicator);
  }



  void
  DisplacementMultigrid::vmult(LA::Vector &x, const LA::Vector &b) const
  {
    if (!prolongation)
      {
        hierarchy.vmult(x, b);
        return;
      }
    fine_smoother.vmult(x, b);
    fine_matrix->residual(residual, x, b);
    prolongation->Tvmult(coarse_residual, residual);
    hierarchy.vmult(coarse_correction, coarse_residual);
    prolongation->vmult(correction, coarse_correction);
    x += correction;
    fine_matrix->residual(residual, x, b);
    fine_smoother.vmult(correction, residual);
    x += correction;
  }
} // namespace stickslip
