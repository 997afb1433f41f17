#include <stickslip/contact/surface/faceted_triangles.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

namespace stickslip
{
  namespace
  {
    /// Normals at nodes say how curved an edge is less accurately than the
    /// fit: it may be more curved by this factor.
    constexpr double tolerance_of_normals = 1.6;
  } // namespace



  /// Of a triangle, from those this->around. Weights that are exact for
  /// spheres: N. Max, Journal of Graphics Tools 4(2), 1999.
  template <int dim>
  Tensor<1, dim>
  FacetedTriangles<dim>::normal_at_node(const unsigned int f,
                                        const unsigned int j) const
  {
    Tensor<1, dim> sum;
    for (const auto &[g, k] : this->around.at(this->node_keys[f][j]))
      {
        if (!this->meet_smoothly(f, g))
          continue;
        const Tensor<1, dim> first =
          this->nodes[g][(k + 1) % 3] - this->nodes[g][k];
        const Tensor<1, dim> second =
          this->nodes[g][(k + 2) % 3] - this->nodes[g][k];
        const double squares = first.norm_square() * second.norm_square();
        const double product = first * second;
        const double twice_the_area =
          std::sqrt(std::max(0., squares - product * product));
        sum += twice_the_area / squares * this->normals[g];
      }
    for (const Tensor<1, dim> &N : this->planes_at(this->node_keys[f][j]))
      sum -= (sum * N) * N;
    return sum / sum.norm();
  }



  /// True if what goes along @p way arrives at a node where there is more of
  /// the surface ahead: the normal there knows how it bends.
  template <int dim>
  bool
  FacetedTriangles<dim>::goes_on_beyond(const unsigned int    f,
                                        const unsigned int    j,
                                        const Tensor<1, dim> &way) const
  {
    constexpr double ahead = 0.64; // 50 degrees to either side
    for (const auto &[g, k] : this->around.at(this->node_keys[f][j]))
      for (unsigned int l = 1; l < 3; ++l)
        {
          const Tensor<1, dim> edge =
            this->nodes[g][(k + l) % 3] - this->nodes[g][k];
          const double least = ahead * edge.norm() * way.norm();
          if (!this->meet_smoothly(f, g))
            continue;
          if (edge * way > least)
            return true;
          for (const Tensor<1, dim> &N : this->planes_at(this->node_keys[f][j]))
            if (mirrored(edge, N) * way > least)
              return true;
        }
    return false;
  }



  /// The rise over an edge of an arc with the normals at its ends.
  template <int dim>
  double
  FacetedTriangles<dim>::rise_of_normals(const unsigned int f,
                                         const unsigned int e) const
  {
    const auto           ends = this->nodes_of_edge(e);
    const Tensor<1, dim> way =
      this->nodes[f][ends[1]] - this->nodes[f][ends[0]];
    const bool at_first = goes_on_beyond(f, ends[0], -1. * way);
    const bool at_last  = goes_on_beyond(f, ends[1], way);
    // the length times the sine of half the angle of the arc
    const double first = -(normal_at_node(f, ends[0]) * way);
    const double last  = normal_at_node(f, ends[1]) * way;
    return 0.25 * (at_first == at_last ? less_curved(first, last)
                   : at_first          ? first
                                       : last);
  }



  /// The vertices of the facets that have a node of triangle @p f, its own not
  /// among them, with mirror images.
  template <int dim>
  std::vector<Tensor<1, dim>>
  FacetedTriangles<dim>::vertices_around(const unsigned int f) const
  {
    std::map<NodeName, Tensor<1, dim>> ring;
    std::vector<Tensor<1, dim>>        vertices_there;
    for (unsigned int j = 0; j < 3; ++j)
      for (const auto &[g, k] : this->around.at(this->node_keys[f][j]))
        {
          if (!this->meet_smoothly(f, g))
            continue;
          for (unsigned int l = 0; l < 3; ++l)
            ring.emplace(this->node_keys[g][l], this->nodes[g][l]);
          for (const Tensor<1, dim> &N : this->planes_at(this->node_keys[f][j]))
            for (unsigned int l = 1; l < 3; ++l)
              {
                const Tensor<1, dim> edge =
                  this->nodes[g][(k + l) % 3] - this->nodes[g][k];
                if (std::abs(edge * N) > this->in_plane * edge.norm())
                  vertices_there.push_back(this->nodes[g][k] +
                                           mirrored(edge, N));
              }
        }
    for (const auto &key : this->node_keys[f])
      ring.erase(key);
    for (const auto &vertex : ring)
      vertices_there.push_back(vertex.second);
    return vertices_there;
  }



  /// Least squares for the heights z = sum_e 4 c_e N_e N_(e+1) of the vertices
  /// around a triangle, divided by the squares of their distances.
  template <int dim>
  std::vector<double>
  FacetedTriangles<dim>::fitted_rises(const unsigned int f) const
  {
    const std::vector<Tensor<1, dim>> ring = vertices_around(f);
    if (ring.empty())
      return {0., 0., 0.};

    std::array<Tensor<1, dim>, 3> N_x; // gradients of N
    for (unsigned int i = 0; i < 3; ++i)
      {
        const Tensor<1, dim> opposite =
          this->nodes[f][(i + 2) % 3] - this->nodes[f][(i + 1) % 3];
        Tensor<1, dim> height = this->nodes[f][i] - this->nodes[f][(i + 1) % 3];
        height -= (height * opposite) / opposite.norm_square() * opposite;
        N_x[i] = height / height.norm_square();
      }
    Tensor<2, 3> matrix;
    Tensor<1, 3> right;
    for (const Tensor<1, dim> &vertex : ring)
      {
        const Tensor<1, dim>  x = vertex - this->centres[f];
        std::array<double, 3> N;
        for (unsigned int i = 0; i < 3; ++i)
          N[i] = 1. / 3. + N_x[i] * x;
        Tensor<1, 3> row;
        for (unsigned int e = 0; e < 3; ++e)
          row[e] = 4. * N[e] * N[(e + 1) % 3] / x.norm_square();
        matrix += outer_product(row, row);
        right += this->normals[f] * x / x.norm_square() * row;
      }
    // what few vertices say nothing about is flat
    constexpr double small = 1e-8;
    const double     of_flat =
      small * trace(matrix) + std::numeric_limits<double>::min();
    for (unsigned int e = 0; e < 3; ++e)
      matrix[e][e] += of_flat;
    const Tensor<1, 3> rises = invert(matrix) * right;
    return {rises[0], rises[1], rises[2]};
  }



  template <int dim>
  std::vector<double>
  FacetedTriangles<dim>::rises_of(const unsigned int f) const
  {
    std::vector<double> rises = fitted_rises(f);
    for (unsigned int e = 0; e < 3; ++e)
      rises[e] =
        less_curved(rises[e], tolerance_of_normals * rise_of_normals(f, e));
    return rises;
  }

  template class FacetedTriangles<2>;
  template class FacetedTriangles<3>;
} // namespace stickslip
