#include <stickslip/mesh/simplex_cut.h>

#include <stickslip/base/user_error.h>
#include <stickslip/mesh/reference_cells.h>

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

#include <deal.II/numerics/rtree.h>

#include <iterator>
#include <utility>
#include <vector>

namespace stickslip
{
  namespace
  {
    /// Moves the vertices of @p simplices that GridGenerator has put into the
    /// middles of faces and cells of @p original, as if all sides were straight,
    /// to the middles that the manifolds know.
    template <int dim>
    void
    move_middles_to_manifolds(const Triangulation<dim> &original,
                              Triangulation<dim>       &simplices)
    {
      namespace bgi             = boost::geometry::index;
      constexpr double roundoff = 1e-9; // of the size of a face or cell

      struct Middle
      {
        Point<dim> on_manifold;
        double     size;
      };
      std::vector<Middle>                              middles;
      std::vector<std::pair<Point<dim>, unsigned int>> places;
      const auto add = [&](const auto &object) {
        places.emplace_back(object->center(), middles.size());
        middles.push_back({object->center(true), object->diameter()});
      };
      for (const auto &cell : original.active_cell_iterators())
        add(cell);
      for (const auto &face : original.active_face_iterators())
        add(face);

      const auto tree = pack_rtree(places);
      GridTools::transform(
        [&](const Point<dim> &x) {
          std::vector<std::pair<Point<dim>, unsigned int>> nearest;
          tree.query(bgi::nearest(x, 1), std::back_inserter(nearest));
          const auto &[place, number] = nearest.front();
          const Middle &middle        = middles[number];
          return x.distance(place) < roundoff * middle.size ? middle.on_manifold
                                                            : x;
        },
        simplices);
    }
  } // namespace



  template <int dim>
  void
  cut_into_simplices(const std::string &path, Triangulation<dim> &triangulation)
  {
    if (triangulation.all_reference_cells_are_simplex())
      throw UserError(path + "/Simplices is true, but the mesh is made of " +
                      plural(reference_cell_of(triangulation)) +
                      " already. Leave it out.");
    Triangulation<dim> flat, simplices;
    GridGenerator::flatten_triangulation(triangulation, flat);
    GridGenerator::convert_hypercube_to_simplex_mesh(flat, simplices);
    move_middles_to_manifolds(triangulation, simplices);
    for (const types::manifold_id id : simplices.get_manifold_ids())
      if (id != numbers::flat_manifold_id)
        simplices.set_manifold(id, triangulation.get_manifold(id));
    triangulation.clear();
    triangulation.copy_triangulation(simplices);
  }

  template void
  cut_into_simplices(const std::string &, Triangulation<2> &);
  template void
  cut_into_simplices(const std::string &, Triangulation<3> &);
} // namespace stickslip
