#include <stickslip/contact/pairing/surface_borders.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace stickslip
{
  namespace
  {
    /// A face lies beyond a border if its centre is seen from the node within
    /// this cosine of the direction out (faces of other levels share no nodes).
    constexpr double beyond_border = 0.2;

    constexpr double same_coordinate = 1e-12;



    /// For each side of the face that node @p j is on, the farthest node of the
    /// side (2D: the node itself).
    template <int dim>
    std::vector<unsigned int>
    border_neighbours(const FaceShape<dim> &shape, const unsigned int j)
    {
      const auto                of_j = distances_to_sides(shape, shape.node(j));
      std::vector<unsigned int> neighbours;
      for (unsigned int side = 0; side < of_j.size(); ++side)
        {
          if (std::abs(of_j[side]) > same_coordinate)
            continue;
          unsigned int farthest = j;
          for (unsigned int k = 0; k < shape.n_nodes(); ++k)
            if (std::abs(distances_to_sides(shape, shape.node(k))[side]) <
                  same_coordinate &&
                shape.node(k).distance(shape.node(j)) >
                  shape.node(farthest).distance(shape.node(j)) +
                    same_coordinate)
              farthest = k;
          neighbours.push_back(farthest);
        }
      return neighbours;
    }



    template <int dim>
    Tensor<1, dim>
    centre_of(const FaceShape<dim>              &shape,
              const std::vector<Tensor<1, dim>> &positions)
    {
      return interpolate<dim>(shape.at_centre().value, positions);
    }



    /// True if another face around the node has the border, or lies beyond it.
    template <int dim>
    bool
    goes_on(const FaceShape<dim>                   &shape,
            const MortarNode<dim>                  &node,
            const std::vector<MortarFace<dim>>     &faces,
            const typename MortarNode<dim>::Border &border)
    {
      const auto             &own  = node.faces[border.around];
      const SurfaceFace<dim> &face = faces[own.face].face;
      const auto              key  = face.name(border.neighbour);
      const Tensor<1, dim>    x    = face.reference_positions[own.displacement];
      const Tensor<1, dim>    out  = direction_out(shape,
                                               face,
                                               own.displacement,
                                               border.neighbour,
                                               face.undeformed_nodes());
      for (unsigned int b = 0; b < node.faces.size(); ++b)
        if (b != border.around)
          {
            const SurfaceFace<dim> &other = faces[node.faces[b].face].face;
            for (unsigned int k = 0; k < other.n_nodes; ++k)
              if (other.name(k) == key)
                return true;
            const Tensor<1, dim> there =
              centre_of(shape, other.undeformed_nodes()) - x;
            if (there * out > beyond_border * there.norm())
              return true;
          }
      return false;
    }



    /// direction_out() without its length and sign: the tangent in 2D, in 3D
    /// b x n with the line b to the neighbour.
    template <int dim>
    Tensor<1, dim>
    across_border(const SurfaceFace<dim>            &face,
                  const FaceShapeValues<dim>        &values,
                  const unsigned int                 j,
                  const unsigned int                 neighbour,
                  const std::vector<Tensor<1, dim>> &positions)
    {
      const auto a = surface_tangents<dim>(values.gradient, positions);
      if constexpr (dim == 2)
        return a[0];
      else
        {
          const Tensor<1, dim> v = outward_normal(face, a);
          return cross_product_3d(positions[neighbour] - positions[j],
                                  v / v.norm());
        }
    }



    /// Which of the two directions across the border leads out.
    template <int dim>
    double
    sign_out(const FaceShape<dim>              &shape,
             const unsigned int                 j,
             const Tensor<1, dim>              &across,
             const std::vector<Tensor<1, dim>> &positions)
    {
      return across * (centre_of(shape, positions) - positions[j]) < 0. ? 1.
                                                                        : -1.;
    }
  } // namespace



  template <int dim>
  SideDistances<dim>
  distances_to_sides(const FaceShape<dim> &shape, const Point<dim - 1> &xi)
  {
    SideDistances<dim> distances;
    for (unsigned int d = 0; d < dim - 1; ++d)
      {
        distances[d]           = xi[d];
        distances[dim - 1 + d] = 1. - xi[d];
      }
    if (shape.is_triangle())
      {
        distances[dim - 1]           = 1. - xi[0] - xi[dim - 2];
        distances[2 * (dim - 1) - 1] = std::numeric_limits<double>::infinity();
      }
    return distances;
  }



  template <int dim>
  std::vector<unsigned int>
  sides_of_node(const FaceShape<dim> &shape, const unsigned int j)
  {
    const auto distances = distances_to_sides(shape, shape.node(j));
    std::vector<unsigned int> sides;
    for (unsigned int side = 0; side < distances.size(); ++side)
      if (std::abs(distances[side]) < same_coordinate)
        sides.push_back(side);
    return sides;
  }



  template <int dim>
  Tensor<1, dim>
  direction_out(const FaceShape<dim>              &shape,
                const SurfaceFace<dim>            &face,
                const unsigned int                 j,
                const unsigned int                 neighbour,
                const std::vector<Tensor<1, dim>> &positions)
  {
    const Tensor<1, dim> across =
      across_border(face, shape.at_node(j), j, neighbour, positions);
    return sign_out(shape, j, across, positions) / across.norm() * across;
  }



  template <int dim>
  std::vector<Tensor<2, dim>>
  direction_out_derivative(const FaceShape<dim>              &shape,
                           const SurfaceFace<dim>            &face,
                           const unsigned int                 j,
                           const unsigned int                 neighbour,
                           const std::vector<Tensor<1, dim>> &positions)
  {
    const auto          &values = shape.at_node(j);
    const Tensor<1, dim> across =
      across_border(face, values, j, neighbour, positions);
    const Tensor<2, dim> D_unit =
      sign_out(shape, j, across, positions) * unit_vector_derivative(across);
    std::vector<Tensor<2, dim>> derivative(face.n_nodes);
    if constexpr (dim == 2)
      for (unsigned int k = 0; k < face.n_nodes; ++k)
        derivative[k] = values.gradient[k][0] * D_unit;
    else
      {
        const Tensor<1, dim> v =
          outward_normal(face,
                         surface_tangents<dim>(values.gradient, positions));
        const Tensor<1, dim> n = v / v.norm();
        const Tensor<1, dim> b = positions[neighbour] - positions[j];
        const auto D_n = outward_normal_derivative(face, positions, values);
        for (unsigned int k = 0; k < face.n_nodes; ++k)
          for (unsigned int c = 0; c < dim; ++c)
            {
              Tensor<1, dim> D_b, D_n_c;
              D_b[c] = (k == neighbour ? 1. : 0.) - (k == j ? 1. : 0.);
              for (unsigned int i = 0; i < dim; ++i)
                D_n_c[i] = D_n[k][i][c];
              const Tensor<1, dim> change =
                D_unit *
                (cross_product_3d(D_b, n) + cross_product_3d(b, D_n_c));
              for (unsigned int i = 0; i < dim; ++i)
                derivative[k][i][c] = change[i];
            }
      }
    return derivative;
  }



  template <int dim>
  std::vector<typename MortarNode<dim>::Border>
  find_borders(const FaceShape<dim>               &shape,
               const MortarNode<dim>              &node,
               const std::vector<MortarFace<dim>> &faces)
  {
    std::vector<typename MortarNode<dim>::Border> borders;
    for (unsigned int a = 0; a < node.faces.size(); ++a)
      for (const unsigned int neighbour :
           border_neighbours(shape, node.faces[a].displacement))
        if (!goes_on(shape, node, faces, {a, neighbour}))
          borders.push_back({a, neighbour});
    return borders;
  }

#define INSTANTIATE(dim)                                                                   \
  template SideDistances<dim>        distances_to_sides(const FaceShape<dim> &,            \
                                                        const Point<dim - 1> &);           \
  template std::vector<unsigned int> sides_of_node(const FaceShape<dim> &,                 \
                                                   const unsigned int);                    \
  template std::vector<typename MortarNode<dim>::Border> find_borders(                     \
    const FaceShape<dim> &,                                                                \
    const MortarNode<dim> &,                                                               \
    const std::vector<MortarFace<dim>> &);                                                 \
  template Tensor<1, dim>              direction_out(const FaceShape<dim> &,               \
                                                     const SurfaceFace<dim> &,             \
                                                     const unsigned int,                   \
                                                     const unsigned int,                   \
                                                     const std::vector<Tensor<1, dim>> &); \
  template std::vector<Tensor<2, dim>> direction_out_derivative(                           \
    const FaceShape<dim> &,                                                                \
    const SurfaceFace<dim> &,                                                              \
    const unsigned int,                                                                    \
    const unsigned int,                                                                    \
    const std::vector<Tensor<1, dim>> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
