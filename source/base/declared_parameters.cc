#include <stickslip/base/declared_parameters.h>

#include <deal.II/base/patterns.h>
#include <deal.II/base/utilities.h>

// The parser needs the names _1, _2 of Boost.Bind; without this it warns.
#ifndef BOOST_BIND_GLOBAL_PLACEHOLDERS
#  define BOOST_BIND_GLOBAL_PLACEHOLDERS
#endif
#include <boost/property_tree/json_parser.hpp>
#include <boost/property_tree/ptree.hpp>

#include <cctype>
#include <exception>
#include <set>
#include <sstream>

namespace stickslip
{
  namespace
  {
    using DeclarationTree = boost::property_tree::ptree;

    bool
    pattern_begins_with(const std::string &text, const std::string &beginning)
    {
      return text.compare(0, beginning.size(), beginning) == 0;
    }



    /// ParameterHandler's internal spelling: other characters become "_2f".
    std::string
    mangled_name(const std::string &name)
    {
      const char *const digits = "0123456789abcdef";
      std::string       result;
      for (const unsigned char letter : name)
        if (letter < 128 && std::isalnum(letter))
          result += letter;
        else
          result += {'_', digits[letter / 16], digits[letter % 16]};
      return result;
    }



    DeclaredSection
    section_from_tree(const DeclarationTree       &tree,
                      const std::string           &mangled_path,
                      const std::set<std::string> &missing)
    {
      DeclaredSection section;
      for (const auto &[name, child] : tree)
        {
          const auto leaf = [&child = child](const std::string &key) {
            const auto entry = child.find(key);
            return entry != child.not_found() && entry->second.empty()
                     ? entry->second.data()
                     : std::string();
          };
          const std::string path = mangled_path + mangled_name(name);

          // A subsection may contain parameters called like the attributes of
          // a parameter, but those have attributes of their own.
          if (!leaf("pattern_description").empty())
            section.parameters.push_back({name,
                                          leaf("value"),
                                          leaf("default_value"),
                                          leaf("documentation"),
                                          leaf("pattern_description"),
                                          missing.count(path) > 0});
          else if (!leaf("alias").empty())
            section.aliases.push_back(name);
          else
            {
              section.subsections.push_back(
                section_from_tree(child, path + ".", missing));
              section.subsections.back().name = name;
            }
        }
      return section;
    }



    /// The text between @p beginning and @p end; empty if they are not there.
    std::string
    enclosed_text(const std::string &text,
                  const std::string &beginning,
                  const std::string &end)
    {
      const std::size_t first = text.find(beginning);
      const std::size_t last  = text.rfind(end);
      if (first == std::string::npos || last == std::string::npos ||
          last < first + beginning.size())
        return "";
      return text.substr(first + beginning.size(),
                         last - first - beginning.size());
    }



    /// "0...MAX_DOUBLE" -> ">= 0", without the bounds that mean none.
    std::string
    range_in_words(const std::string &range)
    {
      const std::size_t dots  = range.find("...");
      const std::string lower = range.substr(0, dots);
      const std::string upper = range.substr(dots + 3);
      const bool has_lower = (lower != "-MAX_DOUBLE" && lower != "-2147483648");
      const bool has_upper = (upper != "MAX_DOUBLE" && upper != "2147483647" &&
                              upper != "4294967295");

      if (has_lower && has_upper)
        return lower == upper ? " equal to " + lower
                              : " from " + lower + " to " + upper;
      return has_lower ? " >= " + lower : has_upper ? " <= " + upper : "";
    }



    std::string
    pattern_in_words(const std::string &pattern);



    /// "[List of <[Bool]> of length 0...3 (inclusive) separated by <;>]"
    std::string
    list_in_words(const std::string &pattern)
    {
      const std::string element =
        enclosed_text(pattern, "[List of <", "> of length ");
      const std::string length =
        enclosed_text(pattern, "> of length ", " (inclusive)");
      std::string separator =
        enclosed_text(pattern, "(inclusive) separated by <", ">]");
      separator = separator.empty() ? "commas" : "'" + separator + "'";

      const std::string count =
        pattern_begins_with(length, "0...") && length != "0...0" &&
            range_in_words(length) == " >= 0"
          ? ""
          : "; number of values" + range_in_words(length);
      return "a list separated by " + separator +
             ", each: " + pattern_in_words(element) + count;
    }



    std::string
    pattern_in_words(const std::string &pattern)
    {
      if (pattern_begins_with(pattern, "[Anything"))
        return "any text";
      if (pattern_begins_with(pattern, "[Bool"))
        return "true or false";
      if (pattern_begins_with(pattern, "[FileName"))
        return "a file name";
      if (pattern_begins_with(pattern, "[DirectoryName"))
        return "a directory name";
      if (pattern_begins_with(pattern, "[Integer range "))
        return "an integer" +
               range_in_words(
                 enclosed_text(pattern, "[Integer range ", " (inclusive)"));
      if (pattern_begins_with(pattern, "[Integer"))
        return "an integer";
      if (pattern_begins_with(pattern, "[Double "))
        return "a number" +
               range_in_words(
                 enclosed_text(pattern, "[Double ", " (inclusive)"));
      if (pattern_begins_with(pattern, "[Double"))
        return "a number";
      if (pattern_begins_with(pattern, "[List of <"))
        return list_in_words(pattern);
      if (pattern_begins_with(pattern, "[Tuple of <"))
        return "numbers separated by ':'"; // deal.II cannot read its own text
      try
        {
          return dealii::Patterns::pattern_factory(pattern)->description(
            dealii::Patterns::PatternBase::Text);
        }
      catch (const std::exception &)
        {
          return pattern; // a pattern of a derived class
        }
    }
  } // namespace



  std::string
  DeclaredParameter::allowed_values() const
  {
    std::string words;
    for (const std::string &choice : choices())
      words += (words.empty() ? "" : " | ") + choice;
    return words.empty() ? pattern_in_words(pattern) : words;
  }



  std::vector<std::string>
  DeclaredParameter::choices() const
  {
    const std::string names = enclosed_text(pattern, "[Selection ", "]");
    return pattern_begins_with(pattern, "[Selection ")
             ? dealii::Utilities::split_string_list(names, '|')
             : std::vector<std::string>();
  }



  const DeclaredParameter *
  DeclaredSection::find_parameter(const std::string &parameter_name) const
  {
    for (const DeclaredParameter &parameter : parameters)
      if (parameter.name == parameter_name)
        return &parameter;
    return nullptr;
  }



  const DeclaredSection *
  DeclaredSection::find_subsection(const std::string &subsection_name) const
  {
    for (const DeclaredSection &subsection : subsections)
      if (subsection.name == subsection_name)
        return &subsection;
    return nullptr;
  }



  std::vector<std::string>
  DeclaredSection::parameter_names() const
  {
    std::vector<std::string> names;
    for (const DeclaredParameter &parameter : parameters)
      names.push_back(parameter.name);
    return names;
  }



  std::vector<std::string>
  DeclaredSection::subsection_names() const
  {
    std::vector<std::string> names;
    for (const DeclaredSection &subsection : subsections)
      names.push_back(subsection.name);
    return names;
  }



  DeclaredSection
  declared_parameters(const dealii::ParameterHandler &prm)
  {
    using dealii::ParameterHandler;

    // JSON is the only complete description that ParameterHandler gives.
    std::stringstream description;
    prm.print_parameters(description,
                         ParameterHandler::JSON |
                           ParameterHandler::KeepDeclarationOrder);
    DeclarationTree tree;
    boost::property_tree::read_json(description, tree);
    return section_from_tree(tree, "", prm.get_entries_wrongly_not_set());
  }
} // namespace stickslip
