#include <stickslip/simulation/dual_increment.h>

#include <stickslip/linear_solvers/projected_conjugate_gradient.h>

#include <deal.II/base/timer.h>

#include <algorithm>
#include <vector>

namespace stickslip
{
  namespace
  {
    /// Of the multipliers; the residuals that Newton looks at are smaller.
    constexpr double       dual_tolerance = 1e-11;
    constexpr unsigned int max_iterations = 2000;



    /// A row without entries belongs to a node that has no contact or, for
    /// Lambda, no friction threshold.
    template <int dim>
    AdmissibleMultipliers
    admissible_multipliers(const ContactAssembler<dim> &contact,
                           const LA::SparseMatrix      &rows)
    {
      const auto has_entries = [&rows](const types::global_dof_index row) {
        bool any = false;
        LA::visit_row(rows, row, [&any](const auto, const double value) {
          any = any || value != 0.;
        });
        return any;
      };
      AdmissibleMultipliers admissible;
      for (const MultiplierNode &node : contact.multipliers().owned_nodes())
        {
          const unsigned int n_components =
            contact.contact_pairs()[node.pair]->n_multiplier_components();
          admissible.nodes.push_back(
            {node.first_dof,
             n_components,
             has_entries(node.first_dof),
             n_components > 1 && has_entries(node.first_dof + 1)});
        }
      return admissible;
    }
  } // namespace



  template <int dim>
  void
  solve_dual_increment(ContactProblem<dim>   &problem,
                       const LA::BlockVector &state,
                       LA::BlockVector       &increment)
  {
    {
      // the blocks of the bodies, of the gaps and of the slips
      const StatusRuleScope<dim> equalities(problem.contact(),
                                            StatusRule::all_stick);
      problem.assemble(state);
    }
    Timer                            timer;
    const ProjectedConjugateGradient solver(dual_tolerance, max_iterations);
    const ProjectedSolve             result =
      solver.solve(problem.matrix(),
                   problem.right_hand_side(),
                   problem.describe_system().regularization,
                   admissible_multipliers(problem.contact(),
                                          problem.matrix().block(1, 0)),
                   state.block(1),
                   increment);
    problem.counts.linear_iterations += result.solves;
    problem.counts.solve_seconds += timer.wall_time();
    problem.distribute(increment);
  }

  template void
  solve_dual_increment(ContactProblem<2> &,
                       const LA::BlockVector &,
                       LA::BlockVector &);
  template void
  solve_dual_increment(ContactProblem<3> &,
                       const LA::BlockVector &,
                       LA::BlockVector &);
} // namespace stickslip
