// Shared by the mesh tests: bodies by name and what is printed of a mesh.
// Everything printed is independent of the number of ranks.

#ifndef stickslip_tests_print_mesh_h
#define stickslip_tests_print_mesh_h

#include "print.h"

#include <stickslip/base/user_error.h>
#include <stickslip/mesh/mesh_builder.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <sstream>
#include <string>
#include <vector>

using namespace stickslip;

namespace
{
  const MPI_Comm comm = MPI_COMM_WORLD;

  std::string
  text(const double value)
  {
    char buffer[32];
    std::snprintf(buffer,
                  sizeof(buffer),
                  "%.6g",
                  std::abs(value) < 1e-12 ? 0. : value);
    return buffer;
  }



  [[maybe_unused]] BodyParameters
  generated(const std::string &generator, const std::string &arguments)
  {
    BodyParameters body;
    body.generator = generator;
    body.arguments = arguments;
    body.material  = "steel";
    return body;
  }



  template <int dim>
  void
  print_bodies(const Mesh<dim> &mesh)
  {
    const auto    &triangulation = *mesh.triangulation;
    const unsigned n_bodies      = mesh.bodies.n_bodies();
    const double   large         = std::numeric_limits<double>::max();

    std::vector<unsigned int>        n_cells(mesh.bodies.regions.size());
    std::vector<double>              volume(n_bodies);
    std::vector<Point<dim>>          low(n_bodies), high(n_bodies);
    std::map<unsigned, unsigned int> n_faces;
    for (unsigned int b = 0; b < n_bodies; ++b)
      {
        for (unsigned int d = 0; d < dim; ++d)
          {
            low[b][d]  = large;
            high[b][d] = -large;
          }
        for (const auto id : mesh.bodies.bodies[b].boundary_ids)
          n_faces[mesh.bodies.global_boundary_id(b, id)] = 0;
      }

    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          const unsigned int b = mesh.bodies.body_of(cell->material_id());
          ++n_cells[cell->material_id()];
          volume[b] += cell->measure();
          for (const unsigned int v : cell->vertex_indices())
            for (unsigned int d = 0; d < dim; ++d)
              {
                low[b][d]  = std::min(low[b][d], cell->vertex(v)[d]);
                high[b][d] = std::max(high[b][d], cell->vertex(v)[d]);
              }
          for (const auto &face : cell->face_iterators())
            if (face->at_boundary())
              ++n_faces.at(face->boundary_id());
        }

    print("  cells " + std::to_string(triangulation.n_global_active_cells()));
    for (unsigned int b = 0; b < n_bodies; ++b)
      {
        const Body        &body = mesh.bodies.bodies[b];
        std::ostringstream line;
        line << "  body " << body.name << (body.is_rigid ? " (rigid)" : "")
             << ": volume " << text(Utilities::MPI::sum(volume[b], comm))
             << ", box";
        for (unsigned int d = 0; d < dim; ++d)
          line << " [" << text(Utilities::MPI::min(low[b][d], comm)) << ", "
               << text(Utilities::MPI::max(high[b][d], comm)) << "]";
        line << ", faces";
        for (const auto id : body.boundary_ids)
          line << " " << id << ":"
               << Utilities::MPI::sum(
                    n_faces[mesh.bodies.global_boundary_id(b, id)], comm);
        print(line.str());
      }
    for (unsigned int r = 0; r < mesh.bodies.regions.size(); ++r)
      print("  region " + std::to_string(r) + ": body " +
            std::to_string(mesh.bodies.regions[r].body) + ", material '" +
            mesh.bodies.regions[r].material + "', cells " +
            std::to_string(Utilities::MPI::sum(n_cells[r], comm)));
  }



  template <int dim>
  Mesh<dim>
  show(const std::string                  &title,
       const NamedList<BodyParameters>    &bodies,
       const MeshParameters               &parameters = MeshParameters(),
       const std::vector<PeriodicRequest> &periodic   = {})
  {
    print(title);
    Mesh<dim> mesh = build_mesh<dim>(parameters, bodies, periodic, comm);
    print_bodies(mesh);
    return mesh;
  }
} // namespace

#endif
