#ifndef stickslip_simulation_result_expression_h
#define stickslip_simulation_result_expression_h

#include <functional>
#include <string>
#include <vector>

namespace stickslip
{
  /**
   * A result of a run by its name, or an expression of results:
   * "base.force_y", "abs(base.friction_force_x) / base.normal_force_y". Names
   * may have blanks and dots; the longest name that fits is taken. muparser
   * evaluates the rest, with pi and its functions.
   */
  class ResultExpression
  {
  public:
    /// Throws UserError that blames @p path for a name that is not among
    /// @p known, for a maximum or sum of one, and for what muparser does not
    /// understand.
    ResultExpression(const std::string              &text,
                     const std::vector<std::string> &known,
                     const std::string              &path);

    /// The results that it is made of.
    const std::vector<std::string> &
    names() const
    {
      return used;
    }

    /// nan if one of the results is not a finite number.
    double
    value(const std::function<double(const std::string &)> &result) const;

  private:
    void
    refuse_unknown_names(const std::string              &text,
                         const std::vector<std::string> &known) const;

    /// max(x), sum(x) are x, which is hardly what was meant.
    void
    refuse_functions_of_one(const std::string &text) const;

    std::string              path;
    std::vector<std::string> texts; ///< before, between and after the results
    std::vector<std::string> used;
  };
} // namespace stickslip

#endif
