#include <stickslip/adaptivity/free_directions.h>

#include <algorithm>

namespace stickslip
{
  namespace
  {
    /// The direction that the line of component @p c fixes; zero if it is free.
    template <int dim>
    Tensor<1, dim>
    fixed_direction(const ContactProblem<dim>                  &problem,
                    const std::vector<types::global_dof_index> &dofs,
                    const unsigned int                          c)
    {
      const Constraints &increment = problem.increment_constraints();
      Tensor<1, dim>     direction;
      if (!increment.is_constrained(dofs[c]))
        return direction;
      direction[c]        = 1.;
      const auto *entries = increment.get_constraint_entries(dofs[c]);
      if (entries == nullptr)
        return direction;
      for (const auto &[other, factor] : *entries)
        {
          const unsigned int component =
            std::find(dofs.begin(), dofs.end(), other) - dofs.begin();
          if (component < dim)
            direction[component] -= factor;
          else if (problem.geometric_constraints().is_constrained(dofs[c]))
            return Tensor<1, dim>();
        }
      return direction;
    }
  } // namespace



  template <int dim>
  Tensor<2, dim>
  free_directions(const ContactProblem<dim>                  &problem,
                  const std::vector<types::global_dof_index> &dofs)
  {
    Tensor<2, dim> projection(unit_symmetric_tensor<dim>());
    for (unsigned int c = 0; c < dim; ++c)
      {
        const Tensor<1, dim> rest =
          projection * fixed_direction(problem, dofs, c);
        if (rest.norm_square() > 1e-12)
          projection -= outer_product(rest, rest) / rest.norm_square();
      }
    return projection;
  }

  template Tensor<2, 2>
  free_directions(const ContactProblem<2> &,
                  const std::vector<types::global_dof_index> &);
  template Tensor<2, 3>
  free_directions(const ContactProblem<3> &,
                  const std::vector<types::global_dof_index> &);
} // namespace stickslip
