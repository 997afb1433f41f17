#ifndef stickslip_mesh_mesh_inspection_h
#define stickslip_mesh_mesh_inspection_h

#include <stickslip/mesh/file/mesh_file.h>
#include <stickslip/mesh/mesh_interfaces.h>
#include <stickslip/mesh/second_order_nodes.h>

#include <deal.II/base/point.h>

#include <limits>
#include <string>
#include <vector>

namespace stickslip
{
  using namespace dealii;

  struct PointBox
  {
    Point<3> low = Point<3>(1., 1., 1.) * std::numeric_limits<double>::max();
    Point<3> high =
      Point<3>(-1., -1., -1.) * std::numeric_limits<double>::max();

    void
    add(const Point<3> &point);

    /// The longest side; 0 without points.
    double
    extent() const;
  };

  /// Cells that are connected by common nodes.
  struct InspectedBody
  {
    std::size_t              n_cells = 0;
    PointBox                 box;
    std::vector<std::string> groups; ///< of cells, in words
  };

  struct InspectedGroup
  {
    std::string kind; ///< "cells", "faces", "edges", "points"
    int         number = -1;
    std::string name;
    std::size_t n_elements = 0;
    PointBox    box;
  };

  /// What is known of a mesh file without a case.
  struct MeshInspection
  {
    std::string  file, format;
    unsigned int dimension = 0;
    std::size_t  n_points = 0, n_unused_points = 0;
    std::string  cells; ///< numbers and types
    PointBox     box;

    std::vector<InspectedBody>  bodies;
    std::vector<InspectedGroup> groups;

    double      shortest_edge = 0., longest_edge = 0.;
    double      worst_quality = 1.; ///< scaled Jacobian, 1 at best
    Point<3>    worst_place;        ///< centre of that cell
    std::size_t n_inverted = 0;     ///< of quality <= 0

    bool          is_of_second_order = false;
    NodeDeviation deviation;        ///< of nodes between vertices
    std::size_t   n_inside_out = 0; ///< curved cells with a bad Jacobian
    Point<3>      inside_out_place;

    MeshInterfaces interfaces;

    std::vector<std::string> warnings;
  };

  /// Reads and looks at a mesh file. Not collective. Throws UserError if it
  /// cannot be read.
  MeshInspection
  inspect_mesh(const std::string &file_name);
} // namespace stickslip

#endif
