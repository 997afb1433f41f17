#ifndef stickslip_mesh_mesh_format_h
#define stickslip_mesh_mesh_format_h

#include <stickslip/base/choice.h>

namespace stickslip
{
  /// The formats of mesh files.
  enum class MeshFormat
  {
    automatic, ///< by the extension; .inp by its contents
    gmsh,
    abaqus,
    vtk, ///< legacy format
    vtu, ///< XML
    ucd
  };

  inline const Choices<MeshFormat> &
  all_mesh_formats()
  {
    static const Choices<MeshFormat> choices = {{"automatic",
                                                 MeshFormat::automatic},
                                                {"gmsh", MeshFormat::gmsh},
                                                {"abaqus", MeshFormat::abaqus},
                                                {"vtk", MeshFormat::vtk},
                                                {"vtu", MeshFormat::vtu},
                                                {"ucd", MeshFormat::ucd}};
    return choices;
  }
} // namespace stickslip

#endif
