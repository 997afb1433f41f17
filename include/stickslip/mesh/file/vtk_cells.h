#ifndef stickslip_mesh_file_vtk_cells_h
#define stickslip_mesh_file_vtk_cells_h

#include <stickslip/mesh/file/mesh_file.h>

#include <string>
#include <vector>

namespace stickslip
{
  /// An unstructured grid as VTK's formats have it.
  struct VtkGrid
  {
    std::vector<double> coordinates;  ///< three per point
    std::vector<double> connectivity; ///< points of all cells
    std::vector<double> offsets;      ///< end of each cell in connectivity
    std::vector<double> types;        ///< one per cell
    std::vector<double> ids; ///< one per cell, or none; numbers of groups

    /// Throws MeshFileError if the parts do not fit together.
    MeshFile
    mesh_file() const;
  };

  /// Is a cell array of this name taken for the numbers of groups? MaterialID
  /// (deal.II), gmsh:physical and others (meshio), CellEntityIds (Gmsh).
  bool
  is_vtk_id_array(const std::string &name);
} // namespace stickslip

#endif
