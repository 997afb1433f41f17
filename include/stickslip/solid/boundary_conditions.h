#ifndef stickslip_solid_boundary_conditions_h
#define stickslip_solid_boundary_conditions_h

#include <stickslip/base/amplitude.h>
#include <stickslip/base/parameter_file.h>
#include <stickslip/base/types.h>

#include <stickslip/mesh/body.h>
#include <stickslip/mesh/periodic_nodes.h>

#include <stickslip/solid/boundary_condition_parameters.h>
#include <stickslip/solid/load.h>
#include <stickslip/solid/prescribed_displacement.h>
#include <stickslip/solid/pretension.h>

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/hp/mapping_collection.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace stickslip
{
  /**
   * What the user prescribes on the bodies' boundaries, made from the section
   * "Boundary conditions": loads (for SolidAssembler), displacements and
   * pretension (as constraints). Periodicity is a matter of the mesh
   * (mesh/periodic_nodes.h).
   */
  template <int dim>
  class BoundaryConditions
  {
  public:
    /**
     * Not collective, but the same on all ranks. Throws UserError for unknown
     * bodies, boundary ids without a face, wrong expressions and for
     * conditions that make no sense on a rigid body. Keeps a reference to
     * @p bodies.
     */
    BoundaryConditions(const NamedList<BoundaryConditionParameters> &parameters,
                       const Bodies                                 &bodies,
                       const Amplitudes &amplitudes = {});

    /**
     * Adds the lines of the increment, u_i = g_i(time) - u_i(current), for all
     * prescribed displacements that act at this time; bodies marked rigid that
     * no rigid motion names are held in place. @p u holds the current displacements and needs the
     * locally owned entries. Degrees of freedom that are constrained already
     * (hanging nodes, periodicity) keep their lines; what is prescribed at
     * images is prescribed to their originals (solid/held_images.h). Nodes that
     * follow a reference point are left to RigidCoupling. All lines of
     * constraints.get_local_lines() are filled, so ranks agree, also on
     * degrees of freedom of cells that they do not see.
     *
     * Collective. Throws UserError on all ranks if two conditions contradict
     * each other at a node, if a condition holds at no node, or if a symmetry
     * boundary is not plane. Call before constraints.close().
     */
    void
    add_prescribed_displacements(const hp::MappingCollection<dim> &mapping,
                                 const DoFHandler<dim>            &dof_handler,
                                 const PeriodicNodes<dim> &periodic_nodes,
                                 const double              time,
                                 const LA::Vector         &u,
                                 Constraints              &constraints) const;

    /// Whether a rigid motion with free components moves the rigid body.
    bool
    drives_rigid_body(const unsigned int body) const;

    /// Indices of the prescribed displacements whose nodes follow a reference
    /// point that is not held in all components.
    std::vector<unsigned int>
    reference_points() const;

    /// Without the prescribed displacements that begin or end.
    BoundaryConditions
    permanent() const;

    /// Whether the same conditions prescribe displacements at both times, and
    /// the same cuts are locked.
    bool
    hold_the_same(const double time, const double other_time) const;

    /// The boundaries that distributed forces act on (ForceDistribution).
    /// Collective. Before the forces are asked for.
    void
    measure_distributed_forces(const hp::MappingCollection<dim> &mapping,
                               const DoFHandler<dim> &dof_handler) const;

    const std::vector<Load<dim>> &
    loads() const
    {
      return all_loads;
    }

    const std::vector<PrescribedDisplacement<dim>> &
    prescribed_displacements() const
    {
      return displacements;
    }

    const std::vector<Pretension<dim>> &
    pretensions() const
    {
      return all_pretensions;
    }

  private:
    void
    add_condition(const std::string                 &name,
                  const BoundaryConditionParameters &parameters);

    void
    add_displacement(const std::string                 &name,
                     const BoundaryConditionParameters &parameters);

    void
    add_load(const std::string                 &name,
             const BoundaryConditionParameters &parameters);

    /// Null if the condition names none.
    std::shared_ptr<const Amplitude>
    amplitude_of(const BoundaryConditionParameters &parameters,
                 const std::string                 &path) const;

    static std::optional<CylindricalFrame<dim>>
    frame_of(const BoundaryConditionParameters &parameters,
             const std::string                 &path);

    const Bodies    &bodies;
    const Amplitudes amplitudes;

    std::vector<PrescribedDisplacement<dim>> displacements;
    std::vector<Load<dim>>                   all_loads;
    std::vector<Pretension<dim>>             all_pretensions;
  };
} // namespace stickslip

#endif
