#include <stickslip/contact/cycling/admissible_scale.h>

#include <cmath>
#include <vector>

namespace stickslip
{
  namespace
  {
    /// How far beyond a bound of eqs. 29 and 32 the new r lies.
    constexpr double beyond_bound = 2.;



    /// The number nearest to @p stiffness at which @p agree holds, if agree()
    /// changes only at @p bounds. 0 if there is none.
    template <typename Predicate>
    double
    nearest_admissible(const double               stiffness,
                       const std::vector<double> &bounds,
                       const Predicate           &agree)
    {
      std::vector<double> candidates = {stiffness};
      for (const double bound : bounds)
        if (bound > 0. && std::isfinite(bound))
          {
            candidates.push_back(bound * beyond_bound);
            candidates.push_back(bound / beyond_bound);
          }
      double best = 0.;
      for (const double r : candidates)
        if (agree(r) && (best == 0. || std::abs(std::log(r / stiffness)) <
                                         std::abs(std::log(best / stiffness))))
          best = r;
      return best;
    }
  } // namespace



  template <int dim>
  double
  admissible_r_n(const StatusState<dim> &a,
                 const StatusState<dim> &b,
                 const double            stiffness)
  {
    return nearest_admissible(
      stiffness, {a.lambda_n / a.d_n, b.lambda_n / b.d_n}, [&](const double r) {
        return (a.lambda_n - r * a.d_n) * (b.lambda_n - r * b.d_n) > 0.;
      });
  }



  template <int dim>
  double
  admissible_r_t(const StatusState<dim> &a,
                 const StatusState<dim> &b,
                 const double            stiffness)
  {
    // |Lambda + r d_t|^2 = 1
    std::vector<double> bounds;
    for (const StatusState<dim> *state : {&a, &b})
      {
        const double square   = state->d_t.norm_square();
        const double product  = state->Lambda * state->d_t;
        const double constant = state->Lambda.norm_square() - 1.;
        const double root     = product * product - square * constant;
        if (square > 0. && root >= 0.)
          for (const double sign : {-1., 1.})
            bounds.push_back((-product + sign * std::sqrt(root)) / square);
      }
    const auto excess = [](const StatusState<dim> &state, const double r) {
      return (state.Lambda + r * state.d_t).norm() - 1.;
    };
    return nearest_admissible(stiffness, bounds, [&](const double r) {
      return excess(a, r) * excess(b, r) > 0.;
    });
  }

#define INSTANTIATE(dim)                                   \
  template double admissible_r_n(const StatusState<dim> &, \
                                 const StatusState<dim> &, \
                                 const double);            \
  template double admissible_r_t(const StatusState<dim> &, \
                                 const StatusState<dim> &, \
                                 const double);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
