#include <stickslip/adaptivity/contact_samples.h>

#include <stickslip/contact/assembly/contact_scales.h>
#include <stickslip/contact/surface/facet_rise.h>

#include <deal.II/base/mpi.h>

#include <deal.II/grid/cell_id.h>

namespace stickslip
{
  namespace
  {
    template <int dim>
    SampledPoint<dim>
    sampled(const ContactPair<dim>       &pair,
            const ContactPoint<dim>      &point,
            const ContactEvaluation<dim> &state)
    {
      SampledPoint<dim> result;
      result.paired = point.pairing.paired;
      result.closed = result.paired && state.status.closed;
      result.stick  = state.status.stick;
      result.n      = state.kinematics.n;
      if (result.closed)
        {
          result.traction  = -1. * state.response.traction;
          result.threshold = state.response.threshold;
        }
      result.stiffness = contact_stiffness(pair, point);
      return result;
    }



    /// Those of a mortar node: the points of the segments around it.
    template <int dim, typename Visitor>
    void
    visit_segments(const ContactPair<dim>  &pair,
                   const unsigned int       node_number,
                   const SampledPoint<dim> &point,
                   const Visitor           &visit)
    {
      const MortarNode<dim> &node   = pair.mortar->node(node_number);
      const auto             motion = [](const std::vector<double> &N,
                             const auto                &positions,
                             const auto                &old_positions) {
        return interpolate<dim>(N, positions) -
               interpolate<dim>(N, old_positions);
      };
      std::vector<double> L;
      for (const auto &around : node.faces)
        {
          const MortarFace<dim> &slave =
            pair.mortar->mortar_faces()[around.face];
          const FaceSegments<dim> &segments =
            pair.mortar->segments(around.face);
          for (const SegmentPoint<dim> &place : segments.points)
            {
              const unsigned int m      = segments.masters[place.master];
              const auto        &master = pair.patch->configuration(m);
              ContactSample<dim> sample(slave.face, pair.patch->face(m));
              pair.displacement_shape.evaluate_values(place.xi, sample.N_slave);
              pair.patch->evaluate_values(place.chart,
                                          place.eta,
                                          sample.N_master);
              pair.multiplier_shape.evaluate_values(place.xi, L);
              sample.weight = place.weight *
                              combination(slave.extended, around.multiplier, L);
              double offset =
                node.gap_offset - rise_between(slave.face,
                                               place.xi,
                                               pair.patch->face(m),
                                               place.eta);
              for (unsigned int k = 0; k < slave.gap_offsets.size(); ++k)
                offset += sample.N_slave[k] * slave.gap_offsets[k];
              const Tensor<1, dim> r =
                interpolate<dim>(sample.N_slave, slave.positions) -
                interpolate<dim>(sample.N_master, master.positions);
              const Tensor<1, dim> w =
                motion(sample.N_slave, slave.positions, slave.old_positions) -
                motion(sample.N_master,
                       master.positions,
                       pair.patch->old_configuration(m).positions);
              sample.d_n = point.n * r - offset;
              sample.d_t = w - (point.n * w) * point.n;
              visit(pair, point, sample);
            }
        }
    }
  } // namespace



  template <int dim>
  void
  for_each_sample(ContactAssembler<dim> &contact,
                  const std::function<void(const ContactPair<dim> &,
                                           const SampledPoint<dim> &,
                                           const ContactSample<dim> &)> &visit)
  {
    for_each_point(
      contact,
      [&](const ContactPair<dim> &pair, const ContactPoint<dim> &point) {
        if (!point.pairing.paired)
          return;
        const ContactEvaluation<dim> &state = contact.evaluate(pair, point);
        const SampledPoint<dim>       known = sampled(pair, point, state);
        if (pair.mortar)
          return visit_segments(pair, point.geometry.mortar_node, known, visit);
        ContactSample<dim> sample(
          pair.slave_faces[point.geometry.slave_face].face,
          pair.patch->face(point.pairing.face));
        sample.N_slave =
          pair.table.displacement[point.geometry.quadrature_index].value;
        pair.patch->evaluate_values(point.pairing.chart,
                                    point.pairing.xi,
                                    sample.N_master);
        sample.weight = pair.area_of(point);
        sample.d_n    = state.kinematics.d_n;
        sample.d_t    = state.kinematics.d_t;
        visit(pair, known, sample);
      });
  }



  template <int dim>
  std::vector<double> &
  FaceMessages<dim>::to(const SurfaceFace<dim> &face, const unsigned int n)
  {
    std::vector<double> &numbers = messages[face.owner][face.id];
    numbers.resize(n, 0.);
    return numbers;
  }



  template <int dim>
  std::vector<typename FaceMessages<dim>::Received>
  FaceMessages<dim>::exchange(const Triangulation<dim> &triangulation) const
  {
    using Message = std::pair<FaceId, std::vector<double>>;
    std::map<unsigned int, std::vector<Message>> to_send;
    for (const auto &[owner, of_owner] : messages)
      to_send[owner].assign(of_owner.begin(), of_owner.end());
    std::map<FaceId, std::vector<double>> sums;
    for (const auto &from :
         Utilities::MPI::some_to_some(triangulation.get_communicator(),
                                      to_send))
      for (const auto &[face, numbers] : from.second)
        {
          std::vector<double> &sum = sums[face];
          sum.resize(numbers.size(), 0.);
          for (unsigned int i = 0; i < numbers.size(); ++i)
            sum[i] += numbers[i];
        }
    std::vector<Received> received;
    for (const auto &[face, numbers] : sums)
      received.push_back(
        {typename Triangulation<dim>::active_cell_iterator(
           triangulation.create_cell_iterator(CellId(face.cell))),
         face.face,
         numbers});
    return received;
  }

#define INSTANTIATE(dim)                                      \
  template void for_each_sample(                              \
    ContactAssembler<dim> &,                                  \
    const std::function<void(const ContactPair<dim> &,        \
                             const SampledPoint<dim> &,       \
                             const ContactSample<dim> &)> &); \
  template class FaceMessages<dim>;
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
