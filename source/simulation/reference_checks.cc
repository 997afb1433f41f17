#include <stickslip/simulation/reference_checks.h>

#include <stickslip/base/nearest_name.h>
#include <stickslip/base/user_error.h>

#include <algorithm>
#include <cmath>
#include <ostream>

namespace stickslip
{
  namespace
  {
    const Choices<ToleranceType> &
    all_tolerance_types()
    {
      static const Choices<ToleranceType> choices = {
        {"relative", ToleranceType::relative},
        {"absolute", ToleranceType::absolute}};
      return choices;
    }
  } // namespace



  void
  ReferenceCheckParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Quantity",
                      quantity,
                      "A result as it is printed at the end of a run, for "
                      "example A_x (displacement of the point A) or "
                      "base.force_y (force on the slave of the pair 'base').");
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
  }



  unsigned int
  evaluate_checks(
    const std::vector<std::pair<std::string, ReferenceCheckParameters>> &checks,
    const NamedValues &results,
    std::ostream      &out)
  {
    unsigned int n_failed = 0;
    for (const auto &[name, check] : checks)
      {
        std::vector<std::string> known;
        const double            *found = nullptr;
        for (const auto &result : results)
          {
            known.push_back(result.first);
            if (result.first == check.quantity)
              found = &result.second;
          }
        if (found == nullptr)
          throw UserError("'Checks/" + name +
                          "/Quantity': there is no result '" + check.quantity +
                          "'." + did_you_mean(check.quantity, known) +
                          " Known: " + quoted_list(known) + ".");
        double error = std::abs(*found - check.expected);
        if (check.tolerance_type == ToleranceType::relative)
          error /= std::abs(check.expected);
        const bool holds = error <= check.tolerance;
        n_failed += holds ? 0 : 1;
        out << "Check '" << name << "': " << check.quantity << " = "
            << check.expected << " within " << check.tolerance
            << (check.tolerance_type == ToleranceType::relative ? " (relative)"
                                                                : "")
            << ": " << (holds ? "holds" : "FALLS SHORT, error ");
        if (!holds)
          out << error;
        out << std::endl;
      }
    return n_failed;
  }
} // namespace stickslip
