#ifndef stickslip_base_declared_parameters_h
#define stickslip_base_declared_parameters_h

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace stickslip
{
  /**
   * What a ParameterHandler knows of one parameter.
   */
  struct DeclaredParameter
  {
    std::string name;
    std::string value;
    std::string default_value;
    std::string documentation;      ///< without the mark of expert()
    std::string pattern;            ///< as Patterns::PatternBase::description()
    bool        is_missing = false; ///< has to be set and is not
    bool        is_expert  = false; ///< declared with expert()

    /// What the pattern allows, in words: "a number >= 0".
    std::string
    allowed_values() const;

    /// The names of a Selection; empty for other patterns.
    std::vector<std::string>
    choices() const;
  };

  /**
   * A subsection with all that is declared in it, in the order of declaration.
   * ParameterHandler itself has no interface to look at its content.
   */
  struct DeclaredSection
  {
    std::string                    name; ///< empty for the top level
    std::vector<DeclaredParameter> parameters;
    std::vector<DeclaredSection>   subsections;
    std::vector<std::string>       aliases; ///< further names of parameters

    /// nullptr if nothing of this name is declared.
    const DeclaredParameter *
    find_parameter(const std::string &parameter_name) const;

    /// nullptr if nothing of this name is declared.
    const DeclaredSection *
    find_subsection(const std::string &subsection_name) const;

    std::vector<std::string>
    parameter_names() const;

    std::vector<std::string>
    subsection_names() const;
  };

  /// Everything that is declared in @p prm, from its top level on.
  DeclaredSection
  declared_parameters(const dealii::ParameterHandler &prm);
} // namespace stickslip

#endif
