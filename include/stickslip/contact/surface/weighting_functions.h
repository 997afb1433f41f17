#ifndef stickslip_contact_surface_weighting_functions_h
#define stickslip_contact_surface_weighting_functions_h

#include <stickslip/base/choice.h>
#include <stickslip/contact/surface/face_shape.h>

#include <deal.II/base/quadrature.h>
#include <deal.II/lac/full_matrix.h>

#include <vector>

namespace stickslip
{
  /// What gap and slip are averaged with, and multipliers interpolated with.
  enum class WeightingFunctions
  {
    standard, ///< the shape functions of the multipliers
    dual      ///< biorthogonal to them
  };

  const Choices<WeightingFunctions> &
  all_weighting_functions();



  /// The multiplier nodes of a face that have no multiplier.
  struct MissingNodes
  {
    std::vector<bool> is_missing; ///< per multiplier node
    /// Who takes the function of a missing node over, per multiplier node, if
    /// that one is not missing, too; invalid, or empty: the nearest others.
    std::vector<unsigned int> heir;
  };



  /**
   * The weighting functions of a face as combinations of the shape functions L
   * of the multipliers: psi_l = sum_m W[l][m] L_m.
   *
   * - Beside @p missing nodes the functions of their heirs, or of the nearest
   *   other nodes of the face, take over what is missing, so that the sum of
   *   all psi is one wherever there is a multiplier. The rows of missing nodes
   *   are zero.
   * - `dual`: int psi_l phi_k = delta_lk int phi_k over the undeformed face,
   * phi the functions so extended. Wohlmuth, SIAM J. Numer. Anal. 38, 2000.
   *
   * @p quadrature is exact for products of two L, @p areas its weights times
   * the undeformed area.
   */
  template <int dim>
  FullMatrix<double>
  weighting_functions(const WeightingFunctions   kind,
                      const FaceShape<dim>      &multiplier_shape,
                      const MissingNodes        &missing,
                      const Quadrature<dim - 1> &quadrature,
                      const std::vector<double> &areas);
} // namespace stickslip

#endif
