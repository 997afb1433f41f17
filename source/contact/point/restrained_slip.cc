#include <stickslip/contact/point/restrained_slip.h>

namespace stickslip
{
  template <int dim>
  Tensor<2, dim>
  restrain_slip(const std::vector<Tensor<1, dim>> &directions,
                const bool                         differentiate,
                ContactKinematics<dim>            &kinematics)
  {
    Tensor<2, dim> projector;
    if (directions.empty())
      return projector;
    const Tensor<1, dim> n = kinematics.n;
    projector =
      Tensor<2, dim>(unit_symmetric_tensor<dim>()) - outer_product(n, n);
    const auto D_d_t = kinematics.D_d_t;
    for (auto &row : kinematics.D_d_t)
      row.fill(0.);
    const Tensor<1, dim> d_t = kinematics.d_t;
    kinematics.d_t           = Tensor<1, dim>();
    if constexpr (dim == 3)
      if (directions.size() == 1)
        {
          // slip is left along f = n x h / |n x h|
          const Tensor<1, dim> &h      = directions[0];
          Tensor<1, dim>        f      = cross_product_3d(n, h);
          const double          length = f.norm();
          f /= length;
          projector -= outer_product(f, f);
          kinematics.d_t = (f * d_t) * f;
          if (!differentiate)
            return projector;
          for (unsigned int c = 0; c < D_d_t[0].size(); ++c)
            {
              Tensor<1, dim> D_n, D_slip;
              for (unsigned int i = 0; i < dim; ++i)
                {
                  D_n[i]    = kinematics.D_n[i][c];
                  D_slip[i] = D_d_t[i][c];
                }
              Tensor<1, dim> D_f = cross_product_3d(D_n, h);
              D_f                = (D_f - (f * D_f) * f) / length;
              const Tensor<1, dim> column =
                (D_f * d_t + f * D_slip) * f + (f * d_t) * D_f;
              for (unsigned int i = 0; i < dim; ++i)
                kinematics.D_d_t[i][c] = column[i];
            }
        }
    (void)differentiate;
    return projector;
  }



  template <int dim>
  void
  restrain_Lambda(const ContactKinematics<dim> &kinematics,
                  const Multipliers<dim>       &multipliers,
                  const Tensor<2, dim>         &projector,
                  const Tensor<1, dim - 1>     &restrained_Lambda,
                  const double                  r_t_law,
                  const bool                    differentiate,
                  ContactResponse<dim>         &response)
  {
    const double s = response.threshold;
    if (s == 0.)
      return;
    const auto &tau = kinematics.tau;
    // The rows as a vector of the tangent plane lose their restrained part and
    // get s / r (Lambda_restrained - Lambda) instead.
    const Tensor<1, dim - 1> missing =
      (restrained_Lambda - multipliers.Lambda) / r_t_law;
    const Tensor<1, dim> missing_vector = tangential_vector<dim>(missing, tau);
    const Tensor<1, dim - 1> law_rows   = response.row_Lambda;
    const Tensor<1, dim>     law_vector = tangential_vector<dim>(law_rows, tau);
    const Tensor<1, dim>     vector =
      law_vector + projector * (s * missing_vector - law_vector);
    for (unsigned int b = 0; b < dim - 1; ++b)
      response.row_Lambda[b] = tau[b] * vector;
    if (!differentiate)
      return;

    using G           = GeneralizedCoordinates<dim>;
    const auto &D_tau = kinematics.D_tau;
    for (unsigned int c = 0; c < G::n; ++c)
      {
        Tensor<1, dim> D_law,
          D_missing = response.D_threshold[c] * missing_vector;
        for (unsigned int b = 0; b < dim - 1; ++b)
          for (unsigned int i = 0; i < dim; ++i)
            {
              D_law[i] += response.D_row_Lambda[b][c] * tau[b][i] +
                          law_rows[b] * D_tau[b][i][c];
              D_missing[i] += s * (missing[b] * D_tau[b][i][c] -
                                   (c == G::Lambda + b) / r_t_law * tau[b][i]);
            }
        const Tensor<1, dim> D_vector = D_law + projector * (D_missing - D_law);
        for (unsigned int b = 0; b < dim - 1; ++b)
          {
            double D_row = tau[b] * D_vector;
            for (unsigned int i = 0; i < dim; ++i)
              D_row += D_tau[b][i][c] * vector[i];
            response.D_row_Lambda[b][c] = D_row;
          }
      }
  }



#define INSTANTIATE(dim)                                                     \
  template Tensor<2, dim> restrain_slip(const std::vector<Tensor<1, dim>> &, \
                                        const bool,                          \
                                        ContactKinematics<dim> &);           \
  template void           restrain_Lambda(const ContactKinematics<dim> &,    \
                                          const Multipliers<dim> &,          \
                                          const Tensor<2, dim> &,            \
                                          const Tensor<1, dim - 1> &,        \
                                          const double,                      \
                                          const bool,                        \
                                          ContactResponse<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
