#ifndef stickslip_simulation_checkpoint_h
#define stickslip_simulation_checkpoint_h

#include <stickslip/problem/contact_problem.h>

#include <string>

namespace stickslip
{
  /// The numbers of a state that are not fields.
  struct CheckpointScalars
  {
    double       time          = 0.;
    double       step_size     = 0.;
    unsigned int step          = 0;
    double       external_work = 0.;
    double       friction_work = 0.;
  };

  /**
   * Writes the accepted state @p x with all histories below @p directory
   * (the output directory). Keyed by cell, so that any number of ranks and
   * either partitioner can read it. The checkpoint before stays valid until
   * this one is complete. Collective; throws UserError on all ranks if it
   * cannot be written.
   */
  template <int dim>
  void
  save_checkpoint(const std::string       &directory,
                  ContactProblem<dim>     &problem,
                  const LA::BlockVector   &x,
                  const CheckpointScalars &scalars);

  /**
   * Reads the latest complete checkpoint below @p directory into @p x and the
   * histories of @p problem, which must have been made from the same mesh.
   * Collective; throws UserError on all ranks if there is none or it does not
   * fit.
   */
  template <int dim>
  CheckpointScalars
  load_checkpoint(const std::string   &directory,
                  ContactProblem<dim> &problem,
                  LA::BlockVector     &x);
} // namespace stickslip

#endif
