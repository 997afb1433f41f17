#ifndef stickslip_mesh_mesh_interfaces_h
#define stickslip_mesh_mesh_interfaces_h

#include <stickslip/mesh/file/mesh_file.h>

#include <deal.II/base/point.h>

#include <string>
#include <vector>

namespace stickslip
{
  using namespace dealii;

  /// Two bodies with surfaces that are near each other.
  struct NearSurfaces
  {
    unsigned int first, second; ///< bodies, from 0
    double       gap;           ///< the least distance of a node from a face
    Point<3>     place;         ///< of that node
    std::size_t  n_points;      ///< nodes of both nearer than a face is long
    bool         has_matching_nodes = false; ///< nodes at the same places
    std::vector<std::string> first_surfaces, second_surfaces; ///< in words
  };

  /// Where surfaces of a mesh touch or nearly do.
  struct MeshInterfaces
  {
    std::size_t n_coincident = 0; ///< pairs of nodes at one place
    std::size_t n_crack      = 0; ///< those of one body: a crack, or not merged
    Point<3>    crack_place;
    std::size_t n_hanging = 0; ///< nodes inside a face of the same body
    Point<3>    hanging_place;

    std::vector<NearSurfaces> near_surfaces; ///< the nearest first
  };

  /**
   * Looks at the free faces of quadrilaterals (@p dim = 2) or hexahedra. Two
   * places are the same if they are nearer than 1e-6 times the extent of the
   * mesh. @p bodies are the bodies of the @p cells.
   */
  template <int dim>
  MeshInterfaces
  find_interfaces(const MeshFile                  &file,
                  const std::vector<std::size_t>  &cells,
                  const std::vector<unsigned int> &bodies,
                  const double                     extent);

  /// "'top' (3)", "'top'" or "3".
  std::string
  in_words(const MeshGroup &group);
} // namespace stickslip

#endif
