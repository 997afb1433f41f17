#ifndef stickslip_contact_pairing_corner_normals_h
#define stickslip_contact_pairing_corner_normals_h

#include <stickslip/contact/pairing/segment_search.h>
#include <stickslip/contact/point/mortar_node.h>

#include <vector>

namespace stickslip
{
  /**
   * The sum of normals M of a node at a corner. A corner has no normal of its
   * own: on a smooth partner it is pressed along the partner's normal, whatever
   * its own faces do. So M is what of the master's normal t opposite the node,
   * turned round, is in the cone of normals: all non-negative combinations of
   * the faces' normals. On a face that lies flat on the master this is the
   * face's normal.
   *
   * t must not jump from facet to facet of the master. It is normal to the
   * plane that fits what is opposite the faces around the node: to S_d, the
   * integrals of (xi_d - mean of xi_d) (x_m - mean of x_m) over the segments,
   * with a weight that is linear, 1 at the node and 0 at the sides of the face
   * opposite it. They are continuous in the configuration, as x_m is in xi, and
   * on a plane master t is its normal.
   *
   * Sets n, length and the parts of the frame; false, and nothing, if the node
   * has no partner or the cone does not face it.
   */
  template <int dim>
  bool
  find_corner_normal(const FaceShape<dim>                 &shape,
                     const MortarNode<dim>                &node,
                     const std::vector<MortarFace<dim>>   &faces,
                     const std::vector<FaceSegments<dim>> &segments,
                     const MasterPatch<dim>               &patch,
                     MortarFrame<dim>                     &frame);

  /**
   * Derivative of M, for a frame that find_corner_normal() has set, added to
   * @p D_normal [stencil node, then master node of the average]. Segments that
   * do not move (@p partners_move is false) leave that of the positions.
   */
  template <int dim>
  void
  add_corner_normal_derivative(const FaceShape<dim>                 &shape,
                               const MortarNode<dim>                &node,
                               const MortarAverage<dim>             &average,
                               const std::vector<MortarFace<dim>>   &faces,
                               const std::vector<FaceSegments<dim>> &segments,
                               const MasterPatch<dim>               &patch,
                               const bool                   partners_move,
                               std::vector<Tensor<2, dim>> &D_normal);
} // namespace stickslip

#endif
