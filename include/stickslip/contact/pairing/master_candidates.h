#ifndef stickslip_contact_pairing_master_candidates_h
#define stickslip_contact_pairing_master_candidates_h

#include <stickslip/contact/pairing/mortar_face.h>
#include <stickslip/contact/pairing/possible_penetration.h>
#include <stickslip/contact/surface/mortar_segments.h>

#include <vector>

namespace stickslip
{
  /// A master face above or below a slave face.
  template <int dim>
  struct FaceCandidate
  {
    unsigned int                   master = 0;
    ProjectedFace<dim>             projected;
    std::vector<SegmentPoint<dim>> points;
    double                         area     = 0.; ///< undeformed
    double                         distance = 0.; ///< mean, without sign
    SearchingPoint<dim>            middle;        ///< of the segments, mean
    PossiblePartner<dim>           partner;       ///< opposite
    Tensor<1, dim> through; ///< undeformed, to the master; of one body only
  };



  /// The slave face as it is seen, and the master faces opposite.
  template <int dim>
  struct SeenFrom
  {
    ProjectionPlane<dim>            plane;
    ProjectedFace<dim>              projected;
    std::vector<FaceCandidate<dim>> candidates;
  };



  /// The undeformed area of the slave face that @p candidates lie opposite.
  template <int dim>
  double
  covered_area(const std::vector<FaceCandidate<dim>> &candidates);



  /**
   * The faces of @p patch that look at @p slave, lie within the search distance
   * along its normal and may be its partners; of those that lie behind each
   * other only the nearest. Not collective.
   */
  template <int dim>
  SeenFrom<dim>
  look_from(const MortarFace<dim>  &slave,
            const SegmentRule<dim> &rule,
            const MasterPatch<dim> &patch);
} // namespace stickslip

#endif
