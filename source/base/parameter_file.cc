#include <stickslip/base/parameter_file.h>

#include <stickslip/base/declared_parameters.h>
#include <stickslip/base/named_constants.h>
#include <stickslip/base/nearest_name.h>
#include <stickslip/base/parameter_setter.h>
#include <stickslip/base/user_error.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

namespace stickslip
{
  namespace
  {
    void
    collect_missing_parameters(
      const DeclaredSection                                         &section,
      const std::vector<std::string>                                &path,
      std::vector<std::pair<std::vector<std::string>, std::string>> &missing)
    {
      for (const DeclaredParameter &parameter : section.parameters)
        if (parameter.is_missing)
          missing.emplace_back(path, parameter.name);
      for (const DeclaredSection &subsection : section.subsections)
        {
          std::vector<std::string> subsection_path = path;
          subsection_path.push_back(subsection.name);
          collect_missing_parameters(subsection, subsection_path, missing);
        }
    }
  } // namespace



  ParameterFile::ParameterFile(const std::string &file_name,
                               const MPI_Comm     communicator)
    : file_name(file_name)
  {
    namespace MPI = dealii::Utilities::MPI;

    // Only one rank can see what is wrong, but all must throw.
    std::string error;
    if (MPI::this_mpi_process(communicator) == 0)
      try
        {
          statements = ParameterFileReader::read_file(file_name);
        }
      catch (const UserError &exception)
        {
          error = exception.what();
        }

    error = MPI::broadcast(communicator, error);
    if (!error.empty())
      throw UserError(error);
    statements = MPI::broadcast(communicator, statements);
  }



  ParameterFile
  ParameterFile::from_string(const std::string &text, const std::string &name)
  {
    std::istringstream input(text);
    ParameterFile      file;
    file.file_name  = name;
    file.statements = ParameterFileReader::read_stream(input, name);
    return file;
  }



  void
  ParameterFile::override_with(const std::string &assignment)
  {
    const std::size_t  equal_sign = assignment.find('=');
    ParameterStatement entry;
    entry.path = split_parameter_path(assignment.substr(0, equal_sign));
    if (equal_sign == std::string::npos || entry.path.empty())
      throw UserError("--set '" + assignment +
                      "': write --set \"Section/Name=value\".");

    entry.name = entry.path.back();
    entry.path.pop_back();
    entry.value = dealii::Utilities::trim(assignment.substr(equal_sign + 1));

    for (ParameterStatement &other : statements.entries)
      if (other.path == entry.path && other.name == entry.name)
        {
          other = entry;
          return;
        }
    // Nobody would notice a new one that nothing uses.
    if (is_about_constants(entry))
      throw UserError("--set '" + assignment + "': '" + name() +
                      "' has no such constant.");
    statements.entries.push_back(entry);
  }



  ParameterFile
  ParameterFile::with_constants_inserted() const
  {
    const NamedConstants constants(statements.entries);
    ParameterFile        result;
    result.file_name = file_name;
    for (const ParameterStatement &section : statements.sections)
      if (!is_about_constants(section))
        result.statements.sections.push_back(section);

    std::string errors;
    for (ParameterStatement entry : statements.entries)
      if (!is_about_constants(entry))
        try
          {
            entry.value = constants.inserted_in(entry.value,
                                                entry.location() + ": '" +
                                                  entry.full_name() + "'");
            result.statements.entries.push_back(entry);
          }
        catch (const UserError &error)
          {
            errors += (errors.empty() ? "" : "\n") + std::string(error.what());
          }
    if (!errors.empty())
      throw UserError(errors);
    return result;
  }



  std::vector<std::string>
  ParameterFile::subsections_of(const std::string &section) const
  {
    const std::vector<std::string> parent = split_parameter_path(section);

    std::vector<std::string> names;
    for (const ParameterStatement &statement : statements.sections)
      if (statement.path.size() == parent.size() + 1 &&
          std::equal(parent.begin(), parent.end(), statement.path.begin()) &&
          std::find(names.begin(), names.end(), statement.path.back()) ==
            names.end())
        names.push_back(statement.path.back());
    return names;
  }



  std::optional<std::string>
  ParameterFile::value_of(const std::string &section,
                          const std::string &name) const
  {
    const ParameterStatement *const entry =
      find(split_parameter_path(section), name);
    return entry != nullptr ? std::optional<std::string>(entry->value)
                            : std::nullopt;
  }



  void
  ParameterFile::require(const std::string              &section,
                         const std::vector<std::string> &names) const
  {
    const std::vector<std::string> path = split_parameter_path(section);

    std::vector<std::string> missing;
    for (const std::string &name : names)
      if (find(path, name) == nullptr)
        missing.push_back(name);
    if (!missing.empty())
      throw UserError(section_statement(path).location() + ": '" + section +
                      "' must also set " + quoted_list(missing) + ".");
  }



  void
  ParameterFile::apply_to(dealii::ParameterHandler &prm) const
  {
    ParameterSetter setter(prm);
    for (const ParameterStatement &section : statements.sections)
      setter.check_section(section);
    for (const ParameterStatement &entry : statements.entries)
      setter.set(entry);

    std::vector<std::pair<std::vector<std::string>, std::string>> missing;
    collect_missing_parameters(declared_parameters(prm), {}, missing);

    for (const auto &[path, name] : missing)
      if (find(path, name) == nullptr) // else its value was not accepted
        {
          ParameterStatement section = section_statement(path);
          section.name               = name;
          setter.add_error(section,
                           "the parameter '" + section.full_name() +
                             "' must be set.");
        }
    const std::string errors = setter.errors();
    if (!errors.empty())
      throw UserError(errors);
  }



  std::string
  ParameterFile::directory() const
  {
    const std::string folder =
      std::filesystem::path(file_name).parent_path().string();
    return folder.empty() ? "." : folder;
  }



  const ParameterStatement *
  ParameterFile::find(const std::vector<std::string> &path,
                      const std::string              &name) const
  {
    for (const ParameterStatement &entry : statements.entries)
      if (entry.path == path && entry.name == name)
        return &entry;
    return nullptr;
  }



  ParameterStatement
  ParameterFile::section_statement(const std::vector<std::string> &path) const
  {
    for (const ParameterStatement &section : statements.sections)
      if (section.path == path)
        return section;

    ParameterStatement nowhere;
    nowhere.path = path;
    nowhere.file = file_name.empty() ? "parameters" : file_name;
    return nowhere;
  }
} // namespace stickslip
