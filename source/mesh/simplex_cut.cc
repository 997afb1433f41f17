#include <stickslip/mesh/simplex_cut.h>

#include <stickslip/base/user_error.h>
#include <stickslip/mesh/reference_cells.h>

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <map>

namespace stickslip
{
  namespace
  {
    template <int dim>
    struct SmallerCoordinates
    {
      bool
      operator()(const Point<dim> &a, const Point<dim> &b) const
      {
        return std::lexicographical_compare(a.begin_raw(),
                                            a.end_raw(),
                                            b.begin_raw(),
                                            b.end_raw());
      }
    };



    /// Moves the vertices of @p simplices that GridGenerator has put into the
    /// middles of faces and cells of @p original, as if all sides were straight,
    /// to the middles that the manifolds know.
    template <int dim>
    void
    move_middles_to_manifolds(const Triangulation<dim> &original,
                              Triangulation<dim>       &simplices)
    {
      std::map<Point<dim>, Point<dim>, SmallerCoordinates<dim>> middles;
      for (const auto &cell : original.active_cell_iterators())
        middles[cell->center()] = cell->center(true);
      for (const auto &face : original.active_face_iterators())
        middles[face->center()] = face->center(true);
      GridTools::transform(
        [&](const Point<dim> &x) {
          const auto middle = middles.find(x);
          return middle == middles.end() ? x : middle->second;
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
