#ifndef stickslip_contact_contact_point_h
#define stickslip_contact_contact_point_h

#include <stickslip/contact/contact_law.h>

#include <vector>

namespace stickslip
{
  /// A slave face: its displacements and its multipliers.
  template <int dim>
  struct SlaveFace
  {
    SurfaceFace<dim> face;
    std::vector<types::global_dof_index>
      multiplier_dofs; ///< [node * n_comp + c]
  };

  /**
   * One contact (quadrature) point: what never changes, what the outer loops
   * freeze, and what the step has accumulated.
   */
  template <int dim>
  struct ContactPoint
  {
    // in the reference configuration
    unsigned int   slave_face       = 0;
    unsigned int   quadrature_index = 0;
    double         weight = 0.; ///< quadrature weight x reference area
    Tensor<1, dim> reference_position;
    double         gap_offset = 0.;
    /// Derivative of the slave shape functions along the first reference
    /// tangent: carries the tangent basis (3D).
    std::vector<double> direction_gradients;
    /// Turns nodal Lambda components into those at this point, per multiplier
    /// node.
    std::vector<Tensor<2, dim - 1>> nodal_rotations;

    // quantities that outer loops may freeze
    ContactFrame<dim> frame;
    bool              closed    = false; ///< frozen S_c
    double            threshold = 0.;    ///< frozen s

    // scales, kept during a Newton iteration
    Regularization regularization;

    // what constraints hold, kept during a Newton iteration
    /// Orthonormal tangential directions without slip (held_directions.h).
    std::vector<Tensor<1, dim>> held_directions;
    Tensor<1, dim - 1>          kept_Lambda; ///< Lambda along these

    // history
    ContactFrame<dim> accepted_frame; ///< of the last accepted step
    Tensor<1, dim>    accumulated_slip;
  };
} // namespace stickslip

#endif
