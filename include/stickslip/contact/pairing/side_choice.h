#ifndef stickslip_contact_pairing_side_choice_h
#define stickslip_contact_pairing_side_choice_h

#include <stickslip/contact/surface/surface_face.h>

#include <vector>

namespace stickslip
{
  /// A face of a surface that meets itself, as choose_sides() knows it.
  struct SidedFace
  {
    FaceId                               id;
    std::vector<types::global_dof_index> nodes; ///< their first dofs
    double                               diameter      = 0.; ///< [length]
    bool                                 may_be_slave  = false;
    bool                                 may_be_master = false;
    Side                                 side = Side::neither; ///< so far

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &id &nodes &diameter &may_be_slave &may_be_master &side;
    }
  };



  template <int dim>
  SidedFace
  sided(const SurfaceFace<dim> &face, const Side side)
  {
    SidedFace result{face.id.original(), {}, face.diameter, false, false, side};
    for (unsigned int k = 0; k < face.n_nodes; ++k)
      result.nodes.push_back(face.dofs[k * dim]);
    return result;
  }



  /// Two faces that may meet.
  struct OppositeFaces
  {
    FaceId a, b;
    double distance = 0.; ///< without sign [length]

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &a &b &distance;
    }
  };



  /**
   * Sets the sides of all @p faces, sorted by id: no face is slave and master,
   * faces that are opposite each other have different sides, and neighbours
   * the same one. What cannot all be fulfilled is fulfilled for the closest
   * faces first: then for those that are opposite, so that a fold that is
   * closed to its root has the border there. Faces that touch keep their
   * sides. Elsewhere a part of the surface keeps what most of its faces were;
   * a new one is slave if it is clearly finer than what is opposite, or else if
   * it has the first of all their faces. Faces with nothing opposite take the
   * side of neighbours a few layers away.
   */
  void
  choose_sides(std::vector<SidedFace>           &faces,
               const std::vector<OppositeFaces> &opposite);
} // namespace stickslip

#endif
