#include <stickslip/contact/point/contact_law.h>

#include <algorithm>
#include <cmath>

namespace stickslip
{
  namespace
  {
    /// A point that has slipped begins the next step with |Lambda| = 1 and no
    /// slip: it sticks, and roundoff (another number of ranks, a restart) has
    /// no say.
    constexpr double roundoff_of_disc = 1e-12;



    /// s at the point, from lambda_n and from min(lambda_n - r_n d_n, 0).
    double
    threshold_value(const FrictionThreshold &threshold,
                    const double             lambda_n,
                    const double             pressure)
    {
      const double mu = threshold.friction_coefficient;
      double       s  = threshold.given;
      if (threshold.kind == ThresholdKind::augmented)
        s = std::max(-mu * pressure, 0.);
      else if (threshold.kind == ThresholdKind::plain)
        s = -mu * lambda_n;
      // a pressure of roundoff would make Lambda as large as its inverse
      return std::abs(s) <= threshold.negligible ? 0. : s;
    }



    /// ds, from the derivatives of min(lambda_n - r_n d_n, 0) and of d_n.
    template <int dim>
    typename GeneralizedCoordinates<dim>::Row
    threshold_derivative(const FrictionThreshold &threshold,
                         const double             s,
                         const double             slope,
                         const double             r_n,
                         const typename GeneralizedCoordinates<dim>::Row &D_d_n)
    {
      using G         = GeneralizedCoordinates<dim>;
      const double mu = threshold.friction_coefficient;

      typename G::Row D_s;
      D_s.fill(0.);
      if (threshold.kind == ThresholdKind::augmented && s > 0.)
        for (unsigned int c = 0; c < G::n; ++c)
          D_s[c] = -mu * slope * ((c == G::lambda) - r_n * D_d_n[c]);
      else if (threshold.kind == ThresholdKind::plain)
        D_s[G::lambda] = -mu;
      return D_s;
    }
  } // namespace



  double
  augmented_threshold(const double friction_coefficient,
                      const double lambda_n,
                      const double r_n,
                      const double d_n)
  {
    return std::max(-friction_coefficient * (lambda_n - r_n * d_n), 0.);
  }



  bool
  is_closed(const double          lambda_n,
            const double          d_n,
            const Regularization &r,
            const double          negligible)
  {
    return lambda_n - r.r_n_status * d_n <= negligible;
  }



  template <int dim>
  bool
  is_stick(const Tensor<1, dim> &Lambda,
           const Tensor<1, dim> &d_t,
           const Regularization &r)
  {
    return (Lambda + r.r_t_status * d_t).norm() <= 1. + roundoff_of_disc;
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
  evaluate_contact_law(const PointLaw               &point_law,
                       const ContactKinematics<dim> &kinematics,
                       const Multipliers<dim>       &multipliers,
                       const ContactStatus          &status,
                       const bool                    differentiate,
                       ContactResponse<dim>         &response)
  {
    using G             = GeneralizedCoordinates<dim>;
    const auto  &r      = point_law.r;
    const auto  &k      = kinematics;
    const double lambda = multipliers.lambda_n;
    const auto  &width  = point_law.rounding;
    const bool   acts   = status.closed || width.acts();

    // normal part
    const NegativePart pressure =
      negative_part(lambda - r.r_n_augmentation * k.d_n,
                    status.closed,
                    width.pressure);
    const NegativePart law_pressure =
      negative_part(lambda - r.r_n_law * k.d_n, status.closed, width.pressure);
    response.traction   = -pressure.value * k.n;
    response.row_lambda = -(lambda - law_pressure.value) / r.r_n_law;
    if (differentiate)
      {
        response.D_row_lambda.fill(0.);
        response.D_row_lambda[G::lambda] =
          -(1. - law_pressure.slope) / r.r_n_law;
        for (unsigned int c = 0; c < G::n; ++c)
          {
            response.D_row_lambda[c] -= law_pressure.slope * k.D_d_n[c];
            const double D_pressure =
              (c == G::lambda) - r.r_n_augmentation * k.D_d_n[c];
            for (unsigned int i = 0; i < dim; ++i)
              response.D_traction[i][c] =
                -(pressure.slope * k.n[i] * D_pressure +
                  pressure.value * k.D_n[i][c]);
          }
        for (auto &row : response.D_row_Lambda)
          row.fill(0.);
      }
    response.row_Lambda         = Tensor<1, dim - 1>();
    response.threshold          = 0.;
    response.friction_direction = Tensor<1, dim>();
    if (point_law.threshold.kind == ThresholdKind::none)
      return;

    // friction part
    const double s =
      threshold_value(point_law.threshold, lambda, pressure.value);
    response.threshold = acts ? s : 0.;
    if (!acts || s == 0.)
      {
        response.row_Lambda = -point_law.open_row * multipliers.Lambda;
        if (differentiate)
          for (unsigned int b = 0; b < dim - 1; ++b)
            response.D_row_Lambda[b][G::Lambda + b] = -point_law.open_row;
        if (!acts)
          return;
      }

    const Tensor<1, dim> Lambda =
      tangential_vector<dim>(multipliers.Lambda, k.tau);
    const auto force = disc_projection(Lambda + r.r_t_augmentation * k.d_t,
                                       status.stick,
                                       width.disc);
    const auto law =
      disc_projection(Lambda + r.r_t_law * k.d_t, status.stick, width.disc);
    response.traction += s * force.T;
    response.friction_direction   = force.T;
    const Tensor<1, dim> mismatch = law.T - Lambda;
    if (s != 0.)
      for (unsigned int b = 0; b < dim - 1; ++b)
        response.row_Lambda[b] = s / r.r_t_law * (k.tau[b] * mismatch);
    if (!differentiate)
      return;

    response.D_threshold = threshold_derivative<dim>(
      point_law.threshold, s, pressure.slope, r.r_n_augmentation, k.D_d_n);
    for (unsigned int c = 0; c < G::n; ++c)
      {
        const double   D_s = response.D_threshold[c];
        Tensor<1, dim> D_Lambda, D_d_t;
        for (unsigned int i = 0; i < dim; ++i)
          {
            D_d_t[i] = k.D_d_t[i][c];
            for (unsigned int b = 0; b < dim - 1; ++b)
              D_Lambda[i] += k.tau[b][i] * (c == G::Lambda + b) +
                             multipliers.Lambda[b] * k.D_tau[b][i][c];
          }
        const Tensor<1, dim> D_T =
          force.derivative * (D_Lambda + r.r_t_augmentation * D_d_t);
        for (unsigned int i = 0; i < dim; ++i)
          response.D_traction[i][c] += force.T[i] * D_s + s * D_T[i];
        if (s == 0.)
          continue;
        const Tensor<1, dim> D_law =
          law.derivative * (D_Lambda + r.r_t_law * D_d_t);
        const Tensor<1, dim> D_mismatch = D_law - D_Lambda;
        for (unsigned int b = 0; b < dim - 1; ++b)
          {
            double D_row = s * (k.tau[b] * D_mismatch);
            if (!point_law.holds_at_point)
              D_row += (k.tau[b] * mismatch) * D_s;
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
  template void evaluate_contact_law(const PointLaw &,                        \
                                     const ContactKinematics<dim> &,          \
                                     const Multipliers<dim> &,                \
                                     const ContactStatus &,                   \
                                     const bool,                              \
                                     ContactResponse<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
