#include <stickslip/contact/pairing/far_surfaces.h>

#include <stickslip/contact/surface/facet_rise.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace stickslip
{
  namespace
  {
    /// Of the distance between nodes: gaps of the surfaces, and of an average
    /// that is one of a closed node, or will soon be.
    constexpr double far_apart   = 0.5;
    constexpr double hardly_open = 0.25;

    constexpr double nowhere = std::numeric_limits<double>::lowest();



    /// Depth of node @p k of @p slave behind the tangent plane of the master at
    /// the integration point nearest to it, along the normal in the middle of
    /// the face; `nowhere` if there is none on the half way to the next node.
    template <int dim>
    double
    depth_of_node(const FaceShape<dim>    &shape,
                  const unsigned int       k,
                  const MortarFace<dim>   &slave,
                  const FaceSegments<dim> &segments,
                  const MasterPatch<dim>  &patch)
    {
      const auto distance = [&](const SegmentPoint<dim> &point) {
        return point.xi.distance(shape.node(k));
      };
      const auto nearest = std::min_element(segments.points.begin(),
                                            segments.points.end(),
                                            [&](const auto &a, const auto &b) {
                                              return distance(a) < distance(b);
                                            });
      if (nearest == segments.points.end() ||
          distance(*nearest) > 0.5 / shape.degree())
        return nowhere;
      Pairing<dim> there;
      there.face  = segments.masters[nearest->master];
      there.chart = nearest->chart;
      there.xi    = nearest->eta;
      MasterPoint<dim> master;
      patch.evaluate(there, patch.configuration(there.face), master);
      const Tensor<1, dim> outward =
        outward_normal(slave.face,
                       surface_tangents<dim>(shape.at_centre().gradient,
                                             slave.positions));
      return master.n * (slave.positions[k] - master.x) /
               (master.n * outward / outward.norm()) +
             rise_between(slave.face,
                          shape.node(k),
                          patch.face(there.face),
                          there.xi) -
             (slave.gap_offsets.empty() ? 0. : slave.gap_offsets[k]);
    }
  } // namespace



  template <int dim>
  bool
  is_closed_from_afar(const FaceShape<dim>                  &shape,
                      const MortarNode<dim>                 &node,
                      const std::vector<MortarFace<dim>>    &faces,
                      const std::vector<FaceSegments<dim>>  &segments,
                      const std::vector<FaceIntegrals<dim>> &integrals,
                      const MasterPatch<dim>                &patch)
  {
    double area = 0., depth = 0.;
    double node_distance = std::numeric_limits<double>::max();
    for (const auto &around : node.faces)
      {
        const FaceIntegrals<dim> &integral = integrals[around.face];
        const double              here     = faces[around.face].node_distance;
        if (integral.deepest > node.gap_offset - far_apart * here)
          return false;
        area += integral.area[around.multiplier];
        depth += integral.depth[around.multiplier];
        node_distance = std::min(node_distance, here);
      }
    if (depth < (node.gap_offset - hardly_open * node_distance) * area)
      return false; // open anyway
    return std::none_of(node.faces.begin(),
                        node.faces.end(),
                        [&](const auto &around) {
                          const MortarFace<dim> &slave = faces[around.face];
                          return depth_of_node(shape,
                                               around.displacement,
                                               slave,
                                               segments[around.face],
                                               patch) >
                                 node.gap_offset -
                                   far_apart * slave.node_distance;
                        });
  }

#define INSTANTIATE(dim)                                                     \
  template bool is_closed_from_afar(const FaceShape<dim> &,                  \
                                    const MortarNode<dim> &,                 \
                                    const std::vector<MortarFace<dim>> &,    \
                                    const std::vector<FaceSegments<dim>> &,  \
                                    const std::vector<FaceIntegrals<dim>> &, \
                                    const MasterPatch<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
