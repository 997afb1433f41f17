// Cycles of contact statuses are put into one point by hand: it gets the r that
// closed forms give, or a fixed status, at most three times; the contact law is
// back when statuses are released.

#include "planted_contact.h"
#include "print.h"

#include <stickslip/contact/cycling/status_cycle_treatment.h>

#include <iostream>
#include <string>
#include <vector>

using namespace stickslip;

namespace
{
  /// Stiffness k = 20/3 and pressure 8, so that k/s = 5/3.
  std::string
  case_text(const std::string &scale)
  {
    return two_blocks(
      "set Quadrature = nodal\nset Friction = Coulomb\n"
      "set Friction coefficient = 0.5\nsubsection Regularization\n" +
      scale + "end\n");
  }

  const std::string automatic = "";
  const std::string plain = "set Scale = plain\nset r_n = 1e6\nset r_t = 1e6\n";



  ObservedState<2>
  observed(const ContactState state,
           const double       lambda_n,
           const double       d_n,
           const double       Lambda = 0.,
           const double       d_t    = 0.)
  {
    ObservedState<2> result;
    result.state             = state;
    result.values.lambda_n   = lambda_n;
    result.values.d_n        = d_n;
    result.values.Lambda[0]  = Lambda;
    result.values.d_t[0]     = d_t;
    result.slip_direction[0] = state == ContactState::slip ? 1. : 0.;
    return result;
  }

  // The status of the first is closed up to r = 3, that of the second always.
  const auto opens  = observed(ContactState::open, -3., -1.);
  const auto closes = observed(ContactState::stick, -1., 1.);
  // The first slips from r = 0.5, the second from r = 2.
  const auto slips  = observed(ContactState::slip, -8., 0., 0.5, 1.);
  const auto sticks = observed(ContactState::stick, -8., 0., 0., 0.5);
  // One closed, one open, whatever r.
  const auto always_open   = observed(ContactState::open, 1., -1.);
  const auto always_closed = observed(ContactState::stick, -1., 1.);
  // Slip to and fro, whatever r.
  const auto forward  = observed(ContactState::slip, -8., 0., 2., 1.);
  auto       backward = observed(ContactState::slip, -8., 0., -0.5, 0.);



  /// The case, and one point of it that does what a test says.
  class PlantedCycle : public PlantedContact
  {
  public:
    explicit PlantedCycle(const std::string &scale,
                          const bool         adapt = true,
                          const bool         fix   = true)
      : PlantedContact(case_text(scale))
      , treatment(parameters_with(adapt, fix), problem.contact())
    {
      press([](const double) { return -8.; });
      treatment.begin_step();
      treatment.begin_solve();
    }

    /// Three periods of the states; in the last iteration cycles are treated.
    CycleTreatment
    repeat(const std::vector<ObservedState<2>> &states)
    {
      CycleTreatment result = CycleTreatment::none;
      for (unsigned int i = 0; i < 3 * states.size(); ++i)
        {
          for (auto &other : points())
            other.observed = observed(ContactState::stick, -8., 0.);
          point().observed = states[i % states.size()];
          result           = treatment.observe(i + 1 == 3 * states.size());
        }
      // the scales follow
      press([](const double) { return -8.; });
      return result;
    }

    ContactPoint<2> &
    point()
    {
      return points()[0];
    }

    /// What the law, or a fixed status, makes of a pressed point at rest.
    std::string
    status()
    {
      const ContactStatus status =
        problem.contact().evaluate(pair(), point()).status;
      return !status.closed ? "open" : status.stick ? "stick" : "slip";
    }

    StatusCycleTreatment<2> treatment;

  private:
    static CyclingParameters
    parameters_with(const bool adapt, const bool fix)
    {
      CyclingParameters parameters;
      parameters.adapt_scales = adapt;
      parameters.fix_statuses = fix;
      return parameters;
    }
  };



  std::string
  text_of(const CycleTreatment treatment)
  {
    return treatment == CycleTreatment::none      ? "no cycle"
           : treatment == CycleTreatment::treated ? "treated"
                                                  : "untreatable";
  }



  void
  report(const std::string   &title,
         PlantedCycle        &cycle,
         const CycleTreatment result)
  {
    const Regularization &r = cycle.point().regularization;
    std::cout << "  " << title << ": " << text_of(result) << ' '
              << name_of(cycle.treatment.history().treatment(0, 0)) << ", r_n "
              << r.r_n_status << ", r_t " << r.r_t_status << ", "
              << cycle.status() << '\n';
  }



  void
  test_other_r()
  {
    std::cout << "Another r, the nearest to 20/3 and 5/3\n";
    for (const unsigned int period : {2, 3})
      {
        const std::string name = "period " + std::to_string(period) + ", ";
        // 1.5 is half of the bound; at 20/3 and 6 the statuses differ
        PlantedCycle normal(plain);
        report(name + "contact/open",
               normal,
               normal.repeat(
                 period == 2
                   ? std::vector<ObservedState<2>>{opens, closes}
                   : std::vector<ObservedState<2>>{opens, opens, closes}));
        // 4 is twice the larger bound, 1/4 half of the smaller one
        PlantedCycle tangential(plain);
        report(name + "stick/slip",
               tangential,
               tangential.repeat(
                 period == 2
                   ? std::vector<ObservedState<2>>{slips, sticks}
                   : std::vector<ObservedState<2>>{slips, slips, sticks}));
        print("    the other r stays",
              tangential.point().regularization.r_n_status == 1e6);
        print("    and so does that of the others",
              tangential.points()[3].regularization.r_t_status == 1e6);
      }
    PlantedCycle near(automatic);
    report("at 20/3, nearer than 1.5", near, near.repeat({opens, closes}));
    PlantedCycle again(plain);
    again.repeat({opens, closes});
    report("a second time", again, again.repeat({opens, closes}));
    PlantedCycle other(plain);
    other.repeat({opens, closes});
    report("then stick/slip", other, other.repeat({slips, sticks}));
    PlantedCycle off(plain, false);
    report("'Adapt r' off", off, off.repeat({opens, closes}));
  }



  void
  test_fixed_statuses()
  {
    std::cout
      << "Fixed statuses of points that no r helps, the law says stick\n";
    PlantedCycle normal(automatic);
    for (const std::string time : {"first", "second", "third", "fourth"})
      report(time + " time",
             normal,
             normal.repeat({always_open, always_closed}));
    const CycleTreatmentCounts &counts = normal.treatment.counts;
    std::cout << "  " << counts.cycles << " cycles, " << counts.adapted_scales
              << " other r, " << counts.fixed_statuses << " fixed\n";
    print("  released", normal.treatment.release());
    print("  nothing is left to release", !normal.treatment.release());
    std::cout << "  then " << normal.status() << '\n';

    // five of the six records that prove a cycle, and one after the release
    PlantedCycle forgets(automatic);
    forgets.repeat({always_open, always_closed});
    CycleTreatment result = CycleTreatment::none;
    for (unsigned int i = 0; i < 6; ++i)
      {
        if (i == 5)
          forgets.treatment.release();
        forgets.point().observed = i % 2 == 0 ? always_open : always_closed;
        result                   = forgets.treatment.observe(i == 5);
      }
    std::cout << "  a cycle across the release: " << text_of(result) << '\n';

    PlantedCycle tangential(automatic);
    for (const std::string time : {"first", "second", "third", "fourth"})
      report(time + " time, slip to and fro",
             tangential,
             tangential.repeat({forward, backward}));
    tangential.treatment.begin_solve();
    report("in another solve",
           tangential,
           tangential.repeat({forward, backward}));
    PlantedCycle off(automatic, true, false);
    report("'Hold statuses' off",
           off,
           off.repeat({always_open, always_closed}));
  }



  void
  test_left_alone()
  {
    std::cout << "What is left alone\n";
    PlantedCycle constant(automatic);
    report("no cycle", constant, constant.repeat({closes, closes}));
    PlantedCycle pairing(automatic);
    report("paired and unpaired",
           pairing,
           pairing.repeat({observed(ContactState::unpaired, 0., 0.), closes}));
    std::cout << "    "
              << pairing.treatment.last_report()
                   ->n_cycling[static_cast<unsigned int>(CycleKind::pairing)]
              << " point of a pairing cycle, "
              << pairing.treatment.last_report()->n_fixed << " fixed\n";
    PlantedCycle   facet(automatic);
    CycleTreatment result = CycleTreatment::none;
    for (unsigned int i = 0; i < 6; ++i)
      {
        facet.point().observed             = closes;
        facet.point().pairing.face_id.face = i % 2;
        result                             = facet.treatment.observe(i == 5);
      }
    report("from facet to facet", facet, result);
    PlantedCycle asked(automatic);
    asked.repeat({opens, closes});
    for (unsigned int i = 0; i < 6; ++i)
      {
        asked.point().observed = i % 2 == 0 ? opens : closes;
        if (asked.treatment.observe(false) != CycleTreatment::none)
          std::cout << "  treated without being asked\n";
      }
    print("  no report where nothing was asked for",
          !asked.treatment.last_report());
  }
} // namespace



int
main(int argc, char *argv[])
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  backward.slip_direction[0] = -1.;
  test_other_r();
  test_fixed_statuses();
  test_left_alone();
}
