#ifndef stickslip_mesh_curved_simplex_mapping_h
#define stickslip_mesh_curved_simplex_mapping_h

#include <deal.II/base/point.h>

#include <deal.II/fe/mapping_fe.h>

#include <deal.II/grid/tria.h>

#include <memory>
#include <vector>

namespace stickslip
{
  using namespace dealii;

  /**
   * The mapping of degree 2 of triangles and tetrahedra, with the middle of
   * each edge on the manifold of the edge: cells that share it agree on it.
   * (MappingFE asks the manifold of the cell.) The nodes of all simplices that
   * are not artificial are kept, like those of MappingQCache; it does not
   * outlive a change of the triangulation.
   */
  template <int dim>
  class CurvedSimplexMapping : public MappingFE<dim>
  {
  public:
    explicit CurvedSimplexMapping(const Triangulation<dim> &triangulation);

    /// Shares the nodes.
    std::unique_ptr<Mapping<dim>>
    clone() const override;

  protected:
    std::vector<Point<dim>>
    compute_mapping_support_points(
      const typename Triangulation<dim>::cell_iterator &cell) const override;

  private:
    /// By active cell index.
    std::shared_ptr<const std::vector<std::vector<Point<dim>>>> nodes;
  };
} // namespace stickslip

#endif
