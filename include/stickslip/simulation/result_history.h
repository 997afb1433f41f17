#ifndef stickslip_simulation_result_history_h
#define stickslip_simulation_result_history_h

#include <stickslip/output/statistics_table.h>

#include <map>
#include <string>
#include <vector>

namespace stickslip
{
  /// A final result: its value, and what is printed of it.
  struct NamedResultValue
  {
    std::string name;
    double      value;
    std::string text;
  };

  using NamedValues = std::vector<NamedResultValue>;

  /**
   * What a run knows of its results by name: the values at its end, and those
   * of its accepted steps, as its tables have them (of a run that continues
   * another, the earlier steps as well, if they are in its output directory).
   * On rank 0.
   */
  class ResultHistory
  {
  public:
    ResultHistory(const std::vector<const StatisticsTable *> &tables,
                  const NamedValues                          &at_end);

    /// Those at the end first, in their order.
    const std::vector<std::string> &
    names() const
    {
      return known;
    }

    /// nan if it has none.
    double
    at_end(const std::string &name) const;

    /// What has been printed of it; empty if nothing has.
    std::string
    text_at_end(const std::string &name) const;

    /// {time: value} of the steps in which the result was written.
    const std::map<double, double> &
    of_steps(const std::string &name) const;

  private:
    std::vector<std::string>                        known;
    std::map<std::string, NamedResultValue>         end;
    std::map<std::string, std::map<double, double>> steps;
  };
} // namespace stickslip

#endif
