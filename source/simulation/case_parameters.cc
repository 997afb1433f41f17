#include <stickslip/simulation/case_parameters.h>

#include <stickslip/base/declared_parameters.h>
#include <stickslip/base/named_constants.h>
#include <stickslip/base/nearest_name.h>
#include <stickslip/base/print_parameters.h>
#include <stickslip/base/user_error.h>

#include <stickslip/problem/rigid_tools.h>

#include <stickslip/simulation/pair_checks.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace stickslip
{
  namespace
  {
    template <typename T>
    void
    check_named_list(const std::string &section, const NamedList<T> &list)
    {
      for (const auto &[name, member] : list)
        member.check(section + "/" + name);
    }



    std::vector<std::string>
    names_of_pairs(const NamedList<ContactPairParameters> &pairs)
    {
      std::vector<std::string> names;
      for (const auto &pair : pairs)
        names.push_back(pair.first);
      return names;
    }



    /// What the matrix of the displacements has of each cell [byte]: a row of
    /// Q_p has dim (p+2)^dim entries on average, each a number and an index.
    double
    matrix_bytes_per_cell(const unsigned int dim, const unsigned int p)
    {
      const double rows    = dim * std::pow(1. * p, 1. * dim);
      const double entries = dim * std::pow(2. + p, 1. * dim);
      return 12. * rows * entries;
    }



    /// The same of a triangle or tetrahedron, at least: dim! of them make up a
    /// cell of Q_p, with the same nodes.
    double
    matrix_bytes_per_simplex(const unsigned int dim, const unsigned int p)
    {
      const double rows =
        dim * std::pow(1. * p, 1. * dim) / (dim == 2 ? 2. : 6.);
      const double entries = dim * std::pow(1. + p, 1. * dim);
      return 12. * rows * entries;
    }



    /// All values of the members of the list @p section, without subsections
    /// (Regularization does not change what is solved).
    void
    add_values(const DeclaredSection &all,
               const std::string     &section,
               ParameterValues       &values)
    {
      for (const DeclaredSection &member :
           all.find_subsection(section)->subsections)
        for (const DeclaredParameter &parameter : member.parameters)
          values.emplace_back(section + "/" + member.name + "/" +
                                parameter.name,
                              parameter.value);
    }
  } // namespace



  void
  CaseParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Title", title, "A line about the case, for the log.");
    prm.add_parameter("Dimension",
                      dimension,
                      "2 (plane strain unless a material says plane stress, or "
                      "bodies of revolution, Axisymmetric) or 3.",
                      Patterns::Integer(2, 3));
    prm.add_parameter("Axisymmetric",
                      axisymmetric,
                      "In 2D: the bodies are bodies of revolution without "
                      "torsion; x is the radius, y the axis. Their radial "
                      "displacement on the axis is zero of itself. Forces, "
                      "areas and works are those of the whole bodies (2 pi).",
                      Patterns::Bool());
    prm.add_parameter(
      "Degree",
      degree,
      "Polynomial degree of the displacement, and of the sides of "
      "the cells where bodies are curved.",
      Patterns::Integer(1, 6));
    add_named_list(prm, "Bodies", bodies);
    add_named_list(prm, "Materials", materials);
    add_named_list(prm, "Amplitudes", amplitudes);
    add_named_list(prm, "Boundary conditions", boundary_conditions);
    const auto add_section = [&prm](const std::string &name, auto &section) {
      prm.enter_subsection(name);
      section.add_parameters(prm);
      prm.leave_subsection();
    };
    add_section("Contact", automatic_contact);
    add_named_list(prm, "Contact", contact_pairs);
    add_section("Mesh", mesh);
    add_named_list(prm, "Refinement", refinement);
    add_section("Adaptation", adaptation);
    add_section("Algorithm", algorithm);
    prm.enter_subsection("Algorithm");
    add_section("Cycling", cycling);
    add_section("Acceptance", acceptance);
    prm.leave_subsection();
    add_section("Load stepping", load_stepping);
    add_section("Linear solver", linear_solver);
    add_section("Output", output);
    add_named_list(prm, "Checks", checks);
  }



  void
  CaseParameters::read(const ParameterFile &given,
                       ParameterHandler    &prm,
                       const MPI_Comm       communicator)
  {
    const ParameterFile file = given.with_constants_inserted();
    file.declare_names("Bodies", bodies);
    file.declare_names("Refinement", refinement);
    file.declare_names("Materials", materials);
    file.declare_names("Amplitudes", amplitudes);
    file.declare_names("Boundary conditions", boundary_conditions);
    file.declare_names("Contact", contact_pairs);
    file.declare_names("Output/Points", output.points);
    file.declare_names("Output/Contact lines", output.lines);
    file.declare_names("Checks", checks);
    for (auto &[name, material] : materials)
      {
        const std::string path = "Materials/" + name;
        material.choose_law(file.value_of(path, "Law").value_or(material.law),
                            path);
      }
    output.pair_names = names_of_pairs(contact_pairs);
    add_parameters(prm);
    file.apply_to(prm);
    mesh.input_directory   = file.directory();
    mesh.is_axisymmetric   = axisymmetric;
    mesh.degree            = degree;
    mesh.bytes_per_cell    = matrix_bytes_per_cell(dimension, degree);
    mesh.bytes_per_simplex = matrix_bytes_per_simplex(dimension, degree);
    for (auto &[name, material] : materials)
      material.read_files("Materials/" + name,
                          mesh.input_directory,
                          communicator);
    check();
    adaptation.global_refinements = mesh.global_refinements;
    load_stepping.request(ends_of_intervals(boundary_conditions));
    mesh.refinements = refinement_requests();
    if (adaptation.is_active())
      {
        mesh.later_refinement =
          "Adaptation/Estimator = " + adaptation.estimator;
        prm.enter_subsection("Adaptation");
        for (const std::string name : {"Estimator", "Distance"})
          physics.emplace_back("Adaptation/" + name, prm.get(name));
        prm.leave_subsection();
      }
    const DeclaredSection all = declared_parameters(prm);
    if (axisymmetric)
      physics.emplace_back("Axisymmetric", "true");
    if (!materials.empty())
      add_values(all, "Materials", physics);
    if (!contact_pairs.empty())
      add_values(all, "Contact", physics);
    if (automatic_contact.active)
      physics.emplace_back("Contact/Automatic friction coefficient",
                           std::to_string(
                             automatic_contact.friction_coefficient));
    std::ostringstream values;
    print_parameters(values, prm, ParameterFormat::all);
    record = values.str();
  }



  void
  CaseParameters::declare_all(CaseParameters &parameters, ParameterHandler &prm)
  {
    parameters.bodies.emplace_back("<body>", BodyParameters());
    parameters.refinement.emplace_back("<rule>", RefinementParameters());
    for (const std::string &law : constitutive_law_names())
      {
        parameters.materials.emplace_back("<" + law + " material>",
                                          MaterialParameters());
        parameters.materials.back().second.choose_law(law, "Materials");
      }
    NamedConstants::declare_placeholder(prm);
    parameters.amplitudes.emplace_back("<amplitude>", AmplitudeParameters());
    parameters.boundary_conditions.emplace_back("<condition>",
                                                BoundaryConditionParameters());
    parameters.contact_pairs.emplace_back("<pair>", ContactPairParameters());
    parameters.output.points.emplace_back("<point>", PointParameters());
    parameters.output.lines.emplace_back("<line>", ContactLineParameters());
    parameters.checks.emplace_back("<check>", ReferenceCheckParameters());
    parameters.add_parameters(prm);
  }



  void
  CaseParameters::check() const
  {
    if (bodies.empty())
      throw UserError(
        "Section 'Bodies' names no body. Add one: 'subsection "
        "Bodies', 'subsection block', ...");
    check_named_list("Bodies", bodies);
    if (axisymmetric && dimension != 2)
      throw UserError(
        "Axisymmetric is true, but Dimension is 3: sections of "
        "bodies of revolution are models of Dimension 2.");
    for (const auto &[name, rule] : refinement)
      rule.check("Refinement/" + name, dimension);
    adaptation.check("Adaptation",
                     !contact_pairs.empty() || automatic_contact.active);
    for (const auto &[name, condition] : boundary_conditions)
      if (condition.type == BoundaryConditionType::pretension &&
          adaptation.is_active())
        throw UserError("Adaptation/Estimator = " + adaptation.estimator +
                        ": the two sides of a cut ('Boundary conditions/" +
                        name +
                        "') need the same mesh, which adaptation would not "
                        "keep. Refine with section 'Refinement' instead.");
    if (axisymmetric && adaptation.estimator == "residual")
      throw UserError(
        "Adaptation/Estimator = residual knows no bodies of "
        "revolution (Axisymmetric = true). Take 'recovery'.");
    for (const auto &[name, material] : materials)
      {
        material.check("Materials/" + name, dimension, degree);
        if (axisymmetric && material.plane_stress)
          throw UserError("Materials/" + name +
                          "/Plane stress is true, but so is Axisymmetric: "
                          "bodies of revolution have a hoop stress. Remove one "
                          "of them.");
      }
    check_named_list("Amplitudes", amplitudes);
    check_named_list("Boundary conditions", boundary_conditions);
    automatic_contact.check("Contact");
    check_named_list("Contact", contact_pairs);
    check_pairs_suit(algorithm.name, contact_pairs);
    algorithm.check("Algorithm");
    check_pairs_differ(contact_pairs);
    load_stepping.check("Load stepping");
    linear_solver.check("Linear solver");
    output.check("Output");
    for (const auto &[name, point] : output.points)
      {
        point.check("Output/Points/" + name);
        if (!point.contact_pair.empty() &&
            pair_called(point.contact_pair, "Output/Points/" + name)
                .slave_body != point.body)
          throw UserError("Output/Points/" + name + "/Contact pair: '" +
                          point.body + "' is not the slave body of '" +
                          point.contact_pair + "'.");
      }
    for (const auto &[name, line] : output.lines)
      {
        line.check("Output/Contact lines/" + name, dimension);
        pair_called(line.contact_pair, "Output/Contact lines/" + name);
      }
    check_named_list("Checks", checks);
  }



  const ContactPairParameters &
  CaseParameters::pair_called(const std::string &name,
                              const std::string &path) const
  {
    for (const auto &[pair_name, pair] : contact_pairs)
      if (pair_name == name)
        return pair;
    throw UserError(
      path + "/Contact pair: there is no contact pair '" + name + "'." +
      did_you_mean(name, output.pair_names) + " Known: " +
      (contact_pairs.empty() ? "none" : quoted_list(output.pair_names)) + "." +
      (automatic_contact.active ? " Automatic pairs cannot be named here: give "
                                  "the two bodies a pair of "
                                  "their own."
                                : ""));
  }



  Amplitudes
  CaseParameters::make_amplitudes(const MPI_Comm communicator) const
  {
    return stickslip::make_amplitudes(amplitudes,
                                      mesh.input_directory,
                                      communicator);
  }



  std::vector<RefinementRequest>
  CaseParameters::refinement_requests() const
  {
    std::vector<RefinementRequest> requests;
    for (const auto &[name, rule] : refinement)
      {
        requests.push_back({"Refinement/" + name, rule, {}, {}, {}});
        if (rule.contact_pair.empty())
          continue;
        const auto &pair = pair_called(rule.contact_pair, "Refinement/" + name);
        const std::string path = "Contact/" + rule.contact_pair;
        requests.back().slave  = {path + "/Slave boundary",
                                  pair.slave_body,
                                  pair.slave_boundary};
        requests.back().master = {path + "/Master boundary",
                                  pair.master_body,
                                  pair.master_boundary};
        for (const auto &[body, of_body] : bodies)
          if (body == pair.master_body && of_body.is_tool())
            requests.back().distance_from_tool =
              distance_from_tool(of_body, "Bodies/" + body, dimension);
      }
    return requests;
  }



  template <int dim>
  AutomaticPairs
  CaseParameters::add_automatic_pairs(const Mesh<dim> &mesh)
  {
    AutomaticPairs automatic = automatic_pairs(
      mesh, automatic_contact, contact_pairs, boundary_conditions, materials);
    contact_pairs.insert(contact_pairs.end(),
                         automatic.pairs.begin(),
                         automatic.pairs.end());
    output.pair_names = names_of_pairs(contact_pairs);
    return automatic;
  }

  template AutomaticPairs
  CaseParameters::add_automatic_pairs(const Mesh<2> &);
  template AutomaticPairs
  CaseParameters::add_automatic_pairs(const Mesh<3> &);



  std::vector<NamedSurface>
  CaseParameters::slave_surfaces() const
  {
    std::vector<NamedSurface> surfaces;
    for (const auto &[name, pair] : contact_pairs)
      surfaces.push_back({"Contact/" + name + "/Slave boundary",
                          pair.slave_body,
                          pair.slave_boundary});
    return surfaces;
  }
} // namespace stickslip
