#ifndef stickslip_linear_solvers_multigrid_fewer_ranks_h
#define stickslip_linear_solvers_multigrid_fewer_ranks_h

#include <stickslip/linear_solvers/multigrid/aggregation.h>

namespace stickslip
{
  /**
   * Moves the @p nodes of a level, of which there are no vectors and matrices
   * yet, and their @p modes to fewer ranks, if half of those that have some are
   * enough for @p least_unknowns on each. Groups of at most about eight ranks
   * one after the other, with about as many nodes each, send all to their first
   * one. So nodes keep their numbers over all ranks, and prolongations their
   * columns. The matrix of the level is then summed up, and vectors come and
   * go, directly between the ranks of the finer level and the new ones.
   * Collective.
   */
  void
  move_to_fewer_ranks(NodeSpace                    &nodes,
                      Modes                        &modes,
                      const types::global_dof_index least_unknowns);
} // namespace stickslip

#endif
