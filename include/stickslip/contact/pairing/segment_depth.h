#ifndef stickslip_contact_pairing_segment_depth_h
#define stickslip_contact_pairing_segment_depth_h

#include <stickslip/contact/pairing/contact_pair.h>

#include <optional>

namespace stickslip
{
  /// How a slave face lies to its master at an integration point of a segment.
  template <int dim>
  struct SegmentDepth
  {
    Tensor<1, dim> x;          ///< of the slave
    Tensor<1, dim> n;          ///< outward unit normal of the slave face
    double         depth = 0.; ///< behind the master, with the rise of facets
                               ///< and the user's gap offset [length]
  };

  /// At @p point, one of the @p segments of @p slave.
  template <int dim>
  SegmentDepth<dim>
  segment_depth(const FaceShape<dim>    &slave_shape,
                const MortarFace<dim>   &slave,
                const FaceSegments<dim> &segments,
                const SegmentPoint<dim> &point,
                const MasterPatch<dim>  &patch);

  /// How far the slave surface of a pair with segments is behind the master at
  /// the node of @p point itself [length]; nothing without a partner there.
  template <int dim>
  std::optional<double>
  node_depth(const ContactPair<dim> &pair, const ContactPoint<dim> &point);
} // namespace stickslip

#endif
