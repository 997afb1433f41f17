#ifndef stickslip_solid_solid_assembler_h
#define stickslip_solid_solid_assembler_h

#include <stickslip/base/types.h>

#include <stickslip/mesh/body.h>

#include <stickslip/solid/boundary_conditions.h>
#include <stickslip/solid/cell_scratch.h>
#include <stickslip/solid/constitutive_law.h>
#include <stickslip/solid/inadmissible_point.h>
#include <stickslip/solid/linear_stiffness.h>
#include <stickslip/solid/material_states.h>
#include <stickslip/solid/mean_dilatation.h>
#include <stickslip/solid/point_history.h>
#include <stickslip/solid/surface_loads.h>
#include <stickslip/solid/viscous_stabilization.h>

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/hp/mapping_collection.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace stickslip
{
  /**
   * Internal and external forces of the bodies, and their tangent, in the
   * total Lagrangian form
   *
   *   R_u(v) = int P : Grad v  +  springs  -  (tractions, pressures, body
   * forces)
   *
   * with cell_quadrature() in the reference cells. Works with any FESystem of
   * dim equal FE_Q or FE_SimplexP, one for each kind of cells. Cells of rigid
   * bodies are skipped, and those of linear laws are evaluated once.
   */
  template <int dim>
  class SolidAssembler
  {
  public:
    using PointState = MaterialState<dim>;

    /**
     * @p laws is indexed by material id (see laws_of_regions()), as is
     * @p with_mean_dilatation, which says where F-bar or B-bar elements are
     * wanted (nowhere if it is empty; see MeanDilatation). Keeps
     * references to everything but the laws, which it shares. The mesh and the
     * degrees of freedom must be complete; after a change of the mesh make a
     * new object and transfer point_history(). Measures the boundaries of
     * distributed forces. Throws UserError if a deformable region has no law.
     * Collective.
     */
    SolidAssembler(
      const hp::MappingCollection<dim>                          &mapping,
      const DoFHandler<dim>                                     &dof_handler,
      const Bodies                                              &bodies,
      const std::vector<std::shared_ptr<const ConstitutiveLaw>> &laws,
      const BoundaryConditions<dim> &boundary_conditions,
      const std::vector<bool>       &with_mean_dilatation = {});

    /**
     * Adds internal and external forces, so that R_u = internal - external.
     * @p u is ghosted (locally relevant entries). Rows of hanging nodes and
     * periodicity are condensed with @p geometric; rows of prescribed
     * displacements are left: they are the reactions. The vectors must be
     * writable (owned entries plus ghosts); they are not compressed. Writes
     * the trial history.
     */
    void
    add_residual(const LA::Vector  &u,
                 const double       time,
                 const Constraints &geometric,
                 LA::Vector        &internal,
                 LA::Vector        &external);

    /**
     * Adds dR_u/du to @p matrix and -R_u to @p rhs with all @p constraints of
     * the increment eliminated. Constrained rows get a positive diagonal of
     * the order of the stiffness. Not compressed. Writes the trial history.
     */
    void
    add_tangent(const LA::Vector  &u,
                const double       time,
                const Constraints &constraints,
                LA::SparseMatrix  &matrix,
                LA::Vector        &rhs);

    /// False if the last add_residual() or add_tangent() met a point where the
    /// law found no stress or (large strains) det F <= 0. Collective.
    bool
    state_is_admissible() const;

    /// Why and where the last evaluation failed (one point out of all ranks).
    /// Collective.
    InadmissibleState
    inadmissible_state() const;

    /// The trial history of the last evaluation becomes the accepted one.
    void
    accept();

    /// Forgets the trial history.
    void
    restore();

    /// Stress, strain and history of a cell; see MaterialStates::evaluate().
    void
    evaluate_point_states(
      const typename DoFHandler<dim>::active_cell_iterator &cell,
      const LA::Vector                                     &u,
      std::vector<PointState>                              &states)
    {
      material_states.evaluate(cell, u, states);
    }

    /// Off until it is activated.
    ViscousStabilization<dim> &
    stabilization()
    {
      return viscous;
    }

    /// Work of the stabilization in the step that leads to the ghosted @p u.
    /// Collective.
    double
    stabilization_work(const LA::Vector &u);

    /// Names of PointState::history.
    const std::vector<std::string> &
    history_names() const
    {
      return material_states.history_names();
    }

    /// lambda + 2 mu at rest; zero for a region of a rigid body without law.
    double
    longitudinal_modulus(const types::material_id material) const;

    /// That of a region; it must have one.
    const ConstitutiveLaw &
    law(const types::material_id material) const
    {
      return *laws[material];
    }

    const PointHistory &
    point_history() const
    {
      return history;
    }

    PointHistory &
    point_history()
    {
      return history;
    }

  private:
    using CellIterator = typename DoFHandler<dim>::active_cell_iterator;

    void
    initialize_history();

    bool
    is_rigid(const CellIterator &cell) const;

    /// The material of the cell has a stiffness that does not change.
    bool
    is_linear(const CellIterator &cell) const;

    bool
    has_loads(const CellIterator &cell) const;

    /// The cell adds nothing but its linear stiffness.
    bool
    is_only_linear(const CellIterator &cell) const
    {
      return is_linear(cell) && !has_loads(cell) && !viscous.is_active();
    }

    /// Sums up the cells of linear laws when they are first needed.
    void
    assemble_linear_stiffness(const LA::Vector &u);

    /// Forces (without those of linear stiffness) and, with_tangent, stiffness
    /// of one cell. Returns the scratch that has them.
    const CellScratch<dim> &
    evaluate_cell(const CellIterator &cell,
                  const LA::Vector   &u,
                  const double        time,
                  const bool          with_tangent);

    void
    add_stresses(const CellIterator &cell,
                 const bool          with_tangent,
                 CellScratch<dim>   &at);

    void
    add_body_forces(const CellIterator &cell,
                    const double        time,
                    CellScratch<dim>   &at);

    /// A diagonal of the size of the stiffness elsewhere.
    void
    add_rigid_cell(const CellIterator &cell,
                   const Constraints  &constraints,
                   LA::SparseMatrix   &matrix);

    void
    record_failure(const CellIterator     &cell,
                   const CellScratch<dim> &at,
                   const unsigned int      q,
                   const bool              has_volume);

    const DoFHandler<dim>                                    &dof_handler;
    const Bodies                                             &bodies;
    const std::vector<std::shared_ptr<const ConstitutiveLaw>> laws;

    /// By material id; empty where the dilatation is that of the point.
    std::vector<std::optional<MeanDilatation<dim>>> mean_dilatation;

    PointHistory              history;
    MaterialStates<dim>       material_states;
    SurfaceLoads<dim>         surface_loads;
    ViscousStabilization<dim> viscous;
    double                    largest_modulus;

    LinearStiffness<dim> linear_stiffness;
    bool                 linear_stiffness_is_known = false;

    InadmissiblePoint<dim> failure; ///< of the last evaluation

    ByKind<CellScratch<dim>> scratch;

    /// By body.
    std::vector<std::vector<const Load<dim> *>> body_forces;
  };
} // namespace stickslip

#endif
