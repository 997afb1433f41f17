#include <stickslip/problem/system_description.h>

#include <stickslip/base/over_ranks.h>

#include <stickslip/contact/assembly/multiplier_scales.h>

#include <stickslip/problem/rigid_modes.h>

#include <deal.II/base/mpi.h>

#include <vector>

namespace stickslip
{
  template <int dim>
  SystemDescription<dim>::SystemDescription(const DofLayout<dim>  &dofs,
                                            const Bodies          &bodies,
                                            ContactAssembler<dim> &contact,
                                            const MPI_Comm        &communicator)
    : dofs(dofs)
    , bodies(bodies)
    , contact(contact)
    , communicator(communicator)
  {
    description.n_components = dim;
  }



  template <int dim>
  bool
  SystemDescription<dim>::has_new_constraints(const Constraints &constraints)
  {
    IndexSet now(dofs.owned.size());
    for (const auto i : dofs.owned)
      if (constraints.is_constrained(i))
        now.add_index(i);
    now.compress();
    const bool is_new = constrained.size() == 0 || now != constrained;
    constrained       = now;
    return any_rank(is_new, communicator);
  }



  template <int dim>
  void
  SystemDescription<dim>::update_scales(const Constraints &constraints)
  {
    const std::vector<IndexSet> owned = {dofs.owned,
                                         contact.multipliers().locally_owned()};
    LA::BlockVector             regularization(owned, communicator);
    LA::BlockVector             stiffness(owned, communicator);
    add_multiplier_scales(contact, constraints, regularization, stiffness);
    regularization.compress(VectorOperation::add);
    stiffness.compress(VectorOperation::add);
    description.regularization = regularization.block(1);
    description.stiffness      = stiffness.block(1);
  }



  template <int dim>
  const BlockSystemDescription &
  SystemDescription<dim>::update(const Constraints &constraints)
  {
    const bool new_constraints = has_new_constraints(constraints);
    if (new_constraints || sparsity_is_new)
      ++description.layout;
    sparsity_is_new = false;
    if (new_constraints)
      {
        const bool is_linear = dofs.degree() == 1;
        if (!is_linear)
          {
            if (!linear_space)
              linear_space =
                std::make_unique<LinearSpace<dim>>(dofs, communicator);
            linear_space->update(constraints);
            description.prolongation = linear_space->prolongation();
            if (description.nodes.bodies.empty())
              description.nodes =
                node_places(dofs.mapping, dofs.dof_handler, bodies);
          }
        description.near_null_space = std::make_shared<const NearNullSpace>(
          rigid_modes(dofs.mapping,
                      is_linear ? dofs.dof_handler : linear_space->handler(),
                      is_linear ? constraints : linear_space->constraints(),
                      bodies));
      }
    update_scales(constraints);
    return description;
  }

  template class SystemDescription<2>;
  template class SystemDescription<3>;
} // namespace stickslip
