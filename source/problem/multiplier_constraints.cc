#include <stickslip/problem/multiplier_constraints.h>

namespace stickslip
{
  template <int dim>
  MultiplierConstraints<dim>::MultiplierConstraints(
    const Bodies                  &bodies,
    const BoundaryConditions<dim> &boundary_conditions,
    const ContactAssembler<dim>   &contact)
    : contact(contact)
  {
    for (const auto &pair : contact.contact_pairs())
      {
        const unsigned int master =
          bodies.index_of(pair->parameters.master_body,
                          "Contact/" + pair->name + "/Master body");
        master_is_rigid.push_back(
          bodies.bodies[master].is_rigid &&
          !boundary_conditions.drives_rigid_body(master));
      }
  }



  template <int dim>
  void
  MultiplierConstraints<dim>::add_to(
    Constraints                  &lines,
    const Constraints            &geometric,
    const types::global_dof_index n_displacements) const
  {
    const auto &pairs     = contact.contact_pairs();
    const auto &numbering = contact.multipliers();
    for (const MultiplierNode &node : numbering.relevant_nodes())
      {
        const ContactPair<dim> &pair   = *pairs[node.pair];
        const unsigned int      n_comp = pair.n_multiplier_components();
        bool is_excluded = pair.excluded_keys().count(node.key) > 0;
        // a node that cannot move against a master that cannot move
        if (master_is_rigid[node.pair])
          {
            bool is_held = true;
            for (unsigned int c = 0; c < dim; ++c)
              {
                const auto *entries =
                  lines.is_constrained(node.key + c)
                    ? lines.get_constraint_entries(node.key + c)
                    : nullptr;
                is_held = is_held && entries != nullptr && entries->empty();
              }
            is_excluded = is_excluded || is_held;
          }
        // hanging nodes have no multipliers of their own
        const auto *entries = pair.hanging_nodes().combination(node.key);
        if (entries == nullptr && geometric.is_constrained(node.key))
          entries = geometric.get_constraint_entries(node.key);
        for (unsigned int c = 0; c < n_comp; ++c)
          {
            const auto dof = n_displacements + node.first_dof + c;
            if (is_excluded)
              lines.add_line(dof);
            else if (entries != nullptr && !entries->empty())
              {
                lines.add_line(dof);
                for (const auto &[key, weight] : *entries)
                  if (numbering.has_node(node.pair, key))
                    lines.add_entry(dof,
                                    n_displacements +
                                      numbering.first_dof(node.pair, key) + c,
                                    weight);
              }
          }
      }
  }

  template class MultiplierConstraints<2>;
  template class MultiplierConstraints<3>;
} // namespace stickslip
