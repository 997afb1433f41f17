#include <stickslip/output/contact_lines.h>

#include <algorithm>

namespace stickslip
{
  namespace
  {
    template <int dim>
    Point<dim>
    point_of(const std::vector<double> &coordinates)
    {
      Point<dim> point;
      for (unsigned int d = 0; d < dim; ++d)
        point[d] = coordinates.at(d);
      return point;
    }



    template <int dim>
    void
    add_vector(const std::string    &name,
               const Tensor<1, dim> &vector,
               StatisticsTable      &table)
    {
      for (unsigned int d = 0; d < dim; ++d)
        table.add(name + "xyz"[d], vector[d]);
    }
  } // namespace



  template <int dim>
  ContactLines<dim>::ContactLines(const OutputParameters &parameters,
                                  const MPI_Comm          communicator)
    : communicator(communicator)
  {
    for (const auto &[name, line] : parameters.lines)
      {
        const unsigned int pair = std::find(parameters.pair_names.begin(),
                                            parameters.pair_names.end(),
                                            line.contact_pair) -
                                  parameters.pair_names.begin();
        const Point<dim> from = point_of<dim>(line.from),
                         to   = point_of<dim>(line.to);
        std::vector<SurfacePoint<dim>> points;
        for (unsigned int i = 0; i < line.n_points; ++i)
          points.push_back({pair,
                            from + i / (line.n_points - 1.) * (to - from),
                            "Output/Contact lines/" + name});
        lines.push_back({points,
                         StatisticsTable(parameters.directory + "/line_" + name,
                                         communicator,
                                         /*write_text=*/false)});
      }
  }



  template <int dim>
  void
  ContactLines<dim>::resume(const double time)
  {
    for (Line &line : lines)
      line.table.resume(time);
  }



  template <int dim>
  void
  ContactLines<dim>::write(const unsigned int                         step,
                           const double                               time,
                           const std::vector<ContactFaceResult<dim>> &faces)
  {
    for (Line &line : lines)
      {
        const auto values = values_on_surface(line.points, faces, communicator);
        for (unsigned int i = 0; i < values.size(); ++i)
          {
            const Point<dim> &position = line.points[i].reference_position;
            line.table.add("step", step);
            line.table.add("time", time);
            line.table.add(
              "distance", position.distance(line.points[0].reference_position));
            add_vector<dim>("reference_", position, line.table);
            add_vector<dim>("", position + values[i].displacement, line.table);
            line.table.add("pressure", values[i].pressure);
            line.table.add("gap", values[i].gap);
            add_vector("tangential_traction_",
                       values[i].tangential_traction,
                       line.table);
            line.table.finish_row();
          }
      }
  }

  template class ContactLines<2>;
  template class ContactLines<3>;
} // namespace stickslip
