#ifndef stickslip_mesh_joined_mesh_h
#define stickslip_mesh_joined_mesh_h

#include <stickslip/mesh/body_mesh.h>

#include <deal.II/grid/tria.h>

#include <algorithm>
#include <map>
#include <memory>
#include <vector>

namespace stickslip
{
  /**
   * Cells of several bodies, collected to become one coarse triangulation.
   * Bodies share no vertex, not even where they touch: what holds them together
   * is contact. This is why GridGenerator::merge_triangulations is not used.
   */
  template <int dim>
  class JoinedMesh
  {
  public:
    /**
     * Appends the active cells of a body. Its material, boundary and manifold
     * ids are replaced: material ids are shifted by the number of materials so
     * far, boundary ids mapped by @p boundary_ids, manifolds numbered through.
     */
    void
    add(const BodyMesh<dim>                                    &body,
        const std::map<types::boundary_id, types::boundary_id> &boundary_ids);

    std::size_t
    n_cells() const
    {
      return cells.size();
    }

    /// Triangles or tetrahedra.
    bool
    has_simplices() const
    {
      return std::any_of(cells.begin(), cells.end(), [](const auto &cell) {
        return cell.vertices.size() == dim + 1;
      });
    }

    /// Creates the coarse triangulation and attaches the manifolds. The same
    /// result on each rank; collective if the triangulation is distributed.
    void
    create(Triangulation<dim> &triangulation) const;

    /// Likewise with cell order[k] as the k-th one.
    void
    create(Triangulation<dim>                         &triangulation,
           const std::vector<types::global_dof_index> &order) const;

    /// Attaches the manifolds only.
    void
    set_manifolds(Triangulation<dim> &triangulation) const;

  private:
    std::vector<Point<dim>>                          vertices;
    std::vector<CellData<dim>>                       cells;
    SubCellData                                      sub_cell_data;
    unsigned int                                     n_materials = 0;
    std::vector<std::unique_ptr<Manifold<dim, dim>>> manifolds;

    void
    add_sub_cells(
      const Triangulation<dim>                               &body,
      const std::map<types::boundary_id, types::boundary_id> &boundary_ids,
      const std::map<types::manifold_id, types::manifold_id> &manifold_ids,
      const std::vector<unsigned int>                        &new_vertices);
  };
} // namespace stickslip

#endif
