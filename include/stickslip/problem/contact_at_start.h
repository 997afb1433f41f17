#ifndef stickslip_problem_contact_at_start_h
#define stickslip_problem_contact_at_start_h

#include <stickslip/contact/assembly/contact_assembler.h>

#include <stickslip/problem/dof_layout.h>

#include <deal.II/base/bounding_box.h>

#include <string>
#include <vector>

namespace stickslip
{
  /// What is between the surfaces of a pair where nothing is deformed: the same
  /// on all ranks.
  template <int dim>
  struct ContactAtStart
  {
    std::string  pair, slave_body, master_body;
    unsigned int n_points        = 0;
    unsigned int n_paired        = 0;
    double       smallest_gap    = 0.; ///< of an open point [length]
    double       largest_overlap = 0.; ///< [length]; 0: none
    Point<dim>   gap_at;               ///< slave point; if any point is open
    Point<dim>   overlap_at;           ///< likewise, if any overlaps
    unsigned int n_open = 0;

    /// Of segments between round surfaces that conform: how the facets of the
    /// meshes change their overlap within a face (root mean square), its mean
    /// (negative: a gap), and the size of a face [length]. Else zero.
    double           facet_ripple = 0., mean_overlap = 0., face_size = 0.;
    BoundingBox<dim> slave, master; ///< of the surfaces
    BoundingBox<dim> unpaired;      ///< around the points without a partner
  };

  /**
   * Pairs the points of all pairs of @p contact without displacements, tells
   * the pairs how far they are from their partners (GapOffsets), and returns
   * what it has seen. Throws UserError (same on all ranks) for an overlap above
   * `Largest initial overlap` and for a pair that cannot part and has no
   * partner. Collective.
   */
  template <int dim>
  std::vector<ContactAtStart<dim>>
  look_at_contact(ContactAssembler<dim> &contact, const DofLayout<dim> &dofs);
} // namespace stickslip

#endif
