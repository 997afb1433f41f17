#ifndef stickslip_strategy_residual_monitors_h
#define stickslip_strategy_residual_monitors_h

#include <stickslip/strategy/newton_problem.h>

#include <deque>
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



  /// Sees whether the last iterations are on their way down, wherever the
  /// residual was before: a transient that goes far up first is no stagnation.
  class DescentMonitor
  {
  public:
    void
    add(const double merit);

    /// The smallest of the last three is clearly smaller than that of the three
    /// before them.
    bool
    descends() const;

    /// It is less than half of all before: not only back from where the
    /// iterations have led away.
    bool
    is_on_its_way() const;

    /// It has been a small part of the first one: what is left to do concerns
    /// few points.
    bool
    has_been_far_down() const
    {
      return smallest < far_down * first;
    }

  private:
    static constexpr double clearly_smaller = 0.9;
    static constexpr double worth_going_on  = 0.5;
    static constexpr double far_down        = 1e-3;

    std::deque<double> last; ///< the newest at the end
    double             first           = 0.;
    double             smallest_before = std::numeric_limits<double>::max();
    double             smallest        = std::numeric_limits<double>::max();
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
