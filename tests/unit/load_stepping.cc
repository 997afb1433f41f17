// Sizes of load steps for scalar problems whose answers are known: one that
// Newton's method solves only in steps below a certain size, one with a limit
// point, one that becomes easier on the way; requested times; and times that no
// step can end at.

#include <stickslip/strategy/load_stepping.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

using namespace stickslip;

namespace
{
  void
  print(const std::string &text, const bool holds)
  {
    std::cout << "  " << text << ": " << (holds ? "yes" : "NO") << '\n';
  }



  /// f(x, t) = 0 and df/dx.
  struct ScalarProblem
  {
    std::function<double(double, double)> residual;
    std::function<double(double, double)> slope;
  };



  /// Newton's method from @p x; returns its iterations, 0 if there was no
  /// convergence in 30.
  unsigned int
  newton(const ScalarProblem &problem, const double t, double &x)
  {
    for (unsigned int iteration = 1; iteration <= 30; ++iteration)
      {
        x -= problem.residual(x, t) / problem.slope(x, t);
        if (!std::isfinite(x))
          return 0;
        if (std::abs(problem.residual(x, t)) < 1e-12)
          return iteration;
      }
    return 0;
  }



  struct Path
  {
    std::vector<double> times{0.}; ///< accepted
    unsigned int        n_cuts  = 0;
    bool                is_done = false;

    std::vector<double>
    sizes() const
    {
      std::vector<double> result;
      for (unsigned int i = 1; i < times.size(); ++i)
        result.push_back(times[i] - times[i - 1]);
      return result;
    }

    bool
    hits(const double time) const
    {
      return std::find(times.begin(), times.end(), time) != times.end();
    }
  };



  /// Follows the solution from @p x at t = 0 as far as the steps allow it.
  Path
  follow(const ScalarProblem          &problem,
         double                        x,
         const LoadSteppingParameters &parameters)
  {
    Path         path;
    LoadStepping steps(parameters);
    while (!steps.finished())
      {
        double             trial = x;
        const unsigned int n     = newton(problem, steps.next_time(), trial);
        if (n > 0)
          {
            x = trial;
            steps.accept_step(n);
            path.times.push_back(steps.time());
          }
        else if (steps.cut_step())
          ++path.n_cuts;
        else
          return path;
      }
    path.is_done = true;
    return path;
  }



  /// From x = t0 Newton's method for atan(x - t) = 0 converges if t - t0 is
  /// below the root of 2 d = (1 + d^2) atan(d), and else diverges.
  const double        largest_step = 1.391745200270735;
  const ScalarProblem arctangent   = {[](const double x, const double t) {
                                      return std::atan(x - t);
                                    },
                                      [](const double x, const double t) {
                                      return 1. / (1. + (x - t) * (x - t));
                                    }};



  void
  test_step_size()
  {
    std::cout << "Newton converges in steps below 1.39 only:\n";
    LoadSteppingParameters parameters;
    parameters.end_time        = 60.;
    parameters.initial_step    = 4.;
    parameters.requested_times = {17.3, 41.};
    const Path path            = follow(arctangent, 0., parameters);
    const auto sizes           = path.sizes();
    print("the end is reached", path.is_done && path.times.back() == 60.);
    print("no accepted step is larger",
          *std::max_element(sizes.begin(), sizes.end()) < largest_step);
    print("requested times are hit exactly", path.hits(17.3) && path.hits(41.));
    print("no rest is left over: all steps above 0.3",
          *std::min_element(sizes.begin(), sizes.end()) > 0.3);
    // growth waits for 2, 4, then 8 easy steps after each cut
    print("the first step is 4 / 4", sizes[0] == 1.);
    print("growth is tried less and less often: at most 2 + 60 / 8 cuts",
          path.n_cuts >= 3 && path.n_cuts <= 9);
  }



  void
  test_limit_point()
  {
    std::cout << "t = 1 - x^2 has no solution beyond t = 1:\n";
    LoadSteppingParameters parameters;
    parameters.end_time     = 2.;
    parameters.initial_step = 0.3;
    parameters.minimum_step = 1e-3;
    const ScalarProblem limit{
      [](const double x, const double t) { return 1. - x * x - t; },
      [](const double x, const double) { return -2. * x; }};
    const Path path = follow(limit, -1., parameters);
    print("the run stops", !path.is_done);
    print("below the limit", path.times.back() <= 1.);
    print("by less than two of the smallest steps",
          1. - path.times.back() < 2e-3);
  }



  void
  test_growth()
  {
    std::cout << "Steps of at most 1 up to t = 10, then of any size:\n";
    LoadSteppingParameters parameters;
    parameters.end_time      = 200.;
    parameters.initial_step  = 1.;
    parameters.maximum_step  = 8.;
    parameters.growth_factor = 2.;
    LoadStepping steps(parameters);
    std::cout << " ";
    unsigned int n_since_cut = 0;
    while (steps.step_size() < 8. || steps.time() < 10.)
      {
        const double size = steps.next_time() - steps.time();
        if (size > 1. && steps.time() < 10.)
          {
            std::cout << " (" << size << ')';
            steps.cut_step();
            n_since_cut = 0;
            continue;
          }
        std::cout << ' ' << size;
        ++n_since_cut;
        steps.accept_step(5);
      }
    std::cout << '\n';
    print("waits of 8, 4 and 2 steps after the last cut",
          n_since_cut == 8 + 4 + 2);

    LoadStepping hard(parameters);
    for (unsigned int i = 0; i < 5; ++i)
      hard.accept_step(parameters.easy_iterations + 1);
    print("no growth after steps that are not easy", hard.step_size() == 1.);
    hard.accept_step(parameters.easy_iterations);
    print("growth after one that just is", hard.step_size() == 2.);
  }



  void
  test_targets()
  {
    std::cout << "Requested times and rests:\n";
    LoadSteppingParameters parameters;
    parameters.end_time        = 3.;
    parameters.initial_step    = 1.;
    parameters.requested_times = {2.7, 0.4};
    LoadStepping steps(parameters);
    print("a target within the step is its end", steps.next_time() == 0.4);
    print("asking changes nothing", steps.next_time() == 0.4);
    steps.accept_step(50);
    print("the requested time is known as such", steps.is_at_requested_time());
    steps.accept_step(50);
    print("a whole step", std::abs(steps.time() - 1.4) < 1e-15);
    print("... is not at a requested time", !steps.is_at_requested_time());
    steps.cut_step();
    steps.accept_step(50);
    steps.accept_step(50);
    print("steps of 0.5 after a cut", std::abs(steps.time() - 2.4) < 1e-15);
    steps.accept_step(50);
    steps.accept_step(50);
    print("the end", steps.finished() && steps.time() == 3.);

    LoadSteppingParameters rest;
    rest.end_time     = 1.2;
    rest.initial_step = 0.5;
    rest.maximum_step = 1.;
    LoadStepping sharing(rest);
    sharing.accept_step(50);
    print("a rest of 1.4 steps is made in two equal ones",
          std::abs(sharing.next_time() - 0.85) < 1e-15);
    rest.maximum_step = 0.5;
    LoadStepping largest(rest);
    largest.accept_step(50);
    print("... but not where steps are as large as they may be",
          largest.next_time() == 1.);
  }



  void
  test_minimum()
  {
    std::cout << "The smallest step:\n";
    LoadSteppingParameters parameters;
    parameters.initial_step = 0.8;
    parameters.minimum_step = 0.2;
    LoadStepping steps(parameters);
    print("0.8 can be cut", steps.can_be_cut() && steps.cut_step());
    print("0.4 can be cut, to just the minimum",
          steps.can_be_cut() && steps.cut_step());
    print("0.2 cannot", !steps.can_be_cut());
    std::cout << "  " << steps.describe_last_step() << '\n';
    print("... and the last cut says so", !steps.cut_step());
    LoadStepping continued(parameters);
    continued.resume(steps.state());
    print("a run that continues takes the smallest step",
          continued.step_size() == 0.2);
  }



  /// Steps of 0.4 to t = 1; contact changes at 0.3, and at 0.55 back.
  void
  test_contact_changes()
  {
    std::cout << "Steps that end where contact changes:\n";
    LoadSteppingParameters parameters;
    parameters.initial_step             = 0.4;
    parameters.locates_contact_changes  = true;
    parameters.contact_change_tolerance = 0.01;
    const auto is_closed                = [](const double time) {
      return time >= 0.3 && time < 0.55;
    };
    LoadStepping steps(parameters);
    while (!steps.finished())
      {
        std::cout << "  from " << steps.time() << ":";
        do
          std::cout << ' ' << steps.next_time();
        while (steps.locate_contact_change(is_closed(steps.next_time()) !=
                                           is_closed(steps.time())));
        steps.accept_step(50);
        std::cout << '\n';
      }
    print("nothing known: any size", size_up_to_change({0.4, 0.}, 0.01) == 0.4);
    print("a change somewhere: half",
          size_up_to_change({0., 0.4}, 0.01) == 0.2);
    print("near enough: the size with the change",
          size_up_to_change({0.305, 0.31}, 0.01) == 0.31);

    LoadStepping failing(parameters);
    failing.locate_contact_change(true);
    print("half a step", failing.next_time() == 0.2);
    print("... that fails is no cut, but ends the search",
          failing.can_be_cut() && failing.cut_step() &&
            failing.next_time() == 0.4 && !failing.locate_contact_change(true));
    parameters.locates_contact_changes = false;
    LoadStepping off(parameters);
    print("not asked for: no search",
          !off.locate_contact_change(true) && off.next_time() == 0.4);
  }



  /// What is tried, in steps of 0.1 down to 0.025, where no step can end
  /// between 0.46 and @p end.
  LoadStepping
  pass_gap(const double end, const LoadSteppingParameters &parameters)
  {
    LoadStepping steps(parameters);
    while (!steps.finished())
      {
        const double time = steps.next_time();
        std::cout << ' ' << time;
        if (time < 0.46 || time > end)
          {
            if (steps.is_leaping())
              std::cout << " (leap)";
            steps.accept_step(50);
          }
        else if (steps.can_be_cut() ? !steps.cut_step() : !steps.leap())
          break;
      }
    std::cout << '\n';
    return steps;
  }



  void
  test_leaps()
  {
    std::cout << "Times without a state:\n";
    LoadSteppingParameters parameters;
    parameters.initial_step = 0.1;
    parameters.minimum_step = 0.025;
    std::cout << "  from 0.46 to 0.53:";
    print("the end is reached", pass_gap(0.53, parameters).finished());
    std::cout << "  from 0.46 to 0.6:";
    const LoadStepping failed = pass_gap(0.6, parameters);
    print("no leap is larger than the initial step", failed.time() == 0.45);
    print("... and the step is the smallest one again",
          !failed.is_leaping() && failed.next_time() == 0.475);
    parameters.requested_times = {0.5};
    std::cout << "  requested at 0.5:";
    print("no leap over requested times",
          pass_gap(0.53, parameters).time() == 0.45);
    parameters.requested_times.clear();
    parameters.leaps_over_snaps = false;
    std::cout << "  not wanted:";
    print("no leaps", pass_gap(0.53, parameters).time() == 0.45);
    parameters.leaps_over_snaps        = true;
    parameters.locates_contact_changes = true;
    LoadStepping locating(parameters);
    locating.cut_step();
    locating.accept_step(50);
    while (locating.can_be_cut())
      locating.cut_step();
    print("nothing is located in a leap",
          locating.leap() && !locating.locate_contact_change(true));
  }
} // namespace



int
main()
{
  test_step_size();
  test_limit_point();
  test_growth();
  test_targets();
  test_minimum();
  test_contact_changes();
  test_leaps();
}
