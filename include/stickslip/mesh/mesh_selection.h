#ifndef stickslip_mesh_mesh_selection_h
#define stickslip_mesh_mesh_selection_h

#include <stickslip/mesh/file/mesh_file.h>

#include <string>
#include <vector>

namespace stickslip
{
  /// A cell of a mesh file that a body has.
  struct SelectedCell
  {
    std::size_t               element;
    std::vector<unsigned int> groups; ///< indices, ascending
  };

  /// The cells that bodies can be made of.
  std::string
  usable_cells_in_words(const unsigned int dim);

  /// True if @p cells are all of one such kind.
  bool
  is_of_usable_cells(const MeshFile                 &file,
                     const std::vector<std::size_t> &cells);

  /// The elements of dimension @p dim that belong to one of the @p groups
  /// (names or numbers), or all. Throws UserError blaming @p path for unknown
  /// groups.
  std::vector<std::size_t>
  elements_of_groups(const MeshFile                 &file,
                     const std::vector<std::string> &groups,
                     const unsigned int              dim,
                     const std::string              &path);

  /// The same in the order of the file, each cell once (files of Gmsh's version
  /// 2 repeat it for each of its groups). Throws UserError that begins with
  /// @p where unless is_of_usable_cells().
  std::vector<SelectedCell>
  select_cells(const MeshFile                 &file,
               const std::vector<std::string> &groups,
               const unsigned int              dim,
               const std::string              &where,
               const std::string              &path);
} // namespace stickslip

#endif
