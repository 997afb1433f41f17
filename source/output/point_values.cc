#include <stickslip/output/point_values.h>

#include <stickslip/base/user_error.h>
#include <stickslip/mesh/reference_cells.h>

#include <deal.II/grid/cell_id.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>

namespace stickslip
{
  namespace
  {
    /// A point this far outside (in units of a cell) still belongs to a cell.
    constexpr double outside_cell_tolerance = 0.05;

    /// Below this distance it is inside, up to roundoff: cells of equal right.
    constexpr double inside_cell_tolerance = 1e-8;

    /// A rank's offer to own a point; the smallest wins.
    struct PointOffer
    {
      double      distance = std::numeric_limits<double>::max();
      std::string cell_id;

      bool
      operator<(const PointOffer &other) const
      {
        // Distances of equal cells may differ by roundoff.
        if (std::abs(distance - other.distance) > inside_cell_tolerance)
          return distance < other.distance;
        if (cell_id.size() != other.cell_id.size())
          return cell_id.size() < other.cell_id.size();
        return cell_id < other.cell_id;
      }

      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int /*version*/)
      {
        archive &distance &cell_id;
      }
    };
  } // namespace



  template <int dim>
  PointValues<dim>::PointValues(const OutputParameters &parameters,
                                const Bodies           &bodies,
                                const MPI_Comm          communicator)
    : bodies(bodies)
    , communicator(communicator)
    , table(parameters.directory + "/points",
            communicator,
            /*write_text=*/false)
  {
    for (const auto &[name, point] : parameters.points)
      {
        const std::string path = "Output/Points/" + name;
        if (point.position.size() != dim)
          throw UserError(path + "/Position: found " +
                          std::to_string(point.position.size()) +
                          " coordinates, the problem has " +
                          std::to_string(dim) + " dimensions.");
        NamedPoint named_point;
        named_point.name = name;
        named_point.body = bodies.index_of(point.body, path + "/Body");
        for (unsigned int d = 0; d < dim; ++d)
          named_point.position[d] = point.position[d];
        named_point.material_state = point.material_state;
        points.push_back(named_point);
        const auto pair = std::find(parameters.pair_names.begin(),
                                    parameters.pair_names.end(),
                                    point.contact_pair);
        if (pair != parameters.pair_names.end())
          {
            surface_points.push_back(
              {static_cast<unsigned int>(pair - parameters.pair_names.begin()),
               named_point.position,
               path + "/Position"});
            names_of_surface_points.push_back(name);
          }
      }
  }



  template <int dim>
  void
  PointValues<dim>::locate(const hp::MappingCollection<dim> &mapping,
                           const DoFHandler<dim>            &dof_handler)
  {
    locations.clear();
    std::vector<PointOffer> offers(points.size());
    for (unsigned int p = 0; p < points.size(); ++p)
      {
        locations.push_back(locate_locally(points[p], mapping, dof_handler));
        if (locations[p].cell.state() == IteratorState::valid)
          {
            offers[p].distance = locations[p].distance;
            offers[p].cell_id  = locations[p].cell->id().to_string();
          }
      }

    const auto all_offers = Utilities::MPI::all_gather(communicator, offers);
    const unsigned int this_rank =
      Utilities::MPI::this_mpi_process(communicator);
    for (unsigned int p = 0; p < points.size(); ++p)
      {
        unsigned int owner = 0;
        for (unsigned int rank = 1; rank < all_offers.size(); ++rank)
          if (all_offers[rank][p] < all_offers[owner][p])
            owner = rank;

        if (all_offers[owner][p].distance > outside_cell_tolerance)
          {
            std::ostringstream position;
            position << points[p].position;
            throw UserError("Output/Points/" + points[p].name +
                            "/Position: the body '" +
                            bodies.bodies[points[p].body].name +
                            "' has no cell that contains (" + position.str() +
                            ") in its undeformed mesh.");
          }
        if (owner != this_rank)
          locations[p] = Location();
      }
  }



  template <int dim>
  typename PointValues<dim>::Location
  PointValues<dim>::locate_locally(const NamedPoint                 &point,
                                   const hp::MappingCollection<dim> &mapping,
                                   const DoFHandler<dim> &dof_handler) const
  {
    Location   best;
    PointOffer best_offer;
    for (const auto &cell : dof_handler.active_cell_iterators())
      if (cell->is_locally_owned() &&
          bodies.body_of(cell->material_id()) == point.body)
        {
          // The sphere around a cell; a quarter more for curved sides.
          if (cell->center().distance(point.position) > 0.75 * cell->diameter())
            continue;
          Point<dim> unit_point;
          try
            {
              unit_point =
                mapping[cell->active_fe_index()].transform_real_to_unit_cell(
                  cell, point.position);
            }
          catch (const typename Mapping<dim>::ExcTransformationFailed &)
            {
              continue; // far outside of a distorted cell
            }
          PointOffer offer;
          offer.distance =
            distance_to_unit_cell(cell->reference_cell(), unit_point);
          offer.cell_id = cell->id().to_string();
          if (offer.distance <= outside_cell_tolerance && offer < best_offer)
            {
              best_offer = offer;
              best.cell  = cell;
              best.unit_point =
                project_to_unit_cell(cell->reference_cell(), unit_point);
              best.distance = offer.distance;
            }
        }
    return best;
  }



  template <int dim>
  std::vector<Tensor<1, dim>>
  PointValues<dim>::evaluate(const LA::Vector &displacement) const
  {
    AssertDimension(locations.size(), points.size());
    Vector<double>      cell_values;
    std::vector<double> values(points.size() * dim, 0.);

    for (unsigned int p = 0; p < points.size(); ++p)
      if (locations[p].cell.state() == IteratorState::valid)
        {
          const FiniteElement<dim> &element = locations[p].cell->get_fe();
          cell_values.reinit(element.n_dofs_per_cell());
          locations[p].cell->get_dof_values(displacement, cell_values);
          for (unsigned int i = 0; i < cell_values.size(); ++i)
            values[p * dim + element.system_to_component_index(i).first] +=
              cell_values[i] * element.shape_value(i, locations[p].unit_point);
        }
    // All but the owner contribute zeros, so that the sum is exact.
    if (!values.empty())
      Utilities::MPI::sum(values, communicator, values);

    std::vector<Tensor<1, dim>> result(points.size());
    for (unsigned int p = 0; p < points.size(); ++p)
      for (unsigned int d = 0; d < dim; ++d)
        result[p][d] = values[p * dim + d];
    return result;
  }



  template <int dim>
  void
  PointValues<dim>::add_material_state(const unsigned int         p,
                                       const MaterialFields<dim> &material,
                                       std::vector<NamedValue>   &values) const
  {
    constexpr std::array<const char *, 6> components{
      {"xx", "yy", "zz", "xy", "xz", "yz"}};
    const unsigned int  n_stresses = dim == 2 ? 4 : 6;
    std::vector<double> state(n_stresses + material.history_names.size(), 0.);
    if (locations[p].cell.state() == IteratorState::valid)
      {
        const auto cell_values = material.evaluate(locations[p].cell);
        const FiniteElement<dim> &element = locations[p].cell->get_fe();
        const auto                places =
          cell_quadrature<dim>(element.reference_cell(), element.degree)
            .get_points();
        const unsigned int q =
          std::min_element(places.begin(),
                           places.end(),
                           [&](const Point<dim> &a, const Point<dim> &b) {
                             return a.distance(locations[p].unit_point) <
                                    b.distance(locations[p].unit_point);
                           }) -
          places.begin();
        if (!cell_values.cauchy_stress.empty())
          {
            for (unsigned int c = 0; c < n_stresses; ++c)
              state[c] = cell_values.cauchy_stress[q].access_raw_entry(c);
            std::copy(cell_values.history[q].begin(),
                      cell_values.history[q].end(),
                      state.begin() + n_stresses);
          }
      }
    Utilities::MPI::sum(state, communicator, state);
    for (unsigned int c = 0; c < state.size(); ++c)
      if (c < n_stresses)
        values.push_back({"stress",
                          points[p].name + ".cauchy_stress_" + components[c],
                          state[c]});
      else
        values.push_back(
          {"history",
           points[p].name + "." + material.history_names[c - n_stresses],
           state[c]});
  }



  template <int dim>
  std::vector<typename PointValues<dim>::NamedValue>
  PointValues<dim>::named_values(
    const LA::Vector                          &displacement,
    const MaterialFields<dim>                 &material,
    const std::vector<ContactFaceResult<dim>> &faces) const
  {
    constexpr std::array<const char *, 3> axis{{"_x", "_y", "_z"}};
    const std::vector<Tensor<1, dim>> displacements = evaluate(displacement);
    std::vector<NamedValue>           values;
    for (unsigned int p = 0; p < points.size(); ++p)
      for (unsigned int d = 0; d < dim; ++d)
        values.push_back(
          {"displacement", points[p].name + axis[d], displacements[p][d]});
    for (unsigned int p = 0; p < points.size(); ++p)
      if (points[p].material_state)
        add_material_state(p, material, values);
    add_contact(faces, values);
    return values;
  }



  template <int dim>
  void
  PointValues<dim>::add_contact(
    const std::vector<ContactFaceResult<dim>> &faces,
    std::vector<NamedValue>                   &values) const
  {
    const auto contact = values_on_surface(surface_points, faces, communicator);
    for (unsigned int p = 0; p < contact.size(); ++p)
      {
        const std::string name = names_of_surface_points[p] + ".";
        values.push_back({"traction", name + "pressure", contact[p].pressure});
        values.push_back({"gap", name + "gap", contact[p].gap});
        for (unsigned int d = 0; d < dim; ++d)
          values.push_back({"traction",
                            name + "tangential_traction_" + "xyz"[d],
                            contact[p].tangential_traction[d]});
      }
  }



  template <int dim>
  void
  PointValues<dim>::resume(const double time)
  {
    table.resume(time);
  }



  template <int dim>
  void
  PointValues<dim>::write(const unsigned int         step,
                          const double               time,
                          const LA::Vector          &displacement,
                          const MaterialFields<dim> &material,
                          const std::vector<ContactFaceResult<dim>> &faces)
  {
    if (points.empty())
      return;
    table.add("step", step);
    table.add("time", time);
    for (const NamedValue &result : named_values(displacement, material, faces))
      table.add(result.name, result.value);
    table.finish_row();
  }



  template class PointValues<2>;
  template class PointValues<3>;
} // namespace stickslip
