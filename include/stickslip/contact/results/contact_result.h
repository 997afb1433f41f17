#ifndef stickslip_contact_results_contact_result_h
#define stickslip_contact_results_contact_result_h

#include <stickslip/base/types.h>

#include <stickslip/contact/point/contact_state.h>

#include <stickslip/mesh/periodicity.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <deal.II/grid/reference_cell.h>

#include <optional>
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
    Point<dim> position;         ///< current
    Point<dim> centre_of_force;  ///< where its force acts
    double     reference_weight; ///< reference area that it stands for
    double     area_ratio;       ///< current / reference slave area
    /// Of the slave face nodes at this point; with segments, of the point's
    /// multiplier at these nodes.
    std::vector<double> shape_values;
    ContactState        state;
    Tensor<1, dim>      Lambda; ///< friction multiplier as a vector
    double              gap;    ///< >= 0 open (minus d_n); 0 if unpaired
    Tensor<1, dim>      normal; ///< outward normal of the master
    double         pressure; ///< >= 0, nominal: -(lambda_n - r d_n) if closed
    Tensor<1, dim> tangential_traction; ///< on the slave, nominal
    Tensor<1, dim> slip; ///< slip of the last step, slave minus master
    Tensor<1, dim> accumulated_slip; ///< sum of the steps' slip vectors
    /// What brings the master to the image of it that this point meets.
    std::optional<PeriodicMotion> image = {};
  };

  /// One locally owned slave face: nodal fields and its contact points.
  template <int dim>
  struct ContactFaceResult
  {
    unsigned int                pair;   ///< index of the contact pair
    unsigned int                degree; ///< nodes in the order of FaceShape
    ReferenceCell               cell = ReferenceCells::get_hypercube<dim - 1>();
    std::vector<Point<dim>>     reference_positions;
    std::vector<Tensor<1, dim>> displacements;
    std::vector<double> lambda_n; ///< nodal normal multiplier (stress, <= 0)
    std::vector<Tensor<1, dim>>
      Lambda; ///< nodal friction multiplier as a vector (unit ball)
    std::vector<ContactPointResult<dim>> points;
    /// With segments: points of its nodes that belong to a neighbour. For nodal
    /// fields only.
    std::vector<ContactPointResult<dim>> points_of_neighbours;

    std::vector<ContactPointResult<dim>>
    all_points() const
    {
      auto all = points;
      all.insert(all.end(),
                 points_of_neighbours.begin(),
                 points_of_neighbours.end());
      return all;
    }
  };
} // namespace stickslip

#endif
