#include <stickslip/base/user_error.h>

#include <stickslip/simulation/checkpoint.h>

namespace stickslip
{
  template <int dim>
  void
  save_checkpoint(const std::string &,
                  ContactProblem<dim> &,
                  const LA::BlockVector &,
                  const CheckpointScalars &)
  {}
  template <int dim>
  CheckpointScalars
  load_checkpoint(const std::string &, ContactProblem<dim> &, LA::BlockVector &)
  {
    return {};
  }
  template void
  save_checkpoint(const std::string &,
                  ContactProblem<2> &,
                  const LA::BlockVector &,
                  const CheckpointScalars &);
  template void
  save_checkpoint(const std::string &,
                  ContactProblem<3> &,
                  const LA::BlockVector &,
                  const CheckpointScalars &);
  template CheckpointScalars
  load_checkpoint(const std::string &, ContactProblem<2> &, LA::BlockVector &);
  template CheckpointScalars
  load_checkpoint(const std::string &, ContactProblem<3> &, LA::BlockVector &);
} // namespace stickslip
