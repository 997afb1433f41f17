#ifndef stickslip_strategy_residual_monitors_h
#define stickslip_strategy_residual_monitors_h

#include <stickslip/strategy/newton_problem.h>

#include <limits>

namespace stickslip
{
  /// The size of a residual: its largest part. NaN if one is.
  double
  residual_size(const NewtonIteration &state);



  /// So many iterations in a row that do not reduce the smallest residual so
  /// far to less than this fraction are a stagnation.
  struct StagnationWindow
  {
    double       reduction;
    unsigned int iterations;
  };



  /// Sees whether iterations have made the residual clearly smaller than it
  /// ever was.
  class StagnationMonitor
  {
  public:
    explicit StagnationMonitor(const StagnationWindow &window);

    void
    add(const double residual);

    bool
    stagnates() const;

  private:
    StagnationWindow window;
    double           smallest = std::numeric_limits<double>::max();
    unsigned int     count    = 0; ///< iterations without a clear reduction
  };



  /// Sees whether the residual has grown beyond all bounds.
  class DivergenceMonitor
  {
  public:
    explicit DivergenceMonitor(const double start);

    /// The first residual that is added is a reference like that of the start:
    /// the first iteration applies prescribed displacements.
    void
    add(const double residual);

    bool
    diverges() const;

  private:
    double reference;
    double last;
    bool   has_first_iteration = false;
  };
} // namespace stickslip

#endif
