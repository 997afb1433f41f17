#include <stickslip/mesh/second_order_nodes.h>

#include <stickslip/base/user_error.h>
#include <stickslip/mesh/mesh_checks.h>

#include <deal.II/grid/reference_cell.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace stickslip
{
  namespace
  {
    using VertexSets = std::vector<std::vector<unsigned int>>;



    ReferenceCell
    reference_cell_of(const ElementShape shape)
    {
      return shape == ElementShape::triangle      ? ReferenceCells::Triangle
             : shape == ElementShape::tetrahedron ? ReferenceCells::Tetrahedron
             : shape == ElementShape::hexahedron
               ? ReferenceCells::Hexahedron
               : ReferenceCells::Quadrilateral;
    }



    /// The type of the second order that has all nodes. Those of the others are
    /// its first ones.
    const MeshElementType &
    complete_type(const ElementShape shape)
    {
      const unsigned int n_nodes = shape == ElementShape::triangle      ? 6
                                   : shape == ElementShape::tetrahedron ? 10
                                   : shape == ElementShape::hexahedron  ? 27
                                                                        : 9;
      return element_types()[element_type_of(shape, n_nodes)];
    }



    /// For each node of @p element the one of @p around that lies at the same
    /// place of the unit cell.
    template <int dim>
    std::vector<unsigned int>
    numbers_in_element(const FiniteElement<dim> &element,
                       const VertexSets         &around)
    {
      const ReferenceCell     cell = element.reference_cell();
      std::vector<Point<dim>> places;
      for (const auto &vertices : around)
        {
          places.emplace_back();
          for (const unsigned int v : vertices)
            {
              // deal.II numbers the vertices lexicographically
              const bool         swaps  = !cell.is_simplex() && v % 4 >= 2;
              const unsigned int number = swaps ? v / 4 * 4 + 5 - v % 4 : v;
              places.back() +=
                cell.template vertex<dim>(number) / (1. * vertices.size());
            }
        }
      std::vector<unsigned int> result;
      for (const Point<dim> &node : element.get_unit_support_points())
        result.push_back(
          std::min_element(places.begin(),
                           places.end(),
                           [&](const Point<dim> &a, const Point<dim> &b) {
                             return a.distance(node) < b.distance(node);
                           }) -
          places.begin());
      return result;
    }



    /// The nodes of a cell; those behind the ones of the file by transfinite
    /// interpolation.
    template <int dim>
    std::vector<Point<dim>>
    complete_nodes(const MeshFile   &file,
                   const std::size_t cell,
                   const VertexSets &around)
    {
      std::vector<Point<dim>> nodes;
      for (const unsigned int number : file.nodes(cell))
        {
          nodes.emplace_back();
          for (unsigned int d = 0; d < dim; ++d)
            nodes.back()[d] = file.points[number][d];
        }
      // Vertices come first, then edges, faces, and the cell; sets ascend.
      for (std::size_t n = nodes.size(); n < around.size(); ++n)
        {
          const auto &all = around[n];
          nodes.emplace_back();
          for (std::size_t m = 0; m < n; ++m)
            if (std::includes(
                  all.begin(), all.end(), around[m].begin(), around[m].end()))
              {
                const double dimensions =
                  std::log2(all.size() / around[m].size());
                nodes.back() -=
                  std::pow(-0.5, dimensions) * Tensor<1, dim>(nodes[m]);
              }
        }
      return nodes;
    }



    /// A node of an edge or face, named by the points at its vertices.
    template <int dim>
    struct SharedNode
    {
      std::vector<unsigned int> vertices;
      Point<dim>                position;

      bool
      operator<(const SharedNode &other) const
      {
        return vertices < other.vertices;
      }
    };



    template <int dim>
    void
    check_that_cells_agree(std::vector<SharedNode<dim>> &nodes,
                           const MeshFile               &file,
                           const std::string            &where)
    {
      constexpr double roundoff = 1e-9;
      std::sort(nodes.begin(), nodes.end());
      for (std::size_t n = 1; n < nodes.size(); ++n)
        {
          const auto  &vertices = nodes[n].vertices;
          const double length =
            file.points[vertices[0]].distance(file.points[vertices.back()]);
          if (vertices == nodes[n - 1].vertices &&
              nodes[n].position.distance(nodes[n - 1].position) >
                roundoff * length)
            throw UserError(
              where + "is no mesh whose cells fit together: two of them have " +
              "the same vertices of a side, but their nodes between these "
              "are " +
              "at " + coordinates_in_message(nodes[n - 1].position) + " and " +
              coordinates_in_message(nodes[n].position) + ".");
        }
    }
  } // namespace



  NodeDeviation
  deviation_of_nodes(const MeshFile                 &file,
                     const std::vector<std::size_t> &cells)
  {
    NodeDeviation deviation;
    for (const std::size_t cell : cells)
      {
        if (file.type(cell).is_linear())
          continue;
        const auto nodes  = file.nodes(cell);
        const auto around = vertices_around_nodes(file.type(cell));
        for (unsigned int n = 0; n < nodes.size(); ++n)
          {
            Point<3> middle;
            for (const unsigned int v : around[n])
              middle += file.points[nodes[v]] / (1. * around[n].size());
            const Point<3> &node   = file.points[nodes[n]];
            const double    length = file.points[nodes[around[n][0]]].distance(
              file.points[nodes[around[n].back()]]);
            const double distance = node.distance(middle);
            if (around[n].size() == 1 || !(distance > 0.))
              continue;
            deviation.ratio = std::max(deviation.ratio, distance / length);
            if (distance > deviation.largest)
              {
                deviation.largest = distance;
                deviation.place   = node;
              }
          }
      }
    return deviation;
  }



  template <int dim>
  std::shared_ptr<QuadraticCells<dim>>
  curved_cells(const MeshFile                 &file,
               const std::vector<std::size_t> &cells,
               const std::string              &where)
  {
    if (!deviation_of_nodes(file, cells).is_curved())
      return {};
    const ElementShape shape  = file.type(cells.front()).shape;
    VertexSets         around = vertices_around_nodes(complete_type(shape));
    for (auto &vertices : around)
      std::sort(vertices.begin(), vertices.end());
    auto result =
      std::make_shared<QuadraticCells<dim>>(reference_cell_of(shape));
    const auto numbers = numbers_in_element(result->element(), around);

    std::vector<SharedNode<dim>> shared;
    for (const std::size_t cell : cells)
      {
        const auto              nodes = complete_nodes<dim>(file, cell, around);
        std::vector<Point<dim>> ordered;
        for (const unsigned int n : numbers)
          ordered.push_back(nodes[n]);
        result->add(ordered);

        const auto points = file.nodes(cell);
        for (unsigned int n = 0; n < nodes.size(); ++n)
          if (around[n].size() > 1 && around[n].size() < n_vertices_of(shape))
            {
              shared.push_back({{}, nodes[n]});
              for (const unsigned int v : around[n])
                shared.back().vertices.push_back(points[v]);
              std::sort(shared.back().vertices.begin(),
                        shared.back().vertices.end());
            }
      }
    check_that_cells_agree(shared, file, where);
    return result;
  }

  template std::shared_ptr<QuadraticCells<2>>
  curved_cells(const MeshFile &,
               const std::vector<std::size_t> &,
               const std::string &);
  template std::shared_ptr<QuadraticCells<3>>
  curved_cells(const MeshFile &,
               const std::vector<std::size_t> &,
               const std::string &);
} // namespace stickslip
