#ifndef stickslip_contact_pairing_face_boxes_h
#define stickslip_contact_pairing_face_boxes_h

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/tensor.h>

#include <vector>

namespace stickslip
{
  using namespace dealii;

  /// Box of the first @p n >= 1 @p positions, larger on each side by
  /// @p relative_margin times its diagonal.
  template <int dim>
  BoundingBox<dim>
  box_of(const std::vector<Tensor<1, dim>> &positions,
         const unsigned int                 n,
         const double                       relative_margin);

  /// Larger by @p amount [length] on each side.
  template <int dim>
  BoundingBox<dim>
  enlarged(const BoundingBox<dim> &box, const double amount);

  /// Not more than @p at_most boxes (a power of two) that cover @p boxes, by
  /// splitting along the longest direction.
  template <int dim>
  std::vector<BoundingBox<dim>>
  summarize(std::vector<BoundingBox<dim>> boxes, const unsigned int at_most);
} // namespace stickslip

#endif
