#ifndef stickslip_problem_contact_couplings_h
#define stickslip_problem_contact_couplings_h

#include <stickslip/contact/assembly/contact_assembler.h>

#include <map>
#include <tuple>
#include <vector>

namespace stickslip
{
  /**
   * Which master faces the slave faces and mortar nodes of this rank are
   * coupled with in a sparsity pattern: those that their points meet, and have
   * met since the pattern before, so that a point that hops between faces costs
   * one pattern, not one per hop. Where points of a pair do hop, more of them
   * will: its patterns have room for the faces around, too.
   */
  template <int dim>
  class ContactCouplings
  {
  public:
    /// @p contact must outlive this object.
    explicit ContactCouplings(const ContactAssembler<dim> &contact);

    /// Adds those of the present pairings. True if this rank had them all.
    bool
    add_present();

    /// Before a pattern is made: removes what points have not met since the
    /// last one, and makes room.
    void
    begin_pattern();

    /// Displacements and multipliers that are coupled with each other: once for
    /// each slave face and master face, or each mortar node and all that it
    /// meets.
    std::vector<std::vector<types::global_dof_index>>
    coupled_dofs(const types::global_dof_index n_displacements) const;

  private:
    /// Pair, mortar node or slave face, master face.
    using Coupling = std::tuple<unsigned int, unsigned int, FaceId>;

    const ContactAssembler<dim> &contact;
    /// With the last pattern during which they were met.
    std::map<Coupling, unsigned int> last_met;
    unsigned int                     n_patterns = 0;
    std::vector<bool>                has_hopped; ///< by pair

    bool
    is_coupled(const unsigned int pair, const unsigned int place) const;

    /// Calls @p visit with a mortar node or slave face and the number in the
    /// patch of a master face that it meets, some more than once.
    template <typename Visitor>
    void
    visit_present(const unsigned int pair, const Visitor &visit) const;

    void
    drop_old();

    /// For the neighbours of what is met, until the next pattern.
    void
    make_room();
  };



  /// Displacements and multipliers of a mortar node (point i is node i) or a
  /// slave face.
  template <int dim>
  std::vector<types::global_dof_index>
  dofs_at(const ContactPair<dim>       &pair,
          const unsigned int            place,
          const types::global_dof_index n_displacements);
} // namespace stickslip

#endif
