#include <stickslip/contact/results/contact_results.h>

#include <stickslip/contact/results/neighbour_points.h>

#include <deal.II/base/array_view.h>
#include <deal.II/base/mpi.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

namespace stickslip
{
  namespace
  {
    /// Multiplier shape function @p l at the displacement nodes of a face.
    template <int dim>
    std::vector<double>
    multiplier_at_nodes(const ContactPair<dim> &pair, const unsigned int l)
    {
      std::vector<double> values, L;
      for (unsigned int j = 0; j < pair.displacement_shape.n_nodes(); ++j)
        {
          pair.multiplier_shape.evaluate_values(pair.displacement_shape.node(j),
                                                L);
          values.push_back(L[l]);
        }
      return values;
    }



    template <int dim>
    ContactPointResult<dim>
    point_result(ContactAssembler<dim>   &contact,
                 const ContactPair<dim>  &pair,
                 const ContactPoint<dim> &point)
    {
      const ContactEvaluation<dim> &state = contact.evaluate(pair, point);
      ContactPointResult<dim>       result;
      result.reference_position = Point<dim>(point.geometry.reference_position);
      result.position           = Point<dim>(pair.slave_position(point).x);
      result.centre_of_force    = result.position;
      result.reference_weight   = pair.area_of(point);
      result.area_ratio         = pair.area_ratio(point);
      result.shape_values =
        pair.table.displacement[point.geometry.quadrature_index].value;
      if (pair.mortar)
        {
          result.shape_values =
            multiplier_at_nodes(pair, point.geometry.quadrature_index);
          if (point.pairing.paired)
            result.centre_of_force =
              Point<dim>(pair.mortar->average(point.geometry.mortar_node).x);
        }
      result.Lambda =
        tangential_vector<dim>(state.multipliers.Lambda, state.kinematics.tau);
      result.accumulated_slip = point.accumulated_slip;
      result.state  = shown_state(observe(point, state).state, pair.parameters);
      result.gap    = point.pairing.paired ? -state.kinematics.d_n : 0.;
      result.normal = -1. * state.kinematics.n;
      result.pressure = 0.;
      if (state.status.closed)
        {
          // the traction on the slave is minus t
          result.pressure = state.response.traction * state.kinematics.n;
          result.tangential_traction = -1. * state.response.traction +
                                       result.pressure * state.kinematics.n;
          if (!pair.parameters.is_tied()) // what is left is roundoff
            result.slip = state.kinematics.d_t;
        }
      result.image = pair.image_of_master(point);
      return result;
    }
  } // namespace



  template <int dim>
  std::vector<Tensor<1, dim>>
  nodal_averages(const ContactFaceResult<dim> &face,
                 Tensor<1, dim> ContactPointResult<dim>::*quantity)
  {
    std::vector<Tensor<1, dim>> averages(face.reference_positions.size());
    std::vector<double>         sums(averages.size(), 0.);
    for (const auto &point : face.all_points())
      for (unsigned int j = 0; j < sums.size(); ++j)
        if (point.shape_values[j] > 0.)
          {
            const double weight =
              point.shape_values[j] * point.reference_weight;
            averages[j] += weight * point.*quantity;
            sums[j] += weight;
          }
    for (unsigned int j = 0; j < sums.size(); ++j)
      if (sums[j] > 0.)
        averages[j] /= sums[j];
    return averages;
  }



  template <int dim>
  std::vector<ContactFaceResult<dim>>
  contact_results(ContactAssembler<dim> &contact)
  {
    std::vector<ContactFaceResult<dim>> results;
    const auto                         &pairs = contact.contact_pairs();
    for (unsigned int p = 0; p < pairs.size(); ++p)
      {
        const ContactPair<dim> &pair  = *pairs[p];
        const std::size_t       first = results.size();
        for (unsigned int f = 0; f < pair.slave_faces.size(); ++f)
          {
            ContactFaceResult<dim> face;
            face.pair   = p;
            face.degree = pair.displacement_shape.degree();
            face.cell   = pair.displacement_shape.reference_cell();
            face.reference_positions =
              pair.slave_faces[f].face.reference_positions;
            const auto &positions = pair.slave_positions(f);
            for (unsigned int j = 0; j < positions.size(); ++j)
              {
                face.displacements.push_back(
                  positions[j] - Tensor<1, dim>(face.reference_positions[j]));
                face.lambda_n.push_back(contact.lambda_n_at_node(pair, f, j));
              }
            results.push_back(face);
          }
        for (const auto &point : pair.points)
          results[first + point.geometry.slave_face].points.push_back(
            point_result(contact, pair, point));
        if (pair.mortar)
          add_points_of_neighbours(contact, p, results.data() + first);
        for (std::size_t f = first; f < results.size(); ++f)
          // as a vector it is known where there is a frame: at the points
          results[f].Lambda =
            nodal_averages(results[f], &ContactPointResult<dim>::Lambda);
      }
    return results;
  }



  template <int dim>
  std::string
  describe_contact(ContactAssembler<dim> &contact)
  {
    std::ostringstream text;
    const auto        &communicator = contact.get_communicator();
    for (const auto &pair : contact.contact_pairs())
      {
        std::array<unsigned int, n_contact_states> counts{};
        double                                     worst = -1.;
        Tensor<1, dim>                             where;
        for (const auto &point : pair->points)
          {
            const auto result = point_result(contact, *pair, point);
            ++counts[static_cast<unsigned int>(result.state)];
            const double error = is_closed(result.state)
                                   ? std::abs(result.gap)
                                   : std::max(0., -result.gap);
            if (error > worst)
              {
                worst = error;
                where = point.geometry.reference_position;
              }
          }
        Utilities::MPI::sum(
          ArrayView<const unsigned int>(counts.data(), counts.size()),
          communicator,
          ArrayView<unsigned int>(counts.data(), counts.size()));
        const auto extremes = Utilities::MPI::min_max_avg(worst, communicator);
        const auto wheres   = Utilities::MPI::all_gather(communicator, where);
        text << "  pair '" << pair->name << "': " << counts[1]
             << " points open, ";
        if (pair->parameters.is_tied())
          text << counts[5] << " tied, ";
        else if (pair->parameters.has_friction())
          text << counts[2] << " stick, " << counts[3] << " slip, ";
        else
          text << counts[4] << " closed, ";
        text << counts[0] << " unpaired; largest gap error " << extremes.max
             << " at reference position (" << wheres[extremes.max_index]
             << ")\n";
      }
    return text.str();
  }

#define INSTANTIATE(dim)                                        \
  template std::vector<ContactFaceResult<dim>> contact_results( \
    ContactAssembler<dim> &);                                   \
  template std::vector<Tensor<1, dim>> nodal_averages(          \
    const ContactFaceResult<dim> &,                             \
    Tensor<1, dim> ContactPointResult<dim>::*);                 \
  template std::string describe_contact(ContactAssembler<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
