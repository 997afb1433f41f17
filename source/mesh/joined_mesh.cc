#include <stickslip/mesh/joined_mesh.h>

#include <deal.II/base/exceptions.h>

namespace stickslip
{
  namespace
  {
    /// Vertices (in new numbers) and manifold of a line or quadrilateral. The
    /// boundary id that says "not at the boundary" is the default.
    template <int structdim, typename Iterator>
    CellData<structdim>
    sub_cell_data_of(
      const Iterator                                         &object,
      const std::map<types::manifold_id, types::manifold_id> &manifold_ids,
      const std::vector<unsigned int>                        &new_vertices)
    {
      CellData<structdim> data(object->n_vertices());
      for (const unsigned int v : object->vertex_indices())
        data.vertices[v] = new_vertices[object->vertex_index(v)];
      const auto manifold = manifold_ids.find(object->manifold_id());
      data.manifold_id =
        (manifold == manifold_ids.end() ? numbers::flat_manifold_id
                                        : manifold->second);
      data.boundary_id = numbers::internal_face_boundary_id;
      return data;
    }
  } // namespace



  template <int dim>
  void
  JoinedMesh<dim>::add(
    const BodyMesh<dim>                                    &body,
    const std::map<types::boundary_id, types::boundary_id> &boundary_ids)
  {
    std::map<types::manifold_id, types::manifold_id> manifold_ids;
    for (const auto &[id, manifold] : body.manifolds)
      {
        manifold_ids[id] = manifolds.size();
        manifolds.push_back(manifold->clone());
      }

    const Triangulation<dim> &triangulation = body.triangulation;
    std::vector<unsigned int> new_vertices(triangulation.n_vertices(),
                                           numbers::invalid_unsigned_int);
    const std::vector<bool>  &is_used = triangulation.get_used_vertices();
    for (unsigned int v = 0; v < triangulation.n_vertices(); ++v)
      if (is_used[v])
        {
          new_vertices[v] = vertices.size();
          vertices.push_back(triangulation.get_vertices()[v]);
        }

    for (const auto &cell : triangulation.active_cell_iterators())
      {
        cells.push_back(
          sub_cell_data_of<dim>(cell, manifold_ids, new_vertices));
        cells.back().material_id = n_materials + cell->material_id();
      }
    n_materials += body.materials.size();
    add_sub_cells(triangulation, boundary_ids, manifold_ids, new_vertices);
  }



  template <int dim>
  void
  JoinedMesh<dim>::add_sub_cells(
    const Triangulation<dim>                               &body,
    const std::map<types::boundary_id, types::boundary_id> &boundary_ids,
    const std::map<types::manifold_id, types::manifold_id> &manifold_ids,
    const std::vector<unsigned int>                        &new_vertices)
  {
    for (const auto &face : body.active_face_iterators())
      {
        auto data = sub_cell_data_of<dim - 1>(face, manifold_ids, new_vertices);
        if (face->at_boundary())
          data.boundary_id = boundary_ids.at(face->boundary_id());
        else if (data.manifold_id == numbers::flat_manifold_id)
          continue;

        if constexpr (dim == 2)
          sub_cell_data.boundary_lines.push_back(data);
        else
          sub_cell_data.boundary_quads.push_back(data);
      }

    if constexpr (dim == 3)
      {
        std::vector<bool> is_done(body.n_raw_lines(), false);
        for (const auto &cell : body.active_cell_iterators())
          for (const unsigned int l : cell->line_indices())
            {
              const auto line = cell->line(l);
              auto data = sub_cell_data_of<1>(line, manifold_ids, new_vertices);
              if (data.manifold_id == numbers::flat_manifold_id ||
                  is_done[line->index()])
                continue;
              is_done[line->index()] = true;
              // Lines need a boundary id if they are at the boundary, but
              // nothing asks which one.
              if (line->at_boundary())
                data.boundary_id = 0;
              sub_cell_data.boundary_lines.push_back(data);
            }
      }
  }



  template <int dim>
  void
  JoinedMesh<dim>::create(Triangulation<dim> &triangulation) const
  {
    triangulation.create_triangulation(vertices, cells, sub_cell_data);
    set_manifolds(triangulation);
  }



  template <int dim>
  void
  JoinedMesh<dim>::create(
    Triangulation<dim>                         &triangulation,
    const std::vector<types::global_dof_index> &order) const
  {
    std::vector<CellData<dim>> ordered_cells;
    for (const auto number : order)
      ordered_cells.push_back(cells[number]);
    triangulation.create_triangulation(vertices, ordered_cells, sub_cell_data);
    set_manifolds(triangulation);
  }



  template <int dim>
  void
  JoinedMesh<dim>::set_manifolds(Triangulation<dim> &triangulation) const
  {
    for (unsigned int m = 0; m < manifolds.size(); ++m)
      triangulation.set_manifold(m, *manifolds[m]);
  }



  template class JoinedMesh<2>;
  template class JoinedMesh<3>;
} // namespace stickslip
