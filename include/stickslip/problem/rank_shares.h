#ifndef stickslip_problem_rank_shares_h
#define stickslip_problem_rank_shares_h

#include <stickslip/contact/assembly/contact_assembler.h>

#include <deal.II/dofs/dof_handler.h>

#include <string>
#include <vector>

namespace stickslip
{
  /**
   * What the ranks have, as far as work depends on it: the least and the most
   * displacements, and contact points of those that have any. A line; none on
   * one rank. Collective.
   */
  template <int dim>
  std::vector<std::string>
  describe_rank_shares(const DoFHandler<dim>       &dof_handler,
                       const ContactAssembler<dim> &contact);
} // namespace stickslip

#endif
