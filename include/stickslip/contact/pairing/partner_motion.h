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
    PartnerMotion(const FaceShape<dim> &shape, const MortarFace<dim> &slave);

    /// The partner of a point that stays where it is on the slave face.
    struct Partner
    {
      std::vector<double>                      N;      ///< slave's, at xi
      FaceShapeValues<dim>                     master; ///< at eta
      std::array<Tensor<1, dim>, dim - 1>      a; ///< tangents of the master
      std::array<std::vector<double>, dim - 1> D_eta; ///< [d][column]
    };

    /// @p master are the positions of the nodes of the master face. Keeps the
    /// memory of @p partner.
    void
    evaluate(const SegmentPoint<dim>           &point,
             const std::vector<Tensor<1, dim>> &master,
             Partner                           &partner) const;

    /// Undeformed area that a segment gains at its border: derivative per
    /// column.
    std::vector<double>
    border_motion(const SegmentEnd<dim>             &end,
                  const std::vector<Tensor<1, dim>> &master) const;

  private:
    const FaceShape<dim>       &shape;
    const MortarFace<dim>      &slave;
    Tensor<1, dim>              n_0;
    std::vector<Tensor<2, dim>> D_n_0; ///< per slave node
  };
} // namespace stickslip

#endif
