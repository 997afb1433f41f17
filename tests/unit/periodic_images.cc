// Nodes that are images of others, and the motions that make them: a strip, a
// sector that is turned in space, and one that also repeats itself along its
// axis.

#include "case_problem.h"
#include "print.h"

#include <stickslip/contact/surface/periodic_images.h>

#include <stickslip/problem/dof_layout.h>

#include <deal.II/base/mpi.h>

#include <deal.II/dofs/dof_tools.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

using namespace stickslip;

namespace
{
  std::string
  material_and_body(const std::string &dimension, const std::string &body)
  {
    return "set Dimension = " + dimension +
           "\nsubsection Materials\n subsection steel\n"
           "  set Law = linear elastic\n end\nend\n"
           "subsection Bodies\n subsection body\n  set Material = steel\n" +
           body + " end\nend\n";
  }



  std::string
  condition(const std::string &name, const std::string &lines)
  {
    return "subsection Boundary conditions\n subsection " + name +
           "\n  set Body = body\n" + lines + " end\nend\n";
  }



  /// The first dofs of the nodes of all ranks, and their places.
  template <int dim>
  std::map<types::global_dof_index, Point<dim>>
  all_places(const DofLayout<dim> &layout)
  {
    std::map<types::global_dof_index, Point<dim>> seen, mine, all;
    DoFTools::map_dofs_to_support_points(layout.mapping[0],
                                         layout.dof_handler,
                                         seen);
    const IndexSet first =
      DoFTools::extract_dofs(layout.dof_handler, ComponentMask([]() {
                               std::vector<bool> mask(dim);
                               mask[0] = true;
                               return mask;
                             }()));
    for (const auto dof : first)
      if (layout.owned.is_element(dof))
        mine[dof] = seen.at(dof);
    for (const auto &of_rank : Utilities::MPI::all_gather(MPI_COMM_WORLD, mine))
      all.insert(of_rank.begin(), of_rank.end());
    return all;
  }



  template <int dim>
  using Field = std::function<Tensor<1, dim>(const Point<dim> &)>;



  template <int dim>
  void
  test_nodes(const DofLayout<dim>                                &layout,
             const std::map<types::global_dof_index, Point<dim>> &places,
             const Field<dim>                                    &field)
  {
    const auto  &images   = layout.periodic_nodes.images();
    unsigned int n_images = 0;
    bool         is_there = true, is_smaller = true;
    for (const auto &[dof, image] : images)
      {
        n_images += layout.owned.is_element(dof) ? 1 : 0;
        is_smaller = is_smaller && image.original < dof &&
                     images.count(image.original) == 0;
        is_there =
          is_there && (image.motion(Tensor<1, dim>(places.at(image.original))) -
                       places.at(dof))
                          .norm() < 1e-12;
      }
    print(std::to_string(places.size()) + " nodes, " +
          std::to_string(Utilities::MPI::sum(n_images, MPI_COMM_WORLD)) +
          " of them images");
    print("images are where the motion has their originals", is_there);
    print("originals come first and are no images", is_smaller);

    Constraints lines(layout.relevant);
    layout.periodic_nodes.add_lines(lines);
    lines.close();
    LA::Vector u(layout.owned, MPI_COMM_WORLD);
    for (const auto &[dof, place] : places)
      if (layout.owned.is_element(dof) && images.count(dof) == 0)
        for (unsigned int c = 0; c < dim; ++c)
          u(dof + c) = field(place)[c];
    u.compress(VectorOperation::insert);
    lines.distribute(u);
    double error = 0.;
    for (const auto &[dof, place] : places)
      if (layout.owned.is_element(dof))
        for (unsigned int c = 0; c < dim; ++c)
          error = std::max(error, std::abs(u(dof + c) - field(place)[c]));
    print("a displacement that repeats itself goes on", error < 1e-12);
  }



  template <int dim>
  void
  test_images(const Mesh<dim>                                     &mesh,
              const DofLayout<dim>                                &layout,
              const std::map<types::global_dof_index, Point<dim>> &places,
              const std::string                                   &surface)
  {
    const PeriodicImages<dim> images(mesh.bodies.periodic_boundaries,
                                     layout.periodic_nodes,
                                     MPI_COMM_WORLD);
    auto                      faces = collect_faces<dim>(
      layout.mapping,
      layout.dof_handler,
      mesh.bodies.global_boundary_ids("body", {surface}, "test"),
      [](const types::material_id) { return 1.; },
      true);
    const auto all      = images.images_of(0, faces);
    bool       is_group = true, has_inverses = true;
    for (const unsigned int i : all)
      {
        has_inverses = has_inverses &&
                       images.after(images.inverse(i), i) ==
                         std::optional<unsigned int>(0) &&
                       images.inverse(images.inverse(i)) == i;
        for (const unsigned int j : all)
          if (const auto product = images.after(i, j))
            {
              const PeriodicMotion both =
                images.motion(i).after(images.motion(j));
              const PeriodicMotion &one = images.motion(*product);
              is_group = is_group && (both.Q - one.Q).norm() < 1e-12 &&
                         (both.c - one.c).norm() < 1e-10;
            }
      }
    print(std::to_string(all.size()) + " images of the body");
    print("motions after each other are that of the image of the image",
          is_group);
    print("inverses lead back", has_inverses);

    bool is_original = true;
    for (const auto &[dof, place] : places)
      if (layout.relevant.is_element(dof))
        {
          const auto image = layout.periodic_nodes.images().find(dof);
          is_original =
            is_original && images.original(dof) ==
                             (image == layout.periodic_nodes.images().end()
                                ? dof
                                : image->second.original);
        }
    print("originals are those of the nodes", is_original);

    // a face, an image or not: each node is where the motion of its name has
    // the original, and moves as that one, turned
    const unsigned int n_faces  = faces.size();
    const auto         is_named = [&](const SurfaceFace<dim> &face) {
      bool holds = true;
      for (unsigned int j = 0; j < face.n_nodes; ++j)
        {
          const auto [dof, image] = face.name(j);
          const auto &motion      = images.motion(image);
          holds =
            holds && layout.periodic_nodes.images().count(dof) == 0 &&
            (motion(Tensor<1, dim>(places.at(dof))) -
             face.reference_positions[j])
                .norm() < 1e-10 &&
            (motion.template rotation_matrix<dim>() - face.rotation(j)).norm() <
              1e-12;
        }
      return holds;
    };
    images.name_nodes(faces);
    bool         are_named = true, are_sorted = true;
    unsigned int n_images = 0;
    for (unsigned int f = 0; f < faces.size(); ++f)
      {
        are_named = are_named && is_named(faces[f].face);
        are_sorted =
          are_sorted && (f == 0 || faces[f - 1].face.id < faces[f].face.id);
        n_images += faces[f].face.id.image > 0 ? 1 : 0;
      }
    for (const unsigned int i : all)
      if (faces.empty())
        break;
      else if (const auto face = images.image_of(faces.front().face, i))
        are_named = are_named && is_named(*face);
    print("nodes of faces and of their images have the right names", are_named);
    print("faces around nodes on the sides are added, sorted",
          are_sorted && faces.size() == n_faces + n_images &&
            Utilities::MPI::sum(n_images, MPI_COMM_WORLD) > 0);
  }



  template <int dim>
  void
  test(const std::string &title,
       const std::string &prm,
       const std::string &surface,
       const Field<dim>  &field)
  {
    print(title);
    const TextParameters parameters(prm);
    const Mesh<dim>      mesh =
      build_mesh<dim>(parameters.mesh,
                      parameters.bodies,
                      periodic_requests(parameters.boundary_conditions, dim),
                      MPI_COMM_WORLD);
    const DofLayout<dim> layout(*mesh.triangulation,
                                2,
                                mesh.bodies.periodic_boundaries);
    const auto           places = all_places(layout);
    test_nodes<dim>(layout, places, field);
    test_images<dim>(mesh, layout, places, surface);
  }
} // namespace



int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  // 13 x 5 nodes, 5 of them on each side
  test<2>("a strip that repeats itself along x",
          material_and_body("2",
                            "  set Generator = subdivided_hyper_rectangle\n"
                            "  set Arguments = 6, 2 : 0, 0 : 3, 1 : true\n") +
            condition("sides",
                      "  set Type = periodic\n  set Boundary = 0\n"
                      "  set Second boundary = 1\n  set Direction = x\n"),
          "3",
          [](const Point<2> &p) {
            const double angle = 2. * numbers::PI / 3. * p[0];
            return Tensor<1, 2>({std::sin(angle), p[1] + std::cos(angle)});
          });

  // of 13 x 5 nodes 12 x 4 stay, corners have three images
  test<2>("a cell that repeats itself along x and y",
          material_and_body("2",
                            "  set Generator = subdivided_hyper_rectangle\n"
                            "  set Arguments = 6, 2 : 0, 0 : 3, 1 : true\n") +
            condition("along x",
                      "  set Type = periodic\n  set Boundary = 0\n"
                      "  set Second boundary = 1\n  set Direction = x\n") +
            condition("along y",
                      "  set Type = periodic\n  set Boundary = 2\n"
                      "  set Second boundary = 3\n  set Direction = y\n"),
          "3",
          [](const Point<2> &p) {
            return Tensor<1, 2>({std::sin(2. * numbers::PI / 3. * p[0]),
                                 std::cos(2. * numbers::PI * p[1])});
          });

  // 3 x 9 x 5 nodes; the axis is that of z, turned by 30 degrees about x
  const std::string sector =
    "  set Generator = graded_annular_sector\n"
    "  set Arguments = 1 |1| 2 : 10 |4| 130 : "
    "0 |2| 3\n";
  const Tensor<1, 3> axis({0., -0.5, std::sqrt(0.75)});
  const Tensor<1, 3> centre({1., 2., 3.});
  const auto         swirl = [](const Tensor<1, 3> &r, const Tensor<1, 3> &e) {
    const double       height = r * e;
    const Tensor<1, 3> radial = r - height * e;
    return (1. + height) * cross_product_3d(e, radial) +
           radial.norm() * radial + height * e;
  };
  test<3>("a third of a tube that is turned in space",
          material_and_body("3",
                            sector + "  set Rotation axis = 1, 0, 0\n"
                                     "  set Rotation angle = 30\n"
                                     "  set Translation = 1, 2, 3\n") +
            condition("sides",
                      "  set Type = cyclic symmetry\n  set Boundary = 2\n"
                      "  set Second boundary = 3\n"
                      "  set Rotation axis = 0, -1, 1.7320508075688772\n"
                      "  set Rotation centre = 1, 2, 3\n"),
          "0",
          [&](const Point<3> &p) { return swirl(p - centre, axis); });

  // of these nodes 3 x 8 x 4 stay
  test<3>("a third of a tube that repeats itself along its axis",
          material_and_body("3", sector) +
            condition("sides",
                      "  set Type = cyclic symmetry\n  set Boundary = 2\n"
                      "  set Second boundary = 3\n") +
            condition("ends",
                      "  set Type = periodic\n  set Boundary = 4\n"
                      "  set Second boundary = 5\n  set Direction = z\n"),
          "0",
          [&](const Point<3> &p) {
            Tensor<1, 3> r(p);
            r[2] = 0.;
            return std::cos(2. * numbers::PI / 3. * p[2]) *
                   swirl(r, Tensor<1, 3>({0., 0., 1.}));
          });
}
