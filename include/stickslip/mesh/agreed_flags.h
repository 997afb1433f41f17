#ifndef stickslip_mesh_agreed_flags_h
#define stickslip_mesh_agreed_flags_h

#include <deal.II/distributed/tria.h>

namespace stickslip
{
  using namespace dealii;

  /**
   * Replaces the flags of the cells of @p triangulation by those that
   * execute_agreed_flags() executes. Returns whether there are any: whether the
   * mesh is to change. Collective.
   */
  template <int dim>
  bool
  agree_on_flags(parallel::distributed::Triangulation<dim> &triangulation);

  /**
   * Refines and coarsens the cells of @p triangulation that have flags, after
   * the ranks have agreed on flags that can be executed as they are: a cell
   * becomes coarser only with all its siblings, and the levels of cells that
   * share a vertex stay within one, for which cells are refined that had no
   * flag and others kept that were to be coarser. These are the smallest such
   * changes, the same on any number of ranks. (deal.II alone does not ask
   * what the cells of other ranks want, and keeps more cells fine along the
   * borders between ranks.)
   *
   * Collective.
   */
  template <int dim>
  void
  execute_agreed_flags(
    parallel::distributed::Triangulation<dim> &triangulation);
} // namespace stickslip

#endif
