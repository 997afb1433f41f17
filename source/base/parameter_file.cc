#include <stickslip/base/declared_parameters.h>
#include <stickslip/base/nearest_name.h>
#include <stickslip/base/parameter_file.h>
#include <stickslip/base/user_error.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <sstream>

namespace stickslip
{
  namespace
  {
    /**
     * Holds the statements of a file against what is declared, sets what is
     * right and collects the messages about what is wrong.
     */
    class ParameterSetter
    {
    public:
      explicit ParameterSetter(dealii::ParameterHandler &prm)
        : prm(prm)
        , declared(declared_parameters(prm))
      {}

      void
      check_section(const ParameterStatement &statement);

      void
      set(const ParameterStatement &entry);

      void
      add_error(const ParameterStatement &statement, const std::string &text);

      /// One message per line, in the order of the file, `--set` last.
      std::string
      errors() const;

    private:
      /// nullptr, after a message, if the section is not declared.
      const DeclaredSection *
      find_section(const ParameterStatement &statement);

      void
      report_unknown_name(const ParameterStatement &entry,
                          const DeclaredSection    &section);

      dealii::ParameterHandler &prm;
      const DeclaredSection     declared;

      std::vector<std::pair<ParameterStatement, std::string>> messages;

      /// An unknown section is one mistake, whatever it contains.
      std::set<std::vector<std::string>> reported_sections;
    };



    void
    ParameterSetter::add_error(const ParameterStatement &statement,
                               const std::string        &text)
    {
      messages.emplace_back(statement, statement.location() + ": " + text);
    }



    std::string
    ParameterSetter::errors() const
    {
      auto sorted_messages = messages;
      std::stable_sort(sorted_messages.begin(),
                       sorted_messages.end(),
                       [](const auto &first, const auto &second) {
                         const auto &[a, a_text] = first;
                         const auto &[b, b_text] = second;
                         if (a.file.empty() != b.file.empty())
                           return b.file.empty();
                         return a.file == b.file && a.line < b.line;
                       });
      std::string text;
      for (const auto &[statement, message] : sorted_messages)
        text += (text.empty() ? "" : "\n") + message;
      return text;
    }



    const DeclaredSection *
    ParameterSetter::find_section(const ParameterStatement &statement)
    {
      const DeclaredSection   *section = &declared;
      std::vector<std::string> path;
      for (const std::string &name : statement.path)
        {
          path.push_back(name);
          const DeclaredSection *const parent = section;
          section                             = parent->find_subsection(name);
          if (section != nullptr)
            continue;

          if (!reported_sections.insert(path).second)
            return nullptr;
          if (parent->find_parameter(name) != nullptr)
            add_error(statement,
                      "'" + join_parameter_path(path) +
                        "' is a parameter, not a subsection.");
          else
            add_error(statement,
                      "unknown subsection '" + join_parameter_path(path) +
                        "'." + did_you_mean(name, parent->subsection_names()) +
                        " Subsections known here: " +
                        quoted_list(parent->subsection_names()) + ".");
          return nullptr;
        }
      return section;
    }



    void
    ParameterSetter::check_section(const ParameterStatement &statement)
    {
      find_section(statement);
    }



    /// The sections below @p section that declare the parameter @p name.
    void
    collect_sections_with(const std::string        &name,
                          const DeclaredSection    &section,
                          const std::string        &path,
                          std::vector<std::string> &sections)
    {
      if (section.find_parameter(name) != nullptr)
        sections.push_back(path.empty() ? "the top level" : path);
      for (const DeclaredSection &subsection : section.subsections)
        collect_sections_with(name,
                              subsection,
                              path + (path.empty() ? "" : "/") +
                                subsection.name,
                              sections);
    }



    void
    ParameterSetter::report_unknown_name(const ParameterStatement &entry,
                                         const DeclaredSection    &section)
    {
      if (section.find_subsection(entry.name) != nullptr)
        return add_error(entry,
                         "'" + entry.full_name() +
                           "' is a subsection, not a parameter.");

      std::string text =
        "unknown parameter '" + entry.full_name() + "'." +
        did_you_mean(entry.name, section.parameter_names()) +
        " Known here: " + quoted_list(section.parameter_names()) + ".";

      std::vector<std::string> other_sections;
      collect_sections_with(entry.name, declared, "", other_sections);
      if (!other_sections.empty() && other_sections.size() <= 5)
        text += " There is a '" + entry.name +
                "' in: " + quoted_list(other_sections) + ".";
      add_error(entry, text);
    }



    void
    ParameterSetter::set(const ParameterStatement &entry)
    {
      const DeclaredSection *const section = find_section(entry);
      if (section == nullptr)
        return;

      const DeclaredParameter *const parameter =
        section->find_parameter(entry.name);
      const auto &aliases = section->aliases;
      const bool  is_alias =
        std::find(aliases.begin(), aliases.end(), entry.name) != aliases.end();
      if (parameter == nullptr && !is_alias)
        return report_unknown_name(entry, *section);

      for (const std::string &name : entry.path)
        prm.enter_subsection(name);
      try
        {
          prm.set(entry.name, entry.value);
        }
      // ExcValueDoesNotMatchPattern, or the conversion to the member's type
      catch (const std::exception &)
        {
          std::string text =
            "'" + entry.full_name() + "' is '" + entry.value + "'.";
          if (parameter != nullptr)
            text += " Allowed: " + parameter->allowed_values() + "." +
                    did_you_mean(entry.value, parameter->choices());
          add_error(entry, text);
        }
      for (std::size_t i = 0; i < entry.path.size(); ++i)
        prm.leave_subsection();
    }



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
    statements.entries.push_back(entry);
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
