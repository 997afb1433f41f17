#include <stickslip/contact/surface/triangle_shape.h>

#include <array>

namespace stickslip
{
  namespace
  {
    /// The gradients of the barycentric coordinates.
    const std::array<Tensor<1, 2>, 3> &
    barycentric_gradients()
    {
      static const std::array<Tensor<1, 2>, 3> gradients = {
        {Tensor<1, 2>({-1., -1.}),
         Tensor<1, 2>({1., 0.}),
         Tensor<1, 2>({0., 1.})}};
      return gradients;
    }



    std::array<double, 3>
    barycentric_coordinates(const Point<2> &xi)
    {
      return {{1. - xi[0] - xi[1], xi[0], xi[1]}};
    }
  } // namespace



  std::vector<Point<2>>
  triangle_nodes(const unsigned int degree)
  {
    std::vector<Point<2>> nodes = {Point<2>(0., 0.),
                                   Point<2>(1., 0.),
                                   Point<2>(0., 1.)};
    if (degree == 2)
      nodes.insert(nodes.end(),
                   {Point<2>(0.5, 0.), Point<2>(0.5, 0.5), Point<2>(0., 0.5)});
    return nodes;
  }



  void
  evaluate_triangle_values(const unsigned int   degree,
                           const Point<2>      &xi,
                           std::vector<double> &value)
  {
    const auto L = barycentric_coordinates(xi);
    value.assign(L.begin(), L.end());
    if (degree == 1)
      return;
    value.resize(6);
    for (unsigned int i = 0; i < 3; ++i)
      {
        value[i]     = L[i] * (2. * L[i] - 1.);
        value[3 + i] = 4. * L[i] * L[(i + 1) % 3];
      }
  }



  void
  evaluate_triangle_gradients(const unsigned int  degree,
                              const Point<2>     &xi,
                              FaceShapeValues<3> &shape)
  {
    const auto  L = barycentric_coordinates(xi);
    const auto &G = barycentric_gradients();
    evaluate_triangle_values(degree, xi, shape.value);
    shape.gradient.assign(G.begin(), G.end());
    if (degree == 1)
      return;
    shape.gradient.resize(6);
    for (unsigned int i = 0; i < 3; ++i)
      {
        const unsigned int j  = (i + 1) % 3;
        shape.gradient[i]     = (4. * L[i] - 1.) * G[i];
        shape.gradient[3 + i] = 4. * (L[i] * G[j] + L[j] * G[i]);
      }
  }



  void
  evaluate_triangle(const unsigned int  degree,
                    const Point<2>     &xi,
                    FaceShapeValues<3> &shape)
  {
    const auto &G = barycentric_gradients();
    evaluate_triangle_gradients(degree, xi, shape);
    shape.hessian.assign(shape.value.size(), Tensor<2, 2>());
    if (degree == 1)
      return;
    for (unsigned int i = 0; i < 3; ++i)
      {
        const unsigned int j = (i + 1) % 3;
        shape.hessian[i]     = 4. * outer_product(G[i], G[i]);
        shape.hessian[3 + i] =
          4. * (outer_product(G[i], G[j]) + outer_product(G[j], G[i]));
      }
  }
} // namespace stickslip
