#ifndef stickslip_contact_pairing_far_surfaces_h
#define stickslip_contact_pairing_far_surfaces_h

#include <stickslip/contact/pairing/mortar_integrals.h>

#include <vector>

namespace stickslip
{
  /// What the average of a node says about its gap, and what the surfaces do.
  enum class NodeGap
  {
    open, ///< clearly open, or without any master
    near, ///< closed, or hardly open
    far   ///< the same, but nothing touches
  };



  /**
   * The nodes that have no partner because they are far: an average may say
   * closed while the surfaces are far apart wherever they are opposite. Dual
   * functions change sign, and a gap that rises steeply, as beside a round
   * master, is no polynomial.
   *
   * Far is more than half of the shortest distance between the nodes of a face
   * (undeformed) at all integration points on it, and at the node itself where
   * one of these is close to it. They may be less: where a round surface
   * touches, and where the end of a master does between two nodes. Hardly open
   * is a quarter of that distance.
   *
   * Who has touched in a step keeps its partner until its average opens: it
   * would press the surfaces apart, lose it, and spring back. Between steps
   * that is forgotten, so that a run that is continued decides in the same way.
   */
  template <int dim>
  class FarNodes
  {
  public:
    /// Of all @p nodes in the present configuration.
    void
    find(const FaceShape<dim>                  &shape,
         const std::vector<MortarNode<dim>>    &nodes,
         const std::vector<MortarFace<dim>>    &faces,
         const std::vector<FaceSegments<dim>>  &segments,
         const std::vector<FaceIntegrals<dim>> &integrals,
         const MasterPatch<dim>                &patch);

    /// No node is before find().
    bool
    contain(const unsigned int i) const
    {
      return i < gaps.size() && gaps[i] == NodeGap::far && !has_touched[i];
    }

    void
    accept_iterate();

    /// A step is accepted, or begins again.
    void
    forget_touches();

  private:
    std::vector<NodeGap> gaps;
    std::vector<bool>    has_touched;
  };
} // namespace stickslip

#endif
