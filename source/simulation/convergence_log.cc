#include <stickslip/simulation/convergence_log.h>

#include <iomanip>

namespace stickslip
{
  ConvergenceLog::ConvergenceLog(const std::string &directory,
                                 const MPI_Comm    &communicator)
  {
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      name = directory + "/convergence.log";
  }



  void
  ConvergenceLog::open(const bool go_on)
  {
    if (!name.empty())
      file.open(name, go_on ? std::ios::app : std::ios::trunc);
  }



  void
  ConvergenceLog::begin_step(const unsigned int step,
                             const double       time,
                             const double       size)
  {
    last_run.clear();
    if (file.is_open())
      file << "step " << step << " to t = " << time << " (size " << size
           << ")\n        Newton   equilibrium       contact    prescribed"
              "     increment   length"
           << std::endl;
  }



  void
  ConvergenceLog::newton_iteration(const unsigned int     iteration,
                                   const NewtonIteration &state)
  {
    if (iteration == 0)
      last_run.clear();
    last_run.push_back(state);
    if (file.is_open())
      file << std::setw(14) << iteration << std::scientific
           << std::setprecision(4) << std::setw(14) << state.equilibrium
           << std::setw(14) << state.contact << std::setw(14)
           << state.prescribed << std::setw(14) << state.increment
           << std::defaultfloat << std::setw(9) << state.step_length
           << std::endl;
  }



  void
  ConvergenceLog::loop_pass(const std::string &quantity,
                            const unsigned int pass,
                            const double       change,
                            const unsigned int depth)
  {
    if (file.is_open())
      file << std::string(2 + 2 * depth, ' ') << quantity << " pass " << pass
           << ": change " << change << std::endl;
  }



  void
  ConvergenceLog::cycle_treatment(const CycleReport &report)
  {
    if (!file.is_open())
      return;
    file << "  statuses repeat (";
    for (unsigned int kind = 0, n_words = 0; kind < n_cycle_kinds; ++kind)
      if (report.n_cycling[kind] > 0)
        file << (n_words++ > 0 ? ", " : "") << report.n_cycling[kind]
             << " points " << name_of(static_cast<CycleKind>(kind));
    file << "): " << report.n_other_r << " get another r, " << report.n_fixed
         << " a fixed status until the rest has converged" << std::endl;
  }



  void
  ConvergenceLog::rounding(const LawRounding &width)
  {
    if (!file.is_open())
      return;
    if (width.acts())
      file << "  corners of the contact law rounded: pressure by "
           << width.pressure << ", disc of friction by " << width.disc
           << std::endl;
    else
      file << "  contact law exact again" << std::endl;
  }



  void
  ConvergenceLog::note(const std::string &text)
  {
    if (file.is_open())
      file << text << std::endl;
  }
} // namespace stickslip
