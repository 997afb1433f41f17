#ifndef stickslip_mesh_file_gmsh_file_h
#define stickslip_mesh_file_gmsh_file_h

#include <stickslip/mesh/file/mesh_file.h>

#include <string>

namespace stickslip
{
  /**
   * Reads a .msh file of the versions 1, 2.0 to 2.2, 4.0 and 4.1, as text or
   * (2.x and 4.1) binary, after the description in Gmsh's reference manual,
   * section "MSH file format". Physical groups become groups. Throws
   * MeshFileError.
   *
   * Why not deal.II's reader: it knows no binary files and no names, keeps one
   * physical group per element and ends broken files with an exception or a
   * crash, without the line.
   */
  MeshFile
  read_gmsh(const std::string &contents);
} // namespace stickslip

#endif
