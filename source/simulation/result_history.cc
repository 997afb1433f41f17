#include <stickslip/simulation/result_history.h>

#include <limits>

namespace stickslip
{
  ResultHistory::ResultHistory(
    const std::vector<const StatisticsTable *> &tables,
    const NamedValues                          &at_end)
  {
    for (const NamedResultValue &result : at_end)
      {
        known.push_back(result.name);
        end[result.name] = result;
      }
    for (const StatisticsTable *table : tables)
      for (const std::string &name : table->column_names())
        {
          const auto numbers = table->numbers(name);
          if (numbers.empty() || !steps.emplace(name, numbers).second)
            continue;
          if (end.count(name) == 0)
            known.push_back(name);
        }
  }



  double
  ResultHistory::at_end(const std::string &name) const
  {
    if (const auto found = end.find(name); found != end.end())
      return found->second.value;
    const auto &values = of_steps(name);
    return values.empty() ? std::numeric_limits<double>::quiet_NaN()
                          : values.rbegin()->second;
  }



  std::string
  ResultHistory::text_at_end(const std::string &name) const
  {
    const auto found = end.find(name);
    return found == end.end() ? std::string() : found->second.text;
  }



  const std::map<double, double> &
  ResultHistory::of_steps(const std::string &name) const
  {
    static const std::map<double, double> none;
    const auto                            found = steps.find(name);
    return found == steps.end() ? none : found->second;
  }
} // namespace stickslip
