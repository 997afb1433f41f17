#ifndef stickslip_contact_pairing_mortar_face_h
#define stickslip_contact_pairing_mortar_face_h

#include <stickslip/contact/pairing/master_patch.h>
#include <stickslip/contact/surface/weighting_functions.h>

#include <stickslip/mesh/cross_section.h>

#include <deal.II/base/quadrature.h>

#include <deal.II/lac/full_matrix.h>

#include <vector>

namespace stickslip
{
  /// A slave face that takes part in mortar integrals of this rank.
  template <int dim>
  struct MortarFace
  {
    SurfaceFace<dim> face;
    double           area = 0.; ///< undeformed
    double node_distance  = 0.; ///< the shortest between neighbours, undeformed
    /// weighting_functions() of the whole face, standard ones and those in use
    FullMatrix<double> extended;
    FullMatrix<double> weighting;
    WeightingFunctions weighting_kind = WeightingFunctions::standard;
    MissingNodes       missing;
    /// Without contact whatever the face is: those of a surface that meets
    /// itself miss more where its slave and master sides meet.
    MissingNodes        always_missing;
    Side                side = Side::slave;
    std::vector<double> gap_offsets; ///< per node; empty: none

    std::vector<Tensor<1, dim>> positions;     ///< now
    std::vector<Tensor<1, dim>> old_positions; ///< at the start of the step

    /// The other side of a fold does not turn the normals of this one.
    bool
    counts_for_normals() const
    {
      return side != Side::master;
    }
  };



  /**
   * Sets the undeformed sizes of @p slave and its weighting functions, of the
   * kind and without the nodes that it says. Returns their integrals over the
   * face, by multiplier.
   */
  template <int dim>
  std::vector<double>
  set_weightings(const FaceShape<dim>      &displacement_shape,
                 const FaceShape<dim>      &multiplier_shape,
                 const Quadrature<dim - 1> &quadrature,
                 const CrossSection        &cross_section,
                 MortarFace<dim>           &slave);
} // namespace stickslip

#endif
