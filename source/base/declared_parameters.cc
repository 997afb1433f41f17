#include <stickslip/base/declared_parameters.h>

#include <stickslip/base/allowed_values.h>
#include <stickslip/base/expert_parameter.h>

// The parser needs the names _1, _2 of Boost.Bind; without this it warns.
#ifndef BOOST_BIND_GLOBAL_PLACEHOLDERS
#  define BOOST_BIND_GLOBAL_PLACEHOLDERS
#endif
#include <boost/property_tree/json_parser.hpp>
#include <boost/property_tree/ptree.hpp>

#include <cctype>
#include <set>
#include <sstream>

namespace stickslip
{
  namespace
  {
    using DeclarationTree = boost::property_tree::ptree;

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
            {
              const std::string text      = leaf("documentation");
              const bool        is_expert = text.rfind(expert_mark, 0) == 0;
              section.parameters.push_back(
                {name,
                 leaf("value"),
                 leaf("default_value"),
                 is_expert ? text.substr(expert_mark.size()) : text,
                 leaf("pattern_description"),
                 missing.count(path) > 0,
                 is_expert});
            }
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
  } // namespace



  std::string
  DeclaredParameter::allowed_values() const
  {
    return allowed_values_of_pattern(pattern);
  }



  std::vector<std::string>
  DeclaredParameter::choices() const
  {
    return choices_of_pattern(pattern);
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
