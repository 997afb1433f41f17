#include <stickslip/simulation/reference_checks.h>

#include <stickslip/base/user_error.h>

#include <stickslip/simulation/result_expression.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <sstream>

namespace stickslip
{
  namespace
  {
    /// Times closer than this, relative to their size, are the same.
    constexpr double same_time = 1e-9;

    const Choices<ToleranceType> &
    all_tolerance_types()
    {
      static const Choices<ToleranceType> choices = {
        {"relative", ToleranceType::relative},
        {"absolute", ToleranceType::absolute}};
      return choices;
    }



    const Choices<CheckedValue> &
    all_checked_values()
    {
      static const Choices<CheckedValue> choices = {
        {"at the end", CheckedValue::at_the_end},
        {"at a time", CheckedValue::at_a_time},
        {"minimum", CheckedValue::minimum},
        {"maximum", CheckedValue::maximum}};
      return choices;
    }



    /// {time: value} in the steps that have all results of @p expression.
    std::map<double, double>
    values_over_time(const ResultExpression &expression,
                     const ResultHistory    &history)
    {
      std::map<double, double> values;
      if (expression.names().empty())
        return values;
      for (const auto &entry : history.of_steps(expression.names()[0]))
        {
          const double time        = entry.first;
          bool         is_complete = true;
          for (const std::string &name : expression.names())
            is_complete = is_complete && history.of_steps(name).count(time) > 0;
          if (is_complete)
            values[time] = expression.value([&](const std::string &name) {
              return history.of_steps(name).at(time);
            });
        }
      return values;
    }



    double
    value_at(const std::map<double, double> &values,
             const double                    time,
             const std::string              &path)
    {
      for (const auto &[step_time, value] : values)
        if (std::abs(step_time - time) <= same_time * std::abs(time))
          return value;
      std::ostringstream text;
      text << "'" << path << "/Time' is " << time
           << ", but no step of the run ended there.";
      throw UserError(text.str());
    }



    double
    extreme(const std::map<double, double> &values, const bool is_maximum)
    {
      double result = std::numeric_limits<double>::quiet_NaN();
      for (const auto &entry : values)
        if (std::isnan(result) ||
            (is_maximum ? entry.second > result : entry.second < result))
          result = entry.second;
      return result;
    }



    double
    computed_value(const ReferenceCheckParameters &check,
                   const ResultHistory            &history,
                   const std::string              &path)
    {
      const ResultExpression expression(check.quantity,
                                        history.names(),
                                        path + "/Quantity");
      if (check.checked_value == CheckedValue::at_the_end)
        return expression.value(
          [&](const std::string &name) { return history.at_end(name); });
      const auto values = values_over_time(expression, history);
      if (check.checked_value == CheckedValue::at_a_time)
        return value_at(values, check.time, path);
      return extreme(values, check.checked_value == CheckedValue::maximum);
    }



    /// As it is printed among the results; else six digits, but none below a
    /// tenth of the tolerance, where results may be roundoff.
    std::string
    shown_value(const ReferenceCheckParameters &check,
                const double                    value,
                const ResultHistory            &history)
    {
      if (check.checked_value == CheckedValue::at_the_end &&
          !history.text_at_end(check.quantity).empty())
        return history.text_at_end(check.quantity);
      const double largest_difference = check.largest_difference();
      double       shown              = value;
      if (largest_difference > 0. && std::isfinite(value))
        {
          const double unit =
            std::pow(10., std::floor(std::log10(largest_difference)) - 1.);
          if (std::abs(value) < 1e15 * unit)
            shown = std::round(value / unit) * unit;
        }
      std::ostringstream text;
      text << (shown == 0. ? 0. : shown); // not -0
      return text.str();
    }



    std::string
    name_of_value(const ReferenceCheckParameters &check)
    {
      std::ostringstream text;
      switch (check.checked_value)
        {
          case CheckedValue::at_the_end:
            return check.quantity;
          case CheckedValue::at_a_time:
            text << check.quantity << " at t = " << check.time;
            return text.str();
          case CheckedValue::minimum:
            return "minimum of " + check.quantity;
          case CheckedValue::maximum:
            break;
        }
      return "maximum of " + check.quantity;
    }



    void
    add_to_report(const std::string              &name,
                  const ReferenceCheckParameters &check,
                  const ResultHistory            &history,
                  CheckReport                    &report)
    {
      const bool is_relative = check.tolerance_type == ToleranceType::relative;
      const double value     = computed_value(check, history, "Checks/" + name);
      double       error     = std::abs(value - check.expected);
      if (is_relative)
        error /= std::abs(check.expected);
      const bool         holds = error <= check.tolerance; // no nan
      std::ostringstream text;
      text << "Check '" << name << "': " << name_of_value(check) << " = "
           << shown_value(check, value, history) << ", expected "
           << check.expected << " within " << check.tolerance
           << (is_relative ? " (relative)" : "") << ": "
           << (holds ? "holds" : "FALLS SHORT, error ");
      if (!holds)
        text << error;
      text << '\n';
      report.text += text.str();
      if (!holds)
        {
          ++report.n_failed;
          report.failed += text.str();
        }
    }
  } // namespace



  void
  ReferenceCheckParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter(
      "Quantity",
      quantity,
      "A result as it is printed at the end of a run, for "
      "example A_x (displacement of the point A) or "
      "base.force_y (force on the slave of the pair 'base'), "
      "a column of points.csv, resultants.csv, reactions.csv "
      "or statistics.csv, or an expression of them, for "
      "example abs(base.friction_force_x)/base.normal_force_y.");
    add_choice(prm,
               "Value",
               checked_value,
               all_checked_values(),
               "Which one: at the end of the run, at the time 'Time', or the "
               "smallest or largest of all accepted steps.");
    prm.add_parameter("Time",
                      time,
                      "With 'Value = at a time': a load time at which a step "
                      "ends ('Load stepping/Requested times').",
                      Patterns::Double());
    prm.add_parameter("Expected",
                      expected,
                      "The known value.",
                      Patterns::Double());
    prm.add_parameter("Tolerance",
                      tolerance,
                      "Largest difference from it.",
                      Patterns::Double(0.));
    add_choice(prm,
               "Tolerance type",
               tolerance_type,
               all_tolerance_types(),
               "relative (to the known value) or absolute.");
  }



  void
  ReferenceCheckParameters::check(const std::string &path) const
  {
    if (quantity.empty())
      throw UserError("'" + path + "/Quantity' is missing.");
    if (expected == 0. && tolerance_type == ToleranceType::relative)
      throw UserError("'" + path +
                      "/Expected' is 0, to which nothing can be relative. Set "
                      "'Tolerance type = absolute'.");
    if (time != 0. && checked_value != CheckedValue::at_a_time)
      throw UserError("'" + path + "/Time' is given, but 'Value' is '" +
                      name_of(checked_value, all_checked_values()) +
                      "'. Set 'Value = at a time' or remove it.");
    if (checked_value == CheckedValue::at_a_time && !(time > 0.))
      throw UserError("'" + path +
                      "/Time' has to be greater than 0 with 'Value = at a "
                      "time'.");
  }



  double
  ReferenceCheckParameters::largest_difference() const
  {
    return tolerance * (tolerance_type == ToleranceType::relative
                          ? std::abs(expected)
                          : 1.);
  }



  void
  check_quantities(const ReferenceChecks &checks,
                   const ResultTables    &tables,
                   const MPI_Comm         communicator)
  {
    on_first_rank(
      [&] {
        const ResultHistory history(tables, {});
        for (const auto &[name, check] : checks)
          ResultExpression(check.quantity,
                           history.names(),
                           "Checks/" + name + "/Quantity");
      },
      communicator);
  }



  CheckReport
  evaluate_checks(const ReferenceChecks &checks,
                  const ResultTables    &tables,
                  const NamedValues     &at_end,
                  const MPI_Comm         communicator)
  {
    CheckReport report;
    on_first_rank(
      [&] {
        const ResultHistory history(tables, at_end);
        for (const auto &[name, check] : checks)
          add_to_report(name, check, history, report);
      },
      communicator);
    report.n_failed = Utilities::MPI::max(report.n_failed, communicator);
    return report;
  }
} // namespace stickslip
