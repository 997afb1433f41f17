#ifndef stickslip_contact_point_contact_element_h
#define stickslip_contact_point_contact_element_h

#include <stickslip/contact/point/contact_point.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <vector>

namespace stickslip
{
  /**
   * One contact point with the nodes that it couples: what is needed to turn
   * the law's response into a local vector and matrix, without any knowledge of
   * global numbers or ranks. Local unknowns are
   * [slave nodes * dim, master stencil nodes * dim, multiplier nodes * n_comp];
   * the master's are missing if the point is not paired.
   */
  template <int dim>
  struct ContactElement
  {
    const ContactPoint<dim>   &point;
    const std::vector<double> &slave_shape;      ///< values at the point
    const std::vector<double> &multiplier_shape; ///< values at the point
    unsigned int               n_multiplier_components = 1;

    const SurfaceFace<dim>         *master = nullptr; ///< nullptr: unpaired
    const MasterConfiguration<dim> *master_configuration = nullptr;

    unsigned int
    n_dofs() const;
  };

  /// All that is known of one contact point in the present configuration.
  template <int dim>
  struct ContactEvaluation
  {
    Multipliers<dim>       multipliers;
    ContactKinematics<dim> kinematics;
    MasterPoint<dim>       master;
    ContactStatus          status;
    ContactResponse<dim>   response;
  };

  /// The unknowns at the point from @p nodal_values [node * n_comp + c]. The
  /// nodal Lambda are turned into the frame of the point.
  template <int dim>
  Multipliers<dim>
  interpolate_multipliers(const ContactElement<dim> &element,
                          const std::vector<double> &nodal_values);

  /// Weak form of the point times its weight (doc/theory.md, section 5).
  /// Overwrites @p local, of size n_dofs().
  template <int dim>
  void
  local_residual(const ContactElement<dim>    &element,
                 const ContactEvaluation<dim> &state,
                 Vector<double>               &local);

  /**
   * Derivative of local_residual(), from the derivatives in @p state, which
   * must have been evaluated with `differentiate`. @p with_nodal_normals adds
   * the variation of smoothed master normals with the master nodes. @p local
   * must be zero and of size n_dofs().
   */
  template <int dim>
  void
  local_tangent(const ContactElement<dim>    &element,
                const ContactEvaluation<dim> &state,
                const bool                    with_nodal_normals,
                FullMatrix<double>           &local);
} // namespace stickslip

#endif
