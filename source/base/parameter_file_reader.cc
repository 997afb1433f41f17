#include <stickslip/base/parameter_file_reader.h>

#include <deal.II/base/utilities.h>

#include <stickslip/base/nearest_name.h>
#include <stickslip/base/text_encoding.h>
#include <stickslip/base/user_error.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <utility>

namespace stickslip
{
  namespace
  {
    /// Any white space counts as one blank, as in ParameterHandler.
    std::string
    normalized_parameter_name(const std::string &text)
    {
      std::string result;
      for (const char letter : dealii::Utilities::trim(text))
        if (letter != ' ' && letter != '\t')
          result += letter;
        else if (result.back() != ' ')
          result += ' ';
      return result;
    }
  } // namespace



  std::string
  ParameterStatement::full_name() const
  {
    return join_parameter_path(path) + (path.empty() ? "" : "/") + name;
  }



  std::string
  ParameterStatement::location() const
  {
    if (file.empty())
      return "--set";
    return line == 0 ? file : file + ":" + std::to_string(line);
  }



  ParameterStatements
  ParameterFileReader::read_file(const std::string &file_name)
  {
    ParameterFileReader reader;
    reader.open(file_name, "");
    return std::move(reader.statements);
  }



  ParameterStatements
  ParameterFileReader::read_stream(std::istream &input, const std::string &name)
  {
    ParameterFileReader reader;
    reader.read(input, name);
    return std::move(reader.statements);
  }



  void
  ParameterFileReader::open(const std::string &file_name,
                            const std::string &included_at)
  {
    const std::string prefix =
      included_at.empty() ? "The" : included_at + ": the";

    std::error_code error; // a name that is too long opens nothing
    if (std::filesystem::is_directory(file_name, error))
      throw UserError(prefix + " parameter file '" + file_name +
                      "' is a directory.");
    std::ifstream input(file_name);
    if (!input)
      throw UserError(prefix + " parameter file '" + file_name +
                      "' cannot be opened for reading.");
    read(input, file_name);
  }



  void
  ParameterFileReader::read(std::istream &input, const std::string &file_name)
  {
    open_files.push_back(
      {file_name, open_sections.size(), statements.entries.size()});

    std::string  line, statement;
    unsigned int line_number = 0;
    bool         is_complete = true; // no line before asks for this one
    while (std::getline(input, line))
      {
        ++line_number;
        if (line_number == 1)
          line = std::string(without_byte_order_mark(line));
        const std::size_t comment     = line.find('#');
        const bool        has_comment = (comment != std::string::npos);
        line = dealii::Utilities::trim(line.substr(0, comment));

        // A comment between continued lines does not end the statement.
        if (!is_complete && line.empty() && has_comment)
          continue;

        if (is_complete)
          open_files.back().line = line_number;
        check_encoding(line);
        is_complete = line.empty() || line.back() != '\\';
        if (!is_complete)
          line.pop_back();
        statement += line;

        if (is_complete)
          {
            process(statement);
            statement.clear();
          }
      }
    process(statement);
    close();
  }



  void
  ParameterFileReader::check_encoding(const std::string &line) const
  {
    if (is_utf16(line))
      fail(
        "the file is encoded as UTF-16. Save it as UTF-8 (iconv -f UTF-16 "
        "-t UTF-8).");
    if (line.find('\0') != std::string::npos)
      fail("found a zero byte: it is no text file.");
    if (!is_utf8(line))
      fail("found a letter that is not UTF-8 (in Latin-1 '" +
           utf8_of_latin1(line) +
           "'). Save the file as UTF-8 (iconv -f LATIN1 -t UTF-8).");
  }



  void
  ParameterFileReader::close()
  {
    if (open_sections.size() > open_files.back().n_outer_sections)
      throw UserError(open_sections.back().location() + ": the subsection '" +
                      join_parameter_path(open_sections.back().path) +
                      "' is not closed by an 'end'.");
    open_files.pop_back();
  }



  void
  ParameterFileReader::process(const std::string &statement)
  {
    if (statement.empty())
      return;
    const std::size_t keyword_end = statement.find_first_of(" \t");
    const std::string keyword     = statement.substr(0, keyword_end);
    const std::string rest =
      (keyword_end == std::string::npos)
        ? ""
        : dealii::Utilities::trim(statement.substr(keyword_end));

    if (keyword == "set" || keyword == "SET")
      set(rest);
    else if (keyword == "subsection" || keyword == "SUBSECTION")
      enter_subsection(normalized_parameter_name(rest));
    else if ((keyword == "end" || keyword == "END") && rest.empty())
      leave_subsection();
    else if (keyword == "include" || keyword == "INCLUDE")
      include(rest);
    else
      fail("cannot understand '" + statement + "'." +
           did_you_mean(keyword, {"set", "subsection", "end", "include"}) +
           " A line is 'set Name = value', 'subsection Name', 'end' or "
           "'include FILE'; '#' begins a comment.");
  }



  void
  ParameterFileReader::enter_subsection(const std::string &name)
  {
    if (name.empty())
      fail("'subsection' needs a name.");
    for (const char c : {'/', '.'})
      if (name.find(c) != std::string::npos)
        fail("the name of the subsection '" + name + "' must not contain '" +
             c + "'.");

    ParameterStatement section = statement_here();
    section.path.push_back(name);
    open_sections.push_back(section);
    statements.sections.push_back(section);
  }



  void
  ParameterFileReader::leave_subsection()
  {
    if (open_sections.size() == open_files.back().n_outer_sections)
      fail("'end' without an open subsection.");
    open_sections.pop_back();
  }



  void
  ParameterFileReader::include(const std::string &file_name)
  {
    if (file_name.empty())
      fail("'include' needs a file name.");

    const std::string path =
      (std::filesystem::path(open_files.back().name).parent_path() / file_name)
        .string();
    for (const OpenFile &file : open_files)
      if (file.name == path)
        fail("the file '" + path + "' includes itself.");
    open(path, statement_here().location());
  }



  void
  ParameterFileReader::set(const std::string &assignment)
  {
    const std::size_t equal_sign = assignment.find('=');
    if (equal_sign == std::string::npos)
      fail("'set " + assignment + "' lacks a '='. Write 'set Name = value'.");

    ParameterStatement entry = statement_here();
    entry.name  = normalized_parameter_name(assignment.substr(0, equal_sign));
    entry.value = dealii::Utilities::trim(assignment.substr(equal_sign + 1));
    if (entry.name.empty())
      fail("'set' lacks the name of a parameter. Write 'set Name = value'.");
    if (entry.name.find('/') != std::string::npos)
      fail("the parameter name '" + entry.name +
           "' must not contain '/'. Enter the subsection instead.");

    auto      &entries  = statements.entries;
    const auto previous = std::find_if(entries.begin(),
                                       entries.end(),
                                       [&](const ParameterStatement &other) {
                                         return other.path == entry.path &&
                                                other.name == entry.name;
                                       });
    if (previous == entries.end())
      entries.push_back(entry);
    // A file specializes what it includes: its own value wins. Anything else
    // set twice is a mistake.
    else if (previous->file != entry.file &&
             static_cast<std::size_t>(previous - entries.begin()) >=
               open_files.back().n_outer_entries)
      *previous = entry;
    else
      fail("the parameter '" + entry.full_name() + "' is already set in " +
           previous->location() + ".");
  }



  void
  ParameterFileReader::fail(const std::string &text) const
  {
    throw UserError(statement_here().location() + ": " + text);
  }



  ParameterStatement
  ParameterFileReader::statement_here() const
  {
    ParameterStatement statement;
    if (!open_sections.empty())
      statement.path = open_sections.back().path;
    statement.file = open_files.back().name;
    statement.line = open_files.back().line;
    return statement;
  }



  std::vector<std::string>
  split_parameter_path(const std::string &path)
  {
    std::vector<std::string> names;
    std::size_t              begin = 0;
    while (begin < path.size())
      {
        const std::size_t end = std::min(path.find('/', begin), path.size());
        const std::string name =
          normalized_parameter_name(path.substr(begin, end - begin));
        if (!name.empty())
          names.push_back(name);
        begin = end + 1;
      }
    return names;
  }



  std::string
  join_parameter_path(const std::vector<std::string> &path)
  {
    std::string text;
    for (const std::string &name : path)
      text += (text.empty() ? "" : "/") + name;
    return text;
  }
} // namespace stickslip
