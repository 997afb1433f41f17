#ifndef stickslip_contact_pairing_tool_motion_h
#define stickslip_contact_pairing_tool_motion_h

#include <stickslip/contact/pairing/segment_search.h>

#include <array>
#include <vector>

namespace stickslip
{
  /**
   * The partner on a rigid tool of a point that stays where it is on a slave
   * face, and how it moves over the tool when the nodes of both do: from
   * (x_s - x_m) . a = 0, as the closest point. Derivatives are along the
   * columns [slave nodes * dim, nodes of the frame * dim].
   */
  template <int dim>
  struct ToolMotion
  {
    MasterPoint<dim>                         master;
    std::array<std::vector<double>, dim - 1> D_xi; ///< [d][column]
    std::vector<Tensor<1, dim>>              D_n;  ///< of the normal [column]

    /// Where the partner stays on the tool (@p moves is false) D_xi is zero.
    /// Keeps the memory.
    void
    evaluate(const FaceShape<dim>    &slave_shape,
             const MortarFace<dim>   &slave,
             const SegmentPoint<dim> &point,
             const MasterPatch<dim>  &patch,
             const bool               moves);

  private:
    std::vector<double> N; ///< slave's
  };
} // namespace stickslip

#endif
