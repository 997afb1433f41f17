#include <stickslip/contact/cycling/point_diagnosis.h>

#include <deal.II/grid/cell_id.h>

namespace stickslip
{
  namespace
  {
    /// "coarse cell_level:children/face", as CellId writes cells.
    std::string
    name_of_face(const FaceId &id)
    {
      return CellId(id.cell).to_string() + "/" + std::to_string(id.face);
    }



    template <int dim>
    PointDiagnosis<dim>
    diagnose_point(ContactAssembler<dim>   &contact,
                   const ContactPair<dim>  &pair,
                   const ContactPoint<dim> &point)
    {
      const ContactEvaluation<dim> &state = contact.evaluate(pair, point);
      PointDiagnosis<dim>           result{};
      result.name =
        name_of_face(pair.slave_faces[point.geometry.slave_face].face.id) +
        "/" + std::to_string(point.geometry.quadrature_index);
      result.reference_position = Point<dim>(point.geometry.reference_position);
      result.position           = Point<dim>(pair.slave_position(point).x);
      result.state = shown_state(observe(point, state).state, pair.parameters);
      result.was_paired    = point.initial_pairing.paired;
      result.is_far        = point.pairing.is_far;
      result.has_threshold = state.response.threshold > 0.;
      if (!point.pairing.paired)
        return result;
      result.gap   = -state.kinematics.d_n;
      result.facet = name_of_face(pair.patch->face(point.pairing.face).id);
      if (state.status.closed)
        result.pressure = state.response.traction * state.kinematics.n;
      if (pair.parameters.has_tangential_traction())
        result.Lambda =
          tangential_vector<dim>(state.multipliers.Lambda, state.kinematics.tau)
            .norm();
      return result;
    }
  } // namespace



  template <int dim>
  std::vector<PointDiagnosis<dim>>
  diagnose_points(ContactAssembler<dim>    &contact,
                  const StatusHistory<dim> &history)
  {
    const auto                       cycles = history.cycling_points();
    auto                             cycle  = cycles.begin();
    std::vector<PointDiagnosis<dim>> result;
    for (unsigned int p = 0; p < contact.contact_pairs().size(); ++p)
      {
        const ContactPair<dim> &pair = *contact.contact_pairs()[p];
        for (unsigned int i = 0; i < pair.points.size(); ++i)
          {
            const auto &point = pair.points[i];
            result.push_back(diagnose_point(contact, pair, point));
            auto &diagnosis = result.back();
            diagnosis.pair  = p;
            if (history.n_records() > 0)
              {
                diagnosis.history         = history.text(p, i);
                diagnosis.n_facet_changes = history.n_facet_changes(p, i);
              }
            diagnosis.treatment = history.treatment(p, i);
            diagnosis.keeps_facet =
              point.hysteresis.retention().overlap_factor > 0. &&
              pair.parameters.facet_overlap > 0.;
            if (cycle != cycles.end() && cycle->pair == p && cycle->point == i)
              {
                diagnosis.cycle         = cycle->kind;
                diagnosis.period        = cycle->period;
                diagnosis.changes_facet = cycle->changes_facet;
                ++cycle;
              }
          }
      }
    return result;
  }

  template std::vector<PointDiagnosis<2>>
  diagnose_points(ContactAssembler<2> &, const StatusHistory<2> &);
  template std::vector<PointDiagnosis<3>>
  diagnose_points(ContactAssembler<3> &, const StatusHistory<3> &);
} // namespace stickslip
