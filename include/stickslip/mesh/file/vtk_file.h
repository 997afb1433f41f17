#ifndef stickslip_mesh_file_vtk_file_h
#define stickslip_mesh_file_vtk_file_h

#include <stickslip/mesh/file/mesh_file.h>

#include <string>

namespace stickslip
{
  /**
   * Reads an unstructured grid in VTK's legacy format (.vtk), versions 2 to
   * 5.1, as text or binary. Integers of a cell array that is_vtk_id_array()
   * become numbers of groups. Throws MeshFileError.
   */
  MeshFile
  read_vtk(const std::string &contents);
} // namespace stickslip

#endif
