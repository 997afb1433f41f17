#include <stickslip/contact/pairing/segment_depth.h>

#include <stickslip/contact/surface/facet_rise.h>

#include <vector>

namespace stickslip
{
  template <int dim>
  SegmentDepth<dim>
  segment_depth(const FaceShape<dim>    &slave_shape,
                const MortarFace<dim>   &slave,
                const FaceSegments<dim> &segments,
                const SegmentPoint<dim> &point,
                const MasterPatch<dim>  &patch)
  {
    const unsigned int   m = segments.masters[point.master];
    FaceShapeValues<dim> values;
    std::vector<double>  N_master;
    slave_shape.evaluate_gradients(point.xi, values);
    patch.evaluate_values(point.chart, point.eta, N_master);
    SegmentDepth<dim> there;
    there.x = interpolate<dim>(values.value, slave.positions);
    there.n =
      outward_normal(slave.face,
                     surface_tangents<dim>(values.gradient, slave.positions));
    there.n /= there.n.norm();
    there.depth =
      there.n * (there.x -
                 interpolate<dim>(N_master, patch.configuration(m).positions)) +
      rise_between(slave.face, point.xi, patch.face(m), point.eta);
    for (unsigned int k = 0; k < slave.gap_offsets.size(); ++k)
      there.depth -= values.value[k] * slave.gap_offsets[k];
    return there;
  }



  template <int dim>
  std::optional<double>
  node_depth(const ContactPair<dim> &pair, const ContactPoint<dim> &point)
  {
    const Pairing<dim> pairing = pair.find_pairing(point);
    if (!pairing.paired)
      return {};
    const auto &nodes = pair.patch->configuration(pairing.face).positions;
    const auto  slave = pair.slave_position(point);
    std::vector<double> N;
    pair.patch->evaluate_values(pairing.chart, pairing.xi, N);
    return pairing.n * (slave.x - interpolate<dim>(N, nodes)) -
           slave.gap_offset +
           rise_at(pair.patch->face(pairing.face), pairing.xi);
  }

#define INSTANTIATE(dim)                                                  \
  template SegmentDepth<dim>     segment_depth(const FaceShape<dim> &,    \
                                               const MortarFace<dim> &,   \
                                               const FaceSegments<dim> &, \
                                               const SegmentPoint<dim> &, \
                                               const MasterPatch<dim> &); \
  template std::optional<double> node_depth(const ContactPair<dim> &,     \
                                            const ContactPoint<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
