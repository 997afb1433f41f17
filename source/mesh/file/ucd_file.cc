#include <stickslip/mesh/file/ucd_file.h>

#include <stickslip/mesh/file/mesh_scanner.h>
#include <stickslip/mesh/file/point_numbers.h>

#include <map>
#include <string>
#include <vector>

namespace stickslip
{
  namespace
  {
    void
    read_ucd_cell(MeshScanner        &scanner,
                  const PointNumbers &numbers,
                  MeshFile           &file)
    {
      static const std::map<std::string, ElementShape> shapes = {
        {"pt", ElementShape::point},
        {"line", ElementShape::line},
        {"tri", ElementShape::triangle},
        {"quad", ElementShape::quadrilateral},
        {"tet", ElementShape::tetrahedron},
        {"hex", ElementShape::hexahedron},
        {"prism", ElementShape::wedge},
        {"pyr", ElementShape::pyramid}};
      const long        number   = scanner.integer("the number of a cell");
      const long        material = scanner.integer("a material id");
      const std::string name(scanner.word("a type of cell"));
      const auto        shape = shapes.find(name);
      if (shape == shapes.end())
        scanner.fail("cell " + std::to_string(number) + " is of the type " +
                     quoted_word(name) +
                     "; pt, line, tri, quad, tet, hex, prism or pyr is "
                     "expected");
      if (material < 0 || material > MeshFile::largest_number)
        scanner.fail("the material id " + std::to_string(material) +
                     " is out of range: 0 to 999999999 is possible");

      std::vector<unsigned int> nodes(n_vertices_of(shape->second));
      for (unsigned int &node : nodes)
        {
          const long vertex = scanner.integer("a vertex of a cell");
          if (!numbers.find(vertex, node))
            scanner.fail("cell " + std::to_string(number) +
                         " refers to vertex " + std::to_string(vertex) +
                         ", which is not there");
        }
      const std::size_t element =
        file.add_element(element_type_of(shape->second, nodes.size()), nodes);
      file.add_to_group(element,
                        file.group(dimension_of(shape->second), material));
    }
  } // namespace



  MeshFile
  read_ucd(const std::string &contents)
  {
    const std::string text = plain_text(contents);
    MeshScanner       scanner(text);
    MeshScanner       further = scanner;
    while (further.word("the number of vertices")[0] == '#')
      {
        scanner.is_at_end();
        scanner.rest_of_line();
        further = scanner;
      }
    const std::size_t n_vertices = scanner.count("the number of vertices");
    const std::size_t n_cells    = scanner.count("the number of cells");
    scanner.rest_of_line();

    MeshFile     file;
    PointNumbers numbers;
    for (std::size_t v = 0; v < n_vertices; ++v)
      {
        const long number = scanner.integer("the number of a vertex");
        Point<3>   point;
        for (unsigned int d = 0; d < 3; ++d)
          point[d] = scanner.number("a coordinate of a vertex");
        if (!numbers.add(number, file.points.size()))
          scanner.fail("there are two vertices " + std::to_string(number));
        file.points.push_back(point);
      }
    for (std::size_t c = 0; c < n_cells; ++c)
      read_ucd_cell(scanner, numbers, file);
    return file;
  }
} // namespace stickslip
