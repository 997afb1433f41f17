#ifndef stickslip_adaptivity_state_transfer_h
#define stickslip_adaptivity_state_transfer_h

#include <stickslip/adaptivity/cell_transfer.h>

#include <stickslip/problem/contact_problem.h>

#include <deal.II/distributed/tria.h>

#include <deal.II/lac/vector.h>

#include <memory>
#include <vector>

namespace stickslip
{
  /// What a run has on a mesh. Vectors of locally owned entries.
  struct MeshState
  {
    LA::BlockVector x;     ///< the accepted displacements and multipliers
    LA::Vector      rate;  ///< of the displacements, where they go
    LA::BlockVector guess; ///< where the next solution may be; often x
  };



  /**
   * Carries a state from one mesh to the next: displacements, multipliers, the
   * histories of the materials, the slip of the contact surfaces, cut into
   * records of cells (CellTransfer) that travel with them. Three calls, between
   * which the old problem is destroyed and the new one is made: constructor,
   * execute(), put_into(). These are collective.
   *
   * What is not carried follows from the rest: pairings and statuses from the
   * positions, adapted regularization parameters from new cycles.
   */
  template <int dim>
  class StateTransfer
  {
  public:
    /// Takes @p state at load time @p time out of @p problem, with the accepted
    /// histories; @p indicators are those of an estimate, or empty.
    StateTransfer(ContactProblem<dim>  &problem,
                  const double          time,
                  const MeshState      &state,
                  const Vector<double> &indicators);

    /// Refines and coarsens the cells of @p triangulation that have flags, and
    /// distributes them anew. May be called again.
    void
    execute(parallel::distributed::Triangulation<dim> &triangulation);

    /// The indicators to expect on the cells that execute() has made.
    Vector<double>
    expected_indicators() const;

    /// The state on the new mesh: a first guess, not in equilibrium.
    /// @p problem is ready for an iteration at its x.
    MeshState
    put_into(ContactProblem<dim> &problem, const double time) const;

  private:
    const std::unique_ptr<FiniteElement<dim>> element; ///< scalar
    const CellTransfer<dim>                   transfer;
    std::vector<CellRecord>                   records; ///< by active cell

    std::vector<CellRecord>
    records_of_children(
      const typename Triangulation<dim>::cell_iterator &parent) const;
  };
} // namespace stickslip

#endif
