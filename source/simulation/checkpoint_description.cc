#include <stickslip/simulation/checkpoint_description.h>

#include <stickslip/output/csv.h>

#include <stickslip/simulation/cell_records.h>
#include <stickslip/simulation/cell_state.h>

#include <deal.II/base/array_view.h>
#include <deal.II/base/mpi.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <map>
#include <sstream>

namespace stickslip
{
  namespace
  {
    const std::string checkpoint_mark   = "stickslip checkpoint ";
    const std::string checkpoint_format = "9";
    const std::string checkpoint_first_line =
      checkpoint_mark + checkpoint_format;
    const std::string checkpoint_last_line = "end";

    /// Begins the line after the last one.
    const std::string checksum_mark = "checksum = ";

    /// Begins the lines of CheckpointDescription::physics.
    const std::string parameter_mark = "parameter ";

    /// The line that has to follow on @p content.
    std::string
    checksum_line(const std::string &content)
    {
      return checksum_mark +
             std::to_string(hash_of_bytes(content.data(), content.size())) +
             "\n";
    }



    /// Sums over the same mesh differ by less than this fraction of the sum of
    /// the sizes of their terms, whatever the order.
    constexpr double geometry_tolerance = 1e-10;



    /// Hash of the set of cells, and weighted sums of their centers; the weight
    /// tells the cells apart.
    template <int dim>
    std::uint64_t
    hash_mesh(const DoFHandler<dim> &dof_handler,
              const MPI_Comm        &communicator,
              std::vector<double>   &geometry)
    {
      const PartitionFreeNames<dim> names(dof_handler.get_triangulation());
      std::uint64_t                 topology = 0;
      geometry.assign(dim + 1, 0.);
      for (const auto &cell : dof_handler.active_cell_iterators())
        if (cell->is_locally_owned())
          {
            const CellKey                     key = names.name_of(cell->id());
            const std::array<unsigned int, 5> name{
              {key[0], key[1], key[2], key[3], cell->material_id()}};
            const std::uint64_t hash = hash_of_bytes(name.data(), sizeof(name));
            const double        weight = std::ldexp(hash >> 11, -53);
            const Point<dim>    center = cell->center();
            topology += hash;
            for (unsigned int d = 0; d < dim; ++d)
              {
                geometry[d] += weight * center[d];
                geometry[dim] += std::abs(center[d]) + cell->diameter();
              }
          }
      Utilities::MPI::sum(ArrayView<const double>(geometry.data(),
                                                  geometry.size()),
                          communicator,
                          ArrayView<double>(geometry.data(), geometry.size()));
      return Utilities::MPI::sum(topology, communicator);
    }



    /// @p value is the sum over the ranks of @p of_this_rank.
    std::string
    sum_in_words(const std::uint64_t of_this_rank, const MPI_Comm &communicator)
    {
      return std::to_string(Utilities::MPI::sum(of_this_rank, communicator));
    }
  } // namespace



  std::vector<std::string>
  changed_values(const ParameterValues &before, const ParameterValues &now)
  {
    const std::map<std::string, std::string> old(before.begin(), before.end());
    const std::map<std::string, std::string> present(now.begin(), now.end());
    std::vector<std::string>                 texts;
    for (const auto &[name, value] : now)
      {
        const auto found = old.find(name);
        if (found == old.end())
          texts.push_back("'" + name + "' = " + value + " is new");
        else if (found->second != value &&
                 (!number_in_cell(value) ||
                  number_in_cell(value) != number_in_cell(found->second)))
          texts.push_back("'" + name + "' was " + found->second + " and is " +
                          value);
      }
    for (const auto &[name, value] : before)
      if (present.count(name) == 0)
        texts.push_back("'" + name + "' = " + value + " is gone");
    return texts;
  }



  bool
  have_same(const ParameterValues &a,
            const ParameterValues &b,
            const std::string     &section)
  {
    const auto in_section = [&section](const ParameterValues &all) {
      ParameterValues values;
      for (const auto &value : all)
        if (value.first.find(section) == 0)
          values.push_back(value);
      return values;
    };
    return in_section(a) == in_section(b);
  }



  std::string
  ProblemFingerprint::difference_from(const ProblemFingerprint &other) const
  {
    for (unsigned int i = 0;
         i < std::max(properties.size(), other.properties.size());
         ++i)
      {
        const auto in_words = [i](const auto &list) {
          return i < list.size()
                   ? "'" + list[i].first + " = " + list[i].second + "'"
                   : std::string("nothing more");
        };
        if (in_words(properties) != in_words(other.properties))
          return "it has " + in_words(other.properties) + ", this case " +
                 in_words(properties);
      }
    bool is_same = geometry.size() == other.geometry.size();
    for (unsigned int d = 0; is_same && d + 1 < geometry.size(); ++d)
      is_same = std::abs(geometry[d] - other.geometry[d]) <=
                geometry_tolerance * geometry.back();
    return is_same ? "" : "its mesh has other coordinates";
  }



  template <int dim>
  ProblemFingerprint
  fingerprint(ContactProblem<dim> &problem)
  {
    const DofLayout<dim> &layout       = problem.layout();
    const auto           &dof_handler  = layout.dof_handler;
    const auto           &communicator = problem.contact().get_communicator();
    ProblemFingerprint    result;
    const auto            add = [&result](const std::string &name,
                               const std::string &value) {
      result.properties.emplace_back(name, value);
    };
    add("dimension",
        std::to_string(dim) + (problem.bodies().cross_section.is_axisymmetric
                                 ? ", axisymmetric"
                                 : ""));
    add("degree", std::to_string(layout.degree()));
    add("cells",
        std::to_string(
          dof_handler.get_triangulation().n_global_active_cells()));
    add("displacement unknowns", std::to_string(dof_handler.n_dofs()));
    add("mesh",
        std::to_string(hash_mesh(dof_handler, communicator, result.geometry)));

    std::uint64_t n_history = 0;
    for (const auto &cell : dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
        n_history += problem.solid()
                       .point_history()
                       .accepted_of_cell(cell->active_cell_index())
                       .size();
    add("history variables", sum_in_words(n_history, communicator));

    const auto &pairs = problem.contact().contact_pairs();
    add("contact pairs", std::to_string(pairs.size()));
    for (unsigned int p = 0; p < pairs.size(); ++p)
      add("contact pair " + std::to_string(p + 1),
          sum_in_words(pairs[p]->slave_faces.size(), communicator) +
            " slave faces, " +
            sum_in_words(pairs[p]->points.size(), communicator) +
            " contact points, " +
            std::to_string(pairs[p]->multiplier_shape.n_nodes()) + " x " +
            std::to_string(pairs[p]->n_multiplier_components()) +
            " multipliers per face" +
            (pairs[p]->parameters.is_bilateral()
               ? ", " + name_of(pairs[p]->parameters.law, all_pair_laws())
               : ""));
    return result;
  }



  std::string
  CheckpointDescription::text() const
  {
    std::ostringstream out;
    out << std::setprecision(17) << checkpoint_first_line
        << "\nidentity = " << identity << "\nfiles = " << n_files << '\n';
    StepControlState::for_each_number(scalars.control,
                                      [&out](const std::string &name,
                                             const auto         value) {
                                        out << name << " = " << value << '\n';
                                      });
    out << "last iterations =";
    for (const unsigned int n : scalars.control.last_iterations)
      out << ' ' << n;
    out << "\nexternal work = " << scalars.work.external
        << "\nfriction work = " << scalars.work.friction
        << "\ncontact work = " << scalars.work.contact
        << "\nstabilization work = " << scalars.work.stabilization
        << "\nadaptations = " << scalars.adaptation.adaptations
        << "\nenergy norm = " << scalars.energy_norm
        << "\nadaptation has begun = " << scalars.adaptation.has_begun
        << "\nlargest estimated error = " << scalars.adaptation.largest_error
        << "\ngeometry =";
    for (const double value : problem.geometry)
      out << ' ' << value;
    out << '\n';
    for (const auto &[name, value] : problem.properties)
      out << name << " = " << value << '\n';
    for (const auto &[name, value] : physics)
      out << parameter_mark << name << " = " << value << '\n';
    out << checkpoint_last_line << '\n';
    return out.str() + checksum_line(out.str());
  }



  std::string
  CheckpointDescription::other_format(const std::string &text)
  {
    const std::string first_line = text.substr(0, text.find('\n'));
    if (first_line.find(checkpoint_mark) != 0 ||
        first_line == checkpoint_first_line)
      return "";
    const std::string format = first_line.substr(checkpoint_mark.size());
    if (format.find_first_not_of("0123456789") != std::string::npos)
      return ""; // damaged, as its checksum will show
    return "it was written by another version of the program (its format is " +
           format + ", this version reads format " + checkpoint_format + ")";
  }



  std::string
  CheckpointDescription::parse(const std::string &text)
  {
    std::istringstream in(text);
    std::string        line;
    if (!std::getline(in, line) || line != checkpoint_first_line)
      return "its description does not begin with '" + checkpoint_first_line +
             "'";
    const std::string content = text.substr(0, text.rfind(checksum_mark));
    if (text != content + checksum_line(content))
      return "its description does not have its checksum";
    bool       is_good = true;
    const auto read    = [&](const std::string &name, auto &value) {
      const std::string start = name + " = ";
      is_good = is_good && std::getline(in, line) && line.find(start) == 0 &&
                (std::istringstream(line.substr(start.size())) >> value);
    };
    const auto read_list = [&](const std::string &name, auto &values) {
      const std::string start = name + " =";
      is_good = is_good && std::getline(in, line) && line.find(start) == 0;
      if (!is_good)
        return;
      values.clear();
      std::istringstream numbers(line.substr(start.size()));
      for (double number; numbers >> number;)
        values.push_back(number);
    };
    read("identity", identity);
    read("files", n_files);
    StepControlState::for_each_number(scalars.control, read);
    read_list("last iterations", scalars.control.last_iterations);
    read("external work", scalars.work.external);
    read("friction work", scalars.work.friction);
    read("contact work", scalars.work.contact);
    read("stabilization work", scalars.work.stabilization);
    read("adaptations", scalars.adaptation.adaptations);
    read("energy norm", scalars.energy_norm);
    read("adaptation has begun", scalars.adaptation.has_begun);
    read("largest estimated error", scalars.adaptation.largest_error);
    read_list("geometry", problem.geometry);
    problem.properties.clear();
    physics.clear();
    while (is_good && std::getline(in, line) && line != checkpoint_last_line)
      {
        const auto equals = line.find(" = ");
        is_good           = equals != std::string::npos;
        if (!is_good)
          continue;
        const bool is_parameter = line.find(parameter_mark) == 0;
        const auto start        = is_parameter ? parameter_mark.size() : 0;
        (is_parameter ? physics : problem.properties)
          .emplace_back(line.substr(start, equals - start),
                        line.substr(equals + 3));
      }
    return is_good && line == checkpoint_last_line && n_files > 0
             ? ""
             : "its description is not complete";
  }

  template ProblemFingerprint
  fingerprint(ContactProblem<2> &);
  template ProblemFingerprint
  fingerprint(ContactProblem<3> &);
} // namespace stickslip
