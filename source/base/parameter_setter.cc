#include <stickslip/base/parameter_setter.h>

#include <stickslip/base/nearest_name.h>

#include <algorithm>
#include <exception>

namespace stickslip
{
  namespace
  {
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
  } // namespace



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
                    "unknown subsection '" + join_parameter_path(path) + "'." +
                      did_you_mean(name, parent->subsection_names()) +
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
} // namespace stickslip
