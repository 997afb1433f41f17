#ifndef stickslip_simulation_failure_report_h
#define stickslip_simulation_failure_report_h

#include <stickslip/contact/cycling/status_history.h>

#include <stickslip/problem/contact_problem.h>

#include <stickslip/simulation/case_parameters.h>
#include <stickslip/simulation/failure_explanation.h>

#include <string>
#include <vector>

namespace stickslip
{
  /// What is said about a failed attempt at a load step.
  struct FailureReport
  {
    std::string        failure;   ///< the loop that failed
    std::string        contact;   ///< what the contact points were doing
    std::string        diagnosis; ///< name of the files with all points, or ""
    FailureExplanation explanation; ///< cause, place, advice

    /// For the log.
    std::string
    text() const;

    /// For the end of a run that @p failure ends: with the last accepted state
    /// of time @p time, where it is (@p state), and the explanation as the last
    /// three lines.
    std::string
    final_text(const std::string &failure,
               const double       time,
               const std::string &state) const;
  };



  /**
   * Looks at the failed attempt at step @p step, in the configuration in which
   * it ended, and writes the diagnosis of its contact points
   * (write_diagnosis()) into the output directory. Collective.
   */
  template <int dim>
  FailureReport
  report_failure(const NoConvergence                &failure,
                 const unsigned int                  step,
                 const CaseParameters               &parameters,
                 ContactProblem<dim>                &problem,
                 const StatusHistory<dim>           &statuses,
                 const std::vector<NewtonIteration> &iterations);
} // namespace stickslip

#endif
