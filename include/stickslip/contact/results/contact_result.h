#ifndef stickslip_contact_results_contact_result_h
#define stickslip_contact_results_contact_result_h

#include <stickslip/base/types.h>

#include <stickslip/contact/point/contact_state.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <vector>

namespace stickslip
{
  /**
   * Converged state of one contact (quadrature) point, for output. Tractions
   * act on the slave and are per *reference* slave area, as lambda_n is.
   */
  template <int dim>
  struct ContactPointResult
  {
    Point<dim> reference_position;
    Point<dim> position;              ///< current
    double     reference_weight;      ///< quadrature weight x reference area
    double     area_ratio;            ///< current / reference slave area
    std::vector<double> shape_values; ///< of the slave face nodes at this point
    ContactState        state;
    double              gap;    ///< >= 0 open (minus d_n); 0 if unpaired
    Tensor<1, dim>      normal; ///< outward normal of the master
    double         pressure; ///< >= 0, nominal: -(lambda_n - r d_n) if closed
    Tensor<1, dim> tangential_traction; ///< on the slave, nominal
    Tensor<1, dim> slip; ///< slip of the last step, slave minus master
    Tensor<1, dim> accumulated_slip; ///< sum of the steps' slip vectors
  };

  /// One locally owned slave face: nodal fields and its contact points.
  template <int dim>
  struct ContactFaceResult
  {
    unsigned int pair;                ///< index of the contact pair
    unsigned int nodes_per_direction; ///< degree + 1; nodes are lexicographic
    std::vector<Point<dim>>     reference_positions;
    std::vector<Tensor<1, dim>> displacements;
    std::vector<double> lambda_n; ///< nodal normal multiplier (stress, <= 0)
    std::vector<Tensor<1, dim>>
      Lambda; ///< nodal friction multiplier as a vector (unit ball)
    std::vector<ContactPointResult<dim>> points;
  };
} // namespace stickslip

#endif
