#include <stickslip/contact/surface/facet_rise.h>

#include <stickslip/base/over_ranks.h>

#include <stickslip/contact/surface/faceted_triangles.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>

namespace stickslip
{
  namespace
  {
    /// A facet that rises less, as a fraction of its size, is flat.
    constexpr double negligible = 1e-9;



    /// Facets that are concave with less than this part of all rises are so by
    /// the error of the fit.
    constexpr double concave_part = 0.1;



    template <int dim>
    struct EdgeFunction
    {
      double             value = 0.;
      Tensor<1, dim - 1> gradient;
    };



    /// Quadratic, 1 in the middle of edge @p e of a face with @p n_edges (one:
    /// a line is its own edge), 0 at all other edges and at the nodes.
    template <int dim>
    EdgeFunction<dim>
    edge_function(const unsigned int    n_edges,
                  const unsigned int    e,
                  const Point<dim - 1> &xi)
    {
      EdgeFunction<dim> function;
      if (n_edges == 3)
        {
          std::array<double, 3>             N{{1., 0., 0.}};
          std::array<Tensor<1, dim - 1>, 3> N_xi;
          for (unsigned int d = 0; d < dim - 1; ++d)
            {
              N[0] -= xi[d];
              N[d + 1]       = xi[d];
              N_xi[0][d]     = -1.;
              N_xi[d + 1][d] = 1.;
            }
          const unsigned int next = (e + 1) % 3;
          function.value          = 4. * N[e] * N[next];
          function.gradient = 4. * (N[next] * N_xi[e] + N[e] * N_xi[next]);
          return function;
        }
      const unsigned int along = dim == 2 ? 0 : 1 - e / 2;
      const double       arc   = 4. * xi[along] * (1. - xi[along]);
      const double       slope = 4. * (1. - 2. * xi[along]);
      function.value           = arc;
      function.gradient[along] = slope;
      if (dim == 3)
        {
          // falls to zero at the opposite edge
          const unsigned int across = 1 - along;
          const double       at_end = e % 2 == 0 ? 1. - xi[across] : xi[across];
          function.value            = arc * at_end;
          function.gradient[along]  = slope * at_end;
          function.gradient[across] = e % 2 == 0 ? -arc : arc;
        }
      return function;
    }



    /// Fetches what the owners of @p faces know of them: @p values of the owned
    /// ones become right for all. Collective.
    template <int dim, typename Value>
    void
    fetch_from_owners(const std::vector<CollectedFace<dim>> &faces,
                      const MPI_Comm                        &communicator,
                      std::vector<Value>                    &values)
    {
      const auto number_of = [&](const FaceId &id) {
        return std::lower_bound(faces.begin(),
                                faces.end(),
                                id,
                                [](const CollectedFace<dim> &face,
                                   const FaceId             &other) {
                                  return face.face.id < other;
                                }) -
               faces.begin();
      };
      std::map<unsigned int, std::vector<FaceId>> questions;
      for (const auto &face : faces)
        if (!face.is_owned())
          questions[face.face.owner].push_back(face.face.id.original());
      std::map<unsigned int, std::vector<Value>> answers;
      for (const auto &[rank, ids] :
           Utilities::MPI::some_to_some(communicator, questions))
        for (const FaceId &id : ids)
          answers[rank].push_back(values[number_of(id)]);
      std::map<FaceId, Value> known;
      for (const auto &[rank, of_rank] :
           Utilities::MPI::some_to_some(communicator, answers))
        for (unsigned int i = 0; i < of_rank.size(); ++i)
          known[questions.at(rank)[i]] = of_rank[i];
      for (unsigned int f = 0; f < faces.size(); ++f)
        if (!faces[f].is_owned())
          values[f] = known.at(faces[f].face.id.original());
    }



    constexpr double none = std::numeric_limits<double>::quiet_NaN();

    /// A facet that is less curved than what is beyond both of its neighbours,
    /// by this factor, is a flat one between curved ones.
    constexpr double flat_between = 0.4;

    /// Curvatures are the same up to this factor where there is but one sign
    /// of them.
    constexpr double same_arc = 1.5;

    /// Curvatures below this fraction of others are those of flat parts.
    constexpr double flat_part = 0.1;



    bool
    are_alike(const double a, const double b)
    {
      return std::max(std::abs(a), std::abs(b)) <
             same_arc * std::abs(less_curved(a, b));
    }



    /// True if what is known of @p beyond is flat against @p curvature.
    bool
    is_flat(const double beyond, const double curvature)
    {
      return std::abs(beyond) < flat_part * std::abs(curvature);
    }



    /// Curvature of a facet from those at its ends (@p first, @p second) and
    /// beyond the neighbours there; 0: flat, or it cannot be said.
    double
    curvature_of_facet(const double first,
                       const double second,
                       const double beyond_first,
                       const double beyond_second)
    {
      if (std::isnan(first) && std::isnan(second))
        return 0.;
      if (std::isnan(first) || std::isnan(second))
        {
          const double here = std::isnan(first) ? second : first;
          const double beyond =
            std::isnan(first) ? beyond_second : beyond_first;
          return are_alike(here, beyond) ? here + 0.5 * (here - beyond) : 0.;
        }
      const double curvature = 0.5 * (first + second);
      // the end of a flat part, a chamfer, a flat facet between curved ones
      if ((is_flat(first, second) && is_flat(beyond_first, second)) ||
          (is_flat(second, first) && is_flat(beyond_second, first)) ||
          (is_flat(beyond_first, curvature) &&
           is_flat(beyond_second, curvature)))
        return 0.;
      const auto is_less_than = [&](const double beyond) {
        return std::isnan(beyond) ||
               std::abs(curvature) < flat_between * std::abs(beyond);
      };
      const bool is_between_curved_ones =
        first * second > 0. && is_less_than(beyond_first) &&
        is_less_than(beyond_second) &&
        !(std::isnan(beyond_first) && std::isnan(beyond_second));
      return is_between_curved_ones ? 0. : curvature;
    }



    /// Rises of lines and quadrilaterals over their middles, per direction.
    template <int dim>
    std::vector<std::vector<double>>
    rises_along_directions(const FacetedSurface<dim>             &surface,
                           const MPI_Comm                        &communicator,
                           const std::vector<CollectedFace<dim>> &faces)
    {
      std::vector<std::vector<double>> curvatures(faces.size());
      for (unsigned int f = 0; f < faces.size(); ++f)
        {
          for (unsigned int e = 0; e < surface.n_edges(); ++e)
            curvatures[f].push_back(surface.curvature_at(f, e));
          // a surface that is not normal to a symmetry plane has an edge there
          for (unsigned int e = 0; e < surface.n_edges(); ++e)
            if (!surface.neighbour(f, e) &&
                !are_alike(curvatures[f][e], curvatures[f][e ^ 1]))
              curvatures[f][e] = none;
        }
      fetch_from_owners(faces, communicator, curvatures);

      // of the facet across edge e, at its other end
      const auto next_but_one = [&](const unsigned int f,
                                    const unsigned int e) {
        const auto beside = surface.neighbour(f, e);
        return beside ? curvatures[beside->face][beside->edge ^ 1] : none;
      };
      std::vector<std::vector<double>> rises(faces.size());
      for (unsigned int f = 0; f < faces.size(); ++f)
        for (unsigned int d = 0; d < dim - 1; ++d)
          {
            const double half = 0.5 * (surface.half_length(f, 2 * d) +
                                       surface.half_length(f, 2 * d + 1));
            const double curvature =
              curvature_of_facet(curvatures[f][2 * d],
                                 curvatures[f][2 * d + 1],
                                 next_but_one(f, 2 * d),
                                 next_but_one(f, 2 * d + 1));
            rises[f].push_back(half * std::tan(0.5 * half * curvature));
          }
      fetch_from_owners(faces, communicator, rises);
      return rises;
    }



    /// Rises over edges, from those of facets along them (of triangles: over
    /// them): the mean of both sides, so that the smooth surface has no step
    /// there. Nodes that hang on an edge are on it.
    template <int dim>
    std::vector<std::vector<double>>
    rises_over_edges(const FacetedSurface<dim>              &surface,
                     const bool                              are_triangles,
                     const std::vector<std::vector<double>> &rises)
    {
      // the edge at an end of direction d runs along the other one
      const auto rise = [&](const unsigned int f, const unsigned int e) {
        return rises[f][are_triangles ? e : 1 - e / 2];
      };
      // where a surface of quadrilaterals ends: on from the other side
      const auto at_end = [&](const unsigned int f, const unsigned int e) {
        const double own = rise(f, e);
        if (are_triangles)
          return own;
        const auto inside = surface.neighbour(f, e ^ 1);
        if (!inside)
          return own;
        const double other = rise(inside->face, inside->edge);
        return are_alike(own, other) ? own + 0.5 * (own - other) : own;
      };
      std::vector<std::vector<double>> over_edges(rises.size());
      for (unsigned int f = 0; f < rises.size(); ++f)
        for (unsigned int e = 0; e < surface.n_edges(); ++e)
          {
            const auto beside = surface.neighbour(f, e);
            over_edges[f].push_back(
              surface.is_between_levels(f, e) ? 0.
              : beside ? 0.5 * (rise(f, e) + rise(beside->face, beside->edge))
                       : at_end(f, e));
          }
      return over_edges;
    }
  } // namespace



  template <int dim>
  void
  find_rises(const FaceShape<dim>            &shape,
             const double                     sharpest_turn,
             const HeldDirections<dim>       &held_directions,
             const MPI_Comm                  &communicator,
             std::vector<CollectedFace<dim>> &faces)
  {
    const FacetedTriangles<dim> surface(shape,
                                        sharpest_turn,
                                        held_directions,
                                        faces);
    if (any_rank(surface.has_curved_faces(faces), communicator))
      return;
    std::vector<std::vector<double>> rises(faces.size());
    if (shape.is_triangle())
      {
        for (unsigned int f = 0; f < faces.size(); ++f)
          rises[f] = surface.rises_of(f);
        fetch_from_owners(faces, communicator, rises);
      }
    else
      rises = rises_along_directions(surface, communicator, faces);
    if (dim == 3)
      {
        rises = rises_over_edges(surface, shape.is_triangle(), rises);
        // the facets around ghosts may be out of sight
        fetch_from_owners(faces, communicator, rises);
      }
    for (unsigned int f = 0; f < faces.size(); ++f)
      if (std::any_of(rises[f].begin(), rises[f].end(), [&](const double r) {
            return std::abs(r) > negligible * faces[f].face.diameter;
          }))
        faces[f].face.rise = rises[f];
  }



  template <int dim>
  bool
  is_partly_concave(const std::vector<CollectedFace<dim>> &faces,
                    const MPI_Comm                        &communicator)
  {
    double inside = 0., all = 0.;
    for (const auto &face : faces)
      if (face.is_owned())
        for (const double rise : face.face.rise)
          {
            inside += std::max(0., -rise);
            all += std::abs(rise);
          }
    return Utilities::MPI::sum(inside, communicator) >
           concave_part * Utilities::MPI::sum(all, communicator);
  }



  template <int dim>
  double
  rise_at(const SurfaceFace<dim> &face, const Point<dim - 1> &xi)
  {
    double rise = 0.;
    for (unsigned int e = 0; e < face.rise.size(); ++e)
      rise += face.rise[e] * edge_function<dim>(face.rise.size(), e, xi).value;
    return rise;
  }



  template <int dim>
  double
  rise_between(const SurfaceFace<dim> &slave,
               const Point<dim - 1>   &xi,
               const SurfaceFace<dim> &master,
               const Point<dim - 1>   &eta)
  {
    return rise_at(slave, xi) + rise_at(master, eta);
  }



  template <int dim>
  Tensor<1, dim - 1>
  rise_gradient(const SurfaceFace<dim> &face, const Point<dim - 1> &xi)
  {
    Tensor<1, dim - 1> gradient;
    for (unsigned int e = 0; e < face.rise.size(); ++e)
      gradient +=
        face.rise[e] * edge_function<dim>(face.rise.size(), e, xi).gradient;
    return gradient;
  }

#define INSTANTIATE(dim)                                                     \
  template void   find_rises(const FaceShape<dim> &,                         \
                             const double,                                   \
                             const HeldDirections<dim> &,                    \
                             const MPI_Comm &,                               \
                             std::vector<CollectedFace<dim>> &);             \
  template bool   is_partly_concave(const std::vector<CollectedFace<dim>> &, \
                                    const MPI_Comm &);                       \
  template double rise_at(const SurfaceFace<dim> &, const Point<dim - 1> &); \
  template double rise_between(const SurfaceFace<dim> &,                     \
                               const Point<dim - 1> &,                       \
                               const SurfaceFace<dim> &,                     \
                               const Point<dim - 1> &);                      \
  template Tensor<1, dim - 1> rise_gradient(const SurfaceFace<dim> &,        \
                                            const Point<dim - 1> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
