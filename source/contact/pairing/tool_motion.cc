#include <stickslip/contact/pairing/tool_motion.h>

namespace stickslip
{
  template <int dim>
  void
  ToolMotion<dim>::evaluate(const FaceShape<dim>    &slave_shape,
                            const MortarFace<dim>   &slave,
                            const SegmentPoint<dim> &point,
                            const MasterPatch<dim>  &patch,
                            const bool               moves)
  {
    slave_shape.evaluate_values(point.xi, N);
    patch.tool()->evaluate(patch.configuration(0).positions,
                           point.chart,
                           point.eta,
                           master);
    const unsigned int n         = N.size();
    const unsigned int n_frame   = ToolFrame<dim>::n_nodes;
    const unsigned int n_columns = (n + n_frame) * dim;
    for (auto &derivative : D_xi)
      derivative.assign(n_columns, 0.);
    D_n.assign(n_columns, Tensor<1, dim>());

    if (moves)
      {
        const Tensor<1, dim> r =
          interpolate<dim>(N, slave.positions) - master.x;
        Tensor<2, dim - 1> jacobian;
        for (unsigned int d = 0; d < dim - 1; ++d)
          for (unsigned int e = 0; e < dim - 1; ++e)
            jacobian[d][e] = master.a[d] * master.a[e] - r * master.x_ab[d][e];
        const Tensor<2, dim - 1> inverse = invert(jacobian);
        for (unsigned int k = 0; k < n_columns; ++k)
          {
            const unsigned int node = k / dim, c = k % dim;
            Tensor<1, dim - 1> slope; // derivative of (x_s - x_m) . a
            for (unsigned int d = 0; d < dim - 1; ++d)
              slope[d] = node < n
                           ? N[node] * master.a[d][c]
                           : master.shape.gradient[node - n][d] * r[c] -
                               master.shape.value[node - n] * master.a[d][c];
            const Tensor<1, dim - 1> D = inverse * slope;
            for (unsigned int d = 0; d < dim - 1; ++d)
              {
                D_xi[d][k] = D[d];
                D_n[k] += D[d] * master.n_a[d];
              }
          }
      }
    // the tool turns
    Tensor<1, dim>       v           = surface_normal<dim>(master.a);
    const double         orientation = v * master.n > 0. ? 1. : -1.;
    const Tensor<2, dim> D_unit      = orientation * unit_vector_derivative(v);
    for (unsigned int j = 0; j < n_frame; ++j)
      {
        const Tensor<2, dim> D =
          D_unit *
          surface_normal_derivative<dim>(master.a, master.shape.gradient[j]);
        for (unsigned int c = 0; c < dim; ++c)
          for (unsigned int i = 0; i < dim; ++i)
            D_n[(n + j) * dim + c][i] += D[i][c];
      }
  }

  template struct ToolMotion<2>;
  template struct ToolMotion<3>;
} // namespace stickslip
