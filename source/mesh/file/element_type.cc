#include <stickslip/mesh/file/element_type.h>

#include <map>
#include <numeric>

namespace stickslip
{
  unsigned int
  dimension_of(const ElementShape shape)
  {
    constexpr std::array<unsigned int, 8> dimensions = {
      {0, 1, 2, 2, 3, 3, 3, 3}};
    return dimensions[static_cast<unsigned int>(shape)];
  }



  unsigned int
  n_vertices_of(const ElementShape shape)
  {
    constexpr std::array<unsigned int, 8> numbers = {{1, 2, 3, 4, 4, 8, 6, 5}};
    return numbers[static_cast<unsigned int>(shape)];
  }



  bool
  is_simplex(const ElementShape shape)
  {
    return shape == ElementShape::triangle ||
           shape == ElementShape::tetrahedron;
  }



  std::string
  MeshElementType::plural() const
  {
    static const std::array<std::string, 8> names = {{"points",
                                                      "lines",
                                                      "triangles",
                                                      "quadrilaterals",
                                                      "tetrahedra",
                                                      "hexahedra",
                                                      "wedges",
                                                      "pyramids"}};
    return (n_nodes == 1 ? "" : std::to_string(n_nodes) + "-node ") +
           names[static_cast<unsigned int>(shape)];
  }



  const std::vector<MeshElementType> &
  element_types()
  {
    using Shape                                     = ElementShape;
    static const std::vector<MeshElementType> types = {
      {Shape::point, 1, 15, 1},
      {Shape::line, 2, 1, 3},
      {Shape::line, 3, 8, 21},
      {Shape::triangle, 3, 2, 5},
      {Shape::triangle, 6, 9, 22},
      {Shape::quadrilateral, 4, 3, 9},
      {Shape::quadrilateral, 8, 16, 23},
      {Shape::quadrilateral, 9, 10, 28},
      {Shape::tetrahedron, 4, 4, 10},
      {Shape::tetrahedron, 10, 11, 24},
      {Shape::hexahedron, 8, 5, 12},
      {Shape::hexahedron, 20, 17, 25},
      {Shape::hexahedron, 27, 12, 29},
      {Shape::wedge, 6, 6, 13},
      {Shape::wedge, 15, 18, 26},
      {Shape::wedge, 18, 13, 32},
      {Shape::pyramid, 5, 7, 14},
      {Shape::pyramid, 13, 19, 27},
      {Shape::pyramid, 14, 14, 37}};
    return types;
  }



  namespace
  {
    template <typename Predicate>
    int
    find_element_type(const Predicate &is_wanted)
    {
      const std::vector<MeshElementType> &types = element_types();
      for (unsigned int t = 0; t < types.size(); ++t)
        if (is_wanted(types[t]))
          return t;
      return -1;
    }
  } // namespace



  int
  element_type_of_gmsh(const long code)
  {
    return find_element_type(
      [code](const MeshElementType &type) { return type.gmsh_code == code; });
  }



  int
  element_type_of_vtk(const long code)
  {
    return find_element_type(
      [code](const MeshElementType &type) { return type.vtk_code == code; });
  }



  int
  element_type_of(const ElementShape shape, const unsigned int n_nodes)
  {
    return find_element_type([&](const MeshElementType &type) {
      return type.shape == shape && type.n_nodes == n_nodes;
    });
  }



  const std::vector<unsigned int> &
  node_order_of_gmsh(const MeshElementType &type)
  {
    static const std::vector<unsigned int> same;
    static const std::vector<unsigned int> tetrahedron = {
      0, 1, 2, 3, 4, 5, 6, 7, 9, 8};
    static const std::vector<unsigned int> hexahedron_20 = {0,  1,  2,  3,  4,
                                                            5,  6,  7,  8,  11,
                                                            13, 9,  16, 18, 19,
                                                            17, 10, 12, 14, 15};
    static const std::vector<unsigned int> hexahedron_27 = {
      0,  1,  2,  3,  4,  5,  6,  7,  8,  11, 13, 9,  16, 18,
      19, 17, 10, 12, 14, 15, 22, 23, 21, 24, 20, 25, 26};
    if (type.shape == ElementShape::tetrahedron && type.n_nodes == 10)
      return tetrahedron;
    if (type.shape == ElementShape::hexahedron && type.n_nodes == 20)
      return hexahedron_20;
    if (type.shape == ElementShape::hexahedron && type.n_nodes == 27)
      return hexahedron_27;
    return same;
  }



  const std::vector<unsigned int> &
  node_order_of_abaqus(const MeshElementType &type)
  {
    static const std::vector<unsigned int> same;
    // C3D27: the centre, then the middles of the faces 1 to 6.
    static const std::vector<unsigned int> hexahedron_27 = {
      0,  1,  2,  3,  4,  5,  6,  7,  8,  9,  10, 11, 12, 13,
      14, 15, 16, 17, 18, 19, 26, 24, 23, 25, 21, 22, 20};
    return type.shape == ElementShape::hexahedron && type.n_nodes == 27
             ? hexahedron_27
             : same;
  }



  std::vector<unsigned int>
  nodes_in_order(const std::vector<unsigned int> &nodes,
                 const std::vector<unsigned int> &order)
  {
    if (order.empty())
      return nodes;
    std::vector<unsigned int> ordered;
    for (const unsigned int n : order)
      ordered.push_back(nodes[n]);
    return ordered;
  }



  std::vector<std::vector<unsigned int>>
  vertices_around_nodes(const MeshElementType &type)
  {
    using Middles = std::vector<std::vector<unsigned int>>;
    static const std::map<ElementShape, Middles> middles = {
      {ElementShape::triangle, {{0, 1}, {1, 2}, {2, 0}}},
      {ElementShape::quadrilateral, {{0, 1}, {1, 2}, {2, 3}, {3, 0}}},
      {ElementShape::tetrahedron,
       {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}},
      {ElementShape::hexahedron,
       {{0, 1},
        {1, 2},
        {2, 3},
        {3, 0},
        {4, 5},
        {5, 6},
        {6, 7},
        {7, 4},
        {0, 4},
        {1, 5},
        {2, 6},
        {3, 7},
        {0, 3, 4, 7},
        {1, 2, 5, 6},
        {0, 1, 4, 5},
        {2, 3, 6, 7},
        {0, 1, 2, 3},
        {4, 5, 6, 7}}}};

    Middles            around;
    const unsigned int n_vertices = n_vertices_of(type.shape);
    for (unsigned int v = 0; v < n_vertices; ++v)
      around.push_back({v});
    const Middles &all = middles.at(type.shape);
    for (unsigned int m = 0; m < all.size() && around.size() < type.n_nodes;
         ++m)
      around.push_back(all[m]);
    if (around.size() < type.n_nodes) // the centre
      {
        around.emplace_back(n_vertices);
        std::iota(around.back().begin(), around.back().end(), 0U);
      }
    return around;
  }



  const std::vector<std::vector<unsigned int>> &
  sides_of(const ElementShape shape)
  {
    using Sides = std::vector<std::vector<unsigned int>>;
    static const std::map<ElementShape, Sides> sides = {
      {ElementShape::triangle, {{0, 1}, {1, 2}, {2, 0}}},
      {ElementShape::quadrilateral, {{0, 1}, {1, 2}, {2, 3}, {3, 0}}},
      {ElementShape::tetrahedron, {{0, 1, 2}, {0, 1, 3}, {1, 2, 3}, {0, 2, 3}}},
      {ElementShape::hexahedron,
       {{0, 1, 2, 3},
        {4, 5, 6, 7},
        {0, 1, 5, 4},
        {1, 2, 6, 5},
        {2, 3, 7, 6},
        {3, 0, 4, 7}}},
      {ElementShape::wedge,
       {{0, 1, 2}, {3, 4, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}}},
      {ElementShape::pyramid,
       {{0, 1, 2, 3}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}}};
    static const Sides none;
    const auto         found = sides.find(shape);
    return found == sides.end() ? none : found->second;
  }
} // namespace stickslip
