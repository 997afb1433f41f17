// ParameterFile: reading, named lists, overrides, printing, and the messages
// for wrong files.

#include <deal.II/base/mpi.h>
#include <deal.II/base/parameter_handler.h>

#include <stickslip/base/expert_parameter.h>
#include <stickslip/base/parameter_file.h>
#include <stickslip/base/print_parameters.h>
#include <stickslip/base/registry.h>
#include <stickslip/base/user_error.h>

#include <fstream>
#include <functional>
#include <iostream>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

using namespace dealii;
using namespace stickslip;

struct BodyParameters
{
  std::string generator = "hyper_cube";
  std::string arguments;
  double      scale = 1;
  std::string shape = "round";
  int         seed  = 0;

  void
  add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Generator",
                      generator,
                      "Name of the mesh generator.",
                      Patterns::Selection("hyper_cube|hyper_shell|file"),
                      /*has_to_be_set=*/true);
    prm.add_parameter("Arguments", arguments, "Its arguments.");
    prm.add_parameter("Scale factor",
                      scale,
                      "Multiplies all coordinates (a | b, <c>).",
                      Patterns::Double(0.));
    prm.add_parameter("Shape",
                      shape,
                      "A description that is longer than the place that it has "
                      "in a line, so that one place has to do.");
    prm.add_parameter("Seed",
                      seed,
                      expert("Where the generator begins."),
                      Patterns::Integer(0));
  }
};

struct TestParameters
{
  unsigned int              dimension = 2;
  std::vector<double>       times     = {0.5, 1};
  std::string               treatment = "newton";
  bool                      symmetric = false;
  NamedList<BodyParameters> bodies;

  void
  add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Dimension",
                      dimension,
                      "Space dimension.",
                      Patterns::Integer(2, 3));
    prm.add_parameter("Output times", times, "Hit exactly.");
    prm.enter_subsection("Algorithm");
    prm.add_parameter("Treatment",
                      treatment,
                      "Of the geometry.",
                      Patterns::Selection("newton|fixed point"));
    prm.add_parameter("Symmetric", symmetric, "Drop unsymmetric terms.");
    prm.leave_subsection();
    prm.enter_subsection("Bodies");
    for (auto &[name, body] : bodies)
      {
        prm.enter_subsection(name);
        body.add_parameters(prm);
        prm.leave_subsection();
      }
    prm.leave_subsection();
  }
};

bool
i_speak()
{
  return Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
}

void
say(const std::string &text)
{
  if (i_speak())
    std::cout << text << std::endl;
}

void
expect_user_error(const std::string &title, const std::function<void()> &action)
{
  std::string message;
  try
    {
      action();
    }
  catch (const UserError &error)
    {
      message = error.what();
    }
  // all ranks or none
  const unsigned int n_thrown =
    Utilities::MPI::sum(message.empty() ? 0u : 1u, MPI_COMM_WORLD);
  const bool is_on_all_ranks =
    (n_thrown == Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD));
  say("-- " + title + (is_on_all_ranks ? "" : ": NOT THROWN ON ALL RANKS"));
  say(message);
}

void
write_file(const std::string &name, const std::string &text)
{
  if (i_speak())
    std::ofstream(name) << text;
  Utilities::MPI::sum(1, MPI_COMM_WORLD); // no rank goes on before
}

/// Reads all parameters of a case as an application does.
void
apply(const ParameterFile &file, TestParameters &parameters)
{
  ParameterHandler prm;
  file.declare_names("Bodies", parameters.bodies);
  parameters.add_parameters(prm);
  file.apply_to(prm);
}

void
print(const TestParameters &parameters)
{
  std::ostringstream out;
  out << "dimension " << parameters.dimension << ", treatment '"
      << parameters.treatment << "', symmetric " << parameters.symmetric
      << ", times";
  for (const double time : parameters.times)
    out << ' ' << time;
  for (const auto &[name, body] : parameters.bodies)
    out << "\n  body '" << name << "': " << body.generator << "("
        << body.arguments << "), scale " << body.scale << ", seed "
        << body.seed;
  say(out.str());
}

void
test_good_file()
{
  write_file("parameter_file_included.prm",
             "subsection Algorithm\n"
             "  set Treatment = fixed point\n"
             "  set Symmetric = true\n"
             "end\n");
  write_file("parameter_file_good.prm",
             "# a comment\n"
             "include parameter_file_included.prm\n"
             "set Dimension\t=  3  # another one\n"
             "set Output times = 0.25, \\\n"
             "                   # between continued lines\n"
             "                   0.5,\\\n"
             "                   1\n"
             "subsection Algorithm\n"
             "  set Treatment = newton   # replaces the included value\n"
             "end\n"
             "SUBSECTION Bodies\n"
             "  subsection upper\tblock\n"
             "    set Generator   = hyper_cube\r\n"
             "    set Scale  factor = 2e3\n"
             "  end\n"
             "  subsection Körper\n"
             "    set Generator = file\n"
             "    set Arguments = name = a.msh\n"
             "  END\n"
             "end\n");

  ParameterFile  file("parameter_file_good.prm", MPI_COMM_WORLD);
  TestParameters parameters;
  apply(file, parameters);
  print(parameters);
  say("directory " + file.directory());
  say("arguments and scale factor of Körper: " +
      file.value_of("Bodies/Körper", "Arguments").value_or("not set") + "; " +
      file.value_of("Bodies/Körper", "Scale factor").value_or("not set"));

  say("-- overrides");
  file.override_with("Dimension=2");
  file.override_with("Bodies/upper block/Scale factor = 3");
  file.override_with("Bodies/upper block/Scale factor=4");
  file.override_with("Bodies/upper block/Arguments=a=b/c");
  TestParameters overridden;
  apply(file, overridden);
  print(overridden);
}

void
test_syntax_errors()
{
  say("-- syntax errors");
  for (const std::string &text : std::vector<std::string>{
         "\nsbsection Bodies\nend",
         "set Dimension 3",
         "set = 3",
         "subsection",
         "subsection A/B\nend",
         "end",
         "# x\nsubsection Bodies\n  subsection block\nend\n",
         "set Dimension = 2\n\nset  Dimension=2",
         "subsection A\nend A",
         "include",
         "set A/B = 3"})
    try
      {
        ParameterFile::from_string(text, "case.prm");
        say("accepted: " + text);
      }
    catch (const UserError &error)
      {
        say(error.what());
      }
}

void
test_file_errors()
{
  write_file("parameter_file_a.prm", "\ninclude parameter_file_b.prm\n");
  write_file("parameter_file_b.prm", "include parameter_file_a.prm\n");
  write_file("parameter_file_c.prm",
             "set Dimension = 2\ninclude parameter_file_d.prm\n");
  write_file("parameter_file_d.prm", "set Dimension = 3\n");
  write_file("parameter_file_e.prm", "include no_such_file.prm\n");
  write_file("parameter_file_f.prm",
             "subsection A\ninclude parameter_file_g.prm\nend\n");
  write_file("parameter_file_g.prm", "end\n");
  for (const std::string name : {"no_such_file.prm",
                                 ".",
                                 "parameter_file_a.prm",
                                 "parameter_file_c.prm",
                                 "parameter_file_e.prm",
                                 "parameter_file_f.prm"})
    expect_user_error(name, [&] { ParameterFile(name, MPI_COMM_WORLD); });
}

void
test_wrong_entries()
{
  write_file("parameter_file_wrong.prm",
             "set Dimension = 4\n"
             "set Dimensoin = 2\n"
             "set Algorithm = GNM\n"
             "set Symmetric = true\n"
             "set Output times = 1, x\n"
             "subsection Algorithms\n"
             "  set Treatment = newton\n"
             "end\n"
             "subsection Algorithm\n"
             "  set Treatment = Newton\n"
             "  set Symmetric = perhaps\n"
             "  subsection Treatment\n"
             "  end\n"
             "end\n"
             "subsection Bodies\n"
             "  set Scale factor = 2\n"
             "  subsection block\n"
             "    set Scale = -1\n"
             "    set Scale factor = -1\n"
             "  end\n"
             "end\n");
  ParameterFile  file("parameter_file_wrong.prm", MPI_COMM_WORLD);
  TestParameters parameters;
  file.override_with("Bodies/blok/Scale factor=2");
  file.override_with("Algorithm/Treatment=fixed points");
  expect_user_error("wrong entries", [&] { apply(file, parameters); });
  expect_user_error("--set without =", [&] { file.override_with("Bodies"); });
  expect_user_error("--set without name", [&] { file.override_with("=3"); });
  expect_user_error("mandatory under a condition", [&] {
    file.require("Bodies/block", {"Scale factor", "Arguments", "Generator"});
  });
  expect_user_error("unknown implementation", [&] {
    const Registry<int, const int &> numbers(
      "number",
      {{"one", "the first", [](const int &) { return std::unique_ptr<int>(); }},
       {"two", "twice the argument", [](const int &x) {
          return std::make_unique<int>(2 * x);
        }}});
    say("-- registry");
    say(std::to_string(*numbers.create("two", "Numbers/a", 21)) + " " +
        numbers.selection() + "\n" + numbers.descriptions());
    numbers.create("tow", "Numbers/a", 21);
  });
}

void
test_printing()
{
  TestParameters parameters;
  parameters.bodies.emplace_back("<body>", BodyParameters());
  parameters.bodies.emplace_back("<other body>", BodyParameters());
  ParameterHandler prm;
  parameters.add_parameters(prm);
  prm.set("Dimension", "3");
  prm.enter_subsection("Bodies");
  prm.enter_subsection("<other body>");
  prm.set("Seed", "7");
  prm.leave_subsection();
  prm.leave_subsection();

  std::map<ParameterFormat, std::string> printed;
  for (const auto &[name, format] : all_parameter_formats())
    {
      std::ostringstream out;
      print_parameters(out, prm, format);
      printed[format] = out.str();
      say("-- " + name);
      say(printed[format]);
    }

  for (const auto format : {ParameterFormat::users, ParameterFormat::all})
    {
      say("-- printed as '" + name_of(format, all_parameter_formats()) +
          "' and read again");
      TestParameters again;
      apply(ParameterFile::from_string(printed[format], "printed.prm"), again);
      print(again);
    }
}



/// Messages know expert parameters as all others.
void
test_unknown_expert_parameter()
{
  TestParameters parameters;
  expect_user_error("misspelt expert parameter", [&] {
    apply(ParameterFile::from_string("subsection Bodies\n"
                                     " subsection a\n"
                                     "  set Generator = file\n"
                                     "  set Sed = 1\n"
                                     " end\n"
                                     "end\n",
                                     "case.prm"),
          parameters);
  });
}

int
main(int argc, char **argv)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  test_good_file();
  test_syntax_errors();
  test_file_errors();
  test_wrong_entries();
  test_printing();
  test_unknown_expert_parameter();
}
