#ifndef stickslip_mesh_file_abaqus_file_h
#define stickslip_mesh_file_abaqus_file_h

#include <stickslip/mesh/file/mesh_file.h>

#include <string>

namespace stickslip
{
  /**
   * Reads the mesh of an Abaqus input file, flat (as Gmsh and meshio write it)
   * or with parts, instances and an assembly (as CAE does). Keywords that
   * are no part of a mesh are skipped, those that would change it (*NGEN,
   * *INCLUDE, *SYSTEM, ...) are refused. Throws MeshFileError.
   *
   * Groups: element sets (by the dimension of their elements), element
   * surfaces (of dimension 1 or 2) and instances; node sets and node surfaces
   * become point sets. Sets that CAE marks as internal are left out. A surface,
   * and a set that an *ELEMENT line names, gets the number in its name, or the
   * next free number from 1 if there is none or it is taken.
   *
   * Why not deal.II's reader: it has no names, knows neither parts nor nodes
   * in free format, and waits for lines that need not be there.
   */
  MeshFile
  read_abaqus(const std::string &contents);
} // namespace stickslip

#endif
