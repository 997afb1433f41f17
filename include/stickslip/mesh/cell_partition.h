#ifndef stickslip_mesh_cell_partition_h
#define stickslip_mesh_cell_partition_h

#include <deal.II/grid/tria.h>

#include <vector>

namespace stickslip
{
  using namespace dealii;

  /**
   * Gives each active cell of the serial @p mesh the rank that is to own it, as
   * its subdomain id, from 0 to @p n_ranks - 1: ranks have few common faces,
   * and in each phase of a computation all have about the same work.
   * @p costs [phase][active cell index] are relative to those of other cells in
   * the same phase. (With fewer cells than ranks some ranks get none.) Phases
   * that wait for each other have to be balanced one by one: a rank with more
   * contact and fewer cells waits in both.
   *
   * METIS' partitioning with several constraints (Karypis, Kumar: Multilevel
   * algorithms for multi-constraint graph partitioning, 1998). Not collective.
   */
  template <int dim>
  void
  partition_cells(const unsigned int                            n_ranks,
                  const std::vector<std::vector<unsigned int>> &costs,
                  Triangulation<dim>                           &mesh);
} // namespace stickslip

#endif
