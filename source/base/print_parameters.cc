#include <stickslip/base/print_parameters.h>

#include <deal.II/base/utilities.h>

#include <stickslip/base/declared_parameters.h>

#include <array>
#include <cstdio>
#include <functional>
#include <map>
#include <string>

namespace stickslip
{
  namespace
  {
    using Selector = std::function<bool(const DeclaredParameter &)>;



    /// The parameters that @p is_selected says, without the sections that have
    /// lost all of theirs.
    DeclaredSection
    selected_parameters(const DeclaredSection &section,
                        const Selector        &is_selected)
    {
      DeclaredSection result;
      result.name = section.name;
      for (const DeclaredParameter &parameter : section.parameters)
        if (is_selected(parameter))
          result.parameters.push_back(parameter);
      for (const DeclaredSection &subsection : section.subsections)
        {
          const DeclaredSection part =
            selected_parameters(subsection, is_selected);
          if (!part.parameters.empty() || !part.subsections.empty())
            result.subsections.push_back(part);
        }
      return result;
    }



    /// Where parameters with long descriptions were described first.
    class FirstDescriptions
    {
    public:
      /**
       * The section that has described the same parameter before; empty if
       * there is none, which makes @p section the one to refer to.
       */
      std::string
      section_of(const DeclaredParameter &parameter, const std::string &section)
      {
        if (parameter.documentation.size() < shortest_to_refer_to)
          return "";
        const auto inserted = sections.insert({{{parameter.name,
                                                 parameter.allowed_values(),
                                                 parameter.documentation}},
                                               section});
        return inserted.second ? "" : inserted.first->second;
      }

    private:
      /// A reference is no shorter than a line of text.
      static constexpr unsigned int shortest_to_refer_to = 80;

      using Description = std::array<std::string, 3>;
      std::map<Description, std::string> sections;
    };



    std::string
    path_of(const std::string &parent,
            const std::string &name,
            const std::string &separator)
    {
      return parent + (parent.empty() ? "" : separator) + name;
    }



    // ------------------------------------------------------------------ prm

    void
    write_prm_comment(std::ostream      &out,
                      const std::string &indent,
                      const std::string &text)
    {
      for (const std::string &line :
           dealii::Utilities::break_text_into_lines(text, 76 - indent.size()))
        out << indent << "# " << line << '\n';
    }



    void
    write_prm_description(std::ostream            &out,
                          const DeclaredParameter &parameter,
                          const std::string       &path,
                          const std::string       &indent,
                          FirstDescriptions       &descriptions)
    {
      const std::string described = descriptions.section_of(parameter, path);
      write_prm_comment(out,
                        indent,
                        described.empty()
                          ? parameter.documentation
                          : "See '" + described + "/" + parameter.name + "'.");
      write_prm_comment(out, indent, "Allowed: " + parameter.allowed_values());
    }



    void
    write_prm_section(std::ostream          &out,
                      const DeclaredSection &section,
                      const std::string     &path,
                      const std::string     &indent,
                      FirstDescriptions     &descriptions)
    {
      std::string separator; // between members, not after the last
      for (const DeclaredParameter &parameter : section.parameters)
        {
          out << separator;
          write_prm_description(out, parameter, path, indent, descriptions);
          if (parameter.is_missing)
            write_prm_comment(out, indent, "Must be set.");
          else if (parameter.value != parameter.default_value)
            write_prm_comment(out,
                              indent,
                              "Default: " + parameter.default_value);
          out << indent << "set " << parameter.name << " ="
              << (parameter.value.empty() ? "" : " ") << parameter.value
              << '\n';
          separator = "\n";
        }
      for (const DeclaredSection &subsection : section.subsections)
        {
          out << separator << indent << "subsection " << subsection.name
              << '\n';
          write_prm_section(out,
                            subsection,
                            path_of(path, subsection.name, "/"),
                            indent + "  ",
                            descriptions);
          out << indent << "end\n";
          separator = "\n";
        }
    }



    void
    write_prm(std::ostream &out, const DeclaredSection &declared)
    {
      FirstDescriptions descriptions;
      write_prm_section(out, declared, "", "", descriptions);
    }



    // ----------------------------------------------------------------- JSON

    std::string
    json_string(const std::string &text)
    {
      std::string result = "\"";
      for (const char letter : text)
        if (letter == '"' || letter == '\\')
          result += {'\\', letter};
        else if (static_cast<unsigned char>(letter) < 0x20)
          {
            char code[8];
            std::snprintf(code, sizeof(code), "\\u%04x", letter);
            result += code;
          }
        else
          result += letter;
      return result + '"';
    }



    void
    write_json_parameter(std::ostream            &out,
                         const DeclaredParameter &parameter,
                         const std::string       &indent)
    {
      const auto write = [&](const std::string &key, const std::string &value) {
        out << indent << "  \"" << key << "\": " << value;
      };
      out << "{\n";
      write("value", json_string(parameter.value) + ",\n");
      write("default", json_string(parameter.default_value) + ",\n");
      write("required", parameter.is_missing ? "true,\n" : "false,\n");
      write("expert", parameter.is_expert ? "true,\n" : "false,\n");
      write("allowed", json_string(parameter.allowed_values()) + ",\n");
      write("documentation", json_string(parameter.documentation) + "\n");
      out << indent << '}';
    }



    void
    write_json_section(std::ostream          &out,
                       const DeclaredSection &section,
                       const std::string     &indent)
    {
      const std::string inner     = indent + "  ";
      std::string       separator = "\n";
      out << '{';
      for (const DeclaredParameter &parameter : section.parameters)
        {
          out << separator << inner << json_string(parameter.name) << ": ";
          write_json_parameter(out, parameter, inner);
          separator = ",\n";
        }
      for (const DeclaredSection &subsection : section.subsections)
        {
          out << separator << inner << json_string(subsection.name) << ": ";
          write_json_section(out, subsection, inner);
          separator = ",\n";
        }
      out << '\n' << indent << '}';
    }



    // ------------------------------------------------------------- Markdown

    /// Text that may stand in a table: no cell borders, no HTML.
    std::string
    markdown_cell(const std::string &text)
    {
      std::string result;
      for (const char letter : text)
        if (letter == '|')
          result += "\\|";
        else if (letter == '<')
          result += "&lt;";
        else if (letter == '\n')
          result += ' ';
        else
          result += letter;
      return result;
    }



    void
    write_markdown_row(std::ostream            &out,
                       const DeclaredParameter &parameter,
                       const std::string       &path,
                       FirstDescriptions       &descriptions)
    {
      const std::string described = descriptions.section_of(parameter, path);
      out << "| " << markdown_cell(parameter.name) << " | "
          << (parameter.is_missing ? "(must be set)"
                                   : markdown_cell(parameter.default_value))
          << " | ";
      if (described.empty())
        out << markdown_cell(parameter.allowed_values()) << " | "
            << markdown_cell(parameter.documentation);
      else
        out << "see there | As in " << markdown_cell(described) << ".";
      out << " |\n";
    }



    void
    write_markdown_section(std::ostream          &out,
                           const DeclaredSection &section,
                           const std::string     &path,
                           FirstDescriptions     &descriptions)
    {
      if (!section.parameters.empty())
        {
          out << "\n### " << (path.empty() ? "Top level" : markdown_cell(path))
              << "\n\n"
              << "| Parameter | Default | Allowed | Meaning |\n"
              << "|---|---|---|---|\n";
          for (const DeclaredParameter &parameter : section.parameters)
            write_markdown_row(out, parameter, path, descriptions);
        }
      for (const DeclaredSection &subsection : section.subsections)
        write_markdown_section(out,
                               subsection,
                               path_of(path, subsection.name, " / "),
                               descriptions);
    }



    void
    write_markdown(std::ostream &out, const DeclaredSection &declared)
    {
      FirstDescriptions descriptions;
      out
        << "# Parameters\n\n"
        << "Written by `stickslip --print-parameters markdown`; do not edit.\n"
        << "A heading is the path of subsections; the user chooses the names "
        << "in &lt;angle brackets>,\nas many as there are bodies, materials "
        << "and so on. On the command line:\n"
        << "`--set \"Section/Subsection/Parameter=value\"`.\n"
        << "\n## Parameters for users\n";
      write_markdown_section(out,
                             selected_parameters(declared,
                                                 [](const auto &parameter) {
                                                   return !parameter.is_expert;
                                                 }),
                             "",
                             descriptions);
      out << "\n## Parameters for experts\n\n"
          << "Few cases need them. They are in the same sections; "
          << "`--print-parameters` prints them with\n`all` only, or where a "
          << "case sets them.\n";
      write_markdown_section(out,
                             selected_parameters(declared,
                                                 [](const auto &parameter) {
                                                   return parameter.is_expert;
                                                 }),
                             "",
                             descriptions);
    }
  } // namespace



  const Choices<ParameterFormat> &
  all_parameter_formats()
  {
    static const Choices<ParameterFormat> choices = {
      {"prm", ParameterFormat::users},
      {"all", ParameterFormat::all},
      {"json", ParameterFormat::json},
      {"markdown", ParameterFormat::markdown}};
    return choices;
  }



  void
  print_parameters(std::ostream                   &out,
                   const dealii::ParameterHandler &prm,
                   const ParameterFormat           format)
  {
    const DeclaredSection declared = declared_parameters(prm);
    switch (format)
      {
        case ParameterFormat::users:
          return write_prm(
            out, selected_parameters(declared, [](const auto &parameter) {
              return !parameter.is_expert || parameter.is_missing ||
                     parameter.value != parameter.default_value;
            }));
        case ParameterFormat::all:
          return write_prm(out, declared);
        case ParameterFormat::json:
          write_json_section(out, declared, "");
          out << '\n';
          return;
        case ParameterFormat::markdown:
          return write_markdown(out, declared);
      }
  }
} // namespace stickslip
