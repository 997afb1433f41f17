#include <stickslip/base/add_scaled.h>

#include <stickslip/base/vectorized.h>

namespace stickslip
{
  STICKSLIP_VECTORIZED void
  add_scaled(const double factor, const std::vector<double> &x, double *sum)
  {
    using Lanes               = FourLanes;
    const unsigned int n      = x.size();
    const unsigned int n_full = n - n % 4;
    for (unsigned int k = 0; k < n_full; k += 4)
      Lanes::store(sum + k, Lanes::load(sum + k) + factor * Lanes::load(&x[k]));
    for (unsigned int k = n_full; k < n; ++k)
      sum[k] += factor * x[k];
  }
} // namespace stickslip
