#include <stickslip/mesh/mesh_shapes.h>

#include <deal.II/base/numbers.h>

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold_lib.h>

#include <cmath>

namespace stickslip
{
  template <int dim>
  void
  make_graded_hyper_rectangle(
    const std::array<std::vector<double>, dim> &positions,
    Triangulation<dim>                         &triangulation)
  {
    Point<dim>                       first, last;
    std::vector<std::vector<double>> steps(dim);
    for (unsigned int d = 0; d < dim; ++d)
      {
        first[d] = positions[d].front();
        last[d]  = positions[d].back();
        for (unsigned int i = 1; i < positions[d].size(); ++i)
          steps[d].push_back(positions[d][i] - positions[d][i - 1]);
      }
    GridGenerator::subdivided_hyper_rectangle(
      triangulation, steps, first, last, true);
  }



  template <int dim>
  void
  make_annular_sector(const AnnularSector &sector,
                      Triangulation<dim>  &triangulation)
  {
    constexpr double degree = numbers::PI / 180.;
    const double     range  = sector.angles.back() - sector.angles.front();
    const bool       closed = std::abs(range - 360.) < 1e-9;

    const unsigned int n_angular = sector.angles.size() - 1;
    const unsigned int n_angles  = closed ? n_angular : n_angular + 1;
    const unsigned int n_radii   = sector.radii.size();
    const unsigned int n_layers  = (dim == 3 ? sector.heights.size() : 1);

    // Vertices: radius runs fastest, then the angle, then the axis.
    std::vector<Point<dim>> vertices;
    for (unsigned int k = 0; k < n_layers; ++k)
      for (unsigned int j = 0; j < n_angles; ++j)
        for (const double radius : sector.radii)
          {
            Point<dim> vertex;
            vertex[0] = radius * std::cos(degree * sector.angles[j]);
            vertex[1] = radius * std::sin(degree * sector.angles[j]);
            if (dim == 3)
              vertex[dim - 1] = sector.heights[k];
            vertices.push_back(vertex);
          }

    std::vector<CellData<dim>> cells;
    for (unsigned int k = 0; k < (dim == 3 ? n_layers - 1 : 1); ++k)
      for (unsigned int j = 0; j < n_angular; ++j)
        for (unsigned int i = 0; i + 1 < n_radii; ++i)
          {
            CellData<dim> cell;
            for (unsigned int v = 0; v < cell.vertices.size(); ++v)
              cell.vertices[v] =
                ((k + v / 4) * n_angles + (j + (v / 2) % 2) % n_angles) *
                  n_radii +
                i + v % 2;
            cells.push_back(cell);
          }
    triangulation.create_triangulation(vertices, cells, SubCellData());

    // In a cell, directions are radius, angle, axis: face numbers tell.
    for (const auto &cell : triangulation.active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
        if (cell->face(f)->at_boundary())
          cell->face(f)->set_boundary_id(f);

    triangulation.set_all_manifold_ids(0);
    if constexpr (dim == 2)
      triangulation.set_manifold(0, SphericalManifold<2>());
    else
      triangulation.set_manifold(0, CylindricalManifold<3>(2));
  }



  template void
  make_graded_hyper_rectangle<2>(const std::array<std::vector<double>, 2> &,
                                 Triangulation<2> &);
  template void
  make_graded_hyper_rectangle<3>(const std::array<std::vector<double>, 3> &,
                                 Triangulation<3> &);
  template void
  make_annular_sector(const AnnularSector &, Triangulation<2> &);
  template void
  make_annular_sector(const AnnularSector &, Triangulation<3> &);
} // namespace stickslip
