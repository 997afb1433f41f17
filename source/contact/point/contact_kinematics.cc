#include <stickslip/contact/point/contact_kinematics.h>

#include <stickslip/base/axes_across.h>

namespace stickslip
{
  namespace
  {
    template <int dim>
    void
    clear(VectorRows<dim> &rows)
    {
      for (auto &row : rows)
        row.fill(0.);
    }



    /// rows += A(b): adds factor * T * (derivative of a vector given by rows
    /// b).
    template <int dim>
    void
    add_product(VectorRows<dim>       &rows,
                const Tensor<2, dim>  &T,
                const VectorRows<dim> &b)
    {
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int k = 0; k < dim; ++k)
          if (T[i][k] != 0.)
            for (unsigned int c = 0; c < b[k].size(); ++c)
              rows[i][c] += T[i][k] * b[k][c];
    }



    /// Derivative of v . b for constant v.
    template <int dim>
    typename GeneralizedCoordinates<dim>::Row
    contract(const Tensor<1, dim> &v, const VectorRows<dim> &b)
    {
      typename GeneralizedCoordinates<dim>::Row row;
      row.fill(0.);
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int c = 0; c < row.size(); ++c)
          row[c] += v[i] * b[i][c];
      return row;
    }



    /// Adds v * row (outer product).
    template <int dim>
    void
    add_outer(VectorRows<dim>                                 &rows,
              const Tensor<1, dim>                            &v,
              const typename GeneralizedCoordinates<dim>::Row &row)
    {
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int c = 0; c < row.size(); ++c)
          rows[i][c] += v[i] * row[c];
    }



    /// Derivative of the normal at fixed xi.
    template <int dim>
    VectorRows<dim>
    normal_derivative_at_fixed_xi(const MasterPoint<dim> &master,
                                  const bool              smoothed)
    {
      using G = GeneralizedCoordinates<dim>;
      VectorRows<dim> rows;
      clear<dim>(rows);
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int k = 0; k < dim; ++k)
          if (smoothed)
            rows[i][G::M + k] = ((i == k) - master.n[i] * master.n[k]) /
                                master.averaged_normal_length;
          else
            for (unsigned int d = 0; d < dim - 1; ++d)
              rows[i][G::C + d * dim + k] = -master.a_dual[d][i] * master.n[k];
      return rows;
    }



    /// D xi of a point that projects inside the face: the linearization of
    /// x_s = xbar(xi) + d_n n(xi).
    template <int dim>
    void
    interior_xi_derivative(
      const MasterPoint<dim>                                         &master,
      const double                                                    d_n,
      const VectorRows<dim>                                          &D_n_fixed,
      std::array<typename GeneralizedCoordinates<dim>::Row, dim - 1> &D_xi)
    {
      using G = GeneralizedCoordinates<dim>;
      Tensor<2, dim> jacobian;
      for (unsigned int i = 0; i < dim; ++i)
        {
          for (unsigned int d = 0; d < dim - 1; ++d)
            jacobian[i][d] = master.a[d][i] + d_n * master.n_a[d][i];
          jacobian[i][dim - 1] = master.n[i];
        }
      const Tensor<2, dim> inverse = invert(jacobian);
      for (unsigned int d = 0; d < dim - 1; ++d)
        for (unsigned int c = 0; c < G::n; ++c)
          {
            D_xi[d][c] = c < G::W + dim ? inverse[d][c - G::W] : 0.;
            for (unsigned int i = 0; i < dim; ++i)
              D_xi[d][c] -= inverse[d][i] * d_n * D_n_fixed[i][c];
          }
    }



    /// D xi of a point that sits on an edge (one free direction) or a corner.
    template <int dim>
    void
    edge_xi_derivative(
      const MasterPoint<dim>                                         &master,
      const EdgeMotion<dim>                                          &free,
      const Tensor<1, dim>                                           &r,
      std::array<typename GeneralizedCoordinates<dim>::Row, dim - 1> &D_xi)
    {
      using G = GeneralizedCoordinates<dim>;
      // tangent and curvature of the edge
      Tensor<1, dim> a, curvature;
      for (unsigned int d = 0; d < dim - 1; ++d)
        {
          a += free[d] * master.a[d];
          for (unsigned int e = 0; e < dim - 1; ++e)
            curvature += free[d] * free[e] * master.x_ab[d][e];
        }
      const double slope = a * a - r * curvature;
      for (unsigned int d = 0; d < dim - 1; ++d)
        {
          D_xi[d].fill(0.);
          if (free[d] == 0)
            continue;
          for (unsigned int i = 0; i < dim; ++i)
            {
              D_xi[d][G::W + i] = free[d] * a[i] / slope;
              for (unsigned int e = 0; e < dim - 1; ++e)
                D_xi[d][G::C + e * dim + i] = free[d] * free[e] * r[i] / slope;
            }
        }
    }



    /// Sine of the angle between a normal and a direction that carries no
    /// tangent basis.
    constexpr double parallel = 1e-8;



    /// Whether a direction carries tangents: it is not along the normal.
    bool
    carries_tangents(const Tensor<1, 3> &n, const Tensor<1, 3> &e)
    {
      return (e - (e * n) * n).norm() > parallel * e.norm();
    }



    /// Derivative of the tangent basis, given that of the normal.
    template <int dim>
    void
    basis_derivative(const Tensor<1, dim>                      &n,
                     const std::array<Tensor<1, dim>, dim - 1> &tau,
                     const Tensor<1, dim>                      &direction,
                     const VectorRows<dim>                     &D_n,
                     std::array<VectorRows<dim>, dim - 1>      &D_tau)
    {
      if constexpr (dim == 2)
        {
          (void)n;
          (void)tau;
          (void)direction;
          D_tau[0][1] = D_n[0];
          for (unsigned int c = 0; c < D_n[1].size(); ++c)
            D_tau[0][0][c] = -D_n[1][c];
        }
      else
        {
          using G = GeneralizedCoordinates<dim>;
          // q = P e,  D q = P De - n (Dn.e) - Dn (n.e),  tau_1 = q/|q|
          const bool           moves    = carries_tangents(n, direction);
          const Tensor<1, dim> e        = moves ? direction : farthest_axis(n);
          const double         q_length = (e - (e * n) * n).norm();
          VectorRows<dim>      D_q;
          clear<dim>(D_q);
          for (unsigned int i = 0; i < dim && moves; ++i)
            for (unsigned int k = 0; k < dim; ++k)
              D_q[i][G::E + k] = (i == k) - n[i] * n[k];
          add_outer<dim>(D_q, -1. * n, contract<dim>(e, D_n));
          for (unsigned int i = 0; i < dim; ++i)
            for (unsigned int c = 0; c < G::n; ++c)
              D_q[i][c] -= (n * e) * D_n[i][c];
          clear<dim>(D_tau[0]);
          const Tensor<2, dim> P =
            (Tensor<2, dim>(unit_symmetric_tensor<dim>()) -
             outer_product(tau[0], tau[0])) /
            q_length;
          add_product<dim>(D_tau[0], P, D_q);
          // tau_2 = n x tau_1
          for (unsigned int c = 0; c < G::n; ++c)
            {
              Tensor<1, dim> dn, dtau;
              for (unsigned int i = 0; i < dim; ++i)
                {
                  dn[i]   = D_n[i][c];
                  dtau[i] = D_tau[0][i][c];
                }
              const Tensor<1, dim> column =
                cross_product_3d(dn, tau[0]) + cross_product_3d(n, dtau);
              for (unsigned int i = 0; i < dim; ++i)
                D_tau[1][i][c] = column[i];
            }
        }
    }
  } // namespace



  template <int dim>
  std::array<Tensor<1, dim>, dim - 1>
  tangent_basis(const Tensor<1, dim> &n, const Tensor<1, dim> &direction)
  {
    std::array<Tensor<1, dim>, dim - 1> tau;
    if constexpr (dim == 2)
      {
        (void)direction;
        tau[0] = Tensor<1, dim>({-n[1], n[0]});
      }
    else
      {
        const Tensor<1, dim> e =
          carries_tangents(n, direction) ? direction : farthest_axis(n);
        const Tensor<1, dim> q = e - (e * n) * n;
        tau[0]                 = q / q.norm();
        tau[1]                 = cross_product_3d(n, tau[0]);
      }
    return tau;
  }



  template <int dim>
  void
  evaluate_gap_and_slip(const RelativePosition<dim> &relative,
                        const Tensor<1, dim>        &direction,
                        const double                 gap_offset,
                        const bool                   geometry_is_live,
                        const bool                   differentiate,
                        ContactKinematics<dim>      &kinematics)
  {
    using G                = GeneralizedCoordinates<dim>;
    const Tensor<1, dim> n = kinematics.n;
    const Tensor<1, dim> r = relative.r;
    const Tensor<1, dim> w = relative.w;
    kinematics.d_n         = n * r - gap_offset;
    kinematics.motion      = w;
    kinematics.d_t         = w - (w * n) * n;
    if (!differentiate)
      return;

    for (unsigned int d = 0; d < dim - 1; ++d)
      clear<dim>(kinematics.D_tau[d]);
    if (geometry_is_live)
      basis_derivative<dim>(
        n, kinematics.tau, direction, kinematics.D_n, kinematics.D_tau);

    kinematics.D_d_n       = contract<dim>(n, relative.D_r);
    const auto r_times_D_n = contract<dim>(r, kinematics.D_n);
    for (unsigned int c = 0; c < G::n; ++c)
      kinematics.D_d_n[c] += r_times_D_n[c];

    clear<dim>(kinematics.D_d_t);
    add_product<dim>(kinematics.D_d_t,
                     Tensor<2, dim>(unit_symmetric_tensor<dim>()) -
                       outer_product(n, n),
                     relative.D_w);
    add_outer<dim>(kinematics.D_d_t, -1. * n, contract<dim>(w, kinematics.D_n));
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int c = 0; c < G::n; ++c)
        kinematics.D_d_t[i][c] -= (n * w) * kinematics.D_n[i][c];
  }



  template <int dim>
  void
  evaluate_contact_kinematics(const Pairing<dim>       &frame,
                              const MasterPoint<dim>   &master,
                              const MasterPoint<dim>   &master_old,
                              const SlavePosition<dim> &slave,
                              const bool                smoothed_normals,
                              const bool                geometry_is_live,
                              const bool                differentiate,
                              ContactKinematics<dim>   &kinematics)
  {
    using G        = GeneralizedCoordinates<dim>;
    kinematics.n   = frame.n;
    kinematics.tau = frame.tau;
    kinematics.a   = master.a;
    RelativePosition<dim> relative;
    relative.r = slave.x - master.x;
    relative.w = relative.r - (slave.x_old - master_old.x);

    if (differentiate)
      {
        clear<dim>(kinematics.D_n);
        for (unsigned int d = 0; d < dim - 1; ++d)
          kinematics.D_xi[d].fill(0.);
        if (geometry_is_live)
          {
            kinematics.D_n =
              normal_derivative_at_fixed_xi(master, smoothed_normals);
            if (frame.is_interior())
              interior_xi_derivative<dim>(master,
                                          frame.n * relative.r,
                                          kinematics.D_n,
                                          kinematics.D_xi);
            else
              edge_xi_derivative<dim>(master,
                                      frame.free,
                                      relative.r,
                                      kinematics.D_xi);
            for (unsigned int d = 0; d < dim - 1; ++d)
              add_outer<dim>(kinematics.D_n, master.n_a[d], kinematics.D_xi[d]);
          }
        // D r = DW - a_alpha D xi^alpha;  D w = D r + a_alpha,old D xi^alpha
        clear<dim>(relative.D_r);
        for (unsigned int i = 0; i < dim; ++i)
          relative.D_r[i][G::W + i] = 1.;
        relative.D_w = relative.D_r;
        for (unsigned int d = 0; d < dim - 1; ++d)
          {
            add_outer<dim>(relative.D_r, -1. * master.a[d], kinematics.D_xi[d]);
            add_outer<dim>(relative.D_w,
                           master_old.a[d] - master.a[d],
                           kinematics.D_xi[d]);
          }
      }
    evaluate_gap_and_slip(relative,
                          slave.direction,
                          slave.gap_offset,
                          geometry_is_live,
                          differentiate,
                          kinematics);
  }



#define INSTANTIATE(dim)                                                \
  template std::array<Tensor<1, dim>, dim - 1> tangent_basis(           \
    const Tensor<1, dim> &, const Tensor<1, dim> &);                    \
  template void evaluate_gap_and_slip(const RelativePosition<dim> &,    \
                                      const Tensor<1, dim> &,           \
                                      const double,                     \
                                      const bool,                       \
                                      const bool,                       \
                                      ContactKinematics<dim> &);        \
  template void evaluate_contact_kinematics(const Pairing<dim> &,       \
                                            const MasterPoint<dim> &,   \
                                            const MasterPoint<dim> &,   \
                                            const SlavePosition<dim> &, \
                                            const bool,                 \
                                            const bool,                 \
                                            const bool,                 \
                                            ContactKinematics<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
