#include <stickslip/strategy/residual_monitors.h>

#include <algorithm>
#include <cmath>

namespace stickslip
{
  namespace
  {
    /// Growth of the residual beyond which an iteration diverges.
    constexpr double divergence_factor = 1e12;
  } // namespace



  double
  residual_size(const NewtonIteration &state)
  {
    return std::isnan(state.contact)
             ? state.contact
             : std::max(state.equilibrium, state.contact);
  }



  StagnationMonitor::StagnationMonitor(const StagnationWindow &window)
    : window(window)
  {}



  void
  StagnationMonitor::add(const double residual)
  {
    count    = residual < window.reduction * smallest ? 0 : count + 1;
    smallest = std::min(smallest, residual);
  }



  bool
  StagnationMonitor::stagnates() const
  {
    return count >= window.iterations;
  }



  DivergenceMonitor::DivergenceMonitor(const double start)
    : reference(std::max(start, 1.))
    , last(start)
  {}



  void
  DivergenceMonitor::add(const double residual)
  {
    if (!has_first_iteration)
      reference = std::max(reference, residual);
    has_first_iteration = true;
    last                = residual;
  }



  bool
  DivergenceMonitor::diverges() const
  {
    return last > divergence_factor * reference;
  }
} // namespace stickslip
