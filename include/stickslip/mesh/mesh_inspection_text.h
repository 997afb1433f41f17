#ifndef stickslip_mesh_mesh_inspection_text_h
#define stickslip_mesh_mesh_inspection_text_h

#include <stickslip/mesh/mesh_inspection.h>

#include <ostream>

namespace stickslip
{
  /// What `--inspect-mesh` says, for people.
  void
  print_inspection(std::ostream &out, const MeshInspection &inspection);

  /// The same for programs: one object.
  void
  print_inspection_json(std::ostream &out, const MeshInspection &inspection);
} // namespace stickslip

#endif
