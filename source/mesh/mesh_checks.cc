#include <stickslip/mesh/mesh_checks.h>

#include <stickslip/base/user_error.h>

#include <deal.II/base/geometry_info.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>

namespace stickslip
{
  namespace
  {
    template <int dim>
    std::string
    coordinates_in_message(const Point<dim> &point)
    {
      std::ostringstream text;
      text << '(';
      for (unsigned int d = 0; d < dim; ++d)
        text << (d > 0 ? ", " : "") << point[d];
      text << ')';
      return text.str();
    }



    /// Smallest Jacobian determinant at the vertices relative to a cube of the
    /// cell's size.
    template <int dim>
    double
    smallest_relative_jacobian(
      const typename Triangulation<dim>::active_cell_iterator &cell)
    {
      constexpr unsigned int n = GeometryInfo<dim>::vertices_per_cell;

      Point<dim> vertices[n];
      for (const unsigned int v : cell->vertex_indices())
        vertices[v] = cell->vertex(v);
      Tensor<0, dim> determinants[n];
      GeometryInfo<dim>::alternating_form_at_vertices(vertices, determinants);

      const double volume   = std::pow(cell->diameter(), dim);
      double       smallest = std::numeric_limits<double>::max();
      for (const double determinant : determinants)
        // A NaN shall count as degenerate.
        smallest = !(determinant / volume > -1.)
                     ? -1.
                     : std::min(smallest, determinant / volume);
      return smallest;
    }
  } // namespace



  template <int dim>
  void
  check_cell_types(const Triangulation<dim> &triangulation,
                   const std::string        &path)
  {
    const std::string allowed = (dim == 2 ? "quadrilaterals" : "hexahedra");
    if (triangulation.n_active_cells() == 0)
      throw UserError(path + ": the mesh has no cells. A " +
                      std::to_string(dim) + "D case needs " + allowed + ".");
    if (!triangulation.all_reference_cells_are_hyper_cube())
      throw UserError(
        path + ": the mesh has " +
        (dim == 2 ? "triangles" : "tetrahedra, wedges or pyramids") +
        ", only " + allowed + " are supported.");
  }



  template <int dim>
  void
  check_cell_shapes(const Triangulation<dim> &triangulation,
                    const std::string        &path)
  {
    // Far below what any analysis could use, far above round-off.
    constexpr double tolerance = 1e-10;

    unsigned int n_bad_cells = 0;
    std::string  where;
    for (const auto &cell : triangulation.active_cell_iterators())
      if (const double jacobian = smallest_relative_jacobian<dim>(cell);
          jacobian < tolerance)
        {
          ++n_bad_cells;
          if (n_bad_cells > 1)
            continue;
          where = (jacobian < -tolerance ? "inverted" : "degenerate");
          where +=
            " cell at " + coordinates_in_message(cell->center()) + " (vertices";
          for (const unsigned int v : cell->vertex_indices())
            where += " " + coordinates_in_message(cell->vertex(v));
          where += ")";
        }
    if (n_bad_cells > 0)
      throw UserError(path + ": " + where + "; " + std::to_string(n_bad_cells) +
                      " of " + std::to_string(triangulation.n_active_cells()) +
                      " cells are inverted or degenerate.");
  }



  template void
  check_cell_types(const Triangulation<2> &, const std::string &);
  template void
  check_cell_types(const Triangulation<3> &, const std::string &);
  template void
  check_cell_shapes(const Triangulation<2> &, const std::string &);
  template void
  check_cell_shapes(const Triangulation<3> &, const std::string &);
} // namespace stickslip
