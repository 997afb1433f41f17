#ifndef stickslip_mesh_mesh_file_checks_h
#define stickslip_mesh_mesh_file_checks_h

#include <stickslip/mesh/mesh_format.h>

#include <string>

namespace stickslip
{
  /**
   * What deal.II's readers take for granted (in release builds they may even
   * crash): the version and encoding of a Gmsh file, and that Abaqus, UCD and
   * VTK files have elements of the right dimension and shape. Returns what is
   * wrong or an empty string. @p format is not automatic.
   */
  std::string
  complaint_about_mesh_file(const std::string &contents,
                            const MeshFormat   format,
                            const unsigned int dim);
} // namespace stickslip

#endif
