#ifndef stickslip_base_print_parameters_h
#define stickslip_base_print_parameters_h

#include <deal.II/base/parameter_handler.h>

#include <ostream>
#include <string>

namespace stickslip
{
  /**
   * Print everything that is declared in @p prm, in the order of declaration:
   * name, value, allowed values in words, documentation. For a list whose
   * members the user names, declare one member called like "<body>".
   *
   * As a parameter file; comments carry what is not a value. What is printed
   * can be read again.
   */
  void
  write_prm(std::ostream &out, const dealii::ParameterHandler &prm);

  /**
   * As JSON: subsections are objects, a parameter is an object with the keys
   * value, default, allowed and documentation (all texts) and required.
   */
  void
  write_json(std::ostream &out, const dealii::ParameterHandler &prm);

  /// As a Markdown page with one table per subsection (doc/parameters.md).
  void
  write_markdown(std::ostream &out, const dealii::ParameterHandler &prm);

  /**
   * One of the above for @p format "prm", "json" or "markdown". Throws
   * UserError for another format.
   */
  void
  print_parameters(std::ostream                   &out,
                   const dealii::ParameterHandler &prm,
                   const std::string              &format);
} // namespace stickslip

#endif
