#ifndef stickslip_solid_force_distribution_h
#define stickslip_solid_force_distribution_h

#include <stickslip/base/amplitude.h>
#include <stickslip/base/space_time_function.h>
#include <stickslip/base/types.h>

#include <stickslip/mesh/cross_section.h>

#include <stickslip/solid/boundary_condition_parameters.h>
#include <stickslip/solid/prescribed_displacement.h>
#include <stickslip/solid/rigid_state.h>

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/hp/mapping_collection.h>

#include <memory>
#include <set>
#include <string>
#include <vector>

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
   *
   * Where planes of symmetry cut the boundary it is a part of a surface, and F
   * and M are this part's share of its load. The mirror images leave no arm
   * normal to a plane, and no turning about axes in it by a torque about its
   * normal n: X_R - X_c loses its components along the normals, and, with one
   * plane, J^{-1} becomes C = n n^T / (n.J n) + J^{-1} (I - n n^T) (its
   * transpose in theta).
   */
  template <int dim>
  class ForceDistribution
  {
  public:
    /// Throws UserError for wrong expressions.
    ForceDistribution(const BoundaryConditionParameters      &parameters,
                      const std::shared_ptr<const Amplitude> &amplitude,
                      const std::string                      &path);

    /// Finds area, centre and inertia, and which of the @p conditions are
    /// planes of symmetry that cut the boundary. Before traction() and
    /// mean_motion(). Collective.
    void
    measure(const hp::MappingCollection<dim>               &mapping,
            const DoFHandler<dim>                          &dof_handler,
            const std::set<types::boundary_id>             &boundary,
            const CrossSection                             &section,
            const std::vector<PrescribedDisplacement<dim>> &conditions);

    /// Per reference area at a reference position.
    Tensor<1, dim>
    traction(const Point<dim> &X, const double time) const;

    /// Torque, displacement and rotation (small, in degrees) of the reference
    /// point for the displacements @p u (ghosted). Collective.
    RigidReaction<dim>
    mean_motion(const hp::MappingCollection<dim>   &mapping,
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
    Tensor<1, 3> arm;     ///< from the centre to the reference point
    Tensor<2, 3> turning; ///< C: of torques, to the rotation of the tractions

    Tensor<1, 3>
    torque(const double time) const;
  };
} // namespace stickslip

#endif
