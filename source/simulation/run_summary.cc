#include <stickslip/simulation/run_summary.h>

#include <stickslip/output/csv.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <map>
#include <ostream>
#include <sstream>
#include <utility>
#include <vector>

namespace stickslip
{
  namespace
  {
    /// An attempt at a step that was cut.
    struct CutAttempt
    {
      std::string step; ///< "step 4 to t = 0.8 (size 0.2)"
      std::string cause;
      std::string why, where, advice;
    };



    /// What convergence.log tells beside the iterations.
    struct LogSummary
    {
      std::vector<CutAttempt>  cuts;
      std::vector<std::string> warnings;
      std::string              last_step;
      bool                     is_done        = false;
      bool                     is_stopped     = false;
      bool                     is_interrupted = false;
    };



    /// True, with the rest of @p line in @p rest, if it begins with @p start.
    bool
    begins_with(const std::string &line,
                const std::string &start,
                std::string       &rest)
    {
      if (line.compare(0, start.size(), start) != 0)
        return false;
      rest = line.substr(
        std::min(line.find_first_not_of(' ', start.size()), line.size()));
      return true;
    }



    LogSummary
    read_log(std::istream &log)
    {
      LogSummary  summary;
      std::string line, rest;
      while (std::getline(log, line))
        {
          if (begins_with(line, "step failed:", rest))
            summary.cuts.push_back({summary.last_step, "", "", "", ""});
          else if (begins_with(line, "step ", rest))
            {
              summary.last_step      = line;
              summary.is_stopped     = false; // continued
              summary.is_interrupted = false;
              summary.is_done        = false;
            }
          else if (begins_with(line, "stopped:", rest))
            summary.is_stopped = true;
          else if (begins_with(line, "interrupted:", rest))
            summary.is_interrupted = true;
          else if (begins_with(line, "done:", rest))
            summary.is_done = true;
          else if (begins_with(line, "warning:", rest))
            summary.warnings.push_back(rest);
          if (summary.cuts.empty() || summary.is_stopped)
            continue;
          CutAttempt &cut = summary.cuts.back();
          if (begins_with(line, "  cause:", rest))
            cut.cause = rest;
          else if (begins_with(line, "  why:", rest))
            cut.why = rest;
          else if (begins_with(line, "  where:", rest))
            cut.where = rest;
          else if (begins_with(line, "  try:", rest))
            cut.advice = rest;
        }
      return summary;
    }



    std::string
    text_of(const double value)
    {
      std::ostringstream text;
      text << std::setprecision(4) << value;
      return text.str();
    }



    double
    sum(const CsvTable &table, const std::string &column)
    {
      double result = 0.;
      for (unsigned int row = 0; row < table.rows.size(); ++row)
        if (const double value = table.number(row, column);
            std::isfinite(value))
          result += value;
      return result;
    }



    /// Row with the largest value of a column.
    unsigned int
    row_of_largest(const CsvTable &table, const std::string &column)
    {
      unsigned int best = 0;
      for (unsigned int row = 1; row < table.rows.size(); ++row)
        if (table.number(row, column) > table.number(best, column))
          best = row;
      return best;
    }



    bool
    ends_with(const std::string &text, const std::string &end)
    {
      return text.size() >= end.size() &&
             text.compare(text.size() - end.size(), end.size(), end) == 0;
    }



    std::string
    state_in_words(const LogSummary &log)
    {
      return log.is_done      ? "done"
             : log.is_stopped ? "stopped without convergence"
             : log.is_interrupted
               ? "interrupted (--restart latest goes on)"
               : "not finished (running, or ended from outside)";
    }



    void
    print_progress(const CsvTable   &table,
                   const LogSummary &log,
                   std::ostream     &out)
    {
      const std::string time =
        table.rows.empty()
          ? "0"
          : text_of(table.number(table.rows.size() - 1, "time"));
      out << "State:       " << state_in_words(log) << ", " << table.rows.size()
          << " steps to t = " << time << '\n';
      if (!log.is_done && !log.last_step.empty())
        out << "Last try:    " << log.last_step << '\n';
    }



    void
    print_iterations(const CsvTable   &table,
                     const LogSummary &log,
                     std::ostream     &out)
    {
      const std::string column = "newton_iterations";
      out << "Newton:      " << sum(table, column) << " iterations";
      if (!table.rows.empty())
        {
          const unsigned int worst = row_of_largest(table, column);
          out << ", " << text_of(sum(table, column) / table.rows.size())
              << " per step, at most " << table.number(worst, column)
              << " (step " << table.text(worst, "step") << ")";
        }
      out << '\n';
      std::map<std::string, unsigned int> algorithms;
      for (unsigned int row = 0; row < table.rows.size(); ++row)
        ++algorithms[table.text(row, "algorithm")];
      out << "Algorithms: ";
      for (const auto &[name, n] : algorithms)
        out << ' ' << name << " (" << n << (n == 1 ? " step)" : " steps)");
      out << "\nCut:         " << log.cuts.size()
          << (log.cuts.size() == 1 ? " attempt" : " attempts") << '\n';
      std::map<std::string, std::vector<std::string>> by_cause;
      for (const CutAttempt &cut : log.cuts)
        by_cause[cut.cause.empty() ? "unknown" : cut.cause].push_back(cut.step);
      for (const auto &[cause, steps] : by_cause)
        out << "  " << steps.size() << " x " << cause << ", first in "
            << steps.front() << '\n';
    }



    void
    print_violations(const CsvTable &table, std::ostream &out)
    {
      out << "Largest violations of the contact law over the steps:\n";
      for (const std::string &column : table.columns)
        if (column.compare(0, 4, "max_") == 0 || ends_with(column, "_error"))
          {
            const unsigned int worst = row_of_largest(table, column);
            out << "  " << std::left << std::setw(22) << column << ' '
                << std::setw(12) << text_of(table.number(worst, column))
                << " (step " << table.text(worst, "step") << ")\n";
          }
    }



    void
    print_times(const CsvTable &table, std::ostream &out)
    {
      std::vector<std::pair<double, std::string>> phases;
      double                                      total = 0.;
      for (const std::string &column : table.columns)
        if (ends_with(column, "_seconds"))
          {
            phases.emplace_back(sum(table, column), column);
            total += phases.back().first;
          }
      std::sort(phases.rbegin(), phases.rend());
      out << "Time in accepted steps, " << text_of(total) << " s:\n";
      for (const auto &[seconds, name] : phases)
        out << "  " << std::left << std::setw(22) << name << ' '
            << std::setw(12) << text_of(seconds) << ' '
            << std::lround(100. * seconds / std::max(total, 1e-300)) << " %\n";
    }



    void
    print_files(const std::string &directory, std::ostream &out)
    {
      std::vector<std::string> names;
      std::error_code          error;
      for (const auto &file :
           std::filesystem::directory_iterator(directory, error))
        {
          const std::string name = file.path().filename().string();
          if (name.compare(0, 10, "diagnosis-") == 0)
            names.push_back(name);
        }
      std::sort(names.begin(), names.end());
      if (names.empty())
        return;
      out << "Contact points of the last failed attempt at a step:\n ";
      for (const std::string &name : names)
        out << ' ' << name;
      out << '\n';
    }



    void
    print_explanation(const LogSummary &log, std::ostream &out)
    {
      for (const std::string &text : log.warnings)
        out << "Warning: " << text << '\n';
      if (log.cuts.empty())
        {
          out << "No step was cut.\n";
          return;
        }
      const CutAttempt &last = log.cuts.back();
      out << (log.is_stopped ? "Why it stopped: "
                             : "Why a step was cut the last time: ")
          << last.cause << "\n  why:   " << last.why
          << "\n  where: " << last.where << "\n  try:   " << last.advice
          << '\n';
    }
  } // namespace



  std::string
  summarize_run(const std::string &directory, std::ostream &out)
  {
    std::ifstream log_file(directory + "/convergence.log");
    if (!log_file)
      return "--diagnose: there is no run in '" + directory +
             "' (no file convergence.log).";
    const LogSummary log = read_log(log_file);
    CsvTable         table; // stays empty if no step was accepted
    table.read(directory + "/statistics.csv");

    out << "Run in '" << directory << "'\n";
    print_progress(table, log, out);
    print_iterations(table, log, out);
    if (!table.rows.empty())
      {
        print_violations(table, out);
        print_times(table, out);
      }
    print_files(directory, out);
    print_explanation(log, out);
    return "";
  }
} // namespace stickslip
