#ifndef stickslip_base_allowed_values_h
#define stickslip_base_allowed_values_h

#include <string>
#include <vector>

namespace stickslip
{
  /**
   * What a parameter may be, from the text with which deal.II describes its
   * pattern (Patterns::PatternBase::description()). Patterns have no other
   * interface to their bounds and names. The unit test allowed_values holds
   * these functions against each kind of pattern, so that a deal.II that writes
   * its descriptions in another way is noticed.
   *
   * In words: "a number >= 0", "newton | fixed point". The description itself
   * for a pattern that is not known here.
   */
  std::string
  allowed_values_of_pattern(const std::string &description);

  /// The names of a Patterns::Selection; empty for other patterns.
  std::vector<std::string>
  choices_of_pattern(const std::string &description);
} // namespace stickslip

#endif
