#ifndef stickslip_contact_pairing_mortar_pairing_h
#define stickslip_contact_pairing_mortar_pairing_h

#include <stickslip/contact/pairing/segment_search.h>
#include <stickslip/contact/point/mortar_node.h>

#include <memory>
#include <vector>

namespace stickslip
{
  /// What a frozen geometry keeps of a mortar surface.
  template <int dim>
  struct MortarPairing
  {
    using Segments = std::vector<FaceSegments<dim>>; ///< per mortar face

    std::shared_ptr<const Segments> segments;
    std::vector<MortarFrame<dim>>   frames; ///< per mortar node
  };



  /// @p pairing with the present numbers of the master faces, without the
  /// segments whose master is out of reach.
  template <int dim>
  std::shared_ptr<const MortarPairing<dim>>
  relocated(const MortarPairing<dim> &pairing, const MasterPatch<dim> &patch);
} // namespace stickslip

#endif
