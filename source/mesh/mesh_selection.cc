#include <stickslip/mesh/mesh_selection.h>

#include <stickslip/base/nearest_name.h>
#include <stickslip/base/user_error.h>
#include <stickslip/mesh/labelled_ids.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <utility>

namespace stickslip
{
  namespace
  {
    /// What to do if the cells are not of the right type.
    std::string
    advice_on_cells(const unsigned int dim)
    {
      return dim == 2
               ? "Mesh with triangles alone, or with quadrilaterals alone "
                 "(Gmsh: Mesh.RecombineAll = 1)."
               : "Mesh with tetrahedra alone, or with hexahedra alone (Gmsh: "
                 "transfinite volumes with Recombine, extrusion with Layers "
                 "and "
                 "Recombine, or Mesh.SubdivisionAlgorithm = 2).";
    }



    /// Can cells of this type be used?
    bool
    can_be_used(const MeshElementType &type)
    {
      return is_simplex(type.shape) ||
             type.shape == ElementShape::quadrilateral ||
             type.shape == ElementShape::hexahedron;
    }



    void
    check_element_types(const MeshFile                 &file,
                        const std::vector<std::size_t> &cells,
                        const unsigned int              dim,
                        const std::string              &where)
    {
      const unsigned int found = file.dimension();
      if (cells.empty() || found > dim)
        {
          const std::string words = file.elements_in_words(found);
          throw UserError(
            where + "is no mesh for a " + std::to_string(dim) + "D case: it " +
            (words.empty() ? "has no elements" : "is made of " + words) + ". " +
            (found > 1 && found != dim
               ? "For this mesh set 'Dimension = " + std::to_string(found) +
                   "'."
               : "A " + std::to_string(dim) + "D case needs " +
                   usable_cells_in_words(dim) + "."));
        }
      if (is_of_usable_cells(file, cells))
        return;
      std::map<std::string, std::size_t> usable, wrong;
      for (const std::size_t e : cells)
        ++(can_be_used(file.type(e)) ? usable : wrong)[file.type(e).plural()];
      std::string text;
      for (const auto &[name, number] : wrong.empty() ? usable : wrong)
        text +=
          (text.empty() ? "" : ", ") + std::to_string(number) + " " + name;
      throw UserError(where + "has " + text + " among " +
                      std::to_string(cells.size()) + " cells; the cells of a " +
                      "body have to be of one kind, " +
                      usable_cells_in_words(dim) + ". " + advice_on_cells(dim));
    }



    std::uint64_t
    hash_of_nodes(std::vector<unsigned int> nodes)
    {
      std::sort(nodes.begin(), nodes.end());
      std::uint64_t hash = 14695981039346656037ULL;
      for (const unsigned int node : nodes)
        hash = (hash ^ (node + 0x9E3779B97F4A7C15ULL)) * 1099511628211ULL;
      return hash;
    }



    /// Files of Gmsh's version 2 have an element once for each of its groups.
    /// Returns the cells without repetitions, and the groups of each.
    std::vector<SelectedCell>
    without_repetitions(const MeshFile                 &file,
                        const std::vector<std::size_t> &cells)
    {
      std::vector<std::pair<std::uint64_t, std::size_t>> hashes;
      for (const std::size_t e : cells)
        {
          const auto nodes = file.nodes(e);
          hashes.emplace_back(hash_of_nodes({nodes.begin(), nodes.end()}), e);
        }
      std::sort(hashes.begin(), hashes.end());

      std::vector<SelectedCell> result;
      for (std::size_t i = 0; i < hashes.size(); ++i)
        {
          const auto &groups = file.groups_of(hashes[i].second);
          if (i == 0 || hashes[i].first != hashes[i - 1].first)
            {
              result.push_back({hashes[i].second, groups});
              continue;
            }
          std::vector<unsigned int> &all = result.back().groups;
          all.insert(all.end(), groups.begin(), groups.end());
          std::sort(all.begin(), all.end());
          all.erase(std::unique(all.begin(), all.end()), all.end());
        }
      std::sort(result.begin(),
                result.end(),
                [](const SelectedCell &a, const SelectedCell &b) {
                  return a.element < b.element;
                });
      return result;
    }
  } // namespace



  std::string
  usable_cells_in_words(const unsigned int dim)
  {
    return dim == 2 ? "triangles or quadrilaterals" : "tetrahedra or hexahedra";
  }



  bool
  is_of_usable_cells(const MeshFile                 &file,
                     const std::vector<std::size_t> &cells)
  {
    return std::all_of(cells.begin(), cells.end(), [&](const std::size_t e) {
      return can_be_used(file.type(e)) &&
             file.type(e).shape == file.type(cells.front()).shape;
    });
  }



  std::vector<std::size_t>
  elements_of_groups(const MeshFile                 &file,
                     const std::vector<std::string> &groups,
                     const unsigned int              dim,
                     const std::string              &path)
  {
    // The groups as labels of ids: each group is its own id.
    LabelledIds            labels;
    std::set<unsigned int> present;
    for (const MeshGroup &group : file.groups)
      if (group.dimension == dim)
        present.insert(labels.id_of({GroupLabel{group.number, group.name}}));
    std::set<unsigned int> wanted;
    for (const std::string &label : groups)
      {
        std::set<unsigned int> ids = labels.ids(label);
        if (ids.empty() || present.count(*ids.begin()) == 0)
          throw UserError(path + "/Mesh group: the mesh file has no group '" +
                          label + "' of " + std::to_string(dim) + "D cells." +
                          did_you_mean(label, labels.names(present)) +
                          " Groups of cells: " + labels.in_words(present) +
                          ".");
        wanted.merge(ids);
      }

    LabelledIds       again; // gives the same ids in the same order
    std::vector<bool> is_wanted(file.groups.size(), false);
    for (unsigned int g = 0; g < file.groups.size(); ++g)
      if (file.groups[g].dimension == dim)
        is_wanted[g] =
          wanted.count(again.id_of(
            {GroupLabel{file.groups[g].number, file.groups[g].name}})) > 0;

    std::vector<std::size_t> elements;
    for (std::size_t e = 0; e < file.n_elements(); ++e)
      if (file.dimension(e) == dim)
        {
          const auto &own = file.groups_of(e);
          if (groups.empty() ||
              std::any_of(own.begin(), own.end(), [&](const unsigned int g) {
                return is_wanted[g];
              }))
            elements.push_back(e);
        }
    return elements;
  }



  std::vector<SelectedCell>
  select_cells(const MeshFile                 &file,
               const std::vector<std::string> &groups,
               const unsigned int              dim,
               const std::string              &where,
               const std::string              &path)
  {
    const std::vector<std::size_t> cells =
      elements_of_groups(file, groups, dim, path);
    check_element_types(file, cells, dim, where);
    return without_repetitions(file, cells);
  }
} // namespace stickslip
