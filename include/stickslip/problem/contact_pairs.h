#ifndef stickslip_problem_contact_pairs_h
#define stickslip_problem_contact_pairs_h

#include <stickslip/base/parameter_file.h>

#include <stickslip/contact/pairing/contact_pair.h>

#include <stickslip/mesh/body.h>

#include <stickslip/problem/dof_layout.h>

#include <functional>
#include <memory>
#include <vector>

namespace stickslip
{
  /**
   * The contact pairs that the user asks for, in the order of the file.
   * @p modulus gives the longitudinal modulus by material id, infinity for a
   * rigid body, @p supports (closed) what is prescribed at the start: where all
   * displacements of a slave node are, a pair that cannot part has no
   * multiplier. Throws UserError (same on all ranks) for unknown bodies and
   * boundaries and for two rigid bodies. Collective.
   */
  template <int dim>
  std::vector<std::unique_ptr<ContactPair<dim>>>
  make_contact_pairs(
    const NamedList<ContactPairParameters>                &parameters,
    const Bodies                                          &bodies,
    const DofLayout<dim>                                  &dofs,
    const Constraints                                     &supports,
    const std::function<double(const types::material_id)> &modulus,
    const MPI_Comm                                        &communicator);
} // namespace stickslip

#endif
