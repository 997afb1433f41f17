#include <stickslip/contact/surface/faceted_surface.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace stickslip
{
  namespace
  {
    /// A node of a straight face is off its place by less than this fraction of
    /// the face.
    constexpr double straight = 1e-6;



    /// Nodes nearer than this on the reference face are the same.
    constexpr double same_place = 1e-10;



    /// The nodes of a face of degree p where one of degree 1 has its own.
    template <int dim>
    std::vector<unsigned int>
    nodes_at(const FaceShape<dim> &linear, const FaceShape<dim> &shape)
    {
      std::vector<unsigned int> vertices;
      for (unsigned int k = 0; k < linear.n_nodes(); ++k)
        for (unsigned int j = 0; j < shape.n_nodes(); ++j)
          if (shape.node(j).distance(linear.node(k)) < same_place)
            vertices.push_back(j);
      return vertices;
    }
  } // namespace



  double
  less_curved(const double a, const double b)
  {
    return a * b <= 0. ? 0. : std::abs(a) < std::abs(b) ? a : b;
  }



  template <int dim>
  FacetedSurface<dim>::FacetedSurface(
    const FaceShape<dim>                  &face_shape,
    const double                           sharpest_turn,
    const HeldDirections<dim>             &held_directions,
    const std::vector<CollectedFace<dim>> &faces)
    : face_shape(face_shape)
    , shape(1, face_shape.reference_cell())
    , vertices(nodes_at(shape, face_shape))
    , least_cosine(std::cos(sharpest_turn))
  {
    for (unsigned int f = 0; f < faces.size(); ++f)
      {
        const SurfaceFace<dim> &face = faces[f].face;
        nodes.emplace_back();
        for (const unsigned int j : vertices)
          nodes[f].push_back(face.reference_positions[j]);
        centres.push_back(
          interpolate<dim>(shape.at_centre().value, nodes.back()));
        const Tensor<1, dim> n =
          outward_normal(face,
                         surface_tangents<dim>(shape.at_centre().gradient,
                                               nodes.back()));
        normals.push_back(n / n.norm());
        node_keys.emplace_back();
        for (unsigned int k = 0; k < vertices.size(); ++k)
          {
            node_keys[f].push_back(face.name(vertices[k]));
            around[node_keys[f][k]].push_back({f, k});
          }
        edge_keys.emplace_back();
        for (unsigned int e = 0; e < n_edges(); ++e)
          {
            Key key;
            for (const unsigned int j : nodes_of_edge(e))
              key.push_back(node_keys[f][j]);
            std::sort(key.begin(), key.end());
            edges[key].push_back({f, e});
            edge_keys[f].push_back(key);
          }
      }
    if (dim == 3 && !shape.is_triangle())
      find_edges_between_levels();
    find_planes(held_directions, faces);
  }



  template <int dim>
  void
  FacetedSurface<dim>::find_planes(const HeldDirections<dim> &held_directions,
                                   const std::vector<CollectedFace<dim>> &faces)
  {
    for (const auto &[key, facets] : around)
      for (const Tensor<1, dim> &N :
           held_directions(faces[facets.front().face].face,
                           vertices[facets.front().node]))
        {
          double low = 0., high = 0., size = 0.;
          for (const auto &[g, k] : facets)
            for (const Tensor<1, dim> &x : nodes[g])
              {
                low  = std::min(low, N * (x - nodes[g][k]));
                high = std::max(high, N * (x - nodes[g][k]));
                size = std::max(size, (x - nodes[g][k]).norm());
              }
          if (std::min(-low, high) < in_plane * size)
            planes[key].push_back(N);
        }
  }



  template <int dim>
  const std::vector<Tensor<1, dim>> &
  FacetedSurface<dim>::planes_at(const NodeName &key) const
  {
    static const std::vector<Tensor<1, dim>> nothing;
    const auto                               position = planes.find(key);
    return position == planes.end() ? nothing : position->second;
  }



  template <int dim>
  std::optional<Tensor<1, dim>>
  FacetedSurface<dim>::plane_at_edge(const unsigned int f,
                                     const unsigned int e) const
  {
    const Key &ends = edge_keys[f][e];
    if (edges.at(ends).size() != 1)
      return {};
    const auto           nodes_there = nodes_of_edge(e);
    const Tensor<1, dim> way =
      nodes[f][nodes_there.back()] - nodes[f][nodes_there.front()];
    for (const Tensor<1, dim> &N : planes_at(ends.front()))
      for (const Tensor<1, dim> &other : planes_at(ends.back()))
        if (std::abs(N * other) > 1. - in_plane &&
            std::abs(N * way) <= in_plane * way.norm() &&
            normals[f] * mirrored(normals[f], N) >= least_cosine)
          return N;
    return {};
  }



  /// A longer edge and the halves of it, which have its middle in common.
  template <int dim>
  void
  FacetedSurface<dim>::find_edges_between_levels()
  {
    std::map<NodeName, Tensor<1, dim>>   positions;
    std::map<NodeName, std::vector<Key>> borders;
    for (unsigned int f = 0; f < nodes.size(); ++f)
      for (unsigned int e = 0; e < n_edges(); ++e)
        if (edges.at(edge_keys[f][e]).size() == 1)
          for (const unsigned int j : nodes_of_edge(e))
            {
              positions[node_keys[f][j]] = nodes[f][j];
              borders[node_keys[f][j]].push_back(edge_keys[f][e]);
            }
    constexpr double same = 1e-6; // of the length
    for (const auto &[end, of_end] : borders)
      for (const Key &whole : of_end)
        for (const Key &half : of_end)
          {
            const auto           inner = half[half[0] == end ? 1 : 0];
            const Tensor<1, dim> way =
              positions[whole[1]] - positions[whole[0]];
            const Tensor<1, dim> from_middle =
              positions[inner] - positions[whole[0]] - 0.5 * way;
            if (from_middle.norm() < same * way.norm())
              between_levels.insert({whole, half});
          }
  }



  template <int dim>
  bool
  FacetedSurface<dim>::has_curved_faces(
    const std::vector<CollectedFace<dim>> &faces) const
  {
    std::vector<double> N;
    for (unsigned int f = 0; f < faces.size(); ++f)
      for (unsigned int j = 0; j < face_shape.n_nodes(); ++j)
        {
          shape.evaluate_values(face_shape.node(j), N);
          const Tensor<1, dim> off = interpolate<dim>(N, nodes[f]) -
                                     faces[f].face.reference_positions[j];
          if (off.norm() > straight * faces[f].face.diameter)
            return true;
        }
    return false;
  }



  template <int dim>
  std::vector<unsigned int>
  FacetedSurface<dim>::nodes_of_edge(const unsigned int e) const
  {
    if (shape.is_triangle())
      return {e, (e + 1) % 3};
    std::vector<unsigned int> of_edge;
    for (unsigned int j = 0; j < shape.n_nodes(); ++j)
      if (std::abs(shape.node(j)[e / 2] - (e % 2)) < 0.5)
        of_edge.push_back(j);
    return of_edge;
  }



  template <int dim>
  Tensor<1, dim>
  FacetedSurface<dim>::middle_of_edge(const unsigned int f,
                                      const unsigned int e) const
  {
    const auto     ends = nodes_of_edge(e);
    Tensor<1, dim> middle;
    for (const unsigned int j : ends)
      middle += nodes[f][j] / static_cast<double>(ends.size());
    return middle;
  }



  template <int dim>
  std::optional<typename FacetedSurface<dim>::Beside>
  FacetedSurface<dim>::neighbour(const unsigned int f,
                                 const unsigned int e) const
  {
    const std::vector<Beside> &both = edges.at(edge_keys[f][e]);
    if (both.size() != 2)
      return {};
    const Beside &other = both[0].face == f ? both[1] : both[0];
    if (other.face == f || !meet_smoothly(f, other.face))
      return {};
    return other;
  }



  template <int dim>
  double
  FacetedSurface<dim>::curvature_at(const unsigned int f,
                                    const unsigned int e) const
  {
    const auto beside = neighbour(f, e);
    const auto plane  = plane_at_edge(f, e);
    if (!beside && !plane)
      return std::numeric_limits<double>::quiet_NaN();
    Tensor<1, dim> towards = middle_of_edge(f, e) - centres[f];
    towards /= towards.norm();
    const Tensor<1, dim> n =
      beside ? normals[beside->face] : mirrored(normals[f], *plane);
    return std::atan2(n * towards, n * normals[f]) /
           (half_length(f, e) + (beside
                                   ? half_length(beside->face, beside->edge)
                                   : half_length(f, e)));
  }



  template class FacetedSurface<2>;
  template class FacetedSurface<3>;
} // namespace stickslip
