#ifndef stickslip_contact_pairing_surface_sides_h
#define stickslip_contact_pairing_surface_sides_h

#include <stickslip/contact/pairing/side_choice.h>

#include <map>
#include <set>
#include <vector>

namespace stickslip
{
  /**
   * Which faces of a surface that meets itself are slave and which master, the
   * same on all ranks: of all faces that are near others, and their neighbours.
   */
  class SurfaceSides
  {
  public:
    Side
    side_of(const FaceId &face) const
    {
      const auto found = sides.find(face.original());
      return found == sides.end() ? Side::neither : found->second;
    }

    /// True for nodes (first dofs) of slave and master faces at once: a gap
    /// between a node and itself says nothing.
    bool
    is_on_border(const types::global_dof_index node) const
    {
      return border.count(node) > 0;
    }

    /**
     * Chooses the sides anew (choose_sides()) from the @p faces that this rank
     * knows (the same face may come from several) and those that it has seen
     * @p opposite each other. One rank chooses; it holds the whole surface
     * meanwhile, if anything is opposite at all. True if something has
     * changed. Collective.
     */
    bool
    choose(const std::vector<SidedFace>     &faces,
           const std::vector<OppositeFaces> &opposite,
           const MPI_Comm                   &communicator);

    /// Takes the sides that the @p owned faces have. Collective.
    void
    resume(const std::vector<SidedFace> &owned, const MPI_Comm &communicator);

  private:
    std::map<FaceId, Side>            sides;
    std::set<types::global_dof_index> border;

    /// True if something has changed.
    bool
    set(const std::vector<SidedFace> &faces);
  };
} // namespace stickslip

#endif
