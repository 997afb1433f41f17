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



    /// Of the width of a cell between nodes: an integration point is closer to
    /// a node if the whole cell has a master opposite.
    constexpr double close_to_node = 0.25;



    /// Depth of node @p k of @p slave behind the tangent plane of the master at
    /// the integration point nearest to it, along its own normal; `nowhere` if
    /// none is close to it, or if that plane is seen from its edge.
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
          distance(*nearest) > close_to_node / shape.degree())
        return nowhere;
      Pairing<dim> there;
      there.face  = segments.masters[nearest->master];
      there.chart = nearest->chart;
      there.xi    = nearest->eta;
      MasterPoint<dim> master;
      patch.evaluate(there, patch.configuration(there.face), master);
      const Tensor<1, dim> outward =
        outward_normal(slave.face,
                       surface_tangents<dim>(shape.at_node(k).gradient,
                                             slave.positions));
      const double cosine = master.n * outward / outward.norm();
      if (cosine < patch.tolerances.least_cosine)
        return nowhere;
      return master.n * (slave.positions[k] - master.x) / cosine +
             rise_between(slave.face,
                          shape.node(k),
                          patch.face(there.face),
                          there.xi) -
             (slave.gap_offsets.empty() ? 0. : slave.gap_offsets[k]);
    }



    template <int dim>
    NodeGap
    node_gap_of(const FaceShape<dim>                  &shape,
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
          area += integrals[around.face].area[around.multiplier];
          depth += integrals[around.face].depth[around.multiplier];
          node_distance =
            std::min(node_distance, faces[around.face].node_distance);
        }
      if (area <= 0. ||
          depth < (node.gap_offset - hardly_open * node_distance) * area)
        return NodeGap::open;
      const auto touches = [&](const auto &around, const double deepest) {
        return deepest >
               node.gap_offset - far_apart * faces[around.face].node_distance;
      };
      for (const auto &around : node.faces)
        if (touches(around, integrals[around.face].deepest))
          return NodeGap::near;
      for (const auto &around : node.faces)
        if (touches(around,
                    depth_of_node(shape,
                                  around.displacement,
                                  faces[around.face],
                                  segments[around.face],
                                  patch)))
          return NodeGap::near;
      return NodeGap::far;
    }
  } // namespace



  template <int dim>
  void
  FarNodes<dim>::find(const FaceShape<dim>                  &shape,
                      const std::vector<MortarNode<dim>>    &nodes,
                      const std::vector<MortarFace<dim>>    &faces,
                      const std::vector<FaceSegments<dim>>  &segments,
                      const std::vector<FaceIntegrals<dim>> &integrals,
                      const MasterPatch<dim>                &patch)
  {
    gaps.clear();
    for (const auto &node : nodes)
      gaps.push_back(
        node_gap_of(shape, node, faces, segments, integrals, patch));
    has_touched.resize(nodes.size(), false);
  }



  template <int dim>
  void
  FarNodes<dim>::accept_iterate()
  {
    for (unsigned int i = 0; i < gaps.size(); ++i)
      has_touched[i] =
        gaps[i] == NodeGap::near || (gaps[i] == NodeGap::far && has_touched[i]);
  }



  template <int dim>
  void
  FarNodes<dim>::forget_touches()
  {
    has_touched.assign(has_touched.size(), false);
  }

  template class FarNodes<2>;
  template class FarNodes<3>;
} // namespace stickslip
