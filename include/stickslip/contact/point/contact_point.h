#ifndef stickslip_contact_point_contact_point_h
#define stickslip_contact_point_contact_point_h

#include <stickslip/contact/point/contact_law.h>
#include <stickslip/contact/point/contact_state.h>

#include <stickslip/contact/surface/surface_face.h>

#include <optional>
#include <vector>

namespace stickslip
{
  /// What the treatment of cycles has changed at a point
  /// (status_cycle_treatment.h).
  struct PointCure
  {
    double              r_n_factor = 1.;
    double              r_t_factor = 1.;
    std::optional<bool> held_closed; ///< S_c until the residual has converged
    std::optional<bool> held_stick;  ///< S_f
    unsigned int        n_treatments = 0; ///< in the present solve
    unsigned int        n_holds      = 0; ///< likewise

    /// Frees the statuses. True if one was held.
    bool
    release()
    {
      const bool held = held_closed || held_stick;
      held_closed.reset();
      held_stick.reset();
      return held;
    }
  };

  /// Where a point met its partner when the step began.
  template <int dim>
  struct Meeting
  {
    bool           paired = false;
    Tensor<1, dim> master_position;
    Tensor<1, dim> n; ///< into the master
  };

  /**
   * One contact (quadrature) point: what never changes, what the outer loops
   * freeze, and what the step has accumulated.
   */
  template <int dim>
  struct ContactPoint
  {
    /// Changes in a step from which on a point hops: Newton's first iterations
    /// explain fewer of them.
    static constexpr unsigned int many_facet_changes   = 6;
    static constexpr unsigned int many_pairing_changes = 4;

    // in the reference configuration
    unsigned int   slave_face       = 0;
    unsigned int   quadrature_index = 0;
    double         weight = 0.; ///< quadrature weight x reference area
    Tensor<1, dim> reference_position;
    double         gap_offset = 0.; ///< of this step
    /// Derivative of the slave shape functions along the first reference
    /// tangent: carries the tangent basis (3D).
    std::vector<double> direction_gradients;
    /// Turns nodal Lambda components into those at this point, per multiplier
    /// node, where nothing is deformed.
    std::vector<Tensor<2, dim - 1>> reference_rotations;

    // quantities that outer loops may freeze
    ContactFrame<dim> frame;
    unsigned int      facet_changes = 0; ///< of the frame during this step
    unsigned int      accepted_facet_changes = 0; ///< when it began
    unsigned int      pairing_changes = 0; ///< partner lost or found, likewise
    bool              was_clinging    = false; ///< to the end of the master
    bool              learns    = false; ///< from its changes in this step
    bool              closed    = false; ///< frozen S_c
    double            threshold = 0.;    ///< frozen s

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

    PointCure    cure;
    Meeting<dim> start;

    // history
    ContactFrame<dim> accepted_frame; ///< of the last accepted step
    Tensor<1, dim>    accumulated_slip;

    void
    set_frame(const ContactFrame<dim> &found)
    {
      if (frame.paired && found.paired &&
          !(frame.face_id == found.face_id && frame.free == found.free))
        ++facet_changes;
      if (frame.paired != found.paired)
        ++pairing_changes;
      frame = found;
    }

    void
    accept_frame()
    {
      accepted_frame  = frame;
      was_clinging    = clings() && frame.paired && !frame.is_interior();
      pairing_changes = 0;
      // beyond its facet the point still needs what it has learnt
      accepted_facet_changes = is_beyond_its_facet() ? learnt_changes() : 0;
      facet_changes          = accepted_facet_changes;
    }

    void
    restore_frame()
    {
      frame           = accepted_frame;
      facet_changes   = accepted_facet_changes;
      pairing_changes = 0;
    }

    /// From facet to facet in this step, so often that it would learn from it.
    bool
    hops_between_facets() const
    {
      return facet_changes / many_facet_changes >
             accepted_facet_changes / many_facet_changes;
    }

    /// Likewise, to and fro over the end of the master surface.
    bool
    hops_over_the_end() const
    {
      return pairing_changes >= many_pairing_changes;
    }

    /**
     * How far the point's past decides about its partner. A point that hops
     * from facet to facet, as at a kink, keeps its facet beyond the edge, the
     * farther the longer this goes on; one that has lost and found its partner
     * as often, at the end of the master surface, clings to the end until it is
     * well beyond. Only in steps that fail without that (`learns`), and in
     * later ones while it lasts: which of two facets a point saw first would
     * else decide its normal.
     */
    PairingMemory
    pairing_memory() const
    {
      const unsigned int n = learnt_changes() / many_facet_changes;
      return {n == 0 ? 0. : n == 1 ? 1. : n == 2 ? 10. : 50., clings()};
    }

  private:
    /// Changes of facet that the point takes notice of.
    unsigned int
    learnt_changes() const
    {
      return learns ? facet_changes : accepted_facet_changes;
    }

    bool
    is_beyond_its_facet() const
    {
      for (unsigned int d = 0; d < dim - 1; ++d)
        if (frame.paired && (frame.xi[d] < -1e-10 || frame.xi[d] > 1. + 1e-10))
          return true;
      return false;
    }

    bool
    clings() const
    {
      return was_clinging || (learns && hops_over_the_end());
    }
  };
} // namespace stickslip

#endif
