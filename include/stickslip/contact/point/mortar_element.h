#ifndef stickslip_contact_point_mortar_element_h
#define stickslip_contact_point_mortar_element_h

#include <stickslip/contact/point/contact_element.h>
#include <stickslip/contact/point/mortar_node.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

namespace stickslip
{
  /**
   * One mortar node with the nodes that it couples. Local unknowns are
   * [stencil nodes * dim, master nodes * dim, the node's own multipliers]; the
   * master's are missing if the node is not paired.
   */
  template <int dim>
  struct MortarElement
  {
    const ContactPoint<dim>  &point;
    const MortarNode<dim>    &node;
    const MortarAverage<dim> &average;
    const MortarFrame<dim>   &frame;
    unsigned int              own_multiplier          = 0; ///< on its face
    unsigned int              n_multiplier_components = 1;

    unsigned int
    n_displacements() const;

    unsigned int
    n_dofs() const;

    /// The area that the law is multiplied with [length^(dim-1)].
    double
    weight() const
    {
      return average.paired ? average.area : node.area;
    }

    /// Of Lambda at the node.
    const Tensor<2, dim - 1> &
    rotation() const
    {
      return point.nodal_rotations[own_multiplier];
    }
  };



  /**
   * The kinematics of a mortar node, with derivatives with respect to the
   * generalized coordinates: W is the averaged x_s - x_m with all that moves
   * it, C_1 (!) the averaged motion of the step, M the sum of normals, E as
   * ever. @p slave_direction is E. The derivatives as in
   * evaluate_contact_kinematics().
   */
  template <int dim>
  void
  evaluate_mortar_kinematics(const MortarElement<dim> &element,
                             const Tensor<1, dim>     &slave_direction,
                             const bool                geometry_is_live,
                             const bool                differentiate,
                             ContactKinematics<dim>   &kinematics);

  /// As for a ContactElement. Overwrites @p local, of size n_dofs().
  template <int dim>
  void
  local_residual(const MortarElement<dim>     &element,
                 const ContactEvaluation<dim> &state,
                 Vector<double>               &local);

  /**
   * Whether the derivative of the averages enters local_tangent(): at an open
   * node, which has no traction, only while its multipliers still have to
   * vanish by more than 1e-8 of what the law counts in (@p diameter of the
   * slave face for lambda_n / r_n, 1 for Lambda).
   */
  template <int dim>
  bool
  needs_mortar_derivative(const ContactPoint<dim>    &point,
                          const ContactResponse<dim> &response,
                          const double                diameter);

  /// Derivative of local_residual(). @p derivative is nullptr where the
  /// geometry is not linearized. @p local must be zero and of size n_dofs().
  template <int dim>
  void
  local_tangent(const MortarElement<dim>     &element,
                const ContactEvaluation<dim> &state,
                const MortarDerivative<dim>  *derivative,
                FullMatrix<double>           &local);
} // namespace stickslip

#endif
