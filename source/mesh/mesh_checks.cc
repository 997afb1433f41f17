#include <stickslip/mesh/mesh_checks.h>

#include <stickslip/base/nearest_name.h>
#include <stickslip/base/user_error.h>
#include <stickslip/mesh/reference_cells.h>

#include <deal.II/base/geometry_info.h>

#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <sstream>

namespace stickslip
{
  namespace
  {
    /// The Jacobian determinant, which is the same everywhere.
    template <int dim>
    double
    simplex_jacobian(
      const typename Triangulation<dim>::active_cell_iterator &cell)
    {
      Tensor<2, dim> edges;
      for (unsigned int d = 0; d < dim; ++d)
        edges[d] = cell->vertex(d + 1) - cell->vertex(0);
      return determinant(edges);
    }



    /// Smallest Jacobian determinant at the vertices relative to a cube of the
    /// cell's size.
    template <int dim>
    double
    smallest_relative_jacobian(
      const typename Triangulation<dim>::active_cell_iterator &cell)
    {
      const double volume = std::pow(cell->diameter(), dim);
      if (cell->reference_cell().is_simplex())
        {
          // A NaN shall count as degenerate.
          const double jacobian = simplex_jacobian<dim>(cell) / volume;
          return jacobian > -1. ? jacobian : -1.;
        }
      constexpr unsigned int n = GeometryInfo<dim>::vertices_per_cell;

      Point<dim> vertices[n];
      for (const unsigned int v : cell->vertex_indices())
        vertices[v] = cell->vertex(v);
      Tensor<0, dim> determinants[n];
      GeometryInfo<dim>::alternating_form_at_vertices(vertices, determinants);

      double smallest = std::numeric_limits<double>::max();
      for (const double determinant : determinants)
        // A NaN shall count as degenerate.
        smallest = !(determinant / volume > -1.)
                     ? -1.
                     : std::min(smallest, determinant / volume);
      return smallest;
    }



    /// Where the Jacobian determinants of curved cells are looked at.
    template <int dim>
    class PlacesToLook
    {
    public:
      explicit PlacesToLook(const QuadraticCells<dim> &cells)
      {
        const ReferenceCell   cell       = cells.element().reference_cell();
        const Quadrature<dim> quadrature = cell_quadrature<dim>(cell, 2);
        for (const Point<dim> &place : quadrature.get_points())
          inside.push_back({place, cells.gradients(place)});
        constexpr unsigned int n_parts = 4; // of an edge
        for (unsigned int i = 0; i < std::pow(n_parts + 1, dim); ++i)
          {
            Point<dim> place;
            for (unsigned int d = 0, rest = i; d < dim; ++d)
              {
                place[d] = 1. * (rest % (n_parts + 1)) / n_parts;
                rest /= n_parts + 1;
              }
            if (distance_to_unit_cell(cell, place) < 1e-12)
              everywhere.push_back({place, cells.gradients(place)});
          }
      }

      /// The worst place of @p cell, if it is bad there. At a vertex between
      /// two sides that are tangential to each other, as on a circle, the
      /// determinant is zero, which does no harm.
      std::optional<Point<dim>>
      bad_one(const QuadraticCells<dim> &cells, const std::size_t cell) const
      {
        constexpr double roundoff = 1e-10;
        // Cells with the other orientation are no bad ones: readers turn them.
        double sum = 0., largest = 0.;
        for (const Place &place : inside)
          {
            const double jacobian =
              determinant(cells.jacobian(cell, place.gradients));
            sum += jacobian;
            largest = std::max(largest, std::abs(jacobian));
          }
        const double              sign     = sum < 0. ? -1. : 1.;
        double                    smallest = -roundoff * largest;
        std::optional<Point<dim>> worst;
        const auto                look_at = [&](const Place &place) {
          const double jacobian =
            sign * determinant(cells.jacobian(cell, place.gradients));
          if (!(jacobian >= smallest)) // also if it is no number
            {
              smallest = jacobian;
              worst    = place.unit;
            }
        };
        for (const Place &place : everywhere)
          look_at(place);
        if (!worst)
          smallest = roundoff * largest;
        for (const Place &place : inside)
          look_at(place);
        return worst;
      }

    private:
      struct Place
      {
        Point<dim>                  unit;
        std::vector<Tensor<1, dim>> gradients;
      };

      std::vector<Place> inside, everywhere;
    };
  } // namespace



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



  template <int dim>
  void
  check_cell_types(const Triangulation<dim> &triangulation,
                   const std::string        &path)
  {
    const std::string allowed =
      (dim == 2 ? "quadrilaterals or triangles" : "hexahedra or tetrahedra");
    if (triangulation.n_active_cells() == 0)
      throw UserError(path + ": the mesh has no cells. A " +
                      std::to_string(dim) + "D case needs " + allowed + ".");
    if (!triangulation.all_reference_cells_are_hyper_cube() &&
        !triangulation.all_reference_cells_are_simplex())
      throw UserError(path +
                      ": the mesh has cells of several kinds; all have " +
                      "to be " + allowed + ".");
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



  template <int dim>
  CellsInsideOut<dim>
  cells_inside_out(const QuadraticCells<dim> &cells)
  {
    const PlacesToLook<dim> places(cells);
    CellsInsideOut<dim>     bad;
    for (std::size_t cell = 0; cell < cells.size(); ++cell)
      if (const auto worst = places.bad_one(cells, cell))
        if (bad.n_cells++ == 0)
          {
            bad.first = cell;
            bad.place = cells.position(cell, *worst);
          }
    return bad;
  }



  template <int dim>
  void
  check_curved_cells(const QuadraticCells<dim> &cells, const std::string &path)
  {
    const CellsInsideOut<dim> bad = cells_inside_out(cells);
    if (bad.n_cells == 0)
      return;
    std::string vertices;
    for (const unsigned int v :
         cells.element().reference_cell().vertex_indices())
      vertices += " " + coordinates_in_message(cells.node(bad.first, v));
    throw UserError(
      path +
      ": the nodes between the vertices of a curved cell turn it inside "
      "out at " +
      coordinates_in_message(bad.place) +
      ", where its Jacobian determinant is not positive (vertices" + vertices +
      "); " + std::to_string(bad.n_cells) + " of " +
      std::to_string(cells.size()) +
      " cells are so. Move these nodes, or take a finer mesh.");
  }



  template <int dim>
  std::string
  warning_about_seams(const Triangulation<dim> &triangulation,
                      const std::string        &path)
  {
    // Twins come from the same numbers, so that roundoff does not part them.
    constexpr double tolerance = 1e-9;

    // not GridTools::diameter(): quadratic in the number of boundary vertices
    const auto ends =
      GridTools::compute_bounding_box(triangulation).get_boundary_points();
    const double                    size = ends.first.distance(ends.second);
    std::set<std::array<long, dim>> places;
    std::string                     where;
    unsigned int                    n_seams = 0;
    for (const auto &face : triangulation.active_face_iterators())
      if (face->at_boundary())
        {
          std::array<long, dim> place;
          for (unsigned int d = 0; d < dim; ++d)
            place[d] = std::lround(face->center()[d] / (tolerance * size));
          if (!places.insert(place).second && n_seams++ == 0)
            where = coordinates_in_message(face->center());
        }
    if (n_seams == 0)
      return "";
    return path + ": " + std::to_string(n_seams) +
           (n_seams == 1 ? " face" : " faces") + " of its boundary, first at " +
           where +
           ", lie on other ones: the mesh is open there, as along a crack, and "
           "the two sides can part and pass through each other. Merge the "
           "nodes if the body is whole.";
  }



  std::string
  warning_about_straight_sides(const std::vector<std::string> &bodies)
  {
    return "Degree = 1 makes the curved sides of the cells of " +
           quoted_list(bodies) +
           " straight between their vertices, whatever the nodes of the mesh "
           "file between these say. 'Degree = 2' follows them.";
  }



  template std::string
  coordinates_in_message(const Point<2> &);
  template std::string
  coordinates_in_message(const Point<3> &);
  template void
  check_cell_types(const Triangulation<2> &, const std::string &);
  template void
  check_cell_types(const Triangulation<3> &, const std::string &);
  template void
  check_cell_shapes(const Triangulation<2> &, const std::string &);
  template void
  check_cell_shapes(const Triangulation<3> &, const std::string &);
  template CellsInsideOut<2>
  cells_inside_out(const QuadraticCells<2> &);
  template CellsInsideOut<3>
  cells_inside_out(const QuadraticCells<3> &);
  template void
  check_curved_cells(const QuadraticCells<2> &, const std::string &);
  template void
  check_curved_cells(const QuadraticCells<3> &, const std::string &);
  template std::string
  warning_about_seams(const Triangulation<2> &, const std::string &);
  template std::string
  warning_about_seams(const Triangulation<3> &, const std::string &);
} // namespace stickslip
