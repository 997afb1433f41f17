#ifndef stickslip_contact_point_pairing_h
#define stickslip_contact_point_pairing_h

#include <stickslip/contact/surface/normal_projection.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>

namespace stickslip
{
  using namespace dealii;

  /// The master point of a contact point and the local frame there: what a
  /// frozen geometry keeps.
  template <int dim>
  struct Pairing
  {
    bool         paired = false;
    bool         is_far = false; ///< not paired, though a master is opposite
    unsigned int face   = 0;     ///< in the local patch
    FaceId       face_id;        ///< the same, everywhere

    unsigned int    chart = 0; ///< of a rigid tool: that of xi
    Point<dim - 1>  xi;
    EdgeMotion<dim> free{};

    Tensor<1, dim>                      n; ///< into the master
    std::array<Tensor<1, dim>, dim - 1> tau;

    /// False on an edge or a corner of the face.
    bool
    is_interior() const
    {
      return free == everywhere<dim>();
    }

    /// On the same part (interior, edge, corner) of the same facet.
    bool
    is_on_same_part_as(const Pairing &other) const
    {
      return face_id == other.face_id && free == other.free;
    }
  };



  /// Where a point met its partner when the step began.
  template <int dim>
  struct InitialPairing
  {
    bool           paired = false;
    Tensor<1, dim> master_position;
    Tensor<1, dim> n; ///< into the master
  };
} // namespace stickslip

#endif
