#include <stickslip/mesh/file/abaqus_elements.h>

#include <stickslip/mesh/file/element_type.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace stickslip
{
  int
  element_type_of_abaqus(const std::string &name)
  {
    const auto begins = [&](const std::string &start) {
      return name.compare(0, start.size(), start) == 0;
    };
    const auto type = [&](const ElementShape shape, const unsigned int n) {
      return element_type_of(shape, n);
    };
    if (begins("T2D") || begins("T3D") || begins("R2D2") || begins("RAX2"))
      return type(ElementShape::line, name.find("D3") == 3 - 1 ? 3 : 2);
    if (begins("B21") || begins("B31") || begins("B23") || begins("B33"))
      return type(ElementShape::line, 2);
    if (begins("B22") || begins("B32"))
      return type(ElementShape::line, 3);
    if (begins("STRI3"))
      return type(ElementShape::triangle, 3);
    if (begins("STRI65"))
      return type(ElementShape::triangle, 6);

    // The number of nodes follows the name of the family.
    static const std::vector<std::pair<std::string, unsigned int>> families = {
      {"DC3D", 3},
      {"AC3D", 3},
      {"C3D", 3},
      {"CSS", 3},
      {"SC", 3},
      {"DC2D", 2},
      {"AC2D", 2},
      {"CPEG", 2},
      {"CPE", 2},
      {"CPS", 2},
      {"CGAX", 2},
      {"CAX", 2},
      {"DS", 2},
      {"SFM3D", 2},
      {"M3D", 2},
      {"R3D", 2},
      {"WARP2D", 2},
      {"S", 2}};
    static const std::map<unsigned int, ElementShape> shapes_2d = {
      {3, ElementShape::triangle},
      {4, ElementShape::quadrilateral},
      {6, ElementShape::triangle},
      {8, ElementShape::quadrilateral},
      {9, ElementShape::quadrilateral}};
    static const std::map<unsigned int, ElementShape> shapes_3d = {
      {4, ElementShape::tetrahedron},
      {5, ElementShape::pyramid},
      {6, ElementShape::wedge},
      {8, ElementShape::hexahedron},
      {10, ElementShape::tetrahedron},
      {15, ElementShape::wedge},
      {20, ElementShape::hexahedron},
      {27, ElementShape::hexahedron}};
    for (const auto &[family, dim] : families)
      if (begins(family) && name.size() > family.size())
        {
          const std::string rest = name.substr(family.size());
          unsigned int      n    = 0;
          for (unsigned int i = 0;
               i < 2 && i < rest.size() && rest[i] >= '0' && rest[i] <= '9';
               ++i)
            // "S8R5" has 8 nodes, "C3D20R" 20.
            n = 10 * n + (rest[i] - '0');
          const auto &shapes = dim == 2 ? shapes_2d : shapes_3d;
          const auto  shape  = shapes.find(n);
          return shape == shapes.end() ? -1 : type(shape->second, n);
        }
    return -1;
  }
} // namespace stickslip
