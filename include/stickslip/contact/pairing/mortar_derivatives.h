#ifndef stickslip_contact_pairing_mortar_derivatives_h
#define stickslip_contact_pairing_mortar_derivatives_h

#include <stickslip/contact/pairing/mortar_integrals.h>
#include <stickslip/contact/pairing/share_derivatives.h>

#include <vector>

namespace stickslip
{
  /// Derivatives of the averages of mortar nodes (MortarDerivative).
  template <int dim>
  class MortarDerivatives
  {
  public:
    MortarDerivatives(const FaceShape<dim> &displacement_shape,
                      const FaceShape<dim> &multiplier_shape);

    /// Derivative of the @p average and of the sum of normals of @p frame
    /// (mortar_node.h). Segments that do not move (@p partners_move is false)
    /// leave that of the normal.
    void
    differentiate(const MortarNode<dim>                 &node,
                  const MortarAverage<dim>              &average,
                  const MortarFrame<dim>                &frame,
                  const std::vector<MortarFace<dim>>    &faces,
                  const std::vector<FaceSegments<dim>>  &segments,
                  const std::vector<FaceIntegrals<dim>> &integrals,
                  const MasterPatch<dim>                &patch,
                  const bool                             partners_move,
                  ShareDerivatives<dim>                 &shares,
                  MortarDerivative<dim>                 &derivative) const;

  private:
    const FaceShape<dim> displacement_shape;
    const FaceShape<dim> multiplier_shape;

    /// Adds what a rigid tool and a face around the node change: the shares
    /// and, if @p has_normal_of_tool, the normal.
    void
    add_tool_motion(const MortarNode<dim>                  &node,
                    const typename MortarNode<dim>::Around &around,
                    const MortarAverage<dim>               &average,
                    const MortarFace<dim>                  &slave,
                    const FaceSegments<dim>                &segments,
                    const FaceIntegrals<dim>               &integrals,
                    const MasterPatch<dim>                 &patch,
                    const bool                              has_normal_of_tool,
                    const bool                              partners_move,
                    MortarDerivative<dim>                  &derivative) const;

    /// Adds what the motion of the borders changes where the master surface
    /// ends. @p rows: numbers of the nodes of each master face.
    void
    add_ends(const MortarFace<dim>                        &slave,
             const typename MortarNode<dim>::Around       &around,
             const FaceSegments<dim>                      &segments,
             const FaceIntegrals<dim>                     &integrals,
             const MasterPatch<dim>                       &patch,
             const std::vector<std::vector<unsigned int>> &rows,
             MortarDerivative<dim>                        &derivative) const;
  };
} // namespace stickslip

#endif
