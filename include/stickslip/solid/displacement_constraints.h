#ifndef stickslip_solid_displacement_constraints_h
#define stickslip_solid_displacement_constraints_h

#include <stickslip/base/types.h>

#include <stickslip/solid/prescribed_displacement.h>

#include <deal.II/base/index_set.h>

#include <string>
#include <utility>
#include <vector>

namespace stickslip
{
  /// One line of AffineConstraints, to be sent to other ranks.
  struct ConstraintLine
  {
    types::global_dof_index                                 dof;
    std::vector<std::pair<types::global_dof_index, double>> entries;
    double                                                  inhomogeneity;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int /*version*/)
    {
      archive &dof &entries &inhomogeneity;
    }
  };

  /// For messages, without the roundoff of components that are zero.
  template <int dim>
  std::string
  in_brackets(const Tensor<1, dim> &vector);

  /**
   * Resolves what is prescribed at a node to lines for the increment of its
   * displacement, whose current value is @p u: direction . (u + increment) =
   * value for all rows. Redundant rows are dropped; if they contradict each
   * other, a text naming the two of @p conditions is written to @p error.
   */
  template <int dim>
  std::vector<ConstraintLine>
  resolve_held_node(const HeldNode<dim>                            &node,
                    const Tensor<1, dim>                           &u,
                    const std::vector<PrescribedDisplacement<dim>> &conditions,
                    std::string                                    &error);

  /**
   * A node that follows a reference point and is prescribed something by other
   * conditions, too: allowed if the free components do not move it along these
   * directions and the others move it as prescribed at @p time. Otherwise a text
   * naming the two of @p conditions is written to @p error.
   */
  template <int dim>
  void
  check_coupled_node(const HeldNode<dim>                            &node,
                     const std::vector<PrescribedDisplacement<dim>> &conditions,
                     const double                                    time,
                     std::string                                    &error);

  /**
   * Adds @p lines, one rank's lines of its locally owned degrees of freedom,
   * and asks the owners for those of the other local lines of @p constraints.
   * Lines that exist stay as they are. Collective.
   */
  void
  add_lines_on_all_ranks(const std::vector<ConstraintLine> &lines,
                         const IndexSet                    &locally_owned_dofs,
                         const MPI_Comm                     communicator,
                         Constraints                       &constraints);
} // namespace stickslip

#endif
