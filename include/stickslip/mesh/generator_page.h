#ifndef stickslip_mesh_generator_page_h
#define stickslip_mesh_generator_page_h

#include <ostream>

namespace stickslip
{
  /// Writes a part of a Markdown page: every generator with its arguments and
  /// what its boundary ids are, found out on an example of each.
  void
  print_generators(std::ostream &out);
} // namespace stickslip

#endif
