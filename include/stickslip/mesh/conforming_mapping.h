#ifndef stickslip_mesh_conforming_mapping_h
#define stickslip_mesh_conforming_mapping_h

#include <deal.II/distributed/tria_base.h>

#include <deal.II/hp/mapping_collection.h>

namespace stickslip
{
  using namespace dealii;

  /**
   * The isoparametric mapping of a mesh, one for each of kinds_of_cells(), with
   * its nodes on the manifolds, and without gaps at hanging nodes. It does not
   * outlive a change of the triangulation.
   *
   * On a curved manifold the cells of a refined side have their nodes on the
   * manifold, those of the coarse side are polynomials between theirs: a gap or
   * an overlap where displacements are continuous, so that a rotation of the
   * body would strain it. Here hanging nodes lie where the constraints of the
   * displacements put them, on the coarse side. Collective.
   */
  template <int dim>
  hp::MappingCollection<dim>
  make_conforming_mapping(
    const parallel::DistributedTriangulationBase<dim> &triangulation,
    const unsigned int                                 degree);
} // namespace stickslip

#endif
