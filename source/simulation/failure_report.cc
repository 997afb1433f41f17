#include <stickslip/simulation/failure_report.h>

#include <stickslip/contact/results/contact_results.h>

#include <stickslip/output/diagnosis_output.h>

#include <stickslip/strategy/solution_strategy.h>

#include <sstream>
#include <vector>

namespace stickslip
{
  std::string
  FailureReport::text() const
  {
    return "step failed: " + failure + "\n" + contact +
           "  cause: " + explanation.name + "\n" + explanation.text("  ");
  }



  std::string
  FailureReport::final_text(const std::string &last_failure,
                            const double       time,
                            const std::string &state) const
  {
    std::ostringstream text;
    text << last_failure << "\nThe contact points when it failed:\n"
         << contact << "Last accepted state: t = " << time << ". " << state
         << "\nAll iterations are in convergence.log";
    if (!diagnosis.empty())
      text << ", all contact points in " << diagnosis << ".csv and .vtu";
    text << ".\nCause: " << explanation.name << "\n" << explanation.text("  ");
    return text.str();
  }



  template <int dim>
  FailureReport
  report_failure(const NoConvergence                &failure,
                 const unsigned int                  step,
                 const CaseParameters               &parameters,
                 ContactProblem<dim>                &problem,
                 const StatusHistory<dim>           &statuses,
                 const std::vector<NewtonIteration> &iterations)
  {
    const MPI_Comm communicator = problem.contact().get_communicator();
    const auto     points       = diagnose_points(problem.contact(), statuses);
    std::vector<std::string> pair_names;
    for (const auto &pair : parameters.contact_pairs)
      pair_names.push_back(pair.first);

    FailureReport report;
    report.failure   = failure.what();
    report.contact   = describe_contact(problem.contact());
    report.diagnosis = write_diagnosis(
      parameters.output.directory, step, points, pair_names, communicator);
    const bool needs_supports = needs_held_bodies(parameters.algorithm.name);
    report.explanation =
      explain_failure<dim>({failure,
                            iterations,
                            parameters.algorithm.newton,
                            statuses.cycle(),
                            points,
                            parameters.contact_pairs,
                            problem.free_motions(),
                            problem.weakly_held_motions(),
                            needs_supports ? problem.motions_held_by_springs()
                                           : std::vector<FreeMotion>()},
                           communicator);
    return report;
  }

#define INSTANTIATE(dim)                                            \
  template FailureReport report_failure(const NoConvergence &,      \
                                        const unsigned int,         \
                                        const CaseParameters &,     \
                                        ContactProblem<dim> &,      \
                                        const StatusHistory<dim> &, \
                                        const std::vector<NewtonIteration> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
