#include <stickslip/mesh/bent_cells.h>
#include <stickslip/mesh/mapping_nodes.h>
#include <stickslip/mesh/reference_cells.h>

#include <deal.II/fe/fe.h>
#include <deal.II/fe/mapping.h>

#include <cmath>
#include <vector>

namespace stickslip
{
  namespace
  {
    /// Weights of the vertices of a face for the nodes of degree 2 on it.
    std::vector<std::vector<double>>
    places_on_face(const unsigned int n_vertices)
    {
      std::vector<std::vector<double>> places;
      for (const double a : {0., 0.5, 1.})
        if (n_vertices == 2)
          places.push_back({1. - a, a});
        else
          for (const double b : {0., 0.5, 1.})
            if (n_vertices == 4)
              places.push_back(
                {(1. - a) * (1. - b), a * (1. - b), (1. - a) * b, a * b});
            else if (a + b <= 1.)
              places.push_back({1. - a - b, a, b});
      return places;
    }



    /// How far @p x is from the tangent plane of the straight @p cell's face
    /// at @p unit, over the size of the cell; @p along: two directions (2D: one)
    /// of the face in the unit cell.
    template <int dim>
    double
    distance_from_straight_face(
      const typename Triangulation<dim>::cell_iterator &cell,
      const FiniteElement<dim>                         &linear,
      const Point<dim>                                 &unit,
      const std::vector<Tensor<1, dim>>                &along,
      const Point<dim>                                 &x)
    {
      Tensor<1, dim>              straight;
      std::vector<Tensor<1, dim>> tangents(along.size());
      for (const unsigned int v : cell->vertex_indices())
        {
          const Tensor<1, dim> vertex = cell->vertex(v);
          straight += linear.shape_value(v, unit) * vertex;
          for (unsigned int a = 0; a < along.size(); ++a)
            tangents[a] += (linear.shape_grad(v, unit) * along[a]) * vertex;
        }
      Tensor<1, dim> normal;
      if constexpr (dim == 2)
        normal = cross_product_2d(tangents[0]);
      else
        normal = cross_product_3d(tangents[0], tangents[1]);
      const double size =
        cell->vertex(0).distance(cell->vertex(cell->n_vertices() - 1));
      return std::abs((x - straight) * normal) / (normal.norm() * size);
    }



    /// The vertices of a face in the unit cell, in the order of the cell's.
    template <int dim>
    std::vector<Point<dim>>
    unit_vertices_of_face(
      const typename Triangulation<dim>::cell_iterator &cell,
      const unsigned int                                face,
      const FiniteElement<dim>                         &linear)
    {
      std::vector<Point<dim>> vertices;
      for (const unsigned int v : cell->vertex_indices())
        for (const unsigned int w : cell->face(face)->vertex_indices())
          if (cell->face(face)->vertex_index(w) == cell->vertex_index(v))
            vertices.push_back(linear.unit_support_point(v));
      return vertices;
    }



    template <int dim>
    bool
    is_straight(const typename Triangulation<dim>::cell_iterator &cell,
                const unsigned int                                face,
                const FiniteElement<dim>                         &linear,
                const QuadraticCells<dim>                        &cells,
                const std::size_t                                 number)
    {
      constexpr double roundoff = 1e-10; // of the cell's size

      const auto vertices = unit_vertices_of_face<dim>(cell, face, linear);
      std::vector<Tensor<1, dim>> along;
      for (unsigned int d = 1; d < dim; ++d)
        along.push_back(vertices[d] - vertices[0]);
      for (const auto &weights : places_on_face(vertices.size()))
        {
          Point<dim> unit;
          for (unsigned int v = 0; v < weights.size(); ++v)
            unit += weights[v] * Tensor<1, dim>(vertices[v]);
          if (distance_from_straight_face<dim>(
                cell, linear, unit, along, cells.position(number, unit)) >
              roundoff)
            return false;
        }
      return true;
    }
  } // namespace



  template <int dim>
  std::shared_ptr<QuadraticCells<dim>>
  quadratic_cells_of(const Triangulation<dim> &triangulation)
  {
    const ReferenceCell kind = triangulation.begin_active()->reference_cell();
    const MappingNodes<dim> nodes_on_manifolds(2);
    const auto              simplex = kind.template get_default_mapping<dim>(2);
    auto                    cells = std::make_shared<QuadraticCells<dim>>(kind);
    const auto             &places = cells->element().get_unit_support_points();
    for (const auto &cell : triangulation.active_cell_iterators())
      if (kind.is_simplex())
        {
          std::vector<Point<dim>> nodes;
          for (const Point<dim> &unit : places)
            nodes.push_back(simplex->transform_unit_to_real_cell(cell, unit));
          cells->add(nodes);
        }
      else
        cells->add(nodes_on_manifolds.compute_mapping_support_points(cell));
    return cells;
  }



  template <int dim>
  bool
  has_straight_boundary(const Triangulation<dim>  &triangulation,
                        const QuadraticCells<dim> &cells)
  {
    const auto  linear = make_element<dim>(cells.element().reference_cell(), 1);
    std::size_t number = 0;
    for (const auto &cell : triangulation.active_cell_iterators())
      {
        for (const unsigned int f : cell->face_indices())
          if (cell->at_boundary(f) &&
              !is_straight<dim>(cell, f, *linear, cells, number))
            return false;
        ++number;
      }
    return true;
  }

  template std::shared_ptr<QuadraticCells<2>>
  quadratic_cells_of(const Triangulation<2> &);
  template std::shared_ptr<QuadraticCells<3>>
  quadratic_cells_of(const Triangulation<3> &);
  template bool
  has_straight_boundary(const Triangulation<2> &, const QuadraticCells<2> &);
  template bool
  has_straight_boundary(const Triangulation<3> &, const QuadraticCells<3> &);
} // namespace stickslip
