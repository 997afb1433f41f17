#ifndef stickslip_solid_viscous_stabilization_h
#define stickslip_solid_viscous_stabilization_h

#include <stickslip/base/types.h>

#include <stickslip/solid/cell_scratch.h>

#include <deal.II/dofs/dof_handler.h>

namespace stickslip
{
  /**
   * Viscous forces that let a body snap past a limit point of its quasi-static
   * path: per reference volume
   *
   *   c M (u - u_old) / dt
   *
   * with the longitudinal modulus M of the material, the time step dt and a
   * small coefficient c [time / length^2]. They vanish where the bodies rest;
   * while one snaps, dt becomes small and they take up the energy that is set
   * free.
   */
  template <int dim>
  class ViscousStabilization
  {
  public:
    /// Off until activate(). Collective.
    explicit ViscousStabilization(const DoFHandler<dim> &dof_handler);

    /// c = @p factor @p time_scale / L^2, L the diagonal of the model.
    void
    activate(const double factor, const double time_scale);

    /// Keeps a reference to the ghosted displacement at the start of the step.
    void
    set_start(const LA::Vector &u_old);

    /// The next forces are of a step of this size.
    void
    begin_step(const double step_size);

    bool
    is_active() const
    {
      return coefficient > 0. && step_size > 0. && u_old != nullptr;
    }

    using CellIterator = typename DoFHandler<dim>::active_cell_iterator;

    /// Adds the forces of the cell that @p at is at, and their tangent.
    void
    add_cell(const CellIterator &cell,
             const double        modulus,
             const bool          with_tangent,
             CellScratch<dim>   &at);

    /// Work of these forces in this step.
    double
    work(const CellIterator     &cell,
         const double            modulus,
         const CellScratch<dim> &at);

  private:
    const double               extent;
    double                     coefficient = 0.;
    double                     step_size   = 0.;
    const LA::Vector          *u_old       = nullptr;
    ByKind<ElementArrays<dim>> old_elements;
  };
} // namespace stickslip

#endif
