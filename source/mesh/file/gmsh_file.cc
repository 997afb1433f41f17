#include <stickslip/mesh/file/gmsh_file.h>

#include <stickslip/base/text_encoding.h>
#include <stickslip/mesh/file/gmsh_reader.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace stickslip
{
  void
  GmshReader::read_header()
  {
    version         = scanner.number("the version");
    const long type = scanner.integer("the file type");
    const long size = scanner.integer("the size of numbers");
    scanner.rest_of_line();
    const std::vector<double> known    = {2., 2.1, 2.2, 4., 4.1};
    bool                      is_known = false;
    for (const double v : known)
      is_known = is_known || std::abs(version - v) < 1e-6;
    if (!is_known)
      scanner.fail("version " + std::to_string(version).substr(0, 3) +
                   " of the Gmsh format is not known; known are 1, 2.0 to "
                   "2.2, 4.0 and 4.1");
    if (type != 0 && type != 1)
      scanner.fail("the file type is " + std::to_string(type) +
                   "; 0 (text) or 1 (binary) is expected");
    is_binary = (type == 1);
    if (!is_binary)
      return;
    if (std::abs(version - 4.) < 1e-6)
      scanner.fail(
        "binary files of version 4.0 are not read. Save it as "
        "version 4.1 or as text");
    if (size != 8)
      scanner.fail("numbers have " + std::to_string(size) +
                   " bytes; 8 are expected");
    if (scanner.binary<std::int32_t>("the mark of the byte order") != 1)
      scanner.fail(
        "it was written with another byte order. Save it as text "
        "(in Gmsh: Mesh.Binary = 0)");
  }



  void
  GmshReader::read_physical_names()
  {
    const std::size_t n = scanner.count("the number of physical names");
    for (std::size_t i = 0; i < n; ++i)
      {
        const long dimension =
          scanner.integer("the dimension of a physical group");
        const long number = scanner.integer("the number of a physical group");
        const std::string_view rest  = scanner.rest_of_line();
        const auto             first = rest.find('"');
        const auto             last  = rest.rfind('"');
        if (first == std::string_view::npos || last <= first)
          scanner.fail(
            "the name of a physical group has to be in quotation "
            "marks");
        if (dimension < 0 || dimension > 3)
          scanner.fail("a physical group has the dimension " +
                       std::to_string(dimension) + "; 0 to 3 is possible");
        std::string name(rest.substr(first + 1, last - first - 1));
        if (!is_utf8(name))
          name = utf8_of_latin1(name);
        names[{dimension, std::abs(number)}] = name;
      }
  }



  void
  GmshReader::read_entities()
  {
    std::size_t n_entities[4];
    for (std::size_t &n : n_entities)
      n = count("the number of entities", false, 8);
    for (long dim = 0; dim < 4; ++dim)
      for (std::size_t e = 0; e < n_entities[dim]; ++e)
        {
          const long   tag           = small_integer("the tag of an entity");
          const double n_coordinates = (dim == 0 && version > 4.05) ? 3 : 6;
          for (unsigned int i = 0; i < n_coordinates; ++i)
            real("a coordinate of an entity");
          const std::size_t n =
            count("the number of physical groups", false, 4);
          for (std::size_t i = 0; i < n; ++i)
            physical_groups[{dim, tag}].push_back(
              small_integer("a physical group"));
          if (dim == 0)
            continue;
          const std::size_t n_bounding =
            count("the number of bounding entities", false, 4);
          for (std::size_t i = 0; i < n_bounding; ++i)
            small_integer("a bounding entity");
        }
  }



  void
  GmshReader::add_node(const long number, const Point<3> &position)
  {
    if (!numbers.add(number, file.points.size()))
      scanner.fail("there are two nodes " + std::to_string(number));
    file.points.push_back(position);
  }



  Point<3>
  GmshReader::read_position()
  {
    Point<3> position;
    for (unsigned int d = 0; d < 3; ++d)
      position[d] = real("a coordinate of a node");
    return position;
  }



  void
  GmshReader::read_nodes()
  {
    has_nodes = true;
    if (version < 3.)
      {
        const std::size_t n = scanner.count("the number of nodes");
        scanner.rest_of_line();
        scanner.check_count("the number of nodes", n, is_binary ? 28 : 8);
        for (std::size_t i = 0; i < n; ++i)
          {
            const long number = small_integer("the number of a node");
            add_node(number, read_position());
          }
        return;
      }
    const std::size_t n_blocks = count("the number of blocks", false, 4);
    count("the number of nodes", false, 8);
    if (version > 4.05)
      for (unsigned int i = 0; i < 2; ++i)
        large_integer("the range of node numbers");
    for (std::size_t b = 0; b < n_blocks; ++b)
      read_node_block();
  }



  void
  GmshReader::read_node_block()
  {
    long dimension = small_integer("the dimension of a block");
    long tag       = small_integer("the tag of a block");
    if (version < 4.05)
      std::swap(dimension, tag);
    const long is_parametric = small_integer("0 or 1 (parametric)");
    if (dimension < 0 || dimension > 3)
      scanner.fail("a block of nodes has the dimension " +
                   std::to_string(dimension) + "; 0 to 3 is possible");
    const std::size_t n               = count("the number of nodes", false, 8);
    const auto        skip_parameters = [&]() {
      for (long d = 0; is_parametric == 1 && d < dimension; ++d)
        real("a parametric coordinate of a node");
    };

    if (version < 4.05)
      {
        for (std::size_t i = 0; i < n; ++i)
          {
            const long number = large_integer("the number of a node");
            add_node(number, read_position());
            skip_parameters();
          }
        return;
      }
    std::vector<long> tags(n);
    for (long &node : tags)
      node = large_integer("the number of a node");
    for (const long node : tags)
      {
        add_node(node, read_position());
        skip_parameters();
      }
  }



  MeshFile
  GmshReader::read()
  {
    const std::string_view first = scanner.word("$MeshFormat");
    if (first == "$NOD")
      {
        read_version_1();
        return std::move(file);
      }
    if (first != "$MeshFormat")
      scanner.fail("found " + quoted_word(first) +
                   " where $MeshFormat is expected");
    read_header();
    scanner.expect("$EndMeshFormat");

    while (!scanner.is_at_end())
      {
        const std::string section(scanner.word("a section"));
        if (section.empty() || section[0] != '$' || section.size() > 100)
          scanner.fail("found " + quoted_word(section) +
                       " where a section ($Nodes, $Elements, ...) is "
                       "expected");
        // Text is read by words; binary numbers begin after the line.
        if (is_binary)
          scanner.rest_of_line();
        const std::string end = "$End" + section.substr(1);
        if (section == "$PhysicalNames")
          read_physical_names();
        else if (section == "$Entities")
          read_entities();
        else if (section == "$Nodes")
          read_nodes();
        else if (section == "$Elements")
          read_elements();
        else if (section == "$PartitionedEntities")
          scanner.fail("the mesh is partitioned. Save it without partitions");
        else if (scanner.skip_behind(end))
          continue;
        else
          scanner.fail("the section " + section + " has no " + end);
        scanner.expect(end);
      }
    if (!has_nodes || !has_elements)
      throw MeshFileError(std::string("it has no section ") +
                          (has_nodes ? "$Elements" : "$Nodes") +
                          ": it is incomplete");
    return std::move(file);
  }



  MeshFile
  read_gmsh(const std::string &contents)
  {
    // Only text may be cleaned; the header tells.
    MeshScanner header(contents);
    bool        is_binary = false;
    if (contents.compare(0, 11, "$MeshFormat") == 0)
      {
        header.word("");
        header.word("the version");
        is_binary = header.word("the file type") == "1";
      }
    if (is_binary)
      return GmshReader(contents).read();
    const std::string text = plain_text(contents);
    return GmshReader(text).read();
  }
} // namespace stickslip
