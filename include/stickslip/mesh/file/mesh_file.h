#ifndef stickslip_mesh_file_mesh_file_h
#define stickslip_mesh_file_mesh_file_h

#include <stickslip/mesh/file/element_type.h>

#include <deal.II/base/array_view.h>
#include <deal.II/base/point.h>

#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace stickslip
{
  using namespace dealii;

  /// What is wrong with the text of a mesh file. read_mesh_file() makes a
  /// UserError of it that names the file.
  class MeshFileError : public std::runtime_error
  {
  public:
    /// @p line from 1; 0 if the error has no line.
    explicit MeshFileError(const std::string &text, const std::size_t line = 0)
      : std::runtime_error(text)
      , line(line)
    {}

    const std::size_t line;
  };



  /// Elements of one dimension that the file gives a number or a name:
  /// physical groups of Gmsh, sets and surfaces of Abaqus.
  struct MeshGroup
  {
    unsigned int dimension;
    int          number = -1; ///< -1: it has none
    std::string  name;        ///< may be empty
  };



  /**
   * The contents of a mesh file, whatever its format: points, elements of any
   * type and dimension with the groups that they belong to, and named sets of
   * points. No mesh of any body yet.
   */
  class MeshFile
  {
  public:
    /// Ids of the user have at most 9 digits.
    static constexpr int largest_number = 999999999;

    std::vector<Point<3>>  points;
    std::vector<MeshGroup> groups;

    /// Named sets of points, as indices.
    std::map<std::string, std::vector<unsigned int>> point_sets;

    /// Types that the readers do not know ("Gmsh's type 21"), and how many
    /// elements were left out for that.
    std::map<std::string, std::size_t> unknown_types;

    std::size_t
    n_elements() const
    {
      return types.size();
    }

    /// Appends an element of the type @p type (an index into element_types())
    /// with @p nodes in its order that belongs to no group, and returns its
    /// index. Throws MeshFileError if a node occurs twice.
    std::size_t
    add_element(const unsigned int               type,
                const std::vector<unsigned int> &nodes);

    /// Index of the group with this number, or name if the number is -1; a
    /// new one if there was none.
    unsigned int
    group(const unsigned int dimension,
          const int          number,
          const std::string &name = "");

    void
    add_to_group(const std::size_t element, const unsigned int group);

    const MeshElementType &
    type(const std::size_t element) const
    {
      return element_types()[types[element]];
    }

    unsigned int
    dimension(const std::size_t element) const
    {
      return dimension_of(type(element).shape);
    }

    /// All nodes, as indices of points.
    ArrayView<const unsigned int>
    nodes(const std::size_t element) const
    {
      return ArrayView<const unsigned int>(all_nodes.data() +
                                             first_nodes[element],
                                           type(element).n_nodes);
    }

    /// The nodes at its vertices: the first ones.
    std::vector<unsigned int>
    vertices(const std::size_t element) const
    {
      const auto first = nodes(element).begin();
      return {first, first + n_vertices_of(type(element).shape)};
    }

    /// Indices of the groups of an element, ascending.
    const std::vector<unsigned int> &
    groups_of(const std::size_t element) const
    {
      return group_sets[sets[element]];
    }

    /// The highest dimension of an element; 0 without elements.
    unsigned int
    dimension() const;

    /// The number of elements of each type, as "120 4-node tetrahedra, ...",
    /// those of dimension @p dim only. Types that are not known at the end.
    std::string
    elements_in_words(const unsigned int dim) const;

  private:
    unsigned int
    set_with(const unsigned int set, const unsigned int group);

    std::vector<unsigned char> types;
    std::vector<std::size_t>   first_nodes;
    std::vector<unsigned int>  all_nodes;

    /// Many elements belong to few combinations of groups: those, and each
    /// element's one.
    std::vector<std::vector<unsigned int>> group_sets = {{}};
    std::vector<unsigned int>              sets;

    std::map<std::vector<unsigned int>, unsigned int> known_sets = {{{}, 0}};
    std::map<std::pair<unsigned int, unsigned int>, unsigned int> larger_sets;
    std::map<std::pair<unsigned int, int>, unsigned int> groups_by_number;
    std::map<std::pair<unsigned int, std::string>, unsigned int> groups_by_name;
  };
} // namespace stickslip

#endif
