#ifndef stickslip_contact_pairing_tool_pairing_h
#define stickslip_contact_pairing_tool_pairing_h

#include <stickslip/contact/pairing/segment_search.h>

#include <deal.II/base/quadrature.h>

#include <vector>

namespace stickslip
{
  /**
   * The closest point of the rigid tool of @p patch to @p x_s, a point of a
   * slave surface with the outward normal @p normal. It has none beyond an end
   * of the tool, beyond the search distance, and where the two surfaces do not
   * look at each other. Whether a point is in the tool needs no more than the
   * sign of the gap. Not collective.
   */
  template <int dim>
  Pairing<dim>
  find_tool_partner(const MasterPatch<dim> &patch,
                    const Tensor<1, dim>   &x_s,
                    const Tensor<1, dim>   &normal);



  /// Integration over slave faces opposite a rigid tool: there are no facets to
  /// divide them by, so points are at fixed places of a slave face.
  template <int dim>
  class ToolRule
  {
  public:
    /// At least @p order points per direction.
    ToolRule(const FaceShape<dim> &displacement_shape,
             const FaceShape<dim> &multiplier_shape,
             const unsigned int    order,
             const CrossSection   &cross_section);

    /// Points of the face with a partner on the tool of @p patch.
    FaceSegments<dim>
    find_segments(const MortarFace<dim>  &slave,
                  const MasterPatch<dim> &patch) const;

  private:
    const CrossSection                cross_section;
    const Quadrature<dim - 1>         quadrature;
    std::vector<FaceShapeValues<dim>> shapes; ///< at its points
  };
} // namespace stickslip

#endif
