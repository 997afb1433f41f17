// Bodies from mesh files of the second order: the nodes of the mapping are
// those of the file, refined cells make up the same body, and the map of a
// curved cell is inverted.

#include "print_mesh.h"

#include <stickslip/mesh/conforming_mapping.h>
#include <stickslip/mesh/mesh_reader.h>
#include <stickslip/mesh/reference_cells.h>
#include <stickslip/mesh/second_order_nodes.h>

#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_values.h>

#include <fstream>
#include <iterator>

namespace
{
  const std::string directory = SOURCE_DIR "/../application/data/";



  NamedList<BodyParameters>
  rings(const std::string &file)
  {
    NamedList<BodyParameters> bodies;
    for (const std::string name : {"outer", "inner"})
      {
        BodyParameters body;
        body.mesh_file   = directory + file;
        body.mesh_groups = {name};
        body.material    = "steel";
        bodies.emplace_back(name, body);
      }
    return bodies;
  }



  MeshFile
  contents(const std::string &file)
  {
    std::ifstream stream(directory + file, std::ios::binary);
    return parse_mesh_file({std::istreambuf_iterator<char>(stream), {}},
                           MeshFormat::gmsh);
  }



  template <int dim>
  double
  volume(const Mesh<dim> &mesh, const Mapping<dim> &mapping)
  {
    const ReferenceCell   cell = reference_cell_of(*mesh.triangulation);
    const FE_Nothing<dim> fe(cell);
    FEValues<dim>         values(mapping,
                         fe,
                         gauss_quadrature<dim>(cell, 3),
                         update_JxW_values);
    double                sum = 0.;
    for (const auto &active : mesh.triangulation->active_cell_iterators())
      if (active->is_locally_owned())
        {
          values.reinit(active);
          for (const double weight : values.get_JxW_values())
            sum += weight;
        }
    return Utilities::MPI::sum(sum, comm);
  }



  /// Is each point of the file a node of the mapping, up to roundoff?
  template <int dim>
  bool
  has_all_nodes(const MeshFile     &file,
                const Mesh<dim>    &mesh,
                const Mapping<dim> &mapping)
  {
    const auto fe =
      make_element<dim>(reference_cell_of(*mesh.triangulation), 2);
    std::vector<Point<dim>> nodes;
    for (const auto &cell : mesh.triangulation->active_cell_iterators())
      if (cell->is_locally_owned())
        for (const Point<dim> &unit : fe->get_unit_support_points())
          nodes.push_back(mapping.transform_unit_to_real_cell(cell, unit));
    double largest = 0.;
    for (const Point<3> &point : file.points)
      {
        Point<dim> place;
        for (unsigned int d = 0; d < dim; ++d)
          place[d] = point[d];
        double distance = 1.;
        for (const Point<dim> &node : nodes)
          distance = std::min(distance, node.distance(place));
        largest = std::max(largest, Utilities::MPI::min(distance, comm));
      }
    return largest < 1e-15;
  }



  /// At points inside and on the sides of all cells.
  template <int dim>
  bool
  is_inverted(const MeshFile &file)
  {
    std::vector<std::size_t> elements;
    for (std::size_t e = 0; e < file.n_elements(); ++e)
      if (file.dimension(e) == dim)
        elements.push_back(e);
    const auto            cells = curved_cells<dim>(file, elements, "");
    const Quadrature<dim> inside =
      cell_quadrature<dim>(cells->element().reference_cell(), 2);
    std::vector<Point<dim>> points = inside.get_points();
    for (const Point<dim> &point : inside.get_points())
      {
        points.push_back(point);
        points.back()[0] = 0.;
      }
    double largest = 0.;
    for (std::size_t cell = 0; cell < cells->size(); ++cell)
      for (const Point<dim> &point : points)
        {
          const auto found =
            cells->unit_position(cell, cells->position(cell, point));
          largest = std::max(largest, found ? found->distance(point) : 1.);
        }
    return largest < 1e-12;
  }



  template <int dim>
  void
  test(const std::string &name)
  {
    print(name);
    const MeshFile file = contents(name);
    double         volumes[2];
    for (const unsigned int refinements : {0, 1})
      {
        MeshParameters parameters;
        parameters.degree             = 2;
        parameters.global_refinements = refinements;
        const Mesh<dim> mesh =
          build_mesh<dim>(parameters, rings(name), {}, comm);
        const auto mapping   = make_conforming_mapping(*mesh.triangulation, 2);
        volumes[refinements] = volume(mesh, mapping[0]);
        if (refinements == 0)
          print("  the nodes are those of the file",
                has_all_nodes(file, mesh, mapping[0]));
      }
    print("  volume " + text(volumes[0]));
    print("  refined cells have the same volume",
          std::abs(volumes[1] - volumes[0]) < 1e-13 * volumes[0]);
    print("  the maps of the cells are inverted", is_inverted<dim>(file));
  }
} // namespace



int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test<2>("curved_rings.msh");
  test<2>("curved_rings_TRI6.msh");
  test<3>("curved_rings_HEX20.msh");
  test<3>("curved_rings_HEX27.msh");
  test<3>("curved_rings_TET10.msh");
}
