#ifndef stickslip_base_named_constants_h
#define stickslip_base_named_constants_h

#include <stickslip/base/parameter_file_reader.h>

#include <deal.II/base/parameter_handler.h>

#include <map>
#include <string>
#include <vector>

namespace stickslip
{
  /**
   * The section Constants: numbers that the user names once and uses in the
   * values of other parameters as `{name}`, or in an expression between braces,
   * `{2 * width}`. What is between braces is replaced by its value before the
   * parameter is read; so it may stand in a number, in arguments, in the middle
   * of another expression and in a file's name.
   * @code
   *   subsection Constants
   *     set width = 40
   *     set half  = width / 2   # of those before it
   *   end
   * @endcode
   */
  class NamedConstants
  {
  public:
    static constexpr const char *section_name = "Constants";

    /// Evaluates the constants among @p entries in their order. Throws
    /// UserError, at the statement, for a wrong name and for what is no number.
    explicit NamedConstants(const std::vector<ParameterStatement> &entries);

    /// @p text with its braces replaced. Throws UserError that begins with
    /// @p place for braces that do not match and for what cannot be evaluated.
    std::string
    inserted_in(const std::string &text, const std::string &place) const;

    /// For the page of all parameters.
    static void
    declare_placeholder(dealii::ParameterHandler &prm);

  private:
    std::map<std::string, double> values;
  };

  /// True for a statement in, or the subsection, Constants.
  bool
  is_about_constants(const ParameterStatement &statement);
} // namespace stickslip

#endif
