#include <stickslip/contact/surface/face_shape.h>

#include <stickslip/contact/surface/triangle_shape.h>

#include <deal.II/base/quadrature_lib.h>

#include <array>
#include <cmath>

namespace stickslip
{
  namespace
  {
    /// Largest degree of displacements plus one.
    constexpr unsigned int max_nodes_1d = 7;
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
    value.assign(n_nodes(), 1.);
    for (unsigned int j = 0; j < n_nodes(); ++j)
      for (unsigned int d = 0, rest = j; d < dim - 1; ++d, rest /= n_1d)
        value[j] *= basis[rest % n_1d].value(xi[d]);
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
    std::array<std::array<std::array<double, 3>, dim - 1>, max_nodes_1d> p;
    for (unsigned int d = 0; d < dim - 1; ++d)
      if (n_1d == 2)
        {
          p[0][d] = {{1. - xi[d], -1., 0.}};
          p[1][d] = {{xi[d], 1., 0.}};
        }
      else
        for (unsigned int i = 0; i < n_1d; ++i)
          basis[i].value(xi[d], with_hessians ? 2 : 1, p[i][d].data());

    shape.value.resize(n_nodes());
    shape.gradient.resize(n_nodes());
    if (with_hessians)
      shape.hessian.resize(n_nodes());
    const auto product = [&](const unsigned int                       j,
                             const std::array<unsigned int, dim - 1> &order) {
      double result = 1.;
      for (unsigned int d = 0, rest = j; d < dim - 1; ++d, rest /= n_1d)
        result *= p[rest % n_1d][d][order[d]];
      return result;
    };
    for (unsigned int j = 0; j < n_nodes(); ++j)
      {
        std::array<unsigned int, dim - 1> order{};
        shape.value[j] = product(j, order);
        for (unsigned int a = 0; a < dim - 1; ++a)
          {
            ++order[a];
            shape.gradient[j][a] = product(j, order);
            for (unsigned int b = 0; with_hessians && b < dim - 1; ++b)
              {
                ++order[b];
                shape.hessian[j][a][b] = product(j, order);
                --order[b];
              }
            --order[a];
          }
      }
  }

  template class FaceShape<2>;
  template class FaceShape<3>;
} // namespace stickslip
