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

  /// A shape with a number of nodes, and what formats call it. Nodes are in the
  /// order of VTK: the vertices, then the middles of edges, faces and cell.
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

  /// Which node of Gmsh's or Abaqus' list each node is; empty if their order is
  /// that of VTK.
  const std::vector<unsigned int> &
  node_order_of_gmsh(const MeshElementType &type);

  const std::vector<unsigned int> &
  node_order_of_abaqus(const MeshElementType &type);

  /// The nodes of an element in the order of VTK. @p order is one of the above.
  std::vector<unsigned int>
  nodes_in_order(const std::vector<unsigned int> &nodes,
                 const std::vector<unsigned int> &order);

  /// The vertices in whose middle each node lies if the element is straight:
  /// one for a vertex, two for the node of an edge, and so on. Only of
  /// triangles, quadrilaterals, tetrahedra and hexahedra.
  std::vector<std::vector<unsigned int>>
  vertices_around_nodes(const MeshElementType &type);

  /// Vertices of the sides of @p shape, side 1 first, in Abaqus' numbering
  /// (S1, S2, ...). Empty for lines and points.
  const std::vector<std::vector<unsigned int>> &
  sides_of(const ElementShape shape);
} // namespace stickslip

#endif
