#ifndef stickslip_contact_pairing_partner_motion_h
#define stickslip_contact_pairing_partner_motion_h

#include <stickslip/contact/pairing/segment_search.h>

#include <array>
#include <vector>

namespace stickslip
{
  /**
   * How the places opposite a slave face move over the master when the nodes
   * of both faces do: x_m(eta) + g n_0 = x_s(xi), with n_0 normal to the plane
   * of projection. Derivatives are along the columns [slave nodes * dim, master
   * nodes * dim].
   */
  template <int dim>
  class PartnerMotion
  {
  public:
    PartnerMotion(const FaceShape<dim>  &slave_shape,
                  const FaceShape<dim>  &master_shape,
                  const MortarFace<dim> &slave);

    /**
     * The partner of a point that stays where it is on the slave face. With
     * the dual basis a^d of the tangents and n_0, the nodes change eta by
     * D eta_d = a^d . (N_k - distance D_n_0[k]) at slave node k, and by
     * -a^d N_k at master node k.
     */
    struct Partner
    {
      std::vector<double>                 N;      ///< slave's, at xi
      FaceShapeValues<dim>                master; ///< at eta
      std::array<Tensor<1, dim>, dim - 1> a;      ///< tangents of the master
      std::array<Tensor<1, dim>, dim - 1> dual;   ///< a^d
      double                              distance = 0.; ///< along n_0
    };

    /// @p master are the positions of the nodes of the master face. Keeps the
    /// memory of @p partner.
    void
    evaluate(const SegmentPoint<dim>           &point,
             const std::vector<Tensor<1, dim>> &master,
             Partner                           &partner) const;

    /// Derivative of the normal of the plane per slave node.
    const std::vector<Tensor<2, dim>> &
    plane_normal_derivative() const
    {
      return D_n_0;
    }

    /// Derivative of eta_d per column; keeps the memory of @p D_eta.
    void
    partner_derivative(const Partner       &partner,
                       const unsigned int   d,
                       std::vector<double> &D_eta) const;

    /// Undeformed area that a segment gains at its border: derivative per
    /// column. Keeps the memory of @p motion.
    void
    border_motion(const SegmentEnd<dim>             &end,
                  const std::vector<Tensor<1, dim>> &master,
                  std::vector<double>               &motion) const;

  private:
    const FaceShape<dim>       &slave_shape;
    const FaceShape<dim>       &master_shape;
    const MortarFace<dim>      &slave;
    Tensor<1, dim>              n_0;
    std::vector<Tensor<2, dim>> D_n_0; ///< per slave node
    mutable std::vector<double> N, N_border;
  };
} // namespace stickslip

#endif
