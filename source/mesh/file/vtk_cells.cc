#include <stickslip/mesh/file/vtk_cells.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <set>
#include <utility>

namespace stickslip
{
  namespace
  {
    constexpr int vtk_pixel = 8, vtk_voxel = 11;



    /// Pixels and voxels are quadrilaterals and hexahedra with another order.
    int
    ordinary_vtk_type(const int type, std::vector<unsigned int> &nodes)
    {
      if ((type == vtk_pixel && nodes.size() == 4) ||
          (type == vtk_voxel && nodes.size() == 8))
        {
          for (unsigned int first = 0; first < nodes.size(); first += 4)
            std::swap(nodes[first + 2], nodes[first + 3]);
          return type == vtk_pixel ? 9 : 12;
        }
      return type;
    }



    std::string
    cell_in_words(const std::size_t cell)
    {
      return "cell " + std::to_string(cell) + " (from 0)";
    }
  } // namespace



  bool
  is_vtk_id_array(const std::string &name)
  {
    static const std::set<std::string> names = {"materialid",
                                                "materialids",
                                                "material_id",
                                                "material",
                                                "gmsh:physical",
                                                "medit:ref",
                                                "cellentityids",
                                                "cell_tags"};
    std::string                        lower = name;
    std::transform(lower.begin(),
                   lower.end(),
                   lower.begin(),
                   [](const unsigned char c) { return std::tolower(c); });
    return names.count(lower) > 0;
  }



  MeshFile
  VtkGrid::mesh_file() const
  {
    if (coordinates.empty() || types.empty())
      throw MeshFileError(std::string("it has no ") +
                          (coordinates.empty() ? "points" : "cells"));
    if (coordinates.size() % 3 != 0)
      throw MeshFileError("the number of coordinates is not three per point");
    if (offsets.size() != types.size())
      throw MeshFileError("it has " + std::to_string(types.size()) +
                          " types of cells, but the points of " +
                          std::to_string(offsets.size()) + " cells");
    if (!ids.empty() && ids.size() != types.size())
      throw MeshFileError("it has " + std::to_string(types.size()) +
                          " cells, but " + std::to_string(ids.size()) +
                          " material ids");

    MeshFile file;
    for (std::size_t i = 0; i < coordinates.size(); i += 3)
      file.points.emplace_back(coordinates[i],
                               coordinates[i + 1],
                               coordinates[i + 2]);
    std::size_t               first = 0;
    std::vector<unsigned int> nodes;
    for (std::size_t c = 0; c < types.size(); ++c)
      {
        if (!(offsets[c] >= first && offsets[c] <= connectivity.size()))
          throw MeshFileError("the points of " + cell_in_words(c) +
                              " are not where the offsets say");
        nodes.clear();
        for (std::size_t i = first; i < offsets[c]; ++i)
          {
            if (!(connectivity[i] >= 0. &&
                  connectivity[i] < file.points.size()))
              throw MeshFileError(cell_in_words(c) +
                                  " refers to a point that is not there");
            nodes.push_back(static_cast<unsigned int>(connectivity[i]));
          }
        first          = static_cast<std::size_t>(offsets[c]);
        const int vtk  = std::abs(types[c]) < 1e6 ? int(types[c]) : -1;
        const int type = element_type_of_vtk(ordinary_vtk_type(vtk, nodes));
        if (type < 0)
          {
            ++file.unknown_types["VTK's type " + std::to_string(vtk)];
            continue;
          }
        if (nodes.size() != element_types()[type].n_nodes)
          throw MeshFileError(cell_in_words(c) + " has the type " +
                              std::to_string(vtk) + " (" +
                              element_types()[type].plural() + ") and " +
                              std::to_string(nodes.size()) + " points");
        const std::size_t element = file.add_element(type, nodes);
        if (!ids.empty() && std::abs(ids[c]) <= MeshFile::largest_number)
          file.add_to_group(element,
                            file.group(file.dimension(element),
                                       std::abs(static_cast<int>(ids[c]))));
      }
    return file;
  }
} // namespace stickslip
