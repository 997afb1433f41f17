#ifndef stickslip_simulation_singular_matrix_h
#define stickslip_simulation_singular_matrix_h

#include <stickslip/simulation/failure_explanation.h>

namespace stickslip
{
  /// Why the matrix of a failed step is singular: contact lost, no friction
  /// threshold yet, a body that slides everywhere, or multipliers that nothing
  /// determines. Collective; the same on all ranks.
  template <int dim>
  FailureExplanation
  explain_singular_matrix(const FailedStep<dim> &step,
                          const MPI_Comm         communicator);
} // namespace stickslip

#endif
