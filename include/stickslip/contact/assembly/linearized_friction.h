#ifndef stickslip_contact_assembly_linearized_friction_h
#define stickslip_contact_assembly_linearized_friction_h

#include <stickslip/base/types.h>

#include <stickslip/contact/point/contact_element.h>

#include <stickslip/contact/surface/multiplier_numbering.h>

#include <vector>

namespace stickslip
{
  /**
   * What the last tangent has made of the friction forces s T at multiplier
   * nodes that have one point each (segments) and a live threshold, and what
   * follows for the increment of Lambda.
   *
   * The linearized force is s0 T0 + s0 (Lambda - T0) + T0 (s - s0), that of the
   * next state s Lambda. Both s and Lambda may have changed by any factor: a
   * point that has just closed has a threshold s0 of nearly nothing, which an
   * increment of Lambda of 1e7 makes the tangential force that is needed, while
   * s becomes a thousand times as large. What the linear solve has found is the
   * force; so Lambda becomes this force over the new threshold,
   *
   *   Lambda = T0 + s0/s (Lambda_linear - T0),  s = -mu lambda_n.
   *
   * This is Newton's method in the unknowns lambda_n and the traction instead
   * of lambda_n and Lambda, with the same limit and the same order.
   */
  template <int dim>
  class LinearizedFriction
  {
  public:
    /// Forgets the last tangent. @p owned are the multipliers of this rank.
    /// Collective.
    void
    reinit(const IndexSet &owned, const MPI_Comm &communicator);

    /// Adds the only point of the multiplier node whose first unknown is
    /// @p first_dof, with its weight. Points without friction are left out.
    void
    add_point(const types::global_dof_index first_dof,
              const double                  friction_coefficient,
              const ContactPoint<dim>      &point,
              const Tensor<2, dim - 1>     &rotation,
              const ContactEvaluation<dim> &state);

    /// All points have been added. Collective.
    void
    compress();

    /// Changes the @p increment of the Lambda of @p nodes, @p multipliers being
    /// the state that it starts from. Nodes that the increment opens keep
    /// theirs. Collective.
    void
    convert_increment(const std::vector<MultiplierNode> &nodes,
                      const LA::Vector                  &multipliers,
                      LA::Vector                        &increment) const;

  private:
    LA::Vector forces; ///< in the rows of lambda_n: w s; of Lambda: w s T
    LA::Vector areas;  ///< in the rows of lambda_n: w mu
  };
} // namespace stickslip

#endif
