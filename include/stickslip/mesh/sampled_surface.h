#ifndef stickslip_mesh_sampled_surface_h
#define stickslip_mesh_sampled_surface_h

#include <stickslip/base/types.h>

#include <deal.II/base/bounding_box.h>

#include <deal.II/grid/tria.h>

#include <deal.II/numerics/rtree.h>

#include <set>
#include <string>

namespace stickslip
{
  /**
   * Points on boundaries of the coarse mesh, which every rank has, and of the
   * manifolds on them: what is within a distance of the surface?
   */
  template <int dim>
  class SampledSurface
  {
  public:
    /**
     * Points at most @p spacing apart in each direction of a coarse face, at
     * most 2^@p finest_level + 1 per face and direction. Throws UserError that
     * blames @p parameter_path if these are too many to be kept. Not
     * collective; the same on all ranks.
     */
    SampledSurface(const Triangulation<dim>           &triangulation,
                   const std::set<types::boundary_id> &boundary_ids,
                   const double                        spacing,
                   const unsigned int                  finest_level,
                   const std::string                  &parameter_path);

    /// True if a point is within @p distance of the box.
    bool
    is_within(const double distance, const BoundingBox<dim> &box) const;

  private:
    RTree<Point<dim>> points;
  };
} // namespace stickslip

#endif
