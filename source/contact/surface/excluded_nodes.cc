#include <stickslip/contact/surface/excluded_nodes.h>

#include <stickslip/base/user_error.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <exception>

namespace stickslip
{
  namespace
  {
    /// "x,y; x,y" -> points. Throws UserError.
    template <int dim>
    std::vector<Point<dim>>
    parse_points(const std::string &text, const std::string &path)
    {
      std::vector<Point<dim>> points;
      for (const std::string &item : Utilities::split_string_list(text, ';'))
        {
          const auto numbers = Utilities::split_string_list(item, ',');
          try
            {
              AssertThrow(numbers.size() == dim, ExcInternalError());
              Point<dim> point;
              for (unsigned int c = 0; c < dim; ++c)
                point[c] = Utilities::string_to_double(numbers[c]);
              points.push_back(point);
            }
          catch (const std::exception &)
            {
              throw UserError("'" + path + "' has '" + item + "': expected " +
                              std::to_string(dim) +
                              " numbers separated by commas, points separated "
                              "by semicolons.");
            }
        }
      return points;
    }
  } // namespace



  template <int dim>
  std::set<types::global_dof_index>
  excluded_slave_nodes(const std::vector<CollectedFace<dim>> &slave_faces,
                       const std::set<types::boundary_id>    &boundary,
                       const std::string                     &points_text,
                       const std::string                     &points_path,
                       const PeriodicImages<dim>             &images,
                       const hp::MappingCollection<dim>      &mapping,
                       const DoFHandler<dim>                 &dof_handler,
                       const MPI_Comm                        &communicator)
  {
    std::set<types::global_dof_index> excluded;
    const auto no_modulus = [](const types::material_id) { return 1.; };
    for (const auto &entry :
         collect_faces<dim>(mapping, dof_handler, boundary, no_modulus, true))
      for (unsigned int j = 0; j < entry.face.n_nodes; ++j)
        excluded.insert(images.original(entry.face.dofs[j * dim]));

    const auto points = parse_points<dim>(points_text, points_path);
    for (const Point<dim> &point : points)
      {
        unsigned int found = 0;
        for (const auto &slave : slave_faces)
          for (unsigned int j = 0; j < slave.face.n_nodes; ++j)
            if (slave.face.id.image == 0 &&
                slave.face.reference_positions[j].distance(point) <
                  1e-6 * slave.face.diameter)
              {
                excluded.insert(slave.face.dofs[j * dim]);
                ++found;
              }
        if (Utilities::MPI::sum(found, communicator) == 0)
          throw UserError("'" + points_path +
                          "': no slave node lies at one of the "
                          "points '" +
                          points_text + "'.");
      }
    return excluded;
  }

#define INSTANTIATE(dim)                                           \
  template std::set<types::global_dof_index> excluded_slave_nodes( \
    const std::vector<CollectedFace<dim>> &,                       \
    const std::set<types::boundary_id> &,                          \
    const std::string &,                                           \
    const std::string &,                                           \
    const PeriodicImages<dim> &,                                   \
    const hp::MappingCollection<dim> &,                            \
    const DoFHandler<dim> &,                                       \
    const MPI_Comm &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
