#ifndef stickslip_contact_pairing_share_derivatives_h
#define stickslip_contact_pairing_share_derivatives_h

#include <stickslip/contact/pairing/mortar_integrals.h>

#include <map>
#include <vector>

namespace stickslip
{
  /**
   * How the integrals of psi_l N(master) over slave faces change when nodes
   * move and the borders of the segments stay on the slave face. The nodes
   * around a face need the same evaluations: the first one that asks makes them
   * for all, and the last one takes them away (clear() those of faces whose
   * last node does not ask). With nodes in the order of the faces few faces are
   * kept at a time.
   */
  template <int dim>
  class ShareDerivatives
  {
  public:
    /// Of one master face: [l](i, column), i a node of the master, or after
    /// these the rise of the master (facet_rise.h) in place of N; columns
    /// (slave nodes, master nodes) * dim.
    using OfMaster = std::vector<FullMatrix<double>>;

    ShareDerivatives(const FaceShape<dim> &displacement_shape,
                     const FaceShape<dim> &multiplier_shape);

    /// The @p nodes that will ask, in this order.
    void
    expect(const std::vector<MortarNode<dim>> &nodes);

    /// Something has moved, or nobody asks any more.
    void
    clear()
    {
      kept.clear();
    }

    /// Of mortar face @p f, per master face of its segments. Valid until
    /// finish_node() or clear().
    const std::vector<OfMaster> &
    of_face(const unsigned int        f,
            const MortarFace<dim>    &slave,
            const FaceSegments<dim>  &segments,
            const FullMatrix<double> &weighting,
            const MasterPatch<dim>   &patch);

    /// Node @p i does not ask any more.
    void
    finish_node(const unsigned int i);

  private:
    const FaceShape<dim>                          displacement_shape;
    const FaceShape<dim>                          multiplier_shape;
    std::vector<std::vector<unsigned int>>        last_of; ///< faces by node
    std::map<unsigned int, std::vector<OfMaster>> kept;

    std::vector<OfMaster>
    evaluate(const MortarFace<dim>    &slave,
             const FaceSegments<dim>  &segments,
             const FullMatrix<double> &weighting,
             const MasterPatch<dim>   &patch) const;
  };
} // namespace stickslip

#endif
