#include <stickslip/mesh/axis_of_revolution.h>

#include <stickslip/base/nearest_name.h>
#include <stickslip/base/user_error.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace stickslip
{
  namespace
  {
    /// Radii below this fraction of the largest coordinate are roundoff.
    constexpr double roundoff_of_radii = 1e-10;
  } // namespace



  template <int dim>
  void
  revolve_bodies(const Triangulation<dim> &triangulation, Bodies &bodies)
  {
    const MPI_Comm      communicator = triangulation.get_communicator();
    std::vector<double> smallest(bodies.n_bodies(),
                                 std::numeric_limits<double>::max());
    double              extent = 0.;
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned())
        for (const unsigned int v : cell->vertex_indices())
          {
            double &radius = smallest[bodies.body_of(cell->material_id())];
            radius         = std::min(radius, cell->vertex(v)[0]);
            extent         = std::max(extent, cell->vertex(v).norm());
          }
    const std::vector<double> of_this_rank = smallest;
    Utilities::MPI::min(of_this_rank, communicator, smallest);

    CrossSection &section   = bodies.cross_section;
    section.is_axisymmetric = true;
    section.radius_of_axis =
      roundoff_of_radii * Utilities::MPI::max(extent, communicator);
    for (unsigned int b = 0; b < bodies.n_bodies(); ++b)
      {
        Body &body        = bodies.bodies[b];
        body.reaches_axis = smallest[b] <= section.radius_of_axis;
        if (smallest[b] < -section.radius_of_axis)
          {
            std::ostringstream text;
            text << "Bodies/" << body.name << " reaches x = " << smallest[b]
                 << ", but with 'Axisymmetric = true' x is the radius. It has "
                    "to be 0 (the axis) or greater: model one half of the "
                    "section.";
            throw UserError(text.str());
          }
      }
  }



  std::vector<std::string>
  describe_axis(const Bodies &bodies)
  {
    if (!bodies.cross_section.is_axisymmetric)
      return {};
    std::vector<std::string> held;
    for (const Body &body : bodies.bodies)
      if (body.reaches_axis && !body.is_rigid)
        held.push_back(body.name);
    std::string text =
      "axisymmetric: x is the radius, y the axis; forces, "
      "areas and works are those of the whole bodies";
    if (!held.empty())
      text += "; no radial displacement on the axis of " + quoted_list(held);
    return {text};
  }



  template void
  revolve_bodies(const Triangulation<2> &, Bodies &);
  template void
  revolve_bodies(const Triangulation<3> &, Bodies &);
} // namespace stickslip
