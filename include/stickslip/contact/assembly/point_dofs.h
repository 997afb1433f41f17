#ifndef stickslip_contact_assembly_point_dofs_h
#define stickslip_contact_assembly_point_dofs_h

#include <stickslip/contact/pairing/contact_pair.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <vector>

namespace stickslip
{
  /// Global dofs of a point: slave nodes, master stencil, multipliers (from
  /// @p n_displacements on). A mortar node has only its own multipliers.
  template <int dim>
  std::vector<types::global_dof_index>
  point_dofs(const ContactPair<dim>       &pair,
             const ContactPoint<dim>      &point,
             const types::global_dof_index n_displacements);

  /// What acts on images of nodes acts on the nodes (StencilNodes): a local
  /// vector in the order of point_dofs(), ...
  template <int dim>
  void
  turn_images_back(const ContactPair<dim>  &pair,
                   const ContactPoint<dim> &point,
                   Vector<double>          &local);

  /// ... and its derivative.
  template <int dim>
  void
  turn_images_back(const ContactPair<dim>  &pair,
                   const ContactPoint<dim> &point,
                   FullMatrix<double>      &local);

  /// Where a point meets two images of one node, its dofs are there twice: sums
  /// up their rows and columns, so that each is there once.
  template <int dim>
  void
  merge_images(const ContactPair<dim>               &pair,
               const ContactPoint<dim>              &point,
               std::vector<types::global_dof_index> &dofs,
               Vector<double>                       &local,
               FullMatrix<double>                   &local_matrix);
} // namespace stickslip

#endif
