#include <stickslip/contact/pairing/possible_penetration.h>

#include <stickslip/contact/pairing/face_boxes.h>

#include <stickslip/contact/surface/projected_face.h>

#include <algorithm>
#include <cmath>

namespace stickslip
{
  namespace
  {
    /// Faces that meet a normal at less than this cosine stand beside it; the
    /// others are the face itself, or the back of the body.
    constexpr double beside = 0.7;

    /// Least cosine between the normals of both sides where a point has passed
    /// through a whole body.
    constexpr double along_way = 0.5;

    /// Lengths below this fraction of a face are roundoff.
    constexpr double no_length = 1e-6;

    /// xi within [0,1] up to this is inside.
    constexpr double on_the_face = 1e-10;



    /// Depth up to which a point counts as level with the master: as far as it
    /// may lie beside it.
    template <int dim>
    double
    level_with(const SearchingPoint<dim> &point,
               const SurfaceFace<dim>    &master,
               const MasterPatch<dim>    &patch)
    {
      return std::min({patch.tolerances.projection_tolerance * master.diameter,
                       point.thickness,
                       master.thickness});
    }



    /// Into the master, in the middle of face @p f.
    template <int dim>
    Tensor<1, dim>
    normal_of(const unsigned int f, const MasterPatch<dim> &patch)
    {
      std::vector<Tensor<1, dim>> nodes = patch.configuration(f).positions;
      nodes.resize(patch.face(f).n_nodes);
      return -1. * projection_plane(patch.face(f), patch.face_shape(), nodes).n;
    }



    /// Whether the slave face of the point reaches out of the master through a
    /// plane (@p x, @p n into the master).
    template <int dim>
    bool
    reaches_out(const SearchingPoint<dim> &point,
                const Tensor<1, dim>      &x,
                const Tensor<1, dim>      &n,
                const double               negligible)
    {
      return std::any_of(point.face_nodes->begin(),
                         point.face_nodes->end(),
                         [&](const auto &node) {
                           return n * (node - x) < -negligible;
                         });
    }



    /// Whether another face of the master, beside the partner's, is nearer to
    /// the point, and the slave face crosses it: the point is at a corner of
    /// the slave that has come in there.
    template <int dim>
    bool
    has_shorter_way_out(const SearchingPoint<dim>  &point,
                        const PossiblePartner<dim> &partner,
                        const double                depth,
                        const MasterPatch<dim>     &patch)
    {
      const auto box = enlarged(box_of<dim>({point.x}, 1, 0.), depth);
      for (const unsigned int f : patch.faces_in(box))
        {
          if (f == partner.face ||
              std::abs(normal_of(f, patch) * partner.n) > beside)
            continue;
          const auto &face       = patch.face(f);
          const auto  projection = project_on_face(face,
                                                  patch.configuration(f),
                                                  patch.face_shape(),
                                                  point.x,
                                                  on_the_face);
          if (!projection.found)
            continue;
          MasterPoint<dim> way_out;
          evaluate_master_point(face,
                                patch.configuration(f),
                                patch.face_shape(),
                                projection.xi,
                                way_out);
          const double negligible = no_length * face.diameter;
          const double way        = way_out.n * (point.x - way_out.x);
          if (way > -negligible && way < depth &&
              reaches_out(point, way_out.x, way_out.n, negligible))
            return true;
        }
      return false;
    }



    /// Whether the point, behind an edge of the master, is inside of it: all
    /// faces there have it behind them and none is nearer, and it is between
    /// their normals. At an end of the surface there is no second normal.
    template <int dim>
    bool
    is_inside_at_edge(const SearchingPoint<dim>  &point,
                      const PossiblePartner<dim> &partner,
                      const MasterPatch<dim>     &patch)
    {
      const double negligible = no_length * patch.face(partner.face).diameter;
      const Tensor<1, dim> r  = point.x - partner.x;
      const Tensor<1, dim> beyond = r - (r * partner.n) * partner.n;
      const auto closest = [&](const unsigned int f, const Tensor<1, dim> &x) {
        return project_on_boundary_of_face(patch.face(f),
                                           patch.configuration(f),
                                           patch.face_shape(),
                                           x)
          .distance;
      };
      bool is_between = false;
      for (const unsigned int f : patch.faces_in(
             enlarged(box_of<dim>({partner.x}, 1, 0.), negligible)))
        if (f != partner.face && closest(f, partner.x) < negligible)
          {
            const Tensor<1, dim> n = normal_of(f, patch);
            if (n * r < negligible ||
                closest(f, point.x) < r.norm() - negligible)
              return false;
            is_between = is_between || n * beyond > negligible;
          }
      return is_between;
    }
  } // namespace



  template <int dim>
  Depth
  depth_of(const SearchingPoint<dim>  &point,
           const PossiblePartner<dim> &partner)
  {
    return {partner.n * (point.x - partner.x),
            partner.n_old * (point.x_old - partner.x_old)};
  }



  template <int dim>
  bool
  is_level(const SearchingPoint<dim>  &point,
           const PossiblePartner<dim> &partner,
           const MasterPatch<dim>     &patch)
  {
    return partner.n * (point.x - partner.x) <=
           level_with(point, patch.face(partner.face), patch);
  }



  template <int dim>
  bool
  can_be_partners(const SearchingPoint<dim>  &point,
                  const PossiblePartner<dim> &partner,
                  const MasterPatch<dim>     &patch)
  {
    if (is_level(point, partner, patch))
      return true;
    const SurfaceFace<dim> &master = patch.face(partner.face);
    const Depth             depth  = depth_of(point, partner);
    const double thickness = std::min(point.thickness, master.thickness);
    if (depth.now > thickness && partner.n * point.normal < along_way)
      return false;
    if (depth.at_start <= level_with(point, master, patch))
      return true;
    return std::min(depth.now, depth.at_start) <= thickness &&
           (!partner.is_on_edge || is_inside_at_edge(point, partner, patch)) &&
           !has_shorter_way_out(point, partner, depth.now, patch);
  }



  template <int dim>
  bool
  hides(const SearchingPoint<dim>  &point,
        const PossiblePartner<dim> &entered,
        const PossiblePartner<dim> &behind,
        const MasterPatch<dim>     &patch)
  {
    const SurfaceFace<dim> &body = patch.face(entered.face);
    return entered.n * (point.x - entered.x) > no_length * body.diameter &&
           entered.n * (behind.x - entered.x) >
             (1. - no_length) * body.thickness;
  }

#define INSTANTIATE(dim)                                       \
  template Depth depth_of(const SearchingPoint<dim> &,         \
                          const PossiblePartner<dim> &);       \
  template bool  is_level(const SearchingPoint<dim> &,         \
                          const PossiblePartner<dim> &,        \
                          const MasterPatch<dim> &);           \
  template bool  can_be_partners(const SearchingPoint<dim> &,  \
                                 const PossiblePartner<dim> &, \
                                 const MasterPatch<dim> &);    \
  template bool  hides(const SearchingPoint<dim> &,            \
                       const PossiblePartner<dim> &,           \
                       const PossiblePartner<dim> &,           \
                       const MasterPatch<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
