#ifndef stickslip_contact_pairing_possible_penetration_h
#define stickslip_contact_pairing_possible_penetration_h

#include <stickslip/contact/pairing/master_patch.h>

#include <vector>

namespace stickslip
{
  /// A point of the slave surface that looks for its partner.
  template <int dim>
  struct SearchingPoint
  {
    Tensor<1, dim> x;
    Tensor<1, dim> x_old;     ///< where it was when the step began
    Tensor<1, dim> normal;    ///< outward unit normal of the slave
    double         thickness; ///< SurfaceFace::thickness of its face
    /// Nodes of its face.
    const std::vector<Tensor<1, dim>> *face_nodes = nullptr;
  };



  /// A master point that may be its partner.
  template <int dim>
  struct PossiblePartner
  {
    unsigned int   face = 0; ///< in the patch
    Tensor<1, dim> x;
    Tensor<1, dim> x_old; ///< where this point was when the step began
    Tensor<1, dim> n;     ///< into the master
    Tensor<1, dim> n_old;
    bool           is_on_edge = false; ///< or on a corner
  };



  /// How far a slave point is behind a master point [length]; negative: in
  /// front of it, the gap is open.
  struct Depth
  {
    double now      = 0.;
    double at_start = 0.; ///< of the same two points, when the step began
  };

  template <int dim>
  Depth
  depth_of(const SearchingPoint<dim>  &point,
           const PossiblePartner<dim> &partner);

  /// Whether the gap is open or so small that its history does not matter:
  /// can_be_partners() then needs nothing of the start of the step.
  template <int dim>
  bool
  is_level(const SearchingPoint<dim>  &point,
           const PossiblePartner<dim> &partner,
           const MasterPatch<dim>     &patch);

  /**
   * Whether the two points can be partners. Open gaps can. A negative gap can
   * if it is a penetration (doc/theory.md, section 1): the way from one point
   * to the other runs inside both bodies, so that it is not longer than either
   * of them is thick, and no other face of the master offers a shorter way out.
   * A point that was in front of this partner when the step began has come in,
   * however deep it now is. Not collective.
   */
  template <int dim>
  bool
  can_be_partners(const SearchingPoint<dim>  &point,
                  const PossiblePartner<dim> &partner,
                  const MasterPatch<dim>     &patch);

  /// Whether @p behind, an open partner, lies behind the body that the point
  /// has come into at @p entered.
  template <int dim>
  bool
  hides(const SearchingPoint<dim>  &point,
        const PossiblePartner<dim> &entered,
        const PossiblePartner<dim> &behind,
        const MasterPatch<dim>     &patch);
} // namespace stickslip

#endif
