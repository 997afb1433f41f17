#ifndef stickslip_contact_pairing_mortar_integrals_h
#define stickslip_contact_pairing_mortar_integrals_h

#include <stickslip/contact/pairing/segment_search.h>
#include <stickslip/contact/point/mortar_node.h>

#include <vector>

namespace stickslip
{
  /// Integrals over one slave face and the master faces opposite. Where only a
  /// part of the face has a master, the weighting functions are dual on that
  /// part (Cichosz and Bischoff, Comput. Methods Appl. Mech. Engrg. 200, 2011).
  template <int dim>
  struct FaceIntegrals
  {
    FullMatrix<double>              weighting; ///< psi_l = sum_m W[l][m] L_m
    std::vector<double>             area;      ///< of psi_l
    FullMatrix<double>              D;         ///< psi_l N_k: [l][slave node]
    std::vector<FullMatrix<double>> M;         ///< [master][l][master node]
  };



  /// What the integrals of a pair are made with.
  template <int dim>
  class MortarIntegrals
  {
  public:
    MortarIntegrals(const FaceShape<dim> &displacement_shape,
                    const FaceShape<dim> &multiplier_shape);

    /// From the facets around a node.
    MortarFrame<dim>
    frame_at(const MortarNode<dim>              &node,
             const std::vector<MortarFace<dim>> &faces) const;

    FaceIntegrals<dim>
    integrate(const MortarFace<dim>   &slave,
              const FaceSegments<dim> &segments) const;

    /// From the @p integrals of all faces.
    MortarAverage<dim>
    average(const MortarNode<dim>                 &node,
            const std::vector<MortarFace<dim>>    &faces,
            const std::vector<FaceSegments<dim>>  &segments,
            const std::vector<FaceIntegrals<dim>> &integrals,
            const MasterPatch<dim>                &patch) const;

    /// Derivative of the @p average (mortar_node.h).
    void
    differentiate(const MortarNode<dim>                 &node,
                  const MortarAverage<dim>              &average,
                  const std::vector<MortarFace<dim>>    &faces,
                  const std::vector<FaceSegments<dim>>  &segments,
                  const std::vector<FaceIntegrals<dim>> &integrals,
                  const MasterPatch<dim>                &patch,
                  MortarDerivative<dim>                 &derivative) const;

  private:
    const FaceShape<dim>              displacement_shape;
    const FaceShape<dim>              multiplier_shape;
    FaceShapeValues<dim>              at_centre;
    std::vector<FaceShapeValues<dim>> at_node; ///< displacement nodes

    /// Derivative of the integrals of psi_l N(master), per master face:
    /// [master node][(slave nodes, master nodes) * dim].
    std::vector<FullMatrix<double>>
    share_derivatives(const MortarFace<dim>    &slave,
                      const unsigned int        l,
                      const FaceSegments<dim>  &segments,
                      const FullMatrix<double> &weighting,
                      const MasterPatch<dim>   &patch) const;

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

    /// Derivative of the unit outward normal of a slave face, where its shape
    /// functions are @p values, with respect to its nodes.
    std::vector<Tensor<2, dim>>
    unit_normal_derivative(const MortarFace<dim>      &slave,
                           const FaceShapeValues<dim> &values) const;
  };
} // namespace stickslip

#endif
