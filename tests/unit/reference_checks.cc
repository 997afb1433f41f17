// Section "Checks": names and expressions of results, at the end, at a time,
// the extremes over the steps; what is printed; what is refused. The results
// are made up: force_y = -4, -2, -6 at t = 0.5, 1, 1.5.

#include <stickslip/base/user_error.h>

#include <stickslip/output/statistics_table.h>

#include <stickslip/simulation/reference_checks.h>
#include <stickslip/simulation/result_expression.h>

#include "print.h"

#include <functional>
#include <string>
#include <vector>

using namespace stickslip;

namespace
{
  void
  print_error(const std::function<void()> &act)
  {
    try
      {
        act();
        print("accepted");
      }
    catch (const UserError &error)
      {
        print(error.what());
      }
  }



  ReferenceCheckParameters
  make_check(const std::string &quantity,
             const CheckedValue value,
             const double       expected,
             const double       tolerance = 1e-6,
             const double       time      = 0.)
  {
    ReferenceCheckParameters check;
    check.quantity      = quantity;
    check.checked_value = value;
    check.expected      = expected;
    check.tolerance     = tolerance;
    check.time          = time;
    return check;
  }



  void
  test_checks()
  {
    StatisticsTable           table("reference_checks_forces", MPI_COMM_WORLD);
    const std::vector<double> forces = {-4., -2., -6.};
    for (unsigned int step = 0; step < forces.size(); ++step)
      {
        table.add("step", step + 1);
        table.add("time", 0.5 * (step + 1));
        table.add("base.force_y", forces[step]);
        table.add("base.force_x", 0.25 * forces[step] * (step + 1.));
        table.add("left corner_x", 1e-3 * step);
        table.add("algorithm", "GNM");
        table.finish_row();
      }
    const NamedValues at_end = {{"base.force_y", -6., "-6"},
                                {"A_x", 1e-19, "0"}};

    const CheckedValue end       = CheckedValue::at_the_end,
                       at        = CheckedValue::at_a_time,
                       minimum   = CheckedValue::minimum,
                       maximum   = CheckedValue::maximum;
    auto absolute                = make_check("A_x", end, 0.);
    absolute.tolerance_type      = ToleranceType::absolute;
    auto noise                   = make_check("left corner_x - 0.002", end, 0.);
    noise.tolerance_type         = ToleranceType::absolute;
    const ReferenceChecks checks = {
      {"name", make_check("base.force_y", end, -6.)},
      {"roundoff", absolute},
      {"noise", noise},
      {"of steps only", make_check("base.force_x", end, -4.5)},
      {"falls short", make_check("base.force_y", end, -5., 0.1)},
      {"minimum", make_check("base.force_y", minimum, -6.)},
      {"maximum", make_check("base.force_y", maximum, -2.)},
      {"time", make_check("base.force_y", at, -2., 1e-6, 1.)},
      {"blank", make_check("left corner_x", maximum, 2e-3)},
      {"ratio", make_check("abs(base.force_x)/base.force_y", maximum, -0.25)},
      {"two extremes",
       make_check("base.force_x - 2*base.force_y", maximum, 7.5)},
      {"function",
       make_check("max(base.force_y, -5) + 2*pi", end, 1.28318531, 1e-8)},
      {"division by zero", make_check("1/A_x", end, 1.)}};
    const CheckReport report =
      evaluate_checks(checks, {&table}, at_end, MPI_COMM_WORLD);
    print(report.text);
    print(std::to_string(report.n_failed) + " fall short:\n" + report.failed);

    const auto evaluate = [&](const ReferenceCheckParameters &check) {
      print_error([&] {
        evaluate_checks({{"a", check}}, {&table}, at_end, MPI_COMM_WORLD);
      });
    };
    evaluate(make_check("base.force_z", end, 1.));
    evaluate(make_check("base.force_y + base.fore_x", end, 1.));
    evaluate(make_check("left corner_y", end, 1.));
    evaluate(make_check("base.force_y *", end, 1.));
    evaluate(make_check("base.force_y", at, 1., 1e-6, 0.75));
    print_error([&] {
      check_quantities({{"a", make_check("force", end, 1.)}},
                       {&table},
                       MPI_COMM_WORLD);
    });
  }



  void
  test_parameters()
  {
    print_error(
      [] { make_check("", CheckedValue::minimum, 1.).check("Checks/a"); });
    print_error(
      [] { make_check("a", CheckedValue::minimum, 0.).check("Checks/a"); });
    print_error([] {
      make_check("a", CheckedValue::minimum, 1., 0., 2.).check("Checks/a");
    });
    print_error(
      [] { make_check("a", CheckedValue::at_a_time, 1.).check("Checks/a"); });
    print_error([] {
      make_check("a", CheckedValue::at_a_time, 1., 0., 2.).check("Checks/a");
    });
  }
} // namespace



int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_checks();
  test_parameters();
}
