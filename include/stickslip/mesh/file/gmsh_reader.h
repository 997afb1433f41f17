#ifndef stickslip_mesh_file_gmsh_reader_h
#define stickslip_mesh_file_gmsh_reader_h

#include <stickslip/mesh/file/mesh_file.h>
#include <stickslip/mesh/file/mesh_scanner.h>
#include <stickslip/mesh/file/point_numbers.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace stickslip
{
  /// Reads the sections of a .msh file; see read_gmsh().
  class GmshReader
  {
  public:
    explicit GmshReader(const std::string &contents)
      : scanner(contents)
    {}

    MeshFile
    read();

  private:
    // A version 4.1 file is the same sequence of numbers as text and binary.

    /// A C++ int.
    long
    small_integer(const std::string &what)
    {
      return is_binary ? scanner.binary<std::int32_t>(what)
                       : scanner.integer(what);
    }

    /// A C++ size_t in version 4, an int in version 2.
    long
    large_integer(const std::string &what)
    {
      if (!is_binary)
        return scanner.integer(what);
      const std::uint64_t value = scanner.binary<std::uint64_t>(what);
      if (value > std::uint64_t(std::numeric_limits<long>::max()))
        scanner.fail(what + " is too large");
      return value;
    }

    double
    real(const std::string &what)
    {
      if (!is_binary)
        return scanner.number(what);
      const double value = scanner.binary<double>(what);
      if (!std::isfinite(value))
        scanner.fail(what + " is not a finite number");
      return value;
    }

    std::size_t
    count(const std::string &what,
          const bool         is_small,
          const std::size_t  n_bytes)
    {
      if (!is_binary)
        return scanner.count(what);
      const long value = is_small ? small_integer(what) : large_integer(what);
      if (value < 0)
        scanner.fail(what + " is negative");
      scanner.check_count(what, value, n_bytes);
      return value;
    }

    void
    read_header();

    void
    read_physical_names();

    void
    read_entities();

    void
    read_nodes();

    void
    read_node_block();

    void
    read_elements();

    void
    read_element_block();

    void
    read_elements_of_version_2();

    void
    read_version_1();

    void
    add_node(const long number, const Point<3> &position);

    Point<3>
    read_position();

    unsigned int
    read_type(const long code);

    std::size_t
    read_element(const unsigned int type, const long number);

    void
    add_to_physical_group(const std::size_t element, const long physical);

    MeshScanner  scanner;
    MeshFile     file;
    PointNumbers numbers;
    double       version   = 0.;
    bool         is_binary = false;

    /// Physical groups of an entity, by dimension and tag.
    std::map<std::pair<long, long>, std::vector<long>>   physical_groups;
    std::map<std::pair<unsigned int, long>, std::string> names;
    bool has_nodes = false, has_elements = false;
  };
} // namespace stickslip

#endif
