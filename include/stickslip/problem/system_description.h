#ifndef stickslip_problem_system_description_h
#define stickslip_problem_system_description_h

#include <stickslip/base/block_system.h>

#include <stickslip/contact/assembly/contact_assembler.h>

#include <stickslip/mesh/body.h>

#include <stickslip/problem/dof_layout.h>
#include <stickslip/problem/linear_space.h>

#include <memory>

namespace stickslip
{
  /**
   * Tells a linear solver about the tangent: the rigid motions of each body,
   * the linear space for elements of a higher degree, and the scales of the
   * multipliers. Costs nothing until a solver asks.
   */
  template <int dim>
  class SystemDescription
  {
  public:
    /// All arguments must outlive this object.
    SystemDescription(const DofLayout<dim>  &dofs,
                      const Bodies          &bodies,
                      ContactAssembler<dim> &contact,
                      const MPI_Comm        &communicator);

    /// Says that the sparsity was built anew.
    void
    new_sparsity()
    {
      sparsity_is_new = true;
    }

    /// The description for the present contact state and @p constraints of the
    /// increment. Collective.
    const BlockSystemDescription &
    update(const Constraints &constraints);

  private:
    const DofLayout<dim>             &dofs;
    const Bodies                     &bodies;
    ContactAssembler<dim>            &contact;
    MPI_Comm                          communicator;
    std::unique_ptr<LinearSpace<dim>> linear_space; ///< for degrees above 1
    IndexSet                          constrained;  ///< owned displacements
    bool                              sparsity_is_new = true;
    BlockSystemDescription            description;

    /// True (on all ranks) if other displacements are constrained than before.
    bool
    has_new_constraints(const Constraints &constraints);

    void
    update_scales(const Constraints &constraints);
  };
} // namespace stickslip

#endif
