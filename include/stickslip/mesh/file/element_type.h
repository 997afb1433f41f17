#ifndef stickslip_mesh_file_element_type_h
#define stickslip_mesh_file_element_type_h

#include <array>
#include <string>
#include <vector>

namespace stickslip
{
  enum class ElementShape
  {
    point,
    line,
    triangle,
    quadrilateral,
    tetrahedron,
    hexahedron,
    wedge,
    pyramid
  };

  /// The dimension of @p shape, 0 to 3.
  unsigned int
  dimension_of(const ElementShape shape);

  /// The number of vertices of @p shape, without nodes on edges.
  unsigned int
  n_vertices_of(const ElementShape shape);

  /// True for triangles and tetrahedra.
  bool
  is_simplex(const ElementShape shape);

  /// A shape with a number of nodes, and what formats call it. The first nodes
  /// are the vertices, in the order that Gmsh, Abaqus and VTK have in common.
  struct MeshElementType
  {
    ElementShape shape;
    unsigned int n_nodes;
    int          gmsh_code;
    int          vtk_code;

    /// First order: nodes at the vertices only.
    bool
    is_linear() const
    {
      return n_nodes == n_vertices_of(shape);
    }

    /// "8-node hexahedra".
    std::string
    plural() const;
  };

  /// All types that the readers know. Indices into it are element types.
  const std::vector<MeshElementType> &
  element_types();

  /// Index of the type, or -1.
  int
  element_type_of_gmsh(const long code);

  /// Index of the type, or -1.
  int
  element_type_of_vtk(const long code);

  /// Index of the type, or -1.
  int
  element_type_of(const ElementShape shape, const unsigned int n_nodes);

  /// Vertices of the sides of @p shape, side 1 first, in Abaqus' numbering
  /// (S1, S2, ...). Empty for lines and points.
  const std::vector<std::vector<unsigned int>> &
  sides_of(const ElementShape shape);
} // namespace stickslip

#endif
