#ifndef stickslip_base_command_line_h
#define stickslip_base_command_line_h

#include <stickslip/base/print_parameters.h>

#include <string>
#include <vector>

namespace stickslip
{
  /**
   * What the user asks for on the command line.
   */
  struct CommandLine
  {
    enum class Action
    {
      run,              ///< the case in parameter_file
      help,             ///< print help_text()
      version,          ///< print version_text()
      print_parameters, ///< in format; of parameter_file if there is one
      validate,         ///< check parameter_file, compute nothing
      diagnose,         ///< summarize the run in output_directory
      inspect_mesh      ///< tell what is in mesh_file
    };

    Action      action = Action::run;
    std::string parameter_file; ///< empty only for actions without a case

    /// "Section/Name=value", in order; for ParameterFile::override_with().
    std::vector<std::string> overrides;

    std::string mesh_file;    ///< of inspect_mesh
    bool        json = false; ///< inspect_mesh prints for programs

    std::string output_directory; ///< empty: as the parameter file says

    /// Continue from this checkpoint: a directory or "latest"; empty: start.
    std::string restart;

    ParameterFormat format   = ParameterFormat::users;
    bool            is_quiet = false; ///< print warnings and errors only
  };

  /**
   * Reads the arguments of main(). Not collective; the result is the same on
   * all ranks. Throws UserError for an unknown option (with the nearest one),
   * a missing value or file, and for contradictions.
   */
  CommandLine
  parse_command_line(const int argc, const char *const *argv);

  /// What `--help` prints: usage, options, examples, exit codes.
  std::string
  help_text();

  /// Says from which commit the program has been built ("" if nobody knows);
  /// main() knows it, the library does not.
  void
  set_source_commit(const std::string &commit);

  /// What `--version` prints: the program's version and commit, and deal.II's
  /// version.
  std::string
  version_text();
} // namespace stickslip

#endif
