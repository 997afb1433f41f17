#ifndef stickslip_base_print_parameters_h
#define stickslip_base_print_parameters_h

#include <deal.II/base/parameter_handler.h>

#include <stickslip/base/choice.h>

#include <ostream>

namespace stickslip
{
  /// The ways to print parameters.
  enum class ParameterFormat
  {
    users,    ///< a parameter file without expert parameters
    all,      ///< a parameter file
    json,     ///< everything, for programs
    markdown, ///< everything, as a page
  };

  /// "prm", "all", "json", "markdown".
  const Choices<ParameterFormat> &
  all_parameter_formats();

  /**
   * Prints what is declared in @p prm, in the order of declaration: name,
   * value, allowed values in words, documentation. For a list whose members the
   * user names, declare one member called like "<body>".
   *
   * As a parameter file, comments carry what is not a value; what is printed
   * can be read again and says the same. For users, expert parameters are
   * there only where their value is not the default.
   *
   * As JSON, subsections are objects, a parameter is an object with the keys
   * value, default, allowed and documentation (all texts), required and expert.
   *
   * As a Markdown page (doc/parameters.md), there are two parts, for users and
   * for experts, with one table per subsection.
   *
   * Where members of a list share a parameter with a long description, the
   * file and the page have the description once and refer to it elsewhere.
   */
  void
  print_parameters(std::ostream                   &out,
                   const dealii::ParameterHandler &prm,
                   const ParameterFormat           format);
} // namespace stickslip

#endif
