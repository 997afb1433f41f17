#include <stickslip/contact/pairing/partner_search.h>

#include <stickslip/contact/pairing/tool_pairing.h>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace stickslip
{
  namespace
  {
    /// xi within [0,1] up to this is inside, so that shared edges leave no gap.
    constexpr double inside_tolerance = 1e-10;

    /// Distances that differ by less than this fraction of the face are equal.
    constexpr double tie_tolerance = 1e-9;



    /// The most that a facet is extended, as a fraction of the face.
    constexpr double largest_overlap = 0.5;

    /// The facet of the last pairing is kept without a search while the point
    /// is nearer to it than this fraction of the face, ...
    constexpr double kept_within = 0.25;

    /// ... or than this one if the point has an overlap: far away another face
    /// may be the nearer one, not indefinitely.
    constexpr double kept_within_with_overlap = 1.;

    /// Edges and corners are not searched if the point is nearer to the face on
    /// which it projects than this fraction of it.
    constexpr double edges_ignored_within = 0.25;

    /// Beyond that an edge is the partner if its distance is below this
    /// fraction of the distance of the face.
    constexpr double edge_preferred_below = 0.5;

    /// Overshoot over an edge that is allowed per distance. Over a convex edge
    /// the overshoot shrinks with the gap; beyond the end of the surface it
    /// does not.
    constexpr double overshoot_per_distance = 0.8;

    /// Least cosine of the angle between the slave's outward normal and n for a
    /// facet to be found: one that looks away is the far side of a thin body.
    constexpr double least_facing_to_find = 0.1;

    /// The same for the facet of the last pairing to be kept.
    constexpr double least_facing_to_keep = 0.1;

    /// The nearest few faces nearly always hold the answer; bent surfaces with
    /// large boxes need all within the search distance.
    template <int dim>
    constexpr unsigned int n_near = dim == 2 ? 6 : 16;



    /// Which points of a face are looked at.
    enum class PartOfFace
    {
      inside,
      inside_penetrated, ///< only if the gap is negative
      edges
    };



    /// What a search has found.
    template <int dim>
    struct FoundPartner
    {
      Pairing<dim>         pairing;
      PossiblePartner<dim> partner;
      double               distance = std::numeric_limits<double>::max();
    };



    /// The master point at @p xi, now and when the step began.
    template <int dim>
    PossiblePartner<dim>
    partner_at(const MasterPatch<dim> &patch,
               const unsigned int      f,
               const Projection<dim>  &projection,
               const PartOfFace        part)
    {
      MasterPoint<dim> point;
      evaluate_master_point(patch.face(f),
                            patch.configuration(f),
                            patch.face_shape(),
                            projection.xi,
                            point);
      const auto &old_nodes = patch.old_configuration(f).positions;

      PossiblePartner<dim> partner;
      partner.face  = f;
      partner.x     = point.x;
      partner.x_old = interpolate<dim>(point.shape.value, old_nodes);
      partner.n     = point.n;
      partner.n_old = patch.face(f).orientation *
                      surface_normal<dim>(
                        surface_tangents<dim>(point.shape.gradient, old_nodes));
      partner.n_old /= partner.n_old.norm();
      partner.is_on_edge = part == PartOfFace::edges;
      return partner;
    }



    template <int dim>
    Projection<dim>
    project_on(const MasterPatch<dim> &patch,
               const unsigned int      f,
               const Tensor<1, dim>   &x,
               const PartOfFace        part)
    {
      return part == PartOfFace::edges
               ? project_on_boundary_of_face(patch.face(f),
                                             patch.configuration(f),
                                             patch.face_shape(),
                                             x)
               : project_on_face(patch.face(f),
                                 patch.configuration(f),
                                 patch.face_shape(),
                                 x,
                                 inside_tolerance);
    }



    /// Nearest of the @p candidates on which the point projects.
    template <int dim>
    FoundPartner<dim>
    nearest(const MasterPatch<dim>                             &patch,
            const SearchingPoint<dim>                          &point,
            const std::vector<std::pair<double, unsigned int>> &candidates,
            const EdgeRetention                                &retention,
            const PartOfFace                                    part)
    {
      const PairingTolerances &tolerances = patch.tolerances;
      FoundPartner<dim>        best;
      for (const auto &[box_distance, f] : candidates)
        {
          const double diameter = patch.face(f).diameter;
          const double tie      = tie_tolerance * diameter;
          if (box_distance > best.distance + tie)
            break;
          const auto   projection = project_on(patch, f, point.x, part);
          const double allowed =
            (tolerances.projection_tolerance +
             (retention.beyond_end ? tolerances.end_overlap : 0.)) *
              diameter +
            overshoot_per_distance * projection.distance;
          if (!projection.found ||
              projection.distance > tolerances.search_distance ||
              projection.overshoot > allowed)
            continue;
          const bool is_nearer = projection.distance < best.distance - tie;
          const bool is_tie =
            !is_nearer && projection.distance < best.distance + tie;
          if (!(is_nearer || (is_tie && f < best.pairing.face)))
            continue;
          const auto partner = partner_at(patch, f, projection, part);
          if (partner.n * point.normal <= least_facing_to_find ||
              (part == PartOfFace::inside_penetrated &&
               depth_of(point, partner).now <= 0.) ||
              !can_be_partners(point, partner, patch))
            continue;
          best.distance        = std::min(best.distance, projection.distance);
          best.partner         = partner;
          best.pairing.paired  = true;
          best.pairing.face    = f;
          best.pairing.face_id = patch.face(f).id;
          best.pairing.xi      = projection.xi;
          best.pairing.free    = projection.free;
          best.pairing.n       = partner.n;
        }
      return best;
    }



    /// The pairing on the face of the last one, if that is to be kept.
    template <int dim>
    Pairing<dim>
    kept(const MasterPatch<dim>    &patch,
         const SearchingPoint<dim> &point,
         const Pairing<dim>        &last,
         const double               overlap)
    {
      if (!(last.paired && patch.contains(last) &&
            (last.is_interior() || overlap > 0.)))
        return {};
      const auto &face = patch.face(last.face);
      const auto  projection =
        project_on_face(face,
                        patch.configuration(last.face),
                        patch.face_shape(),
                        point.x,
                        std::clamp(overlap, inside_tolerance, largest_overlap));
      const double farthest =
        (overlap > 0. ? kept_within_with_overlap : kept_within) * face.diameter;
      if (!projection.found || projection.distance >= farthest)
        return {};
      MasterPoint<dim> master;
      evaluate_master_point(face,
                            patch.configuration(last.face),
                            patch.face_shape(),
                            projection.xi,
                            master);
      if (master.n * point.normal <= least_facing_to_keep)
        return {};
      Pairing<dim> pairing = last;
      pairing.free         = everywhere<dim>();
      pairing.xi           = projection.xi;
      pairing.n            = master.n;
      return pairing;
    }
  } // namespace



  template <int dim>
  Pairing<dim>
  find_partner(const MasterPatch<dim>    &patch,
               const SearchingPoint<dim> &point,
               const Pairing<dim>        &last,
               const EdgeRetention       &retention)
  {
    if (patch.tool() != nullptr)
      return find_tool_partner(patch, point.x, point.normal);
    const Pairing<dim> same_face =
      kept(patch,
           point,
           last,
           retention.overlap_factor * patch.tolerances.facet_overlap);
    if (same_face.paired)
      return same_face;

    auto near  = patch.nearest_boxes(point.x, n_near<dim>);
    auto found = nearest(patch, point, near, retention, PartOfFace::inside);
    if (found.pairing.paired &&
        patch.may_pass_through((point.x - point.x_old).norm()))
      {
        const auto entered = nearest(patch,
                                     point,
                                     patch.all_boxes(point.x),
                                     retention,
                                     PartOfFace::inside_penetrated);
        if (entered.pairing.paired &&
            hides(point, entered.partner, found.partner, patch))
          return entered.pairing;
      }
    if (found.pairing.paired &&
        found.distance <
          edges_ignored_within * patch.face(found.pairing.face).diameter)
      return found.pairing;
    if (!found.pairing.paired && near.size() == n_near<dim>)
      {
        near  = patch.all_boxes(point.x);
        found = nearest(patch, point, near, retention, PartOfFace::inside);
      }
    // The point may hang over a convex edge close by although it projects on
    // some face far away.
    const auto edge = nearest(patch, point, near, retention, PartOfFace::edges);
    return edge.pairing.paired &&
               edge.distance < edge_preferred_below * found.distance
             ? edge.pairing
             : found.pairing;
  }

  template Pairing<2>
  find_partner(const MasterPatch<2> &,
               const SearchingPoint<2> &,
               const Pairing<2> &,
               const EdgeRetention &);
  template Pairing<3>
  find_partner(const MasterPatch<3> &,
               const SearchingPoint<3> &,
               const Pairing<3> &,
               const EdgeRetention &);
} // namespace stickslip
