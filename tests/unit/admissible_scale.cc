// The r_n and r_t that stop a cycle (paper, eqs. 29 and 32): the statuses of
// both states agree, no scanned r nearer to the natural one does by more than
// the margin, and where no r helps none is found.

#include <stickslip/contact/cycling/admissible_scale.h>

#include <cmath>
#include <functional>
#include <iostream>
#include <random>
#include <string>

using namespace stickslip;

namespace
{
  template <int dim>
  bool
  agree_n(const StatusState<dim> &a, const StatusState<dim> &b, const double r)
  {
    return (a.lambda_n - r * a.d_n) * (b.lambda_n - r * b.d_n) > 0.;
  }

  template <int dim>
  bool
  agree_t(const StatusState<dim> &a, const StatusState<dim> &b, const double r)
  {
    return ((a.Lambda + r * a.d_t).norm() - 1.) *
             ((b.Lambda + r * b.d_t).norm() - 1.) >
           0.;
  }

  /// Counts pairs of random states by what was found, and wrong findings.
  template <int dim>
  void
  scan(const std::string                                     &what,
       const std::function<double(const StatusState<dim> &,
                                  const StatusState<dim> &)> &find,
       const std::function<bool(const StatusState<dim> &,
                                const StatusState<dim> &,
                                const double)>               &agree)
  {
    std::mt19937                           random(dim);
    std::uniform_real_distribution<double> value(-1.5, 1.5);
    unsigned int natural = 0, other = 0, none = 0, wrong = 0, too_far = 0;
    for (unsigned int sample = 0; sample < 1000; ++sample)
      {
        StatusState<dim> states[2];
        for (auto &state : states)
          {
            state.lambda_n = value(random);
            state.d_n      = value(random);
            for (unsigned int d = 0; d < dim; ++d)
              {
                state.Lambda[d] = value(random);
                state.d_t[d]    = value(random);
              }
          }
        const double r = find(states[0], states[1]);
        if (r == 1.)
          ++natural;
        else if (r > 0.)
          ++other;
        else
          ++none;
        wrong += r > 0. && !agree(states[0], states[1], r);
        // a margin of 2 on both sides of a bound, so 4 beyond what is nearest
        for (int i = -400; i <= 400; ++i)
          {
            const double tried  = std::pow(10., i / 100.);
            bool         inside = true; // an interval as wide as both margins
            for (const double factor : {0.25, 0.5, 1., 2., 4.})
              inside = inside && agree(states[0], states[1], factor * tried);
            if (inside && (r == 0. || std::abs(std::log(tried)) + std::log(4.) <
                                        std::abs(std::log(r))))
              {
                ++too_far;
                break;
              }
          }
      }
    std::cout << what << ": natural " << natural << ", other " << other
              << ", none " << none << "; wrong " << wrong << ", too far "
              << too_far << '\n';
  }

  template <int dim>
  void
  scan_both()
  {
    using State = StatusState<dim>;
    std::cout << dim << "D\n";
    scan<dim>(
      "  r_n",
      [](const State &a, const State &b) { return admissible_r_n(a, b, 1.); },
      agree_n<dim>);
    scan<dim>(
      "  r_t",
      [](const State &a, const State &b) { return admissible_r_t(a, b, 1.); },
      agree_t<dim>);
  }
} // namespace



int
main()
{
  // closed at r < 2, open beyond; the other always closed
  StatusState<2> a, b;
  a.lambda_n = -2.;
  a.d_n      = -1.;
  b.lambda_n = -1.;
  b.d_n      = 1.;
  std::cout << "bound 2, natural 10: " << admissible_r_n(a, b, 10.) << '\n'
            << "bound 2, natural 0.1: " << admissible_r_n(a, b, 0.1) << '\n';
  // one always closed, one always open
  a.d_n      = 0.;
  b.lambda_n = 1.;
  b.d_n      = -1.;
  std::cout << "no bound: " << admissible_r_n(a, b, 10.) << '\n';
  // slip beyond r = 0.5; the other sticks up to 2
  a.Lambda[0] = 0.5;
  a.d_t[0]    = 1.;
  b.d_t[0]    = 0.5;
  std::cout << "slip from 0.5 and from 2, natural 1: "
            << admissible_r_t(a, b, 1.) << '\n';
  scan_both<2>();
  scan_both<3>();
}
