// build_mesh() with generators: motion, ids, materials, manifolds, joining,
// periodicity, both partitioners.

#include "print_mesh.h"

#include <array>
#include <map>
#include <string>

namespace
{
  /// Largest distance of the vertices of a boundary from a circle or cylinder.
  template <int dim>
  void
  print_roundness(const Mesh<dim>         &mesh,
                  const types::boundary_id local_id,
                  const Point<dim>        &centre,
                  const Tensor<1, dim>    &axis,
                  const double             radius)
  {
    double     error = 0.;
    const auto id    = mesh.bodies.global_boundary_id(0, local_id);
    for (const auto &cell : mesh.triangulation->active_cell_iterators())
      if (cell->is_locally_owned())
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary() && face->boundary_id() == id)
            for (const unsigned int v : face->vertex_indices())
              {
                Tensor<1, dim> arm = face->vertex(v) - centre;
                arm -= (arm * axis) * axis;
                error = std::max(error, std::abs(arm.norm() - radius));
              }
    error = Utilities::MPI::max(error, comm);
    print("  boundary " + std::to_string(local_id) + " on radius " +
          text(radius) + " within 1e-12: " + (error < 1e-12 ? "yes" : "no") +
          (error < 1e-12 ? "" : " " + text(error)));
  }



  void
  test_generators_and_motion()
  {
    BodyParameters block =
      generated("subdivided_hyper_rectangle", "4, 2 : 0, 0 : 2, 1 : true");
    block.boundary_ids     = "10: y < 1e-8 && x < 1; 11: id == 1";
    BodyParameters punch   = generated("hyper_cube", "");
    punch.refinements      = 1;
    punch.scale            = {2., 1.};
    punch.translation      = {0., 1.};
    punch.material_regions = "rubber: y > 1.5; brass: id == 0 && y < 1.5";
    punch.material.clear();
    BodyParameters tool  = generated("hyper_rectangle", "0, 0 : 1, 3 : true");
    tool.rotation_angle  = 90.;
    tool.rotation_centre = {1., 0.};
    tool.is_rigid        = true;
    tool.material.clear();
    const NamedList<BodyParameters> bodies = {{"block", block},
                                              {"punch", punch},
                                              {"tool", tool}};
    MeshParameters                  parameters;
    parameters.global_refinements = 1;
    const auto mesh = show<2>("2D blocks, p4est", bodies, parameters);
    print("  global ids of punch 0, tool 2: " +
          std::to_string(mesh.bodies.global_boundary_id(1, 0)) + ", " +
          std::to_string(mesh.bodies.global_boundary_id(2, 2)) + " and back " +
          std::to_string(mesh.bodies.local_boundary_id(
            mesh.bodies.global_boundary_id(2, 2))));
    parameters.partitioner = Partitioner::metis;
    show<2>("2D blocks, METIS", bodies, parameters);

    show<2>("graded rectangle",
            {{"plate",
              generated("graded_hyper_rectangle",
                        "0 |1| 1.25 |3| 5 |2| 7.5 |3| 11.25 |23, 2| 40 : "
                        "0 |10| 40")}});
    show<3>("graded box",
            {{"plate",
              generated("graded_hyper_rectangle",
                        "0, 1, 3 : 0 |3| 1 : 0, 2")}});
    BodyParameters shaped =
      generated("subdivided_hyper_rectangle", "4, 4 : 0, 0 : 1, 1 : true");
    shaped.coordinates = "x^2; y*(1 + x)";
    show<2>("shaped rectangle", {{"plate", shaped}});
  }



  void
  test_manifolds(const std::string &partitioner)
  {
    MeshParameters parameters;
    parameters.partitioner        = value_of(partitioner, all_partitioners());
    parameters.global_refinements = 2;

    BodyParameters ring  = generated("hyper_shell", "0, 0 : 1 : 2 : 8 : true");
    ring.refinements     = 1;
    ring.scale           = {0.5};
    ring.rotation_angle  = 33.;
    ring.rotation_centre = {1., 2.};
    ring.translation     = {5., -1.};
    const double   angle = 33. * numbers::PI / 180.;
    const Point<2> centre(6. - std::cos(angle) + 2. * std::sin(angle),
                          1. - std::sin(angle) - 2. * std::cos(angle));
    const auto     rings = show<2>("moved ring, " + partitioner,
                               {{"ring", ring}, {"core", ring}},
                               parameters);
    print_roundness(rings, 0, centre, Tensor<1, 2>(), 0.5);
    print_roundness(rings, 1, centre, Tensor<1, 2>(), 1.);

    BodyParameters pipe =
      generated("annular_sector", "1 : 2 : 200 : 340 : 1 : 4 : 3 : 2");
    pipe.rotation_axis  = {1., 0., 0.};
    pipe.rotation_angle = 90.;
    pipe.translation    = {0., 3., 4.};
    Tensor<1, 3> y_axis;
    y_axis[1]                     = 1.;
    parameters.global_refinements = 1;
    const auto wall = show<3>("moved part of a pipe, " + partitioner,
                              {{"pipe", pipe}},
                              parameters);
    print_roundness(wall, 0, Point<3>(0., 3., 4.), y_axis, 1.);
    print_roundness(wall, 1, Point<3>(0., 3., 4.), y_axis, 2.);

    // Transfinite interpolation inside, which is dropped.
    BodyParameters plate =
      generated("plate_with_a_hole",
                "0.4 : 1 : 1 : 1 : 1 : 1 : 0, 0 : 0 : 1 : 1 "
                ": 2 : true");
    plate.translation = {1., 0.};
    const auto hole   = show<2>("plate with a hole, " + partitioner,
                              {{"plate", plate}},
                              parameters);
    print_roundness(hole, 4, Point<2>(1., 0.), Tensor<1, 2>(), 0.4);
  }



  /// Every generator that needs no arguments, and some that do.
  template <int dim>
  void
  test_generators(const NamedList<std::string> &arguments)
  {
    for (const auto &[name, values] : arguments)
      show<dim>(name + " in " + std::to_string(dim) + "D",
                {{"body", generated(name, values)}});
  }



  void
  test_joining()
  {
    BodyParameters lower = generated("hyper_cube", "");
    BodyParameters upper = lower;
    upper.translation    = {0., 1., 0.};
    const auto mesh = show<3>("touching cubes", {{"a", lower}, {"b", upper}});
    print("  vertices " + std::to_string(mesh.triangulation->n_vertices()));
  }



  void
  test_periodicity(const std::string &partitioner)
  {
    MeshParameters parameters;
    parameters.partitioner        = value_of(partitioner, all_partitioners());
    parameters.global_refinements = 2;
    PeriodicRequest request;
    request.parameter_path = "Boundary conditions/sides";
    request.body           = "strip";
    request.first          = "0";
    request.second         = "1";
    const auto mesh        = show<2>("periodic strip, " + partitioner,
                              {{"strip",
                                       generated("subdivided_hyper_rectangle",
                                          "3, 1 : 0, 0 : 3, 1 : true")}},
                              parameters,
                              {request});

    unsigned int n_pairs = 0;
    for (const auto &cell : mesh.triangulation->active_cell_iterators())
      if (cell->is_locally_owned())
        for (const unsigned int f : cell->face_indices())
          if (cell->has_periodic_neighbor(f))
            // The neighbour must be there: owned or in the ghost layer.
            n_pairs += (cell->periodic_neighbor(f)->is_artificial() ? 1000 : 1);
    print("  periodic faces " +
          std::to_string(Utilities::MPI::sum(n_pairs, comm)));
  }



  /// The cells of this rank and its faces on the lower one's top, of two strips
  /// of 16 x 2 cells of which these faces are costly.
  std::array<double, 2>
  share_of_strips(const MeshParameters &parameters)
  {
    const auto strip = [](const std::string &y) {
      return generated("subdivided_hyper_rectangle",
                       "16, 2 : 0, " + y + " : 16, " + y + "2 : true");
    };
    const Mesh<2> mesh =
      build_mesh<2>(parameters,
                    {{"upper", strip("1")}, {"lower", strip("0")}},
                    {},
                    comm,
                    {{"path", "lower", {"3"}}});
    const auto            top   = mesh.bodies.global_boundary_id(1, 3);
    std::array<double, 2> share = {{0., 0.}};
    for (const auto &cell : mesh.triangulation->active_cell_iterators())
      if (cell->is_locally_owned())
        {
          share[0] += 1.;
          for (const auto &face : cell->face_iterators())
            if (face->at_boundary() && face->boundary_id() == top)
              share[1] += 1.;
        }
    return share;
  }



  bool
  is_near_mean(const double value, const double tolerance)
  {
    const double mean =
      Utilities::MPI::sum(value, comm) / Utilities::MPI::n_mpi_processes(comm);
    return Utilities::MPI::max(std::abs(value - mean), comm) <=
           std::max(0.1 * mean, tolerance);
  }



  void
  test_weights(const double weight)
  {
    MeshParameters parameters;
    parameters.partitioner    = Partitioner::p4est;
    parameters.contact_weight = weight;
    const auto [cells, faces] = share_of_strips(parameters);
    print("p4est, a face counts as " + text(weight) +
            " cells, loads within a tenth or a cell of each other",
          is_near_mean(cells + weight * faces, 1. + weight));
  }



  void
  test_phases()
  {
    MeshParameters parameters;
    parameters.partitioner    = Partitioner::metis;
    const auto [cells, faces] = share_of_strips(parameters);
    print("METIS, cells and faces within a tenth or two of each other",
          is_near_mean(cells, 2.) && is_near_mean(faces, 2.));
  }



  /// Whoever distributes the cells, a cell has the same id.
  void
  test_ids()
  {
    std::array<std::map<std::string, std::string>, 2> centres; // by id
    for (const auto partitioner : {Partitioner::p4est, Partitioner::metis})
      {
        MeshParameters parameters;
        parameters.partitioner        = partitioner;
        parameters.global_refinements = 1;
        const Mesh<2> mesh            = build_mesh<2>(
          parameters,
          {{"a", generated("hyper_ball", "")},
                      {"b", generated("hyper_shell", "0, 0 : 2 : 3 : 12 : true")}},
          {},
          comm);
        std::map<std::string, std::string> own;
        for (const auto &cell : mesh.triangulation->active_cell_iterators())
          if (cell->is_locally_owned())
            own[cell->id().to_string()] =
              text(cell->center()[0]) + " " + text(cell->center()[1]);
        for (const auto &part : Utilities::MPI::all_gather(comm, own))
          centres[partitioner == Partitioner::metis].insert(part.begin(),
                                                            part.end());
      }
    print("p4est and METIS, " + std::to_string(centres[0].size()) +
            " cells have the same ids",
          centres[0] == centres[1]);
  }
} // namespace

int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_generators_and_motion();
  test_manifolds("p4est");
  test_manifolds("METIS");
  test_generators<2>({{"hyper_ball", ""},
                      {"half_hyper_shell", "0, 0 : 1 : 2 : 0 : true"},
                      {"quarter_hyper_ball", "0, 0 : 3"},
                      {"annular_sector", "1 : 2 : 0 : 360 : 2 : 12"},
                      {"graded_annular_sector", "1 |2, 3| 5 : 0 |12| 360"},
                      {"hyper_cube_slit", "0 : 1 : true"},
                      {"concentric_hyper_shells", ""}});
  test_generators<3>(
    {{"cylinder", "1 : 2"},
     {"graded_annular_sector", "1 |2, 3| 5 : 0 |6| 90, 180 : -1 |2| 0 |1| 3"},
     {"cylinder_shell", "3 : 1 : 2 : 6 : 2"},
     {"half_hyper_ball", ""},
     {"quarter_hyper_ball", ""},
     {"hyper_ball_balanced", ""},
     {"half_hyper_shell", "0, 0, 0 : 1 : 2 : 0 : true"},
     {"quarter_hyper_shell", "0, 0, 0 : 1 : 2 : 3 : true"},
     {"torus", "2 : 0.5"}});
  test_joining();
  test_periodicity("p4est");
  test_periodicity("METIS");
  for (const double weight : {0., 4.})
    test_weights(weight);
  test_phases();
  test_ids();
}
