#ifndef stickslip_contact_contact_point_h
#define stickslip_contact_contact_point_h

#include <stickslip/contact/contact_law.h>
#include <stickslip/contact/contact_state.h>

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
    /// node, where nothing is deformed.
    std::vector<Tensor<2, dim - 1>> reference_rotations;

    // quantities that outer loops may freeze
    ContactFrame<dim> frame;
    unsigned int      facet_changes = 0;     ///< of the frame during this step
    bool              closed        = false; ///< frozen S_c
    double            threshold     = 0.;    ///< frozen s

    // scales, kept during a Newton iteration
    Regularization regularization;

    /// The same for the present deformation (nodal_frames.h), kept as well.
    std::vector<Tensor<2, dim - 1>> nodal_rotations;

    // what constraints hold, kept during a Newton iteration
    /// Orthonormal tangential directions without slip (held_directions.h).
    std::vector<Tensor<1, dim>> held_directions;
    Tensor<1, dim - 1>          kept_Lambda; ///< Lambda along these

    // what the last residual or tangent saw
    ObservedState<dim> observed;

    // history
    ContactFrame<dim> accepted_frame; ///< of the last accepted step
    Tensor<1, dim>    accumulated_slip;

    void
    set_frame(const ContactFrame<dim> &found)
    {
      if (frame.paired && found.paired && !(frame.face_id == found.face_id))
        ++facet_changes;
      frame = found;
    }

    void
    accept_frame()
    {
      accepted_frame = frame;
      facet_changes  = 0;
    }

    void
    restore_frame()
    {
      frame         = accepted_frame;
      facet_changes = 0;
    }

    /// True if the point has changed its facet oftener during this step than
    /// Newton's first iterations explain, as at a kink. Other points are paired
    /// without regard to their past: which of two facets a point saw first
    /// would else decide its normal.
    bool
    has_hopped() const
    {
      return facet_changes >= 6;
    }
  };
} // namespace stickslip

#endif
