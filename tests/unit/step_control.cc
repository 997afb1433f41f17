// Which attempt follows on which failure, how long what has helped is kept, how
// many iterations an attempt may take, and that a control which continues at a
// saved state decides like one that was never interrupted. No equations are
// solved: which attempts fail is planted.

#include <stickslip/strategy/step_control.h>

#include <algorithm>
#include <iostream>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <vector>

using namespace stickslip;

namespace
{
  const std::vector<Algorithm> sequence =
    fallback_sequence(Algorithm::automatic, true);



  void
  print(const std::string &text, const bool holds)
  {
    std::cout << "  " << text << ": " << (holds ? "yes" : "NO") << '\n';
  }



  std::string
  in_words(const Attempt &attempt)
  {
    return name_of(attempt.algorithm) +
           (attempt.guess == Attempt::Guess::predicted ? ", predicted" : "") +
           (attempt.scales == Attempt::Scales::automatic ? ", r reset" : "") +
           (attempt.pairing == Attempt::Pairing::hysteresis ? ", hysteresis"
                                                            : "");
  }



  std::string
  in_words(const std::optional<Attempt> &attempt)
  {
    return attempt ? in_words(*attempt) : "cut";
  }



  const std::vector<FailureCause> all_causes = {FailureCause::cycle,
                                                FailureCause::stagnation,
                                                FailureCause::loop_limit,
                                                FailureCause::loop_cycle,
                                                FailureCause::budget,
                                                FailureCause::rejected,
                                                FailureCause::divergence,
                                                FailureCause::inadmissible,
                                                FailureCause::singular,
                                                FailureCause::linear_solver};



  /// What follows on each cause, without and with an effect of a retry.
  void
  print_table(const Attempt &failed)
  {
    std::cout << in_words(failed) << " fails; a retry would change nothing, "
              << "r, the pairing:\n";
    for (const FailureCause cause : all_causes)
      std::cout
        << "  " << to_string(cause) << ": "
        << in_words(next_attempt(failed, cause, {}, sequence)) << " | "
        << in_words(next_attempt(failed, cause, {true, false}, sequence))
        << " | "
        << in_words(next_attempt(failed, cause, {false, true}, sequence))
        << '\n';
  }



  void
  test_attempts()
  {
    Attempt attempt;
    attempt.algorithm = Algorithm::gnm;
    attempt.guess     = Attempt::Guess::predicted;
    attempt.budget    = 120;
    print_table(attempt);
    const auto retry =
      next_attempt(attempt, FailureCause::stagnation, {true, true}, sequence);
    print_table(*retry);
    const auto next =
      next_attempt(*retry, FailureCause::stagnation, {true, true}, sequence);
    print_table(*next);
    attempt.algorithm = Algorithm::fpm;
    std::cout
      << "The last of the sequence: "
      << in_words(next_attempt(attempt, FailureCause::cycle, {}, sequence))
      << "; a named algorithm: "
      << in_words(
           next_attempt(attempt, FailureCause::cycle, {}, {Algorithm::fpm}))
      << "\n";
    print("the budget stays", next->budget == 120);
    attempt.algorithm       = Algorithm::gnm;
    attempt.guess           = Attempt::Guess::predicted;
    attempt.step_can_be_cut = false;
    std::cout << "A step that cannot be cut any more: ";
    print_table(attempt);
  }



  void
  test_back_off()
  {
    std::cout << "Back-off; the wait is 2 after the first failure, never more "
                 "than 8:\n ";
    BackOff back_off(2, 8);
    std::cout << ' ' << back_off.wait_length();
    for (unsigned int i = 0; i < 4; ++i)
      {
        back_off.fail();
        std::cout << ' ' << back_off.wait_length();
      }
    std::cout << "; after each success:";
    for (unsigned int i = 0; i < 5; ++i)
      {
        back_off.succeed();
        std::cout << ' ' << back_off.wait_length();
      }
    std::cout << '\n';
    back_off.fail();
    back_off.fail();
    for (unsigned int i = 0; i < 3; ++i)
      back_off.advance();
    print("three steps of four: waiting", back_off.is_waiting());
    back_off.advance();
    print("four: over", !back_off.is_waiting());
    back_off.restart();
    print("begun again: four steps", back_off.steps_left() == 4);
    back_off.succeed();
    print("a success shortens the present wait", back_off.steps_left() == 2);
  }



  void
  test_budget()
  {
    constexpr unsigned int unlimited = std::numeric_limits<unsigned int>::max();
    std::cout << "Budget of an attempt, with at most 30 iterations in a Newton "
                 "solve:\n";
    print("first step of a named algorithm: none",
          iteration_budget({}, true, false, 30) == unlimited);
    print("first step with others in reserve: ten solves",
          iteration_budget({}, true, true, 30) == 300);
    print("after 5, 60, 7 iterations: three times 60",
          iteration_budget({5, 60, 7}, true, true, 30) == 180);
    print("after easy steps: a hundred",
          iteration_budget({5, 6, 7}, true, true, 30) == 100);
    print("... or ten solves if there is no other algorithm",
          iteration_budget({5, 6, 7}, true, false, 30) == 300);
    print("after 200: no more than ten solves",
          iteration_budget({200}, true, true, 30) == 300);
    print("... or 600 if there is no other algorithm",
          iteration_budget({200}, true, false, 30) == 600);
    print("no cut, no other algorithm: none",
          iteration_budget({5, 6, 7}, false, false, 30) == unlimited);
    print("no cut, but others: ten solves",
          iteration_budget({5, 6, 7}, false, true, 30) == 300);
  }



  LoadSteppingParameters
  long_run()
  {
    LoadSteppingParameters parameters;
    parameters.end_time     = 100.;
    parameters.initial_step = 1.;
    return parameters;
  }



  /// Solves a step with the first algorithm of the sequence from @p sufficient
  /// on. Returns the first one that was tried.
  Algorithm
  solve(StepControl &control, const Algorithm sufficient)
  {
    control.begin_step();
    Attempt         attempt = control.first_attempt();
    const Algorithm first   = attempt.algorithm;
    bool            is_met  = false;
    for (const Algorithm algorithm : sequence)
      {
        is_met = is_met || algorithm == sufficient;
        if (algorithm == attempt.algorithm && !is_met)
          attempt = *control.next_attempt(attempt, FailureCause::cycle, {});
      }
    control.accept_step(attempt, 6);
    return first;
  }



  void
  test_stay()
  {
    std::cout << "PNM is needed in steps 4 to 60, FPM never:\n";
    StepControl            control(long_run(), sequence, 30);
    std::set<unsigned int> failures, expected{4};
    for (unsigned int step = 1; step <= 80; ++step)
      {
        const bool is_hard = step >= 4 && step <= 60;
        const auto first =
          solve(control, is_hard ? Algorithm::pnm : Algorithm::gnm);
        if (is_hard && first == Algorithm::gnm)
          failures.insert(step);
        if (step > 77)
          print("step " + std::to_string(step) + " begins with GNM",
                first == Algorithm::gnm);
      }
    // a failure, then a stay twice as long as the one before
    for (unsigned int step = 4, length = 1; (step += length + 1) <= 60;
         length = std::min(2 * length, 16U))
      expected.insert(step);
    std::cout << "  GNM fails in steps";
    for (const unsigned int step : failures)
      std::cout << ' ' << step;
    std::cout << '\n';
    print("as stays of 1, 2, 4, 8, 16 steps make it", failures == expected);

    StepControl once(long_run(), sequence, 30);
    solve(once, Algorithm::fpm);
    print("after FPM the next step begins with it",
          solve(once, Algorithm::gnm) == Algorithm::fpm);
    print("then PNM is tried", solve(once, Algorithm::gnm) == Algorithm::pnm);
    print("then GNM", solve(once, Algorithm::gnm) == Algorithm::gnm);
  }



  void
  test_guess()
  {
    std::cout << "The guess of the first attempt:\n";
    LoadSteppingParameters parameters = long_run();
    parameters.requested_times        = {2.};
    StepControl control(parameters, sequence, 30);
    const auto  is_predicted = [&control]() {
      return control.first_attempt().guess == Attempt::Guess::predicted;
    };
    control.begin_step();
    print("predicted", is_predicted());
    control.cut_step();
    print("after a cut: accepted", !is_predicted());
    control.accept_step(control.first_attempt(), 6);
    print("... also as long as the step has not begun", !is_predicted());
    print("the cut still counts for the tables", control.n_cuts() == 1);
    control.begin_step();
    print("the next step: predicted", is_predicted());
    while (control.steps().time() < 2.)
      {
        control.begin_step();
        control.accept_step(control.first_attempt(), 6);
      }
    control.begin_step();
    print("from a requested time on: accepted", !is_predicted());
    parameters.predictor = Predictor::none;
    print("without predictor: accepted",
          StepControl(parameters, sequence, 30).first_attempt().guess ==
            Attempt::Guess::accepted);
  }



  /// One step of a run with difficulties of all kinds; what was decided.
  std::string
  difficult_step(StepControl &control)
  {
    control.begin_step();
    const unsigned int step      = control.steps().step_number();
    const double       largest   = step % 17 > 8 ? 0.4 : 3.;
    std::string        decisions = std::to_string(step) + ":";
    while (control.steps().next_time() - control.steps().time() > largest &&
           control.cut_step())
      decisions += " cut";
    Attempt attempt = control.first_attempt();
    decisions += " to " + std::to_string(control.steps().next_time()) + " " +
                 in_words(attempt) + " " + std::to_string(attempt.budget);
    if (step % 23 > 14 && attempt.algorithm == Algorithm::gnm)
      attempt = *control.next_attempt(attempt, FailureCause::cycle, {});
    control.accept_step(attempt, step % 7 == 3 ? 50 : 5);
    return decisions;
  }



  void
  test_continuation()
  {
    LoadSteppingParameters parameters = long_run();
    parameters.maximum_step           = 4.;
    StepControl reference(parameters, sequence, 30);
    bool        is_same = true, is_different = false;
    while (!reference.steps().finished())
      {
        StepControl continued(parameters, sequence, 30);
        continued.resume(reference.state());
        StepControl      forgetful(parameters, sequence, 30);
        StepControlState state;
        state.load_stepping.time      = reference.steps().time();
        state.load_stepping.step      = reference.steps().step_number();
        state.load_stepping.step_size = reference.steps().step_size();
        forgetful.resume(state);
        StepControl original = reference;
        for (unsigned int i = 0; i < 60 && !original.steps().finished(); ++i)
          {
            const std::string decisions = difficult_step(original);
            is_same = is_same && decisions == difficult_step(continued);
            if (!forgetful.steps().finished())
              is_different =
                is_different || decisions != difficult_step(forgetful);
          }
        difficult_step(reference);
      }
    std::cout << "A run that is continued after any of its steps:\n";
    print("decides as without interruption", is_same);
    print("... which takes more than time, step and size", is_different);
    StepControlState state;
    state.first_level = 2;
    StepControl named(parameters, {Algorithm::pnm}, 30);
    named.resume(state);
    print("another choice of algorithms is followed",
          named.first_attempt().algorithm == Algorithm::pnm);
  }
} // namespace



int
main()
{
  test_attempts();
  test_back_off();
  test_budget();
  test_stay();
  test_guess();
  test_continuation();
}
