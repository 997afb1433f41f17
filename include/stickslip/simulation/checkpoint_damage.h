#ifndef stickslip_simulation_checkpoint_damage_h
#define stickslip_simulation_checkpoint_damage_h

#include <string>

namespace stickslip
{
  // Whether checkpoints are whole. For rank 0, not collective.

  /// What is wrong with the files in the directory @p checkpoint; "" if
  /// nothing. Reads all of them.
  std::string
  find_damage(const std::string &checkpoint);

  /// " The checkpoint 'results/checkpoint-b' is whole." if there is one beside
  /// @p checkpoint, to be appended to a message; "" if not.
  std::string
  name_whole_checkpoint_beside(const std::string &checkpoint);

  /// Says that @p checkpoint cannot be used because of @p damage, and where
  /// another one is.
  std::string
  describe_damage(const std::string &checkpoint, const std::string &damage);
} // namespace stickslip

#endif
