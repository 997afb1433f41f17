#ifndef stickslip_mesh_file_ucd_file_h
#define stickslip_mesh_file_ucd_file_h

#include <stickslip/mesh/file/mesh_file.h>

#include <string>

namespace stickslip
{
  /// Reads a file of AVS UCD's text format. Material ids become numbers of
  /// groups. Throws MeshFileError.
  MeshFile
  read_ucd(const std::string &contents);
} // namespace stickslip

#endif
