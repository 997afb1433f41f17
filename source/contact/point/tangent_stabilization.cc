#include <stickslip/contact/point/tangent_stabilization.h>

#include <cmath>
#include <vector>

namespace stickslip
{
  template <int dim>
  void
  assume_stick_before_first_pressure(const ContactPoint<dim> &point,
                                     ContactEvaluation<dim>  &state)
  {
    const double stiffness = point.scales.initial_stick;
    if (!state.status.closed || state.response.threshold > 0. ||
        stiffness == 0.)
      return;
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int c = 0; c < GeneralizedCoordinates<dim>::n; ++c)
        state.response.D_traction[i][c] +=
          stiffness * state.kinematics.D_d_t[i][c];
  }



  template <int dim>
  void
  hold_touching_node(const ContactPoint<dim> &point,
                     ContactEvaluation<dim>  &state)
  {
    if (state.status.closed || point.scales.initial_contact == 0.)
      return;
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int c = 0; c < GeneralizedCoordinates<dim>::n; ++c)
        state.response.D_traction[i][c] += point.scales.initial_contact *
                                           state.kinematics.n[i] *
                                           state.kinematics.D_d_n[c];
  }



  template <int dim>
  void
  keep_undetermined_Lambda(const ContactPoint<dim>      &point,
                           const ContactEvaluation<dim> &state,
                           const std::vector<double>    &L,
                           const unsigned int            n,
                           FullMatrix<double>           &local)
  {
    // negligible beside the rows of nodes that are free to slip
    constexpr double factor = 1e-9;
    if (!state.status.stick || state.response.threshold <= 0.)
      return;
    const unsigned int first = local.m() - L.size() * n;
    const double       scale = factor * point.geometry.weight *
                         state.response.threshold /
                         point.regularization.r_t_law;
    for (unsigned int l = 0; l < L.size(); ++l)
      for (unsigned int c = 1; c < n; ++c)
        local(first + l * n + c, first + l * n + c) -= scale * std::abs(L[l]);
  }

#define INSTANTIATE(dim)                                                      \
  template void assume_stick_before_first_pressure(const ContactPoint<dim> &, \
                                                   ContactEvaluation<dim> &); \
  template void hold_touching_node(const ContactPoint<dim> &,                 \
                                   ContactEvaluation<dim> &);                 \
  template void keep_undetermined_Lambda(const ContactPoint<dim> &,           \
                                         const ContactEvaluation<dim> &,      \
                                         const std::vector<double> &,         \
                                         const unsigned int,                  \
                                         FullMatrix<double> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
