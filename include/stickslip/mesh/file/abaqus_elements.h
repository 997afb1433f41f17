#ifndef stickslip_mesh_file_abaqus_elements_h
#define stickslip_mesh_file_abaqus_elements_h

#include <string>

namespace stickslip
{
  /// Index of the type that Abaqus calls @p name (upper case), -1 if it is not
  /// known.
  int
  element_type_of_abaqus(const std::string &name);
} // namespace stickslip

#endif
