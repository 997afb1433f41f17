// Why a load step failed: traces of failures made by hand, and what is said
// about them. The points are on the last rank, so that ranks have to agree.

#include <stickslip/simulation/failure_explanation.h>

#include <iostream>
#include <string>
#include <vector>

using namespace stickslip;

namespace
{
  /// A failed step with nothing to see; each test adds its traces.
  struct Traces
  {
    std::string                      solver = "Newton";
    std::string                      reason = "no convergence";
    FailurePlace                     place;
    FailureCause                     cause = FailureCause::stagnation;
    std::vector<NewtonIteration>     iterations;
    StatusCycle                      cycle;
    std::vector<PointDiagnosis<2>>   points;
    NamedList<ContactPairParameters> pairs;
    std::vector<FreeMotion>          free_motions;
    std::vector<FreeMotion>          weakly_held;
    std::vector<FreeMotion>          held_by_springs;

    Traces()
      : pairs(2)
    {
      pairs[0].first              = "sole";
      pairs[0].second.slave_body  = "shoe";
      pairs[0].second.master_body = "floor";
      pairs[0].second.friction    = Friction::Coulomb;
      pairs[1].first              = "wall";
      pairs[1].second.slave_body  = "shoe";
      pairs[1].second.master_body = "brick";
      const bool has_points =
        Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) + 1 ==
        Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
      for (unsigned int i = 0; has_points && i < 10; ++i)
        {
          PointDiagnosis<2> point{};
          point.pair       = i < 6 ? 0 : 1;
          point.position   = Point<2>(0.5 * i, 1.);
          point.state      = ContactState::open;
          point.was_paired = true;
          points.push_back(point);
        }
    }

    void
    set_states(const ContactState state, const bool has_threshold)
    {
      for (auto &point : points)
        {
          point.state         = state;
          point.has_threshold = has_threshold;
        }
    }

    void
    set_cycle(const unsigned int first,
              const unsigned int last,
              const CycleKind    kind,
              const bool         changes_facet = false)
    {
      for (unsigned int i = first; i <= last && i < points.size(); ++i)
        {
          points[i].cycle         = kind;
          points[i].period        = 2;
          points[i].changes_facet = changes_facet;
        }
    }

    void
    set_residuals(const std::vector<double> &equilibrium)
    {
      for (const double residual : equilibrium)
        {
          iterations.emplace_back();
          iterations.back().equilibrium = residual;
        }
    }
  };



  void
  explain(const std::string &title, const Traces &traces)
  {
    const NoConvergence    failure(traces.solver,
                                traces.reason,
                                traces.cause,
                                traces.place);
    const NewtonParameters newton;
    const auto             explanation = explain_failure<2>({failure,
                                                             traces.iterations,
                                                             newton,
                                                             traces.cycle,
                                                             traces.points,
                                                             traces.pairs,
                                                             traces.free_motions,
                                                             traces.weakly_held,
                                                             traces.held_by_springs},
                                                MPI_COMM_WORLD);
    if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      std::cout << title << " -> " << explanation.name << '\n'
                << explanation.text("  ") << std::endl;
  }



  void
  test_matrices_and_cells()
  {
    Traces inverted;
    inverted.cause          = FailureCause::inadmissible;
    inverted.reason         = "The volume is not positive";
    inverted.place.body     = "shoe in shoe";
    inverted.place.position = {1., 2.};
    explain("inverted cell in a body whose name has a word of the text",
            inverted);
    inverted.place = {};
    explain("inadmissible, nobody knows where", inverted);

    Traces singular;
    singular.cause = FailureCause::singular;
    explain("nothing closed", singular);
    singular.free_motions = {{{"shoe"}, "translation along x", {}, {}}};
    explain("free body", singular);
    singular.set_states(ContactState::slip, false);
    explain("free body without pressure", singular);
    singular.set_states(ContactState::slip, true);
    explain("free body that slips", singular);
    singular.set_states(ContactState::stick, true);
    explain("body that sticks", singular);

    // The floor is closed, but another body is free, which it does not touch.
    singular.free_motions = {{{"brick"}, "translation along y", {}, {}}};
    for (auto &point : singular.points)
      if (point.pair == 1)
        point.state = ContactState::open;
    explain("free body of another pair", singular);
    singular.free_motions = {{{"floor"}, "translation along y", {}, {}}};
    explain("free master that sticks", singular);
    singular.weakly_held = {{{"brick"}, "rotation about z", {}, {}}};
    explain("weakly held body", singular);

    Traces dual;
    dual.cause           = FailureCause::linear_solver;
    dual.reason          = "no convergence in 2000 iterations";
    dual.held_by_springs = {{{"shoe"}, "translation along x", {}, {}}};
    explain("a body that contact and springs hold", dual);
  }



  void
  test_points()
  {
    Traces cycle;
    cycle.cycle = {2};
    cycle.set_cycle(2, 4, CycleKind::contact);
    explain("cycle of the contact status", cycle);
    cycle.set_cycle(0, 3, CycleKind::stick);
    cycle.set_cycle(9, 9, CycleKind::direction, true);
    cycle.cycle = {};
    explain("two cycles, not proven", cycle);

    Traces facets;
    facets.set_cycle(7, 9, CycleKind::contact, true);
    explain("cycle of facets and contact", facets);

    Traces hopping;
    for (auto &point : hopping.points)
      point.n_facet_changes = point.position[0] == 2.5 ? 20 : 2;
    explain("hopping", hopping);

    Traces lost;
    for (auto &point : lost.points)
      if (point.position[0] > 3.)
        point.state = ContactState::unpaired;
    explain("lost contact", lost);
  }



  void
  test_iterations()
  {
    Traces loop;
    loop.solver     = "Fixed point";
    loop.cause      = FailureCause::loop_limit;
    loop.reason     = "the geometry loop did not settle in 30 passes";
    loop.place.loop = "geometry";
    explain("outer loop", loop);
    loop.cause      = FailureCause::loop_cycle;
    loop.reason     = "the status loop repeats itself after 4 passes";
    loop.place.loop = "status";
    explain("outer loop that cycles", loop);
    loop.solver = "GNM";
    loop.cause  = FailureCause::budget;
    loop.reason =
      "no end in sight after 300 Newton iterations, the budget of "
      "an attempt";
    loop.place = {};
    explain("budget used up", loop);

    Traces grows;
    grows.set_residuals({1., 10., 1e2, 1e3, 1e4, 1e5, 1e6, 1e7});
    explain("diverging", grows);
    Traces stagnates;
    stagnates.set_residuals({1., 1e-3, 3e-8, 2e-8, 3e-8, 3e-8, 2e-8, 3e-8});
    explain("stagnating", stagnates);
    Traces slow;
    slow.set_residuals({1., 1e-1, 5e-2, 3e-2, 2e-2, 1.5e-2, 1e-2, 0.8e-2});
    explain("slow", slow);
    Traces small;
    small.set_residuals({1., 1e-1, 5e-9, 3e-9, 2e-10, 1e-9, 1e-9});
    explain("small residual", small);
    Traces unclear;
    unclear.set_residuals({1., 1e-1, 5e-2, 3e-1, 2e-3, 1.5e-1, 1e-2, 0.8e-1});
    explain("to and fro", unclear);
    unclear.iterations.clear();
    unclear.set_residuals({1., 0.1});
    for (auto &state : unclear.iterations)
      state.contact = 1.;
    explain("few iterations", unclear);
  }
} // namespace



int
main(int argc, char *argv[])
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_matrices_and_cells();
  test_points();
  test_iterations();
}
