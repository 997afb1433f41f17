#ifndef stickslip_mesh_named_surface_h
#define stickslip_mesh_named_surface_h

#include <string>
#include <vector>

namespace stickslip
{
  /// Boundaries of a body as the user names them.
  struct NamedSurface
  {
    std::string              parameter_path; ///< for messages
    std::string              body;
    std::vector<std::string> boundary; ///< ids or names
  };
} // namespace stickslip

#endif
