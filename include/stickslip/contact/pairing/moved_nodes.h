#ifndef stickslip_contact_pairing_moved_nodes_h
#define stickslip_contact_pairing_moved_nodes_h

#include <stickslip/contact/surface/surface_face.h>

#include <deal.II/base/bounding_box.h>

#include <vector>

namespace stickslip
{
  /// How far the nodes of some faces have moved since a moment.
  template <int dim>
  class MovedNodes
  {
  public:
    /// Reads the positions of the nodes of @p faces from ghosted displacements.
    void
    read(const std::vector<const SurfaceFace<dim> *> &faces,
         const LA::Vector                            &u);

    /// Largest motion on this rank of a node since remember() [length]; 0
    /// before the first.
    double
    largest_motion() const;

    /// The positions that were read are the ones to compare with.
    void
    remember()
    {
      remembered = now;
    }

    /// Boxes around the nodes of the faces, as they were read.
    std::vector<BoundingBox<dim>>
    boxes() const;

  private:
    std::vector<std::vector<Tensor<1, dim>>> now; ///< [face][node]
    std::vector<std::vector<Tensor<1, dim>>> remembered;
  };
} // namespace stickslip

#endif
