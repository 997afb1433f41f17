#ifndef stickslip_output_old_output_h
#define stickslip_output_old_output_h

#include <string>

namespace stickslip
{
  // What earlier runs have left in an output directory. Only files with the
  // names that this program gives are touched: fields, tables, indices,
  // diagnoses, no checkpoints. Both functions are for rank 0, not collective,
  // and return an empty string, or what could not be removed.

  /// For a run that begins: nothing in @p directory may pass for a part of it.
  std::string
  remove_old_output(const std::string &directory);

  /// For a run that goes on after @p step: the files of later steps would be of
  /// a run that was interrupted after its last checkpoint. Tables and indices
  /// drop such steps themselves; the diagnosis of a step that failed stays.
  std::string
  remove_output_after(const std::string &directory, const unsigned int step);
} // namespace stickslip

#endif
