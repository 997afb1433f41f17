// The command line: what is understood, and the messages for what is not.

#include <stickslip/base/command_line.h>
#include <stickslip/base/user_error.h>

#include <iostream>
#include <string>
#include <vector>

using namespace stickslip;

void
test(std::vector<const char *> arguments)
{
  arguments.insert(arguments.begin(), "stickslip");
  for (const char *argument : arguments)
    std::cout << argument << ' ';
  std::cout << "\n  ";
  try
    {
      const CommandLine line =
        parse_command_line(arguments.size(), arguments.data());
      const char *const actions[] = {
        "run", "help", "version", "print parameters", "validate", "diagnose"};
      std::cout << actions[static_cast<int>(line.action)] << " '"
                << line.parameter_file << "' format "
                << name_of(line.format, all_parameter_formats()) << " output '"
                << line.output_directory << "' restart '" << line.restart << "'"
                << (line.is_quiet ? " quiet" : "");
      for (const std::string &text : line.overrides)
        std::cout << " [" << text << ']';
    }
  catch (const UserError &error)
    {
      std::cout << "error: " << error.what();
    }
  std::cout << std::endl;
}

int
main()
{
  test({"case.prm"});
  test({"case.prm", "--set", "A b/C d=e f", "--set=A/B=1", "--quiet"});
  test({"--set", "A/B=1", "C=2", "case.prm", "--output-directory", "out"});
  test({"case.prm", "--output-directory=out/x", "--restart", "latest"});
  test({"--validate", "case.prm"});
  test({"--print-parameters"});
  test({"--print-parameters", "json"});
  test({"--print-parameters", "all", "case.prm"});
  test({"--print-parameters=markdown", "case.prm"});
  test({"--print-parameters", "case.prm", "--set", "A=b"});
  test({"--diagnose", "results"});
  test({"case.prm", "--nonsense", "--help"});
  test({"--version"});

  test({});
  test({"--quiet"});
  test({"--validate"});
  test({"a.prm", "b.prm"});
  test({"case.prm", "--outputdirectory", "x"});
  test({"case.prm", "-v"});
  test({"case.prm", "--output-directory"});
  test({"case.prm", "--output-directory", "--quiet"});
  test({"case.prm", "--set"});
  test({"case.prm", "--set", "A/B"});
  test({"case.prm", "--restart="});
  test({"--print-parameters", "jsn"});
  test({"--print-parameters", "--validate", "case.prm"});
  test({"--diagnose"});
  test({"--diagnose", "results", "--validate", "case.prm"});

  std::cout << help_text();
}
