#include <stickslip/base/command_line.h>

#include <deal.II/base/config.h>

#include <stickslip/base/nearest_name.h>
#include <stickslip/base/user_error.h>

#include <algorithm>

namespace stickslip
{
  namespace
  {
    /// Of the program that is running; empty where nobody has said it.
    std::string source_commit;



    const std::vector<std::string> &
    command_line_options()
    {
      static const std::vector<std::string> names = {"--help",
                                                     "--version",
                                                     "--print-parameters",
                                                     "--validate",
                                                     "--set",
                                                     "--output-directory",
                                                     "--restart",
                                                     "--diagnose",
                                                     "--inspect-mesh",
                                                     "--quiet"};
      return names;
    }



    bool
    is_command_line_option(const std::string &argument)
    {
      return argument.size() > 1 && argument[0] == '-';
    }



    /// The arguments, left to right; `--option=value` counts as two.
    class ArgumentReader
    {
    public:
      ArgumentReader(const int argc, const char *const *argv)
      {
        for (int i = 1; i < argc; ++i)
          {
            const std::string argument   = argv[i];
            const std::size_t equal_sign = argument.find('=');
            if (argument.compare(0, 2, "--") == 0 &&
                equal_sign != std::string::npos)
              {
                arguments.push_back(argument.substr(0, equal_sign));
                arguments.push_back(argument.substr(equal_sign + 1));
              }
            else
              arguments.push_back(argument);
          }
      }

      bool
      is_at_end() const
      {
        return position == arguments.size();
      }

      /// "" at the end.
      std::string
      peek() const
      {
        return is_at_end() ? "" : arguments[position];
      }

      std::string
      next()
      {
        return arguments[position++];
      }

      /// The value of an option that needs one.
      std::string
      value_of(const std::string &option, const std::string &what)
      {
        if (is_at_end() || is_command_line_option(peek()) || peek().empty())
          throw UserError("The option '" + option + "' needs " + what + ".");
        return next();
      }

    private:
      std::vector<std::string> arguments;
      std::size_t              position = 0;
    };



    void
    choose_action(CommandLine &command_line, const CommandLine::Action action)
    {
      if (command_line.action != CommandLine::Action::run &&
          command_line.action != action)
        throw UserError(
          "'--validate', '--print-parameters', '--diagnose' and "
          "'--inspect-mesh' exclude each other.");
      command_line.action = action;
    }



    void
    read_overrides(ArgumentReader &reader, CommandLine &command_line)
    {
      // Further assignments may follow without repeating the option.
      do
        {
          const std::string assignment =
            reader.value_of("--set", "\"Section/Name=value\"");
          if (assignment.find('=') == std::string::npos)
            throw UserError(
              "The option '--set' needs \"Section/Name=value\", "
              "but '" +
              assignment + "' has no '='.");
          command_line.overrides.push_back(assignment);
      } while (!is_command_line_option(reader.peek()) &&
               reader.peek().find('=') != std::string::npos);
    }



    void
    read_format(ArgumentReader &reader, CommandLine &command_line)
    {
      const std::string              word  = reader.peek();
      const std::vector<std::string> known = names_of(all_parameter_formats());
      if (std::find(known.begin(), known.end(), word) != known.end())
        command_line.format = value_of(reader.next(), all_parameter_formats());
      // A bare word that is not a format is not the name of a case either.
      else if (!word.empty() && !is_command_line_option(word) &&
               word.find_first_of("./") == std::string::npos)
        throw UserError("'--print-parameters': unknown format '" + word + "'." +
                        did_you_mean(word, known) +
                        " Known: " + quoted_list(known) + ".");
    }



    void
    read_option(ArgumentReader &reader, CommandLine &command_line)
    {
      using Action             = CommandLine::Action;
      const std::string option = reader.next();

      if (option == "--print-parameters")
        {
          choose_action(command_line, Action::print_parameters);
          read_format(reader, command_line);
        }
      else if (option == "--validate")
        choose_action(command_line, Action::validate);
      else if (option == "--set")
        read_overrides(reader, command_line);
      else if (option == "--output-directory")
        command_line.output_directory = reader.value_of(option, "a directory");
      else if (option == "--restart")
        command_line.restart =
          reader.value_of(option, "a checkpoint directory or 'latest'");
      else if (option == "--diagnose")
        {
          choose_action(command_line, Action::diagnose);
          command_line.output_directory =
            reader.value_of(option, "the output directory of a run");
        }
      else if (option == "--inspect-mesh")
        {
          choose_action(command_line, Action::inspect_mesh);
          command_line.mesh_file = reader.value_of(option, "a mesh file");
          command_line.json      = (reader.peek() == "json");
          if (command_line.json)
            reader.next();
        }
      else if (option == "--quiet")
        command_line.is_quiet = true;
      else
        throw UserError("Unknown option '" + option + "'." +
                        did_you_mean(option, command_line_options()) +
                        " Known: " + quoted_list(command_line_options()) + ".");
    }



    bool
    has_argument(const int          argc,
                 const char *const *argv,
                 const std::string &option)
    {
      return std::find(argv + std::min(argc, 1), argv + argc, option) !=
             argv + argc;
    }
  } // namespace



  CommandLine
  parse_command_line(const int argc, const char *const *argv)
  {
    CommandLine command_line;

    // Who asks for help gets it, whatever else the line says.
    if (has_argument(argc, argv, "--help") || has_argument(argc, argv, "-h"))
      {
        command_line.action = CommandLine::Action::help;
        return command_line;
      }
    if (has_argument(argc, argv, "--version"))
      {
        command_line.action = CommandLine::Action::version;
        return command_line;
      }

    ArgumentReader reader(argc, argv);
    while (!reader.is_at_end())
      if (is_command_line_option(reader.peek()))
        read_option(reader, command_line);
      else if (command_line.parameter_file.empty())
        command_line.parameter_file = reader.next();
      else
        throw UserError("Two parameter files: '" + command_line.parameter_file +
                        "' and '" + reader.peek() +
                        "'. One run reads one file.");

    if (command_line.parameter_file.empty() &&
        command_line.action != CommandLine::Action::print_parameters &&
        command_line.action != CommandLine::Action::diagnose &&
        command_line.action != CommandLine::Action::inspect_mesh)
      throw UserError(
        "No parameter file. Usage: stickslip case.prm [options]; "
        "stickslip --help tells more.");
    return command_line;
  }



  std::string
  help_text()
  {
    return R"(stickslip: frictional contact between deformable bodies

Usage: stickslip case.prm [options]
       mpirun -np 4 stickslip case.prm [options]

Options:
  --set "Section/Name=value"    replace a parameter of the file; more than once
  --output-directory DIRECTORY  write results there
  --restart DIRECTORY|latest    continue from a checkpoint
  --validate                    check the parameter file and stop
  --diagnose DIRECTORY          tell how the run in this output directory went,
                                why it stopped and what to try
  --inspect-mesh FILE [json]    tell what is in a mesh file: bodies, names,
                                extents, quality, gaps between bodies, what
                                looks wrong; json: for programs
  --print-parameters [FORMAT]   print the parameters with their documentation;
                                with case.prm its own, with their values;
                                FORMAT: prm (default; expert parameters only
                                where they are set), all (expert parameters,
                                too), json, markdown
  --quiet                       print warnings and errors only
  --version                     print the version
  --help                        print this text

Examples:
  stickslip parameters/quickstart.prm
  stickslip case.prm --set "Dimension=3" --output-directory results
  stickslip --validate case.prm
  stickslip case.prm --print-parameters > complete.prm
  stickslip --diagnose results
  stickslip --inspect-mesh part.msh

Exit codes:
  0  done
  1  wrong input: the message names the parameter and what is allowed
  2  no convergence, even with the smallest load step
  3  internal error: please report it
  4  solved, but a value in section Checks falls short
  5  stopped by SIGTERM, SIGUSR1 or 'Output/Stop after'; the last accepted state
     is saved, --restart latest goes on
)";
  }



  void
  set_source_commit(const std::string &commit)
  {
    source_commit = commit;
  }



  std::string
  version_text()
  {
    return "stickslip " STICKSLIP_VERSION " (" +
           (source_commit.empty() ? "" : "commit " + source_commit + ", ") +
           "deal.II " DEAL_II_PACKAGE_VERSION ")\n";
  }
} // namespace stickslip
