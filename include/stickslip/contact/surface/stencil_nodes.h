#ifndef stickslip_contact_surface_stencil_nodes_h
#define stickslip_contact_surface_stencil_nodes_h

#include <stickslip/base/types.h>

#include <deal.II/base/tensor.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <utility>
#include <vector>

namespace stickslip
{
  /// Name of a place of a node: its first displacement, and which image of the
  /// node (PeriodicImages; 0: the node itself).
  using NodeName = std::pair<types::global_dof_index, unsigned int>;

  /**
   * Nodes, and how the unknowns move them. An image of a node moves with the
   * displacements of the node, turned as the image is: u_there = R u.
   */
  template <int dim>
  struct StencilNodes
  {
    std::vector<types::global_dof_index> dofs; ///< [node * dim + c]
    /// Per node; empty: there are no images, or none that is turned.
    std::vector<unsigned int>   images;
    std::vector<Tensor<2, dim>> rotations;

    unsigned int
    n_nodes_of_dofs() const
    {
      return dofs.size() / dim;
    }

    /// Nodes with the same name are at the same place, whatever cell is there.
    NodeName
    name(const unsigned int j) const
    {
      return {dofs[j * dim], images.empty() ? 0 : images[j]};
    }

    /// R of node @p j.
    Tensor<2, dim>
    rotation(const unsigned int j) const
    {
      return rotations.empty() ? Tensor<2, dim>(unit_symmetric_tensor<dim>())
                               : rotations[j];
    }

    void
    append(const StencilNodes &others, const unsigned int j);

    /// Says which image node @p j is.
    void
    set_image(const unsigned int    j,
              const unsigned int    image,
              const Tensor<2, dim> &rotation,
              const bool            is_turned);

    /// Forces on the nodes, in entries from @p first on, become those on the
    /// unknowns: R^T f.
    void
    turn_back(const unsigned int first, Vector<double> &forces) const;

    /// The same for the rows and columns of their derivatives: R^T K R.
    void
    turn_back(const unsigned int first, FullMatrix<double> &matrix) const;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &dofs &images &rotations;
    }
  };
} // namespace stickslip

#endif
