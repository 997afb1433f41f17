#include <stickslip/contact/surface/face_shape.h>

#include <stickslip/contact/surface/triangle_shape.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace stickslip
{
  namespace
  {
    /// Largest degree of displacements plus one.
    constexpr unsigned int max_nodes_1d = 7;



    /// Nodes of a triangle of @p degree 1 or 2 that its cells lie between.
    std::vector<std::vector<unsigned int>>
    triangle_cells(const unsigned int degree)
    {
      if (degree == 1)
        return {{0, 1, 2}};
      return {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {3, 4, 5}};
    }



    /// The same for lines and quadrilaterals.
    template <int dim>
    std::vector<std::vector<unsigned int>>
    product_cells(const unsigned int degree)
    {
      const unsigned int                     n = degree + 1;
      std::vector<std::vector<unsigned int>> cells;
      if constexpr (dim == 2)
        for (unsigned int i = 0; i < degree; ++i)
          cells.push_back({i, i + 1});
      else
        for (unsigned int j = 0; j < degree; ++j)
          for (unsigned int i = 0; i < degree; ++i)
            cells.push_back(
              {j * n + i, j * n + i + 1, (j + 1) * n + i + 1, (j + 1) * n + i});
      return cells;
    }
  } // namespace



  template <int dim>
  FaceShape<dim>::FaceShape(const unsigned int   degree,
                            const ReferenceCell &face)
    : face(face)
    , n_1d(degree + 1)
  {
    for (unsigned int d = 0; d < dim - 1; ++d)
      middle[d] = is_triangle() ? 1. / 3. : 0.5;
    if constexpr (dim == 3)
      if (is_triangle())
        nodes = triangle_nodes(degree);
    Assert(n_1d <= max_nodes_1d, ExcIndexRange(n_1d, 2, max_nodes_1d + 1));
    const std::vector<Point<1>> nodes_1d = QGaussLobatto<1>(n_1d).get_points();
    basis = Polynomials::generate_complete_Lagrange_basis(nodes_1d);
    if (!is_triangle())
      for (unsigned int j = 0; j < (dim == 2 ? n_1d : n_1d * n_1d); ++j)
        {
          Point<dim - 1> node;
          for (unsigned int d = 0, rest = j; d < dim - 1; ++d, rest /= n_1d)
            node[d] = nodes_1d[rest % n_1d][0];
          nodes.push_back(node);
        }

    for (const auto &corners :
         is_triangle() ? triangle_cells(degree) : product_cells<dim>(degree))
      {
        Point<dim - 1> centre;
        for (const unsigned int j : corners)
          centre +=
            Tensor<1, dim - 1>(nodes[j]) / static_cast<double>(corners.size());
        node_cells.push_back({corners, centre});
      }

    evaluate(middle, centre_values);
    node_values.resize(n_nodes());
    for (unsigned int j = 0; j < n_nodes(); ++j)
      evaluate(nodes[j], node_values[j]);
  }



  template <int dim>
  unsigned int
  FaceShape<dim>::degree() const
  {
    return n_1d - 1;
  }



  template <int dim>
  unsigned int
  FaceShape<dim>::n_nodes() const
  {
    return nodes.size();
  }



  template <int dim>
  const Point<dim - 1> &
  FaceShape<dim>::node(const unsigned int j) const
  {
    return nodes[j];
  }



  template <int dim>
  double
  FaceShape<dim>::distance(const unsigned int j, const unsigned int k) const
  {
    if (!is_triangle())
      return nodes[j].distance(nodes[k]);
    const Tensor<1, dim - 1> way = nodes[j] - nodes[k];
    return std::sqrt(way.norm_square() + way[0] * way[dim - 2]);
  }



  template <int dim>
  void
  FaceShape<dim>::evaluate_values(const Point<dim - 1> &xi,
                                  std::vector<double>  &value) const
  {
    if constexpr (dim == 3)
      if (is_triangle())
        return evaluate_triangle_values(degree(), xi, value);
    std::array<std::array<double, max_nodes_1d>, dim - 1> p;
    for (unsigned int d = 0; d < dim - 1; ++d)
      {
        const double x = xi[d];
        if (n_1d == 2)
          p[d] = {{1. - x, x}};
        else if (n_1d == 3)
          p[d] = {
            {(1. - x) * (1. - 2. * x), 4. * x * (1. - x), x * (2. * x - 1.)}};
        else
          for (unsigned int i = 0; i < n_1d; ++i)
            p[d][i] = basis[i].value(x);
      }

    value.resize(n_nodes());
    if constexpr (dim == 2)
      std::copy_n(p[0].begin(), n_1d, value.begin());
    else
      for (unsigned int k = 0, j = 0; k < n_1d; ++k)
        for (unsigned int i = 0; i < n_1d; ++i, ++j)
          value[j] = p[0][i] * p[1][k];
  }



  template <int dim>
  void
  FaceShape<dim>::evaluate_gradients(const Point<dim - 1> &xi,
                                     FaceShapeValues<dim> &shape) const
  {
    if constexpr (dim == 3)
      if (is_triangle())
        return evaluate_triangle_gradients(degree(), xi, shape);
    evaluate_product(xi, false, shape);
  }



  template <int dim>
  void
  FaceShape<dim>::evaluate(const Point<dim - 1> &xi,
                           FaceShapeValues<dim> &shape) const
  {
    if constexpr (dim == 3)
      if (is_triangle())
        return evaluate_triangle(degree(), xi, shape);
    evaluate_product(xi, true, shape);
  }



  template <int dim>
  void
  FaceShape<dim>::evaluate_product(const Point<dim - 1> &xi,
                                   const bool            with_hessians,
                                   FaceShapeValues<dim> &shape) const
  {
    // 1D values and two derivatives of every node along every direction
    std::array<std::array<std::array<double, 3>, max_nodes_1d>, dim - 1> p;
    for (unsigned int d = 0; d < dim - 1; ++d)
      {
        const double x = xi[d];
        auto        &f = p[d];
        if (n_1d == 2)
          {
            f[0] = {{1. - x, -1., 0.}};
            f[1] = {{x, 1., 0.}};
          }
        else if (n_1d == 3)
          {
            f[0] = {{(1. - x) * (1. - 2. * x), 4. * x - 3., 4.}};
            f[1] = {{4. * x * (1. - x), 4. - 8. * x, -8.}};
            f[2] = {{x * (2. * x - 1.), 4. * x - 1., 4.}};
          }
        else
          for (unsigned int i = 0; i < n_1d; ++i)
            basis[i].value(x, with_hessians ? 2 : 1, f[i].data());
      }

    shape.value.resize(n_nodes());
    shape.gradient.resize(n_nodes());
    if (with_hessians)
      shape.hessian.resize(n_nodes());
    if constexpr (dim == 2)
      for (unsigned int j = 0; j < n_1d; ++j)
        {
          shape.value[j]       = p[0][j][0];
          shape.gradient[j][0] = p[0][j][1];
          if (with_hessians)
            shape.hessian[j][0][0] = p[0][j][2];
        }
    else
      for (unsigned int k = 0, j = 0; k < n_1d; ++k)
        for (unsigned int i = 0; i < n_1d; ++i, ++j)
          {
            const auto &f        = p[0][i];
            const auto &g        = p[1][k];
            shape.value[j]       = f[0] * g[0];
            shape.gradient[j][0] = f[1] * g[0];
            shape.gradient[j][1] = f[0] * g[1];
            if (!with_hessians)
              continue;
            shape.hessian[j][0][0] = f[2] * g[0];
            shape.hessian[j][1][1] = f[0] * g[2];
            shape.hessian[j][0][1] = shape.hessian[j][1][0] = f[1] * g[1];
          }
  }

  template class FaceShape<2>;
  template class FaceShape<3>;
} // namespace stickslip
