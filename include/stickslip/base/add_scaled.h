#ifndef stickslip_base_add_scaled_h
#define stickslip_base_add_scaled_h

#include <vector>

namespace stickslip
{
  /// sum[k] += factor * x[k] for all entries of @p x.
  void
  add_scaled(const double factor, const std::vector<double> &x, double *sum);
} // namespace stickslip

#endif
