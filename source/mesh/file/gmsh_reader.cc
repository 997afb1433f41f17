#include <stickslip/mesh/file/gmsh_reader.h>

#include <stickslip/mesh/file/element_type.h>

#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

namespace stickslip
{
  unsigned int
  GmshReader::read_type(const long code)
  {
    const int type = element_type_of_gmsh(code);
    if (type < 0 && is_binary)
      scanner.fail("elements of Gmsh's type " + std::to_string(code) +
                   " are not known. Save the mesh with elements of the first "
                   "order (Mesh.ElementOrder = 1)");
    return type < 0 ? numbers::invalid_unsigned_int : type;
  }



  std::size_t
  GmshReader::read_element(const unsigned int type, const long number)
  {
    if (type == numbers::invalid_unsigned_int)
      {
        scanner.rest_of_line();
        return 0;
      }
    std::vector<unsigned int> nodes(element_types()[type].n_nodes);
    for (unsigned int &node : nodes)
      {
        // a file that ends here says so itself
        if (!is_binary && scanner.is_at_end_of_line() && !scanner.is_at_end())
          scanner.fail("element " + std::to_string(number) + " has " +
                       std::to_string(&node - nodes.data()) + " nodes; " +
                       element_types()[type].plural() + " have " +
                       std::to_string(nodes.size()));
        const long tag = (version < 3. ? small_integer("a node of an element")
                                       : large_integer("a node of an element"));
        if (!numbers.find(tag, node))
          scanner.fail("element " + std::to_string(number) +
                       " refers to node " + std::to_string(tag) +
                       ", which is not there");
      }
    try
      {
        return file.add_element(
          type,
          nodes_in_order(nodes, node_order_of_gmsh(element_types()[type])));
      }
    catch (const MeshFileError &error)
      {
        scanner.fail("element " + std::to_string(number) + ": " + error.what());
      }
  }



  void
  GmshReader::add_to_physical_group(const std::size_t element,
                                    const long        physical)
  {
    if (physical == 0)
      return;
    const long number = std::abs(physical);
    if (number > MeshFile::largest_number)
      scanner.fail("the physical group " + std::to_string(physical) +
                   " has too large a number; 9 digits are possible");
    const unsigned int dim  = file.dimension(element);
    const auto         name = names.find({dim, number});
    file.add_to_group(element,
                      file.group(dim,
                                 number,
                                 name == names.end() ? "" : name->second));
  }



  void
  GmshReader::read_elements()
  {
    has_elements = true;
    if (!has_nodes)
      scanner.fail("$Elements comes before $Nodes");
    if (version < 3.)
      return read_elements_of_version_2();
    const std::size_t n_blocks = count("the number of blocks", false, 4);
    count("the number of elements", false, 8);
    if (version > 4.05)
      for (unsigned int i = 0; i < 2; ++i)
        large_integer("the range of element numbers");
    for (std::size_t b = 0; b < n_blocks; ++b)
      read_element_block();
  }



  void
  GmshReader::read_element_block()
  {
    long dimension = small_integer("the dimension of a block");
    long tag       = small_integer("the tag of a block");
    if (version < 4.05)
      std::swap(dimension, tag);
    const long         code   = small_integer("the type of a block");
    const std::size_t  n      = count("the number of elements", false, 8);
    const unsigned int type   = read_type(code);
    const auto         groups = physical_groups.find({dimension, tag});
    if (type == numbers::invalid_unsigned_int)
      {
        file.unknown_types["Gmsh's type " + std::to_string(code)] += n;
        scanner.rest_of_line();
      }
    else if (dimension_of(element_types()[type].shape) !=
             static_cast<unsigned long>(dimension))
      scanner.fail("a block of the dimension " + std::to_string(dimension) +
                   " has " + element_types()[type].plural());
    for (std::size_t i = 0; i < n; ++i)
      {
        const long number  = large_integer("the number of an element");
        const auto element = read_element(type, number);
        if (type != numbers::invalid_unsigned_int &&
            groups != physical_groups.end())
          for (const long physical : groups->second)
            add_to_physical_group(element, physical);
      }
  }



  void
  GmshReader::read_elements_of_version_2()
  {
    const std::size_t n = scanner.count("the number of elements");
    scanner.rest_of_line();
    scanner.check_count("the number of elements", n, is_binary ? 8 : 4);
    for (std::size_t done = 0; done < n;)
      {
        const long number =
          is_binary ? 0 : scanner.integer("the number of an element");
        const long        code = small_integer("the type of an element");
        const std::size_t n_follow =
          is_binary ? count("the number of elements", true, 8) : 1;
        const std::size_t n_tags = count("the number of tags", true, 0);
        if (n_follow == 0 || n_tags > 1000)
          scanner.fail("a block of elements has " + std::to_string(n_follow) +
                       " elements with " + std::to_string(n_tags) + " tags");
        const unsigned int type = read_type(code);
        for (std::size_t i = 0; i < n_follow; ++i)
          {
            const long own_number =
              is_binary ? small_integer("the number of an element") : number;
            long physical = 0;
            for (std::size_t t = 0; t < n_tags; ++t)
              {
                const long tag = small_integer("a tag of an element");
                if (t == 0)
                  physical = tag;
              }
            const std::size_t element = read_element(type, own_number);
            if (type == numbers::invalid_unsigned_int)
              ++file.unknown_types["Gmsh's type " + std::to_string(code)];
            else
              add_to_physical_group(element, physical);
          }
        done += n_follow;
      }
  }



  void
  GmshReader::read_version_1()
  {
    version                   = 1.;
    const std::size_t n_nodes = scanner.count("the number of nodes");
    for (std::size_t i = 0; i < n_nodes; ++i)
      {
        const long number = scanner.integer("the number of a node");
        add_node(number, read_position());
      }
    scanner.expect("$ENDNOD");
    scanner.expect("$ELM");
    const std::size_t n_elements = scanner.count("the number of elements");
    for (std::size_t i = 0; i < n_elements; ++i)
      {
        const long number = scanner.integer("the number of an element");
        const long code   = scanner.integer("the type of an element");
        const long physical =
          scanner.integer("the physical group of an element");
        scanner.integer("the entity of an element");
        scanner.integer("the number of nodes of an element");
        const unsigned int type    = read_type(code);
        const std::size_t  element = read_element(type, number);
        if (type == numbers::invalid_unsigned_int)
          ++file.unknown_types["Gmsh's type " + std::to_string(code)];
        else
          add_to_physical_group(element, physical);
      }
    scanner.expect("$ENDELM");
  }
} // namespace stickslip
