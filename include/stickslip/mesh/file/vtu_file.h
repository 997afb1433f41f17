#ifndef stickslip_mesh_file_vtu_file_h
#define stickslip_mesh_file_vtu_file_h

#include <stickslip/mesh/file/mesh_file.h>

#include <string>

namespace stickslip
{
  /// Reads an unstructured grid in VTK's serial XML format (.vtu): text, base64
  /// or appended data, compressed with zlib or not. Numbers of groups as in
  /// read_vtk(). Throws MeshFileError.
  MeshFile
  read_vtu(const std::string &contents);
} // namespace stickslip

#endif
