#include <stickslip/contact/surface/master_geometry.h>

namespace stickslip
{
  namespace
  {
    template <int dim>
    std::array<Tensor<1, dim>, dim - 1>
    contribution_tangents(const NormalContribution<dim>     &contribution,
                          const std::vector<Tensor<1, dim>> &positions)
    {
      std::array<Tensor<1, dim>, dim - 1> a;
      for (unsigned int i = 0; i < contribution.nodes.size(); ++i)
        for (unsigned int d = 0; d < dim - 1; ++d)
          a[d] +=
            contribution.gradients[i][d] * positions[contribution.nodes[i]];
      return a;
    }



    /// (1 - n n) A, without the product of two matrices.
    template <int dim>
    Tensor<2, dim>
    tangential_part(const Tensor<2, dim> &A, const Tensor<1, dim> &n)
    {
      return A - outer_product(n, n * A);
    }



    template <int dim>
    void
    update_dual_tangents(MasterPoint<dim> &point)
    {
      Tensor<2, dim - 1> metric;
      for (unsigned int d = 0; d < dim - 1; ++d)
        for (unsigned int e = 0; e < dim - 1; ++e)
          metric[d][e] = point.a[d] * point.a[e];
      const Tensor<2, dim - 1> inverse = invert(metric);
      for (unsigned int d = 0; d < dim - 1; ++d)
        {
          point.a_dual[d] = Tensor<1, dim>();
          for (unsigned int e = 0; e < dim - 1; ++e)
            point.a_dual[d] += inverse[d][e] * point.a[e];
        }
    }
  } // namespace



  template <int dim>
  void
  update_nodal_normals(const SurfaceFace<dim>   &face,
                       MasterConfiguration<dim> &configuration)
  {
    configuration.nodal_normals.assign(face.nodal_normals.size(),
                                       Tensor<1, dim>());
    for (unsigned int j = 0; j < face.nodal_normals.size(); ++j)
      {
        Tensor<1, dim> &n = configuration.nodal_normals[j];
        for (const auto &contribution : face.nodal_normals[j])
          {
            const Tensor<1, dim> v =
              contribution.orientation *
              surface_normal<dim>(
                contribution_tangents(contribution, configuration.positions));
            n += v / v.norm();
          }
        n /= n.norm();
      }
  }



  template <int dim>
  void
  nodal_normal_derivatives(const SurfaceFace<dim>         &face,
                           const MasterConfiguration<dim> &configuration,
                           const unsigned int              j,
                           std::vector<Tensor<2, dim>>    &derivative)
  {
    derivative.assign(face.n_stencil_nodes(), Tensor<2, dim>());
    Tensor<1, dim> sum;
    for (const auto &contribution : face.nodal_normals[j])
      {
        const auto a =
          contribution_tangents(contribution, configuration.positions);
        const Tensor<1, dim> v =
          contribution.orientation * surface_normal<dim>(a);
        const double         length = v.norm();
        const Tensor<1, dim> n      = v / length;
        sum += n;
        for (unsigned int i = 0; i < contribution.nodes.size(); ++i)
          derivative[contribution.nodes[i]] +=
            (contribution.orientation / length) *
            tangential_part(
              surface_normal_derivative(a, contribution.gradients[i]), n);
      }
    const double         length = sum.norm();
    const Tensor<1, dim> n      = sum / length;
    for (Tensor<2, dim> &D : derivative)
      D = tangential_part(D, n) / length;
  }



  template <int dim>
  void
  evaluate_curved_point(const std::vector<Tensor<1, dim>> &positions,
                        const unsigned int                 n_nodes,
                        const double                       orientation,
                        MasterPoint<dim>                  &point)
  {
    point.x = Tensor<1, dim>();
    for (unsigned int d = 0; d < dim - 1; ++d)
      {
        point.a[d] = Tensor<1, dim>();
        for (unsigned int e = 0; e < dim - 1; ++e)
          point.x_ab[d][e] = Tensor<1, dim>();
      }
    for (unsigned int j = 0; j < n_nodes; ++j)
      {
        const Tensor<1, dim> &x = positions[j];
        point.x += point.shape.value[j] * x;
        for (unsigned int d = 0; d < dim - 1; ++d)
          {
            point.a[d] += point.shape.gradient[j][d] * x;
            for (unsigned int e = 0; e < dim - 1; ++e)
              point.x_ab[d][e] += point.shape.hessian[j][d][e] * x;
          }
      }
    update_dual_tangents(point);

    const Tensor<1, dim> v = orientation * surface_normal<dim>(point.a);
    point.n                = v / v.norm();
    for (unsigned int e = 0; e < dim - 1; ++e)
      {
        point.n_a[e] = Tensor<1, dim>();
        for (unsigned int d = 0; d < dim - 1; ++d)
          point.n_a[e] -= point.a_dual[d] * (point.n * point.x_ab[d][e]);
      }
  }



  template <int dim>
  void
  evaluate_master_point(const SurfaceFace<dim>         &face,
                        const MasterConfiguration<dim> &configuration,
                        const FaceShape<dim>           &shape,
                        const Point<dim - 1>           &xi,
                        MasterPoint<dim>               &point)
  {
    shape.evaluate(xi, point.shape);
    evaluate_curved_point(configuration.positions,
                          face.n_nodes,
                          face.orientation,
                          point);
    if (configuration.nodal_normals.empty())
      return;

    Tensor<1, dim>                      m;
    std::array<Tensor<1, dim>, dim - 1> m_a;
    for (unsigned int j = 0; j < face.n_nodes; ++j)
      {
        m += point.shape.value[j] * configuration.nodal_normals[j];
        for (unsigned int d = 0; d < dim - 1; ++d)
          m_a[d] += point.shape.gradient[j][d] * configuration.nodal_normals[j];
      }
    point.averaged_normal_length = m.norm();
    point.n                      = m / point.averaged_normal_length;
    for (unsigned int d = 0; d < dim - 1; ++d)
      point.n_a[d] =
        (m_a[d] - point.n * (point.n * m_a[d])) / point.averaged_normal_length;
  }

#define INSTANTIATE(dim)                                                   \
  template void update_nodal_normals(const SurfaceFace<dim> &,             \
                                     MasterConfiguration<dim> &);          \
  template void nodal_normal_derivatives(const SurfaceFace<dim> &,         \
                                         const MasterConfiguration<dim> &, \
                                         const unsigned int,               \
                                         std::vector<Tensor<2, dim>> &);   \
  template void evaluate_curved_point(const std::vector<Tensor<1, dim>> &, \
                                      const unsigned int,                  \
                                      const double,                        \
                                      MasterPoint<dim> &);                 \
  template void evaluate_master_point(const SurfaceFace<dim> &,            \
                                      const MasterConfiguration<dim> &,    \
                                      const FaceShape<dim> &,              \
                                      const Point<dim - 1> &,              \
                                      MasterPoint<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
