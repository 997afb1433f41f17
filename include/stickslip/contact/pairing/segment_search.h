#ifndef stickslip_contact_pairing_segment_search_h
#define stickslip_contact_pairing_segment_search_h

#include <stickslip/contact/pairing/mortar_face.h>
#include <stickslip/contact/pairing/side_choice.h>
#include <stickslip/contact/surface/mortar_segments.h>

#include <functional>
#include <vector>

namespace stickslip
{
  /// The segments of one slave face with the master faces opposite.
  template <int dim>
  struct FaceSegments
  {
    std::vector<unsigned int>      masters; ///< numbers in the patch
    std::vector<FaceId>            master_ids;
    std::vector<SegmentPoint<dim>> points; ///< `master` counts in `masters`
    std::vector<SegmentEnd<dim>>   ends;   ///< likewise
    bool is_partial = false; ///< only some points have the rigid tool opposite
  };



  /**
   * The segments of @p slave in the present configuration: with all master
   * faces that look at it and lie within the search distance along its normal;
   * of those that lie behind each other with the nearest. Of a surface that
   * meets itself only those that @p is_master says count, but the others hide
   * what is behind them, too. Not collective.
   */
  template <int dim>
  FaceSegments<dim>
  find_segments(const MortarFace<dim>                     &slave,
                const SegmentRule<dim>                    &rule,
                const MasterPatch<dim>                    &patch,
                const std::function<bool(const FaceId &)> &is_master = {});

  /// The faces of the patch that find_segments() may take, whatever they are,
  /// with their mean distances. Not collective.
  template <int dim>
  std::vector<OppositeFaces>
  find_opposite(const MortarFace<dim>  &slave,
                const SegmentRule<dim> &rule,
                const MasterPatch<dim> &patch);
} // namespace stickslip

#endif
