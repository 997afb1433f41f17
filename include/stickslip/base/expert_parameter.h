#ifndef stickslip_base_expert_parameter_h
#define stickslip_base_expert_parameter_h

#include <string>

namespace stickslip
{
  /**
   * What the documentation of an expert parameter begins with. ParameterHandler
   * keeps nothing of a parameter but its texts, so the mark travels in one of
   * them; declared_parameters() turns it into DeclaredParameter::is_expert.
   */
  inline const std::string expert_mark = "[expert] ";

  /**
   * Marks a parameter as one for experts where it is declared:
   * @code
   *   prm.add_parameter("Largest zone", largest_zone, expert("..."));
   * @endcode
   * Expert parameters change how a solution is found, not what is solved; few
   * cases need them. They are printed on request only. Messages about unknown
   * parameters know them as all others.
   */
  inline std::string
  expert(const std::string &documentation)
  {
    return expert_mark + documentation;
  }
} // namespace stickslip

#endif
