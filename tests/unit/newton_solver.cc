// Newton's method on equations of one or two unknowns whose roots, iterations
// and cycles are known in advance.

#include "print.h"

#include <stickslip/strategy/forcing_term.h>
#include <stickslip/strategy/globalization.h>
#include <stickslip/strategy/line_search.h>
#include <stickslip/strategy/newton_solver.h>
#include <stickslip/strategy/residual_monitors.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

using namespace stickslip;

namespace
{
  constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

  using Function = std::function<double(const double)>;

  LA::BlockVector
  vector_of(const double value)
  {
    const IndexSet  entry = complete_index_set(1);
    LA::BlockVector x({entry}, MPI_COMM_SELF);
    x = value;
    return x;
  }



  double
  value_of(const LA::BlockVector &x)
  {
    return x.block(0)(0);
  }



  /// f(x) = 0 with a tangent, which may be a wrong one.
  class Equation : public NewtonProblem
  {
  public:
    Equation(const Function &f, const Function &tangent)
      : f(f)
      , tangent(tangent)
    {}

    NewtonIteration
    residual(const LA::BlockVector &x) override
    {
      NewtonIteration state;
      state.equilibrium = std::abs(f(value_of(x)));
      state.merit       = state.equilibrium;
      return state;
    }

    void
    solve_increment(const LA::BlockVector &x,
                    const double           sufficient,
                    LA::BlockVector       &increment) override
    {
      forcing_terms.push_back(sufficient);
      const double value = f(value_of(x));
      if (value != 0.)
        increment = -value / tangent(value_of(x));
    }

    void
    accept_iterate(const LA::BlockVector &x) override
    {
      iterates.push_back(value_of(x));
    }

    void
    report(const unsigned int, const NewtonIteration &state) override
    {
      lengths.push_back(state.step_length);
    }

    Function            f, tangent;
    std::vector<double> iterates, lengths, forcing_terms;
  };



  NewtonParameters
  parameters_with(const LineSearch line_search)
  {
    NewtonParameters parameters;
    parameters.line_search = line_search;
    return parameters;
  }



  /// Solves from @p start and prints what comes of it.
  double
  solve(const std::string      &title,
        NewtonProblem          &problem,
        const double            start,
        const NewtonParameters &parameters = NewtonParameters())
  {
    LA::BlockVector x = vector_of(start);
    std::cout << "  " << title << ": ";
    try
      {
        const unsigned int n = NewtonSolver(parameters, problem).solve(x);
        std::cout << "x = " << value_of(x) << " in " << n << " iterations\n";
      }
    catch (const NoConvergence &failure)
      {
        const std::string text = failure.what();
        std::cout << to_string(failure.cause) << ", "
                  << text.substr(0, text.find(';')) << '\n';
      }
    return value_of(x);
  }



  /// sign(x) sqrt|x|: Newton's method turns the sign of x.
  double
  signed_root(const double x)
  {
    return std::copysign(std::sqrt(std::abs(x)), x);
  }



  double
  tangent_of_signed_root(const double x)
  {
    return 0.5 / std::sqrt(std::abs(x));
  }



  /// Rises from piece to piece such that Newton's method goes from -1 to 2, 1
  /// and -1. The root is 0.
  double
  in_pieces(const double x)
  {
    if (x < -0.5)
      return -1.5 + 0.5 * (x + 1.);
    if (x < 0.)
      return 2.5 * x;
    if (x < 0.5)
      return 1.5 * x;
    if (3. * x < 5.)
      return 1. + 0.5 * (x - 1.);
    return 2. + 2. * (x - 2.);
  }



  double
  tangent_in_pieces(const double x)
  {
    if (x < -0.5)
      return 0.5;
    if (x < 0.)
      return 2.5;
    if (x < 0.5)
      return 1.5;
    return 3. * x < 5. ? 0.5 : 2.;
  }



  void
  test_smooth()
  {
    std::cout << "Smooth equations\n";
    Equation         linear([](const double x) { return 3. * x - 6.; },
                    [](const double) { return 3.; });
    NewtonParameters parameters;
    parameters.increment_tolerance = 1e10;
    solve("3 x = 6, any increment", linear, 0., parameters);
    solve("3 x = 6, small increments", linear, 0.);

    Equation square([](const double x) { return x * x - 2.; },
                    [](const double x) { return 2. * x; });
    solve("x^2 = 2", square, 2.);
    // e' = e^2 / (2 x)
    bool is_quadratic = true;
    for (unsigned int i = 1; i < square.iterates.size(); ++i)
      {
        const double before   = square.iterates[i - 1] - std::sqrt(2.);
        const double error    = square.iterates[i] - std::sqrt(2.);
        const double expected = before * before / (2. * square.iterates[i - 1]);
        is_quadratic = is_quadratic && std::abs(error - expected) < 1e-14;
      }
    print("  quadratic convergence", is_quadratic);
    print("  every iterate is accepted once", square.iterates.size() == 5);
  }



  void
  test_cycles()
  {
    std::cout << "Cycles\n";
    for (const unsigned int period : {2, 3})
      {
        const std::string name  = "period " + std::to_string(period);
        const double      start = period == 2 ? 1. : -1.;
        Equation          equation(period == 2 ? signed_root : in_pieces,
                          period == 2 ? tangent_of_signed_root
                                               : tangent_in_pieces);
        solve(name + ", full steps",
              equation,
              start,
              parameters_with(LineSearch::none));
        print("    a cycle",
              equation.iterates[period] == start &&
                equation.iterates[1] != start);
        solve(name + ", line search", equation, start);
      }
  }



  /// A spring (stiffness 1) that a force of 3 presses against a wall at 1:
  /// u + p = 3, min(p, 1 - u) = 0.
  class SpringAndWall : public NewtonProblem
  {
  public:
    NewtonIteration
    residual(const LA::BlockVector &x) override
    {
      const double    u = x.block(0)(0), p = x.block(1)(0);
      NewtonIteration state;
      state.equilibrium = std::abs(u + p - 3.);
      state.contact     = std::abs(std::min(p, 1. - u));
      state.merit       = std::hypot(state.equilibrium, state.contact);
      return state;
    }

    void
    solve_increment(const LA::BlockVector &x,
                    const double,
                    LA::BlockVector &increment) override
    {
      const double u = x.block(0)(0), p = x.block(1)(0);
      const double du    = p <= 1. - u ? 3. - u : 1. - u;
      increment.block(0) = du;
      increment.block(1) = 3. - u - p - du;
    }
  };



  void
  test_kink()
  {
    std::cout << "Nonsmooth equations\n";
    const IndexSet  entry = complete_index_set(1);
    LA::BlockVector x({entry, entry}, MPI_COMM_SELF);
    SpringAndWall   problem;
    // through the wall, back to it, nothing
    const unsigned int n = NewtonSolver(NewtonParameters(), problem).solve(x);
    std::cout << "  a spring at a wall: u = " << x.block(0)(0)
              << ", p = " << x.block(1)(0) << " in " << n << " iterations\n";
  }



  void
  test_failures()
  {
    std::cout << "Equations that are not solved\n";
    Equation no_root([](const double x) { return x * x + 1.; },
                     [](const double x) { return 2. * x; });
    solve("no root", no_root, 0.4);
    // x is multiplied by -99; the first iteration is a reference as well, so
    // 99^8 is the first to be above 1e12 * 99
    Equation soft([](const double x) { return x; },
                  [](const double) { return 0.01; });
    solve("a tangent a hundred times too soft, full steps",
          soft,
          1.,
          parameters_with(LineSearch::none));
    std::cout << "    after " << soft.iterates.size() - 1 << " iterations\n";
    // 1/64 of a step is the first that reduces x, to 0.5625 of what it was
    NewtonParameters halving;
    halving.max_iterations      = 40;
    halving.max_halvings        = 6;
    halving.increment_tolerance = 1e10;
    soft.lengths.clear();
    solve("the same, at most six halvings", soft, 1., halving);
    std::cout << "    step length 1/" << 1. / soft.lengths.back() << '\n';
  }



  void
  test_no_fraction_decreases()
  {
    // 1 at the start; 3, 1.5, 2 at 1, 1/2, 1/4
    Equation planted(
      [](const double x) {
        return x > 0.9 ? 3. : x > 0.4 ? 1.5 : x > 0.2 ? 2. : 1.;
      },
      [](const double) { return 1.; });
    const ConvergenceCriterion criterion{NewtonParameters()};
    for (const double reference : {1., 2.2})
      {
        LA::BlockVector       x = vector_of(0.);
        const NewtonIteration state =
          advance(planted, vector_of(1.), reference, criterion, 2, x).state;
        std::cout << "  no fraction of a step decreases, reference "
                  << reference << ": x = " << value_of(x) << ", residual "
                  << state.equilibrium << ", length " << state.step_length
                  << '\n';
      }
  }



  /// Two equations in two units: x = 0, in units that make its relative
  /// residual large, and y = 0 with a tangent that is a tenth of the right one.
  /// The relative residual sees x only, which a full step solves; y is
  /// multiplied by -9.
  class TwoUnits : public NewtonProblem
  {
  public:
    NewtonIteration
    residual(const LA::BlockVector &x) override
    {
      const double    a = x.block(0)(0), b = x.block(1)(0);
      NewtonIteration state;
      state.equilibrium = std::abs(b) * 1e-3;
      state.contact     = std::abs(a) * 1e3;
      state.merit       = std::hypot(a, b);
      return state;
    }

    void
    solve_increment(const LA::BlockVector &x,
                    const double,
                    LA::BlockVector &increment) override
    {
      increment.block(0) = -x.block(0)(0);
      increment.block(1) = -10. * x.block(1)(0);
    }
  };



  /// v = u^2, u = 1, where the first equation counts @p stiffness times as much.
  class CurvedValley : public NewtonProblem
  {
  public:
    CurvedValley(const double stiffness, const double bend)
      : stiffness(stiffness)
      , bend(bend)
    {}

    NewtonIteration
    residual(const LA::BlockVector &x) override
    {
      const double    u = x.block(0)(0), v = x.block(1)(0);
      NewtonIteration state;
      state.equilibrium = stiffness * std::abs(v - u * u);
      state.contact     = std::abs(u - 1.);
      state.merit       = std::hypot(state.equilibrium, state.contact);
      return state;
    }

    /// With @p bend = 1 Newton's; with others v is wrong.
    void
    solve_increment(const LA::BlockVector &x,
                    const double,
                    LA::BlockVector &increment) override
    {
      const double u = x.block(0)(0), v = x.block(1)(0), du = 1. - u;
      increment.block(0) = du;
      increment.block(1) = bend * (u * u - v) + 2. * u * du;
    }

    void
    report(const unsigned int, const NewtonIteration &state) override
    {
      std::cout << ' ' << state.merit << " (" << state.step_length << ')';
    }

  private:
    const double stiffness, bend;
  };



  /// Steps of length one have the merits of a list; every fraction of the first
  /// makes the merit grow, too.
  class ListedMerits : public NewtonProblem
  {
  public:
    explicit ListedMerits(const std::vector<double> &merits)
      : merits(merits)
    {}

    NewtonIteration
    residual(const LA::BlockVector &x) override
    {
      const double    u = x.block(0)(0);
      const auto      i = static_cast<unsigned int>(u);
      NewtonIteration state;
      state.merit = u == i ? merits[std::min<std::size_t>(i, merits.size() - 1)]
                           : merits[0] * (1. + u);
      state.equilibrium = state.contact = state.merit;
      return state;
    }

    void
    solve_increment(const LA::BlockVector &,
                    const double,
                    LA::BlockVector &increment) override
    {
      increment          = 0.;
      increment.block(0) = 1.;
    }

  private:
    const std::vector<double> merits;
  };



  void
  test_ways_ahead()
  {
    std::cout << "Merits of full steps: where the iterations go\n";
    const IndexSet entry = complete_index_set(1);
    // each smaller; once larger than the one before; twice, or larger than the
    // two before, and so it goes back; no end
    for (const auto &merits : {std::vector<double>{1., 3., 2., 0.5},
                               {1., 3., 2., 2.5, 2.4, 0.5},
                               {1., 3., 2., 2.5, 2.4, 2.45, 0.5},
                               {1., 3., 2., 3.1, 0.5},
                               {1., 3., 2.9, 2.8, 2.7, 2.6, 2.5, 2.4, 2.3, 0.}})
      {
        LA::BlockVector  x({entry, entry}, MPI_COMM_SELF);
        LA::BlockVector  increment(x);
        NewtonParameters parameters;
        ListedMerits     problem(merits);
        Globalization    globalization(parameters, problem);
        NewtonIteration  state = problem.residual(x);
        std::cout << "  ";
        for (unsigned int i = 0; i < 9 && state.merit >= 1.; ++i)
          {
            problem.solve_increment(x, 0., increment);
            state = globalization.advance(state, increment, x);
            std::cout << ' ' << value_of(x);
          }
        std::cout << '\n';
      }
  }



  void
  test_look_ahead()
  {
    std::cout << "Along a curved valley: merit and length of each step\n";
    const IndexSet   entry = complete_index_set(1);
    NewtonParameters parameters;
    parameters.max_iterations = 8;
    // the second step solves it; the steps after it reduce the residual enough;
    // slowly; not at all, so that it goes back to 1/32
    for (const double bend : {1., 0.95, 0.3, -1.})
      {
        LA::BlockVector x({entry, entry}, MPI_COMM_SELF);
        CurvedValley    problem(1e4, bend);
        std::cout << "  " << bend << ':';
        try
          {
            NewtonSolver(parameters, problem).solve(x);
            std::cout << "; u = " << x.block(0)(0) << ", v = " << x.block(1)(0)
                      << '\n';
          }
        catch (const NoConvergence &failure)
          {
            std::cout << "; " << to_string(failure.cause) << '\n';
          }
      }
  }



  void
  test_merit()
  {
    std::cout << "What a line search compares\n";
    const IndexSet  entry = complete_index_set(1);
    LA::BlockVector x({entry, entry}, MPI_COMM_SELF), increment(x);
    x = 1.;
    TwoUnits problem;
    problem.solve_increment(x, 0., increment);
    const ConvergenceCriterion criterion{NewtonParameters()};
    const NewtonIteration      start = problem.residual(x);
    const NewtonIteration      state =
      advance(problem, increment, start.merit, criterion, 5, x).state;
    std::cout << "  not the relative residuals: length " << state.step_length
              << '\n';

    MeritReference reference;
    std::cout << "  reference";
    for (const double merit : {5., 4., 6., 1., 2., 0.5})
      {
        NewtonIteration iterate;
        iterate.merit      = merit;
        iterate.prescribed = merit == 5. ? 0.1 : 0.;
        reference.add(iterate);
        std::cout << ' ' << reference.value();
      }
    reference.restart();
    std::cout << "; restarted " << reference.value() << '\n';
  }



  /// log(x) = 0; for x <= 0 it is what @p outside says.
  class Logarithm : public Equation
  {
  public:
    Logarithm(const NewtonIteration &outside, const bool admits)
      : Equation([](const double x) { return std::log(x); },
                 [](const double x) { return 1. / x; })
      , outside(outside)
      , admits(admits)
    {}

    NewtonIteration
    residual(const LA::BlockVector &x) override
    {
      last = value_of(x);
      return last > 0. ? Equation::residual(x) : outside;
    }

    bool
    is_admissible(std::string &reason) const override
    {
      if (last > 0. || admits)
        return true;
      reason = "log(" + std::to_string(last) + ")";
      return false;
    }

  private:
    const NewtonIteration outside;
    const bool            admits;
    double                last = 0.;
  };



  void
  test_inadmissible_states()
  {
    std::cout << "States outside of the model\n";
    NewtonIteration nothing, no_number, no_contact;
    no_number.equilibrium = not_a_number;
    no_contact.contact    = not_a_number;
    const auto test       = [](const std::string &title, Logarithm problem) {
      const NewtonParameters full = parameters_with(LineSearch::none);
      solve(title, problem, 4., full); // first to -1.5452
      std::cout << "    length of the first step " << problem.lengths[1]
                << '\n';
      NewtonParameters no_halvings = full;
      no_halvings.max_halvings     = 0;
      solve(title + ", no halvings", problem, 4., no_halvings);
    };
    test("refused", Logarithm(nothing, false));
    test("residual is no number", Logarithm(no_number, true));
    test("contact rows are no number", Logarithm(no_contact, true));
  }



  /// x = 1 is prescribed, and nothing else is wrong but a residual that appears
  /// when it is applied and goes in the next iteration.
  class Prescribed : public Equation
  {
  public:
    Prescribed()
      : Equation([](const double x) { return x - 1.; },
                 [](const double) { return 1.; })
    {}

    NewtonIteration
    residual(const LA::BlockVector &x) override
    {
      NewtonIteration state;
      state.prescribed  = std::abs(value_of(x) - 1.);
      state.equilibrium = value_of(x) == 1. && iterates.size() == 1 ? 1e6 : 0.;
      return state;
    }
  };



  void
  test_prescribed()
  {
    std::cout << "Prescribed displacements\n";
    Prescribed       problem;
    NewtonParameters parameters;
    parameters.increment_tolerance = 1e10;
    parameters.forcing             = Forcing::eisenstat_walker;
    solve("no residual, but not applied", problem, 0., parameters);
    print("    applied in one step, whatever the residual",
          problem.lengths[1] == 1.);
  }



  /// A residual that is never smaller than @p floor, and increments of
  /// @p increment.
  void
  solve_with_floor(const double floor, const double increment)
  {
    Equation        problem([floor](const double) { return floor; },
                     [=](const double) { return -floor / increment; });
    LA::BlockVector x = vector_of(1.);
    std::cout << "  residual " << floor << ", increment " << increment << ": ";
    try
      {
        std::cout << NewtonSolver(NewtonParameters(), problem).solve(x)
                  << " iterations\n";
      }
    catch (const NoConvergence &failure)
      {
        std::cout << to_string(failure.cause) << '\n';
      }
  }



  /// Multipliers of 1e-12 are roundoff.
  class Roundoff : public SpringAndWall
  {
  public:
    double
    negligible_unknown(const unsigned int b) const override
    {
      return b == 0 ? 0. : 1e-12;
    }
  };



  void
  test_roundoff()
  {
    std::cout << "Roundoff, with tolerance 1e-8\n";
    solve_with_floor(0.9e-8, 1e-4);
    solve_with_floor(0.9e-6, 1e-14);
    solve_with_floor(0.9e-6, 1e-12);
    solve_with_floor(1.1e-6, 1e-14);

    const IndexSet  entry = complete_index_set(1);
    LA::BlockVector x({entry, entry}, MPI_COMM_SELF), increment(x);
    x.block(0) = 1.;
    x.block(1) = 100.;
    Roundoff      problem;
    IncrementNorm norm(problem, x);
    increment.block(0) = 0.1;
    increment.block(1) = 20.;
    std::cout << "  0.1 of 1 and 20 of 100: "
              << norm.relative_increment(x, increment) << '\n';
    // as multipliers where contact is lost
    increment.block(0) = 0.;
    x.block(1)         = 1e-18;
    increment.block(1) = 1e-18;
    std::cout << "  1e-18 of 1e-18 that was 100: "
              << norm.relative_increment(x, increment) << '\n';
    // as multipliers where there was no contact before
    IncrementNorm without_contact(problem, x);
    std::cout << "  1e-18 of 1e-18 where 1e-12 is negligible: "
              << without_contact.relative_increment(x, increment) << '\n';
  }



  /// sign(x) sqrt|x| until it is treated, then x with a tangent that is wrong:
  /// 2 halves x in each iteration.
  class TreatedCycle : public Equation
  {
  public:
    explicit TreatedCycle(const CycleTreatment treatment,
                          const double         wrong_tangent = 2.)
      : Equation(signed_root, tangent_of_signed_root)
      , treatment(treatment)
      , wrong_tangent(wrong_tangent)
    {}

    CycleTreatment
    treat_cycle(const bool stagnates) override
    {
      if (!stagnates)
        return CycleTreatment::none;
      ++n_treatments;
      if (treatment == CycleTreatment::treated)
        {
          f       = [](const double x) { return x; };
          tangent = [this](const double) { return wrong_tangent; };
        }
      return treatment;
    }

    unsigned int n_treatments = 0;

  private:
    const CycleTreatment treatment;
    const double         wrong_tangent;
  };



  void
  test_treatment()
  {
    std::cout << "Treatment of cycles\n";
    NewtonParameters parameters    = parameters_with(LineSearch::none);
    parameters.increment_tolerance = 2.;
    // after 7 iterations, and then 27 halvings to below 1e-8
    TreatedCycle treated(CycleTreatment::treated);
    solve("at most 30 with the same equations", treated, 1., parameters);
    std::cout << "    " << treated.n_treatments << " treatment\n";
    parameters.max_iterations = 26;
    TreatedCycle on_its_way(CycleTreatment::treated);
    solve("at most 26, but on its way", on_its_way, 1., parameters);
    parameters.max_iterations = 16;
    TreatedCycle too_far(CycleTreatment::treated);
    solve("at most 16, and half as many more", too_far, 1., parameters);
    parameters.max_iterations = 26;
    // 0.8^3 is more than a half
    TreatedCycle too_slow(CycleTreatment::treated, 5.);
    solve("at most 26, slower", too_slow, 1., parameters);
    TreatedCycle untreated(CycleTreatment::untreatable);
    solve("nothing helps", untreated, 1., parameters);
    std::cout << "    asked " << untreated.n_treatments << " times\n";
  }



  /// x = 1 while a status is fixed, then x = @p root.
  class FixedStatus : public Equation
  {
  public:
    explicit FixedStatus(const double root)
      : Equation([](const double x) { return x - 1.; },
                 [](const double) { return 1.; })
      , root(root)
    {}

    bool
    release_fixed_statuses() override
    {
      const bool was_fixed = is_fixed;
      is_fixed             = false;
      f                    = [this](const double x) { return x - root; };
      return was_fixed;
    }

    bool is_fixed = true;

  private:
    const double root;
  };



  void
  test_release()
  {
    std::cout << "Fixed statuses, released where x = 1\n";
    FixedStatus same(1.), other(3.), none(1.);
    none.is_fixed = false;
    solve("nothing fixed", none, 0.);
    solve("the state is right without them", same, 0.);
    solve("it is not", other, 0.);
    print("    nothing is left fixed", !same.is_fixed && !other.is_fixed);
    // the first solution takes two iterations, and so does the second
    FixedStatus      late(3.);
    NewtonParameters parameters;
    parameters.max_iterations = 2;
    solve("two iterations each", late, 0., parameters);
  }



  /// atan(x) = 0 diverges from beyond 1.39, unless trial states are limited.
  void
  test_limit()
  {
    class Limited : public Equation
    {
    public:
      using Equation::Equation;

      void
      limit(LA::BlockVector &x) const override
      {
        x.block(0)(0) = std::max(-1., std::min(value_of(x), 1.));
        x.compress(VectorOperation::insert);
      }
    };

    const auto f       = [](const double x) { return std::atan(x); };
    const auto tangent = [](const double x) { return 1. / (1. + x * x); };
    std::cout << "Limited trial states\n";
    const auto full_steps = parameters_with(LineSearch::none);
    Equation   plain(f, tangent);
    solve("atan x from 2", plain, 2., full_steps);
    Limited limited(f, tangent);
    solve("the same, |x| <= 1", limited, 2., full_steps);
    std::cout << "  first iterates " << limited.iterates[0] << ' '
              << limited.iterates[1] << '\n';
  }



  void
  test_forcing()
  {
    std::cout
      << "Forcing terms of x^2 = 2, residuals 2, 1/4, 1/144, 1/166464\n";
    for (const Forcing forcing :
         {Forcing::none, Forcing::careful, Forcing::eisenstat_walker})
      {
        Equation         square([](const double x) { return x * x - 2.; },
                        [](const double x) { return 2. * x; });
        NewtonParameters parameters;
        parameters.forcing             = forcing;
        parameters.increment_tolerance = 1e10;
        solve(name_of(forcing, all_forcings()), square, 2., parameters);
        std::cout << "   ";
        for (const double term : square.forcing_terms)
          std::cout << ' ' << term * 1e4;
        std::cout << " e-4\n";
      }
    // at most 0.01, not less than a tenth of what the tolerance needs
    const ConvergenceCriterion criterion{NewtonParameters()};
    const auto                 term =
      [&](const double before, const double now, const double prescribed = 0.) {
        NewtonIteration a, b;
        a.equilibrium = before;
        b.equilibrium = now;
        b.prescribed  = prescribed;
        return forcing_term(Forcing::eisenstat_walker, criterion, a, b) * 1e4;
      };
    std::cout << "  from 1 to 1: " << term(1., 1.)
              << ", to 1e-2: " << term(1., 1e-2)
              << ", to 1e-6: " << term(1., 1e-6)
              << ", to 1e-8: " << term(1., 1e-8)
              << ", to 1e-6 without what is prescribed: " << term(1., 1e-6, 1.)
              << " e-4\n";
  }



  void
  test_monitors()
  {
    std::cout << "Monitors\n";
    StagnationMonitor monitor({0.9, 2});
    std::string       seen;
    for (const double residual : {5., 4., 3.7, 3.65, 3.2, 3.3, 3.1})
      {
        monitor.add(residual);
        seen += monitor.stagnates() ? '1' : '0';
      }
    std::cout << "  5 4 3.7 3.65 3.2 3.3 3.1: " << seen << '\n';
    // a cycle of three after a start below it; transients that come down, not
    // below and below where they began
    for (const auto &merits : {std::vector<double>{1., 5., 4., 6., 5., 4., 6.},
                               {1., 5., 5., 4., 3.9, 3., 2.6},
                               {4., 100., 80., 60., 30., 20., 10.},
                               {4., 10., 8., 6., 3., 2., 1.}})
      {
        DescentMonitor descent;
        std::cout << "  descends:";
        for (const double merit : merits)
          {
            descent.add(merit);
            std::cout << ' ' << descent.descends()
                      << (descent.is_on_its_way() ? " on its way" : "");
          }
        std::cout << '\n';
      }
    // one point cycles where all else is solved
    DescentMonitor descent;
    std::cout << "  has been far down:";
    for (const double merit : {1e4, 120., 4., 0.01, 2.5, 5.})
      {
        descent.add(merit);
        std::cout << ' ' << descent.has_been_far_down();
      }
    std::cout << '\n';
    DivergenceMonitor divergence(1e-3);
    divergence.add(1e6);
    divergence.add(0.9e18);
    const bool before = divergence.diverges();
    divergence.add(1.1e18);
    print("  1e12 times the first residual", !before && divergence.diverges());
  }
} // namespace



int
main(int argc, char *argv[])
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_smooth();
  test_cycles();
  test_kink();
  test_failures();
  test_no_fraction_decreases();
  test_look_ahead();
  test_ways_ahead();
  test_merit();
  test_inadmissible_states();
  test_prescribed();
  test_roundoff();
  test_treatment();
  test_release();
  test_limit();
  test_forcing();
  test_monitors();
}
