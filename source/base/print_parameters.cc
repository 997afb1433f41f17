#include <stickslip/base/print_parameters.h>

#include <deal.II/base/utilities.h>

#include <stickslip/base/declared_parameters.h>
#include <stickslip/base/user_error.h>

#include <cstdio>

namespace stickslip
{
  namespace
  {
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
    write_prm_section(std::ostream          &out,
                      const DeclaredSection &section,
                      const std::string     &indent)
    {
      std::string separator; // between members, not after the last
      for (const DeclaredParameter &parameter : section.parameters)
        {
          out << separator;
          write_prm_comment(out, indent, parameter.documentation);
          write_prm_comment(out,
                            indent,
                            "Allowed: " + parameter.allowed_values());
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
          write_prm_section(out, subsection, indent + "  ");
          out << indent << "end\n";
          separator = "\n";
        }
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
    write_markdown_section(std::ostream          &out,
                           const DeclaredSection &section,
                           const std::string     &path)
    {
      if (!section.parameters.empty())
        {
          out << "\n## " << (path.empty() ? "Top level" : markdown_cell(path))
              << "\n\n"
              << "| Parameter | Default | Allowed | Meaning |\n"
              << "|---|---|---|---|\n";
          for (const DeclaredParameter &parameter : section.parameters)
            out << "| " << markdown_cell(parameter.name) << " | "
                << (parameter.is_missing
                      ? "(must be set)"
                      : markdown_cell(parameter.default_value))
                << " | " << markdown_cell(parameter.allowed_values()) << " | "
                << markdown_cell(parameter.documentation) << " |\n";
        }
      for (const DeclaredSection &subsection : section.subsections)
        write_markdown_section(out,
                               subsection,
                               path + (path.empty() ? "" : " / ") +
                                 subsection.name);
    }
  } // namespace



  void
  write_prm(std::ostream &out, const dealii::ParameterHandler &prm)
  {
    write_prm_section(out, declared_parameters(prm), "");
  }



  void
  write_json(std::ostream &out, const dealii::ParameterHandler &prm)
  {
    write_json_section(out, declared_parameters(prm), "");
    out << '\n';
  }



  void
  write_markdown(std::ostream &out, const dealii::ParameterHandler &prm)
  {
    out << "# Parameters\n\n"
        << "Written by `stickslip --print-parameters markdown`; do not edit.\n"
        << "A heading is the path of subsections; the user chooses the names "
        << "in &lt;angle brackets>,\nas many as there are bodies, materials "
        << "and so on. On the command line:\n"
        << "`--set \"Section/Subsection/Parameter=value\"`.\n";
    write_markdown_section(out, declared_parameters(prm), "");
  }



  void
  print_parameters(std::ostream                   &out,
                   const dealii::ParameterHandler &prm,
                   const std::string              &format)
  {
    if (format == "prm")
      write_prm(out, prm);
    else if (format == "json")
      write_json(out, prm);
    else if (format == "markdown")
      write_markdown(out, prm);
    else
      throw UserError("Unknown format '" + format +
                      "' of parameters. Known: 'prm', 'json', 'markdown'.");
  }
} // namespace stickslip
