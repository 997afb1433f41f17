#ifndef stickslip_adaptivity_state_transfer_h
#define stickslip_adaptivity_state_transfer_h

#include <stickslip/adaptivity/cell_transfer.h>

#include <stickslip/problem/contact_problem.h>

#include <deal.II/distributed/tria.h>

#include <memory>
#include <vector>

namespace stickslip
{
  /**
   * Carries an accepted state from one mesh to the next: displacements and
   * their rate, histories of the materials, multipliers and slip of the contact
   * surfaces, cut into records of cells (CellTransfer) that travel with
   * them. Three calls, between which the old problem is destroyed and the new
   * one is made: constructor, execute(), put_into(). All are collective.
   *
   * What is not carried follows from the rest: pairings and statuses from the
   * positions, adapted regularization parameters from new cycles.
   */
  template <int dim>
  class StateTransfer
  {
  public:
    /// Takes the state @p x at @p time out of @p problem, with the accepted
    /// histories; @p rate is a field like the displacement.
    StateTransfer(ContactProblem<dim>   &problem,
                  const double           time,
                  const LA::BlockVector &x,
                  const LA::Vector      &rate);

    /// Refines and coarsens the cells of @p triangulation that have flags, and
    /// distributes them anew.
    void
    execute(parallel::distributed::Triangulation<dim> &triangulation);

    /// The state on the new mesh, as a first guess: it is not in equilibrium.
    /// @p problem is ready for an iteration at it.
    void
    put_into(ContactProblem<dim> &problem,
             const double         time,
             LA::BlockVector     &x,
             LA::Vector          &rate) const;

  private:
    const std::unique_ptr<FiniteElement<dim>> element; ///< scalar
    const CellTransfer<dim>                   transfer;
    std::vector<CellRecord>                   records; ///< by active cell
  };
} // namespace stickslip

#endif
