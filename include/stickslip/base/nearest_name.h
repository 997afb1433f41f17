#ifndef stickslip_base_nearest_name_h
#define stickslip_base_nearest_name_h

#include <string>
#include <vector>

namespace stickslip
{
  /**
   * The number of letters to insert, delete, replace or swap with their
   * neighbour that turns one word into the other, without regard to case
   * (optimal string alignment distance).
   */
  unsigned int
  edit_distance(const std::string &a, const std::string &b);

  /**
   * The names that the user may have meant, nearest first and at most three:
   * few letters differ, or one is contained in the other. May be empty.
   */
  std::vector<std::string>
  nearest_names(const std::string              &name,
                const std::vector<std::string> &known_names);

  /// " Did you mean 'x' or 'y'?" for the nearest names, or "" without any.
  std::string
  did_you_mean(const std::string              &name,
               const std::vector<std::string> &known_names);

  /// "'a', 'b', 'c'", or "none".
  std::string
  quoted_list(const std::vector<std::string> &names);
} // namespace stickslip

#endif
