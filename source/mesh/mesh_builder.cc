#include <stickslip/mesh/mesh_builder.h>

#include <stickslip/base/short_message.h>
#include <stickslip/base/user_error.h>
#include <stickslip/mesh/axis_of_revolution.h>
#include <stickslip/mesh/body_mesh.h>
#include <stickslip/mesh/cell_distribution.h>
#include <stickslip/mesh/joined_mesh.h>
#include <stickslip/mesh/local_refinement.h>
#include <stickslip/mesh/mesh_checks.h>
#include <stickslip/mesh/reference_cells.h>

#include <deal.II/distributed/tria.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace stickslip
{
  namespace
  {
    /// Appends a body to the list of bodies and its cells to the joined mesh.
    template <int dim>
    void
    append_body(const std::string    &name,
                const BodyParameters &parameters,
                const BodyMesh<dim>  &body_mesh,
                Bodies               &bodies,
                JoinedMesh<dim>      &joined_mesh)
    {
      const unsigned int index = bodies.bodies.size();
      Body               body;
      body.name       = name;
      body.is_rigid   = parameters.moves_as_a_whole();
      body.parameters = parameters;
      body.boundaries = body_mesh.boundaries;
      body.cells      = reference_cell_of(body_mesh.triangulation);
      const auto ids  = body_mesh.triangulation.get_boundary_ids();
      body.boundary_ids.insert(ids.begin(), ids.end());
      bodies.bodies.push_back(body);
      for (const std::string &material : body_mesh.materials)
        bodies.regions.push_back(Region{index, material});
      std::map<types::boundary_id, types::boundary_id> global_ids;
      for (const types::boundary_id id : body.boundary_ids)
        global_ids[id] = bodies.global_boundary_id(index, id);
      joined_mesh.add(body_mesh, global_ids);
    }



    /// What can be refined locally?
    void
    check_local_refinement(const std::string                  &path,
                           const std::optional<ReferenceCell> &simplices,
                           const Partitioner                   partitioner,
                           const std::vector<PeriodicRequest> &periodic)
    {
      if (simplices)
        throw UserError(path + ": " + plural(*simplices) +
                        " cannot be refined locally, only quadrilaterals and "
                        "hexahedra. Take 'Refinements' of the bodies, or a "
                        "graded mesh.");
      if (partitioner == Partitioner::metis)
        throw UserError(path +
                        ": 'Mesh/Partitioner = METIS' cannot distribute "
                        "locally refined meshes. Take p4est.");
      if (!periodic.empty())
        throw UserError(
          path + ": local refinement beside periodic boundaries (" +
          periodic.front().parameter_path + ") is not available.");
    }



    /// Without periodic boundaries, which contact leaves out. That there is no
    /// such body is said by those who make the pairs.
    std::set<types::boundary_id>
    boundaries_of(const std::vector<NamedSurface> &surfaces,
                  const Bodies                    &bodies)
    {
      std::set<types::boundary_id> ids;
      for (const NamedSurface &surface : surfaces)
        if (std::any_of(bodies.bodies.begin(),
                        bodies.bodies.end(),
                        [&](const Body &body) {
                          return body.name == surface.body;
                        }))
          ids.merge(bodies.global_boundary_ids(surface.body,
                                               surface.boundary,
                                               surface.parameter_path));
      for (const PeriodicBoundary &periodic : bodies.periodic_boundaries)
        for (const auto id : {periodic.first, periodic.second})
          ids.erase(id);
      return ids;
    }



    /// Whether METIS distributes quadrilaterals and hexahedra. (p4est knows no
    /// others.) @p contact_ranks: all, or none if there is no contact.
    bool
    is_for_metis(const MeshParameters &parameters,
                 const double          n_cells,
                 const unsigned int    contact_ranks)
    {
      if (parameters.partitioner != Partitioner::automatic)
        return parameters.partitioner == Partitioner::metis;
      // One rank makes the parts of all the others, and looks at the whole mesh
      // for each of them.
      constexpr double most_cells = 1e5, least_cells_per_rank = 20.;
      return contact_ranks > 1 && n_cells <= most_cells &&
             n_cells >= least_cells_per_rank * contact_ranks &&
             parameters.contact_weight == 0. &&
             parameters.refinements.empty() &&
             parameters.later_refinement.empty() && !parameters.goes_on_refined;
    }



    /// The faces must match one to one; better said here than on some ranks.
    template <int dim>
    void
    check_periodicity(const PeriodicRequest  &request,
                      const PeriodicBoundary &boundary,
                      Triangulation<dim>     &coarse_mesh)
    try
      {
        std::map<types::boundary_id, unsigned int> n_faces;
        for (const auto &face : coarse_mesh.active_face_iterators())
          ++n_faces[face->boundary_id()];
        if (n_faces[boundary.first] != n_faces[boundary.second])
          throw UserError(request.parameter_path + ": boundary " +
                          request.first + " of body '" + request.body +
                          "' has " + std::to_string(n_faces[boundary.first]) +
                          " coarse faces, boundary " + request.second +
                          " has " + std::to_string(n_faces[boundary.second]) +
                          "; periodic boundaries must match face to face.");
        add_periodicity<dim>({boundary}, coarse_mesh);
      }
    catch (const ExceptionBase &exception)
      {
        throw UserError(
          request.parameter_path + ": boundaries " + request.first + " and " +
          request.second + " of body '" + request.body +
          "' cannot be identified by a " +
          (boundary.is_cyclic()
             ? std::string("rotation")
             : std::string("shift in direction ") + "xyz"[request.direction]) +
          ". " + short_message(exception));
      }



    template <int dim>
    std::vector<PeriodicBoundary>
    find_periodic_boundaries(const std::vector<PeriodicRequest> &requests,
                             const JoinedMesh<dim>              &joined_mesh,
                             const Bodies                       &bodies)
    {
      std::vector<PeriodicBoundary> result;
      if (requests.empty())
        return result;
      Triangulation<dim> coarse_mesh;
      joined_mesh.create(coarse_mesh);
      for (const PeriodicRequest &request : requests)
        {
          const std::string &path = request.parameter_path;
          if (request.direction >= dim)
            throw UserError(path + ": there is no direction " +
                            std::to_string(request.direction) + " in " +
                            std::to_string(dim) + "D.");
          const auto first =
            bodies.single_boundary_id(request.body, request.first, path);
          const auto second =
            bodies.single_boundary_id(request.body, request.second, path);
          if (first == second)
            throw UserError(path + ": both periodic boundaries are the same.");
          result.push_back(
            find_periodic_boundary(request,
                                   coarse_mesh,
                                   bodies.index_of(request.body, path),
                                   first,
                                   second));
          check_periodicity(request, result.back(), coarse_mesh);
        }
      check_compatible(result);
      return result;
    }
  } // namespace



  template <int dim>
  Mesh<dim>
  build_mesh(const MeshParameters               &parameters,
             const NamedList<BodyParameters>    &body_parameters,
             const std::vector<PeriodicRequest> &periodic_requests,
             const MPI_Comm                      communicator,
             const std::vector<NamedSurface>    &costly_surfaces)
  {
    if (body_parameters.empty())
      throw UserError(
        "Bodies: there is no body. Add a subsection to 'Bodies'.");

    Mesh<dim>                mesh;
    JoinedMesh<dim>          joined_mesh;
    std::vector<std::string> curved_bodies;
    MeshFiles                files(parameters.input_directory, communicator);
    const MeshSize           size(dim, communicator);
    // Tools, whose cell is but a place for their motion, go with any kind.
    double                       n_simplices = 0.;
    std::optional<ReferenceCell> simplices; // none
    for (const bool tools : {false, true})
      for (auto [name, body] : body_parameters)
        {
          if (body.is_tool() != tools)
            continue;
          if (tools && !mesh.bodies.bodies.empty())
            body.simplices = mesh.bodies.bodies.front().cells.is_simplex();
          const std::string path = "Bodies/" + name;
          body.check(path);
          const auto body_mesh =
            make_body_mesh<dim>(body, path, parameters, files, size);
          for (const std::string &warning : body_mesh->warnings)
            if (!warning.empty())
              mesh.warnings.push_back(warning);
          if (body_mesh->has_nodes_between_vertices)
            curved_bodies.push_back(name);
          append_body(name, body, *body_mesh, mesh.bodies, joined_mesh);
          const ReferenceCell cells = mesh.bodies.bodies.back().cells;
          if (!cells.is_simplex())
            continue;
          simplices = cells;
          n_simplices += body_mesh->triangulation.n_active_cells();
        }

    if (parameters.degree == 1 && !curved_bodies.empty())
      mesh.warnings.push_back(warning_about_straight_sides(curved_bodies));

    if (simplices && !periodic_requests.empty())
      throw UserError(periodic_requests.front().parameter_path +
                      ": periodic boundaries are not available in a model "
                      "with " +
                      plural(*simplices) + ", only of " +
                      plural(ReferenceCells::get_hypercube<dim>()) + ".");

    mesh.bodies.periodic_boundaries =
      find_periodic_boundaries(periodic_requests, joined_mesh, mesh.bodies);

    const bool with_metis =
      simplices.has_value() ||
      is_for_metis(parameters,
                   joined_mesh.n_cells() *
                     std::pow(2., 1. * dim * parameters.global_refinements),
                   costly_surfaces.empty()
                     ? 0
                     : Utilities::MPI::n_mpi_processes(communicator));
    if (with_metis && parameters.contact_weight > 0.)
      mesh.warnings.push_back(
        "'Mesh/Contact weight' has no effect on METIS, "
        "which balances contact by itself.");
    const double share_of_simplices = n_simplices / joined_mesh.n_cells();
    size.check_refinements(joined_mesh.n_cells(),
                           parameters.global_refinements,
                           share_of_simplices * parameters.bytes_per_simplex +
                             (1. - share_of_simplices) *
                               parameters.bytes_per_cell,
                           with_metis,
                           "Mesh/Global refinements");
    const auto       &refinements        = parameters.refinements;
    const std::string path_of_refinement = refinements.empty()
                                             ? parameters.later_refinement
                                             : refinements.front().path;
    if (!path_of_refinement.empty())
      check_local_refinement(path_of_refinement,
                             simplices,
                             parameters.partitioner,
                             periodic_requests);
    const double          bytes_per_cell = parameters.bytes_per_cell;
    CellDistribution<dim> distribution{joined_mesh,
                                       mesh.bodies.periodic_boundaries,
                                       parameters.global_refinements};
    distribution.costly_boundaries =
      boundaries_of(costly_surfaces, mesh.bodies);
    if (with_metis)
      mesh.triangulation = distribution.with_metis(communicator);
    else
      mesh.triangulation = distribution.with_p4est(
        parameters.contact_weight,
        [&](parallel::distributed::Triangulation<dim> &triangulation) {
          refine_locally(
            refinements, mesh.bodies, size, bytes_per_cell, triangulation);
        },
        communicator);
    if (parameters.is_axisymmetric)
      revolve_bodies(*mesh.triangulation, mesh.bodies);
    if (!path_of_refinement.empty())
      mesh.cells_by_level = cells_by_level(*mesh.triangulation);
    return mesh;
  }



#define INSTANTIATE(dim)                                                   \
  template Mesh<dim> build_mesh<dim>(const MeshParameters &,               \
                                     const NamedList<BodyParameters> &,    \
                                     const std::vector<PeriodicRequest> &, \
                                     const MPI_Comm,                       \
                                     const std::vector<NamedSurface> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
