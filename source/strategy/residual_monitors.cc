#include <stickslip/strategy/residual_monitors.h>

#include <algorithm>
#include <cmath>

namespace stickslip
{
  namespace
  {
    /// Growth of the residual beyond which an iteration diverges.
    constexpr double divergence_factor = 1e12;

    /// Iterations whose smallest merits are compared: cycles of two and three
    /// states are as long at most.
    constexpr unsigned int n_compared = 3;
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



  void
  DescentMonitor::add(const double merit)
  {
    if (last.empty())
      first = merit;
    smallest = std::min(smallest, merit);
    last.push_back(merit);
    if (last.size() > n_compared)
      smallest_before =
        std::min(smallest_before, last[last.size() - n_compared - 1]);
    if (last.size() > 2 * n_compared)
      last.pop_front();
  }



  bool
  DescentMonitor::descends() const
  {
    if (last.size() < 2 * n_compared)
      return false;
    const auto middle = last.begin() + n_compared;
    return *std::min_element(middle, last.end()) <
           clearly_smaller * *std::min_element(last.begin(), middle);
  }



  bool
  DescentMonitor::is_on_its_way() const
  {
    return last.size() == 2 * n_compared &&
           smallest < worth_going_on * smallest_before;
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
