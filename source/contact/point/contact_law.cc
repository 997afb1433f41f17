#include <stickslip/contact/point/contact_law.h>

#include <algorithm>
#include <cmath>

namespace stickslip
{
  namespace
  {
    /// Projected friction direction T and A = dT/dg.
    template <int dim>
    struct FrictionDirection
    {
      Tensor<1, dim> T;
      Tensor<2, dim> A;
    };



    template <int dim>
    FrictionDirection<dim>
    friction_direction(const Tensor<1, dim> &g, const bool stick)
    {
      const Tensor<2, dim> I = unit_symmetric_tensor<dim>();
      if (stick)
        return {g, I};
      const double length = g.norm();
      // by coincidence without a direction: no friction, and no division by 0
      if (length == 0.)
        return {g, Tensor<2, dim>()};
      return {g / length,
              (I - outer_product(g, g) / (length * length)) / length};
    }
  } // namespace



  bool
  is_closed(const double lambda_n, const double d_n, const Regularization &r)
  {
    return lambda_n - r.r_n_status * d_n <= 0.;
  }



  template <int dim>
  bool
  is_stick(const Tensor<1, dim> &Lambda,
           const Tensor<1, dim> &d_t,
           const Regularization &r)
  {
    return (Lambda + r.r_t_status * d_t).norm() <= 1.;
  }



  template <int dim>
  Tensor<1, dim>
  tangential_vector(const Tensor<1, dim - 1>                  &components,
                    const std::array<Tensor<1, dim>, dim - 1> &tau)
  {
    Tensor<1, dim> v;
    for (unsigned int b = 0; b < dim - 1; ++b)
      v += components[b] * tau[b];
    return v;
  }



  template <int dim>
  void
  evaluate_contact_law(const ContactKinematics<dim> &kinematics,
                       const Multipliers<dim>       &multipliers,
                       const ContactStatus          &status,
                       const Threshold               threshold,
                       const double                  mu,
                       const double                  given_threshold,
                       const Regularization         &r,
                       const bool                    differentiate,
                       ContactResponse<dim>         &response)
  {
    using G             = GeneralizedCoordinates<dim>;
    const auto  &k      = kinematics;
    const double lambda = multipliers.lambda_n;
    const double S_c    = status.closed ? 1. : 0.;

    // normal part
    const double pressure = lambda - r.r_n_augmentation * k.d_n;
    response.traction     = -S_c * pressure * k.n;
    response.row_lambda =
      -(lambda - S_c * (lambda - r.r_n_law * k.d_n)) / r.r_n_law;
    if (differentiate)
      {
        response.D_row_lambda.fill(0.);
        response.D_row_lambda[G::lambda] = -(1. - S_c) / r.r_n_law;
        for (unsigned int c = 0; c < G::n; ++c)
          {
            response.D_row_lambda[c] -= S_c * k.D_d_n[c];
            const double D_pressure =
              (c == G::lambda) - r.r_n_augmentation * k.D_d_n[c];
            for (unsigned int i = 0; i < dim; ++i)
              response.D_traction[i][c] =
                -S_c * (k.n[i] * D_pressure + pressure * k.D_n[i][c]);
          }
        for (auto &row : response.D_row_Lambda)
          row.fill(0.);
      }
    response.row_Lambda = Tensor<1, dim - 1>();
    response.threshold  = 0.;
    if (threshold == Threshold::none)
      return;

    // friction part
    double s = given_threshold;
    if (threshold == Threshold::augmented)
      s = std::max(-mu * pressure, 0.);
    else if (threshold == Threshold::plain)
      s = -mu * lambda;
    // a pressure of roundoff would make Lambda as large as its inverse
    if (std::abs(s) <= r.negligible_threshold)
      s = 0.;
    response.threshold = s;
    if (!status.closed || s == 0.)
      {
        response.row_Lambda = -r.open_scale * multipliers.Lambda;
        if (differentiate)
          for (unsigned int b = 0; b < dim - 1; ++b)
            response.D_row_Lambda[b][G::Lambda + b] = -r.open_scale;
        if (!status.closed)
          return;
      }

    const Tensor<1, dim> Lambda =
      tangential_vector<dim>(multipliers.Lambda, k.tau);
    const auto force =
      friction_direction(Lambda + r.r_t_augmentation * k.d_t, status.stick);
    const auto law =
      friction_direction(Lambda + r.r_t_law * k.d_t, status.stick);
    response.traction += s * force.T;
    Tensor<1, dim> mismatch = law.T - Lambda;
    if (k.is_held)
      mismatch -=
        k.held *
        (law.T - tangential_vector<dim>(multipliers.kept_Lambda, k.tau));
    if (s != 0.)
      for (unsigned int b = 0; b < dim - 1; ++b)
        response.row_Lambda[b] = s / r.r_t_law * (k.tau[b] * mismatch);
    if (!differentiate)
      return;

    for (unsigned int c = 0; c < G::n; ++c)
      {
        double D_s = 0.;
        if (threshold == Threshold::augmented && s > 0.)
          D_s = -mu * ((c == G::lambda) - r.r_n_augmentation * k.D_d_n[c]);
        else if (threshold == Threshold::plain)
          D_s = -mu * (c == G::lambda);

        Tensor<1, dim> D_Lambda, D_kept, D_d_t;
        for (unsigned int i = 0; i < dim; ++i)
          {
            D_d_t[i] = k.D_d_t[i][c];
            for (unsigned int b = 0; b < dim - 1; ++b)
              {
                D_Lambda[i] += k.tau[b][i] * (c == G::Lambda + b) +
                               multipliers.Lambda[b] * k.D_tau[b][i][c];
                D_kept[i] += multipliers.kept_Lambda[b] * k.D_tau[b][i][c];
              }
          }
        const Tensor<1, dim> D_T =
          force.A * (D_Lambda + r.r_t_augmentation * D_d_t);
        for (unsigned int i = 0; i < dim; ++i)
          response.D_traction[i][c] += force.T[i] * D_s + s * D_T[i];
        if (s == 0.)
          continue;
        const Tensor<1, dim> D_law = law.A * (D_Lambda + r.r_t_law * D_d_t);
        Tensor<1, dim>       D_mismatch = D_law - D_Lambda;
        if (k.is_held)
          D_mismatch -= k.held * (D_law - D_kept);
        for (unsigned int b = 0; b < dim - 1; ++b)
          {
            double D_row =
              (k.tau[b] * mismatch) * D_s + s * (k.tau[b] * D_mismatch);
            for (unsigned int i = 0; i < dim; ++i)
              D_row += s * k.D_tau[b][i][c] * mismatch[i];
            response.D_row_Lambda[b][c] = D_row / r.r_t_law;
          }
      }
  }

#define INSTANTIATE(dim)                                                      \
  template bool           is_stick(const Tensor<1, dim> &,                    \
                                   const Tensor<1, dim> &,                    \
                                   const Regularization &);                   \
  template Tensor<1, dim> tangential_vector<dim>(                             \
    const Tensor<1, dim - 1> &, const std::array<Tensor<1, dim>, dim - 1> &); \
  template void evaluate_contact_law(const ContactKinematics<dim> &,          \
                                     const Multipliers<dim> &,                \
                                     const ContactStatus &,                   \
                                     const Threshold,                         \
                                     const double,                            \
                                     const double,                            \
                                     const Regularization &,                  \
                                     const bool,                              \
                                     ContactResponse<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
