#include <stickslip/output/output_parameters.h>

#include <stickslip/base/duration.h>
#include <stickslip/base/expert_parameter.h>
#include <stickslip/base/user_error.h>

#include <utility>

namespace stickslip
{
  void
  PointParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Body", body, "The body that the point belongs to.");
    prm.add_parameter("Position",
                      position,
                      "Coordinates of the point in the undeformed body, one "
                      "per dimension, separated by commas.");
    prm.add_parameter("Material state",
                      material_state,
                      "Record Cauchy stress and history variables (equivalent "
                      "plastic strain, ...) of the nearest quadrature point of "
                      "the cell, too: NAME.cauchy_stress_xx, "
                      "NAME.equivalent_plastic_strain, ...",
                      dealii::Patterns::Bool());
    prm.add_parameter("Contact pair",
                      contact_pair,
                      "Record contact at the point, too, which has to be on "
                      "the slave surface of this pair: NAME.pressure, NAME.gap "
                      "and NAME.tangential_traction_x, ..., as in the fields "
                      "of contact.pvd. Empty: no contact.");
  }



  void
  PointParameters::check(const std::string &path) const
  {
    if (body.empty())
      throw UserError(path + "/Body: the name of a body is needed.");
    if (position.size() != 2 && position.size() != 3)
      throw UserError(path + "/Position: found " +
                      std::to_string(position.size()) +
                      " coordinates, one per dimension is needed.");
  }



  void
  ContactLineParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Contact pair",
                      contact_pair,
                      "The pair on whose slave surface the line is.");
    prm.add_parameter("From",
                      from,
                      "First point, in the undeformed body: coordinates, "
                      "separated by commas.");
    prm.add_parameter("To", to, "Last point.");
    prm.add_parameter("Points",
                      n_points,
                      "Number of points, at equal distances.",
                      dealii::Patterns::Integer(2, 100000));
  }



  void
  ContactLineParameters::check(const std::string &path,
                               const unsigned int dimension) const
  {
    if (contact_pair.empty())
      throw UserError(path + "/Contact pair: the name of a pair is needed.");
    for (const auto &[name, end] :
         {std::make_pair("From", from), std::make_pair("To", to)})
      if (end.size() != dimension)
        throw UserError(path + "/" + name + ": found " +
                        std::to_string(end.size()) +
                        " coordinates, the problem has " +
                        std::to_string(dimension) + " dimensions.");
  }



  const Choices<FieldFormat> &
  all_field_formats()
  {
    static const Choices<FieldFormat> choices = {{"vtu", FieldFormat::vtu},
                                                 {"hdf5", FieldFormat::hdf5}};
    return choices;
  }



  namespace
  {
    const Choices<Verbosity> &
    all_verbosities()
    {
      static const Choices<Verbosity> choices = {
        {"progress", Verbosity::progress},
        {"results", Verbosity::results},
        {"quiet", Verbosity::quiet}};
      return choices;
    }
  } // namespace



  void
  OutputParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Directory",
                      directory,
                      "Where all files of the run go; created if needed.");
    prm.add_parameter("Every n steps",
                      every_n_steps,
                      "Write the fields after every n-th accepted step. The "
                      "statistics have a row for each step.",
                      Patterns::Integer(1));
    add_choice(prm,
               "Format",
               format,
               all_field_formats(),
               "'vtu': VTU files with PVTU and PVD records. 'hdf5': one "
               "HDF5 file per step and an XDMF record, of bodies with one "
               "kind of cells. "
               "Displacements of degree 2 and more are curved Lagrange cells "
               "in VTU (ParaView 5.5 or newer), subdivided linear ones in HDF5 "
               "and on contact surfaces of 2D bodies.");
    prm.add_parameter("Grouped files",
                      grouped_files,
                      expert(
                        "Number of VTU files per step that the ranks share; 0: "
                        "one file per rank, as always for higher order cells "
                        "in 3D."),
                      Patterns::Integer(0));
    prm.add_parameter("Deformed",
                      deformed,
                      "Write the deformed grid. Otherwise warp the undeformed "
                      "one by the field 'displacement'.");
    add_choice(prm,
               "Verbosity",
               verbosity,
               all_verbosities(),
               "On the screen: 'progress' (a line per step and the "
               "results), 'results' (numbers only) or "
               "'quiet' (errors only).");
    prm.add_parameter("Checkpoint every n steps",
                      checkpoint_interval,
                      "Save the state after every n-th accepted step, so that "
                      "the run can be continued; 0: never. When a step fails "
                      "for good, or a signal or 'Stop after' ends the run, the "
                      "last accepted state is saved in any case.",
                      Patterns::Integer(0));
    prm.add_parameter("Checkpoint at the end",
                      checkpoint_at_end,
                      "Save the state at the end of the run, so that it can be "
                      "continued to a later 'Load stepping/End time'.");
    prm.add_parameter(
      "Stop after",
      stop_after,
      "Wall-clock time after which the run saves the last accepted state at "
      "its next Newton iteration and ends with exit code 5; --restart latest "
      "goes on. '3 h', '90 min', '1 d 12 h', or as in Slurm '02:30:00', "
      "'1-12:00:00'. Empty: no limit. Leave time for one iteration and for "
      "writing. SIGTERM and SIGUSR1 do the same.");

    prm.add_parameter("Contact points",
                      contact_points,
                      "Write a table contact_points-NNNN.csv of all contact "
                      "points, with every digit, in addition to the fields of "
                      "each written step.");

    add_named_list(prm, "Points", points);
    add_named_list(prm, "Contact lines", lines);
  }



  void
  OutputParameters::check(const std::string &path) const
  {
    if (directory.empty())
      throw UserError(path + "/Directory: a name is needed ('.' for here).");
    if (!stop_after.empty() && !seconds_of_duration(stop_after))
      throw UserError("'" + path + "/Stop after' = " + stop_after +
                      " is no duration. Write '3 h', '90 min', '1 d 12 h', "
                      "'hours:minutes:seconds' or 'days-hours:minutes:seconds'"
                      ".");
    for (const auto &[name, point] : points)
      point.check(path + "/Points/" + name);
  }
} // namespace stickslip
