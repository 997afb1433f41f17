#ifndef stickslip_solid_force_distribution_h
#define stickslip_solid_force_distribution_h

#include <stickslip/base/amplitude.h>
#include <stickslip/base/space_time_function.h>
#include <stickslip/base/types.h>

#include <stickslip/mesh/cross_section.h>

#include <stickslip/solid/boundary_condition_parameters.h>
#include <stickslip/solid/rigid_state.h>

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/fe/mapping.h>

#include <memory>
#include <set>
#include <string>

namespace stickslip
{
  /**
   * A force F and a torque M at a reference point X_R, as tractions of a
   * boundary that do not make it stiffer: the linear field
   *   t(X) = F / A + J^{-1} (M + (X_R - X_c) x F) x (X - X_c)
   * with area A, centre X_c and inertia J = int |r|^2 I - r r^T dA, r = X -
   * X_c, of the undeformed boundary. Directions and arms stay those of the
   * undeformed body. Conjugate to F and M are the displacement and the (small)
   * rotation of the point that moves with the boundary in the mean, theta =
   * J^{-1} int r x u dA,   u_R = int u dA / A + theta x (X_R - X_c).
   */
  template <int dim>
  class ForceDistribution
  {
  public:
    /// Throws UserError for wrong expressions.
    ForceDistribution(const BoundaryConditionParameters      &parameters,
                      const std::shared_ptr<const Amplitude> &amplitude,
                      const std::string                      &path);

    /// Finds area, centre and inertia. Before traction() and mean_motion().
    /// Collective.
    void
    measure(const Mapping<dim>                 &mapping,
            const DoFHandler<dim>              &dof_handler,
            const std::set<types::boundary_id> &boundary,
            const CrossSection                 &section);

    /// Per reference area at a reference position.
    Tensor<1, dim>
    traction(const Point<dim> &X, const double time) const;

    /// Torque, displacement and rotation (small, in degrees) of the reference
    /// point for the displacements @p u (ghosted). Collective.
    RigidReaction<dim>
    mean_motion(const Mapping<dim>                 &mapping,
                const DoFHandler<dim>              &dof_handler,
                const std::set<types::boundary_id> &boundary,
                const CrossSection                 &section,
                const LA::Vector                   &u,
                const double                        time) const;

  private:
    std::shared_ptr<SpaceTimeFunction<dim>> force_law;  ///< null: none
    std::shared_ptr<SpaceTimeFunction<dim>> torque_law; ///< null: none
    Point<dim>                              reference_point;

    double       area = 0.;
    Point<dim>   centre;
    Tensor<2, 3> inverse_inertia;

    Tensor<1, 3>
    torque(const double time) const;
  };
} // namespace stickslip

#endif
