#ifndef stickslip_adaptivity_free_directions_h
#define stickslip_adaptivity_free_directions_h

#include <stickslip/problem/contact_problem.h>

#include <deal.II/base/tensor.h>

#include <vector>

namespace stickslip
{
  /// The projection on the directions in which the node with the displacements
  /// @p dofs is free to move. What it is not free to do: prescribed components,
  /// combinations of components that are prescribed (normals, cylindrical
  /// ones), following a reference point. Hanging nodes are free as far as one
  /// of those that they hang on is.
  template <int dim>
  Tensor<2, dim>
  free_directions(const ContactProblem<dim>                  &problem,
                  const std::vector<types::global_dof_index> &dofs);
} // namespace stickslip

#endif
