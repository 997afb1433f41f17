#include <stickslip/mesh/mesh_inspection.h>

#include <stickslip/base/user_error.h>
#include <stickslip/mesh/mesh_checks.h>
#include <stickslip/mesh/mesh_reader.h>
#include <stickslip/mesh/mesh_selection.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <numeric>
#include <set>
#include <sstream>
#include <utility>

namespace stickslip
{
  void
  PointBox::add(const Point<3> &point)
  {
    for (unsigned int d = 0; d < 3; ++d)
      {
        low[d]  = std::min(low[d], point[d]);
        high[d] = std::max(high[d], point[d]);
      }
  }



  double
  PointBox::extent() const
  {
    double extent = 0.;
    for (unsigned int d = 0; d < 3; ++d)
      extent = std::max(extent, high[d] - low[d]);
    return extent;
  }



  namespace
  {
    std::string
    read_whole_file(const std::string &file_name)
    {
      std::ifstream   file(file_name, std::ios::binary);
      std::error_code error;
      if (!file || std::filesystem::is_directory(file_name, error))
        throw UserError("--inspect-mesh: '" + file_name + "' cannot be read.");
      return {std::istreambuf_iterator<char>(file), {}};
    }



    MeshFile
    parse_for_inspection(const std::string &file_name, std::string &format_name)
    {
      const std::string contents = read_whole_file(file_name);
      const MeshFormat  format   = format_of_mesh_file(file_name, contents);
      if (format == MeshFormat::automatic)
        throw UserError(
          "--inspect-mesh: cannot tell the format of '" + file_name +
          "' from its extension. Known: msh, inp, vtk, vtu, ucd.");
      format_name = name_of(format, all_mesh_formats());
      try
        {
          return parse_mesh_file(contents, format);
        }
      catch (const MeshFileError &error)
        {
          throw UserError("--inspect-mesh: " + in_words(file_name, error));
        }
    }



    /// Numbers the cells' bodies: cells with a common node are of one body.
    std::vector<unsigned int>
    connected_bodies(const MeshFile                 &file,
                     const std::vector<std::size_t> &cells)
    {
      std::vector<unsigned int> parent(file.points.size());
      std::iota(parent.begin(), parent.end(), 0);
      const auto root_of = [&](unsigned int p) {
        while (parent[p] != p)
          p = parent[p] = parent[parent[p]];
        return p;
      };
      for (const std::size_t cell : cells)
        for (const unsigned int node : file.nodes(cell))
          parent[root_of(node)] = root_of(file.nodes(cell)[0]);

      std::map<unsigned int, unsigned int> numbers;
      std::vector<unsigned int>            bodies;
      for (const std::size_t cell : cells)
        bodies.push_back(
          numbers.insert({root_of(file.nodes(cell)[0]), numbers.size()})
            .first->second);
      return bodies;
    }



    /// Neighbours of each vertex, such that edges to them have a positive
    /// triple product (in 2D cross product) in a cell that is not inverted.
    const std::vector<std::vector<unsigned int>> &
    edges_at_vertices(const ElementShape shape)
    {
      using Edges = std::vector<std::vector<unsigned int>>;
      static const std::map<ElementShape, Edges> edges = {
        {ElementShape::triangle, {{1, 2}, {2, 0}, {0, 1}}},
        {ElementShape::quadrilateral, {{1, 3}, {2, 0}, {3, 1}, {0, 2}}},
        {ElementShape::tetrahedron,
         {{1, 2, 3}, {2, 0, 3}, {0, 1, 3}, {2, 1, 0}}},
        {ElementShape::hexahedron,
         {{1, 3, 4},
          {2, 0, 5},
          {3, 1, 6},
          {0, 2, 7},
          {7, 5, 0},
          {4, 6, 1},
          {5, 7, 2},
          {6, 4, 3}}},
        {ElementShape::wedge,
         {{1, 2, 3}, {2, 0, 4}, {0, 1, 5}, {5, 4, 0}, {3, 5, 1}, {4, 3, 2}}},
        // without its tip, where four edges meet
        {ElementShape::pyramid, {{1, 3, 4}, {2, 0, 4}, {3, 1, 4}, {0, 2, 4}}}};
      static const Edges none;
      const auto         found = edges.find(shape);
      return found == edges.end() ? none : found->second;
    }



    /// The smallest determinant of unit vectors along the edges of a vertex;
    /// in 2D without regard to the orientation.
    double
    scaled_jacobian(const MeshFile   &file,
                    const std::size_t cell,
                    MeshInspection   &inspection)
    {
      const auto  nodes    = file.nodes(cell);
      double      smallest = 1., largest = -1.;
      const auto &edges = edges_at_vertices(file.type(cell).shape);
      for (unsigned int v = 0; v < edges.size(); ++v)
        {
          std::array<Tensor<1, 3>, 3> e;
          for (unsigned int k = 0; k < edges[v].size(); ++k)
            {
              e[k] = file.points[nodes[edges[v][k]]] - file.points[nodes[v]];
              const double length = e[k].norm();
              inspection.shortest_edge =
                std::min(inspection.shortest_edge, length);
              inspection.longest_edge =
                std::max(inspection.longest_edge, length);
              e[k] /= std::max(length, 1e-300);
            }
          const double jacobian = edges[v].size() == 2
                                    ? cross_product_3d(e[0], e[1])[2]
                                    : cross_product_3d(e[0], e[1]) * e[2];
          smallest              = std::min(smallest, jacobian);
          largest               = std::max(largest, jacobian);
        }
      // A cell with the other orientation is no bad one: readers turn it.
      return largest <= 0. ? -largest : smallest;
    }



    void
    look_at_cells(const MeshFile                  &file,
                  const std::vector<std::size_t>  &cells,
                  const std::vector<unsigned int> &bodies,
                  MeshInspection                  &inspection)
    {
      inspection.shortest_edge = std::numeric_limits<double>::max();
      std::vector<bool>                   is_used(file.points.size(), false);
      std::vector<std::set<unsigned int>> groups;
      for (std::size_t c = 0; c < cells.size(); ++c)
        {
          if (bodies[c] >= inspection.bodies.size())
            {
              inspection.bodies.resize(bodies[c] + 1);
              groups.resize(bodies[c] + 1);
            }
          InspectedBody &body = inspection.bodies[bodies[c]];
          ++body.n_cells;
          groups[bodies[c]].insert(file.groups_of(cells[c]).begin(),
                                   file.groups_of(cells[c]).end());
          Point<3> centre;
          for (const unsigned int node : file.nodes(cells[c]))
            {
              is_used[node] = true;
              body.box.add(file.points[node]);
              centre += file.points[node] / (1. * file.nodes(cells[c]).size());
            }
          const double quality = scaled_jacobian(file, cells[c], inspection);
          inspection.n_inverted += quality <= 0.;
          if (quality < inspection.worst_quality)
            {
              inspection.worst_quality = quality;
              inspection.worst_place   = centre;
            }
        }
      for (const InspectedBody &body : inspection.bodies)
        {
          inspection.box.add(body.box.low);
          inspection.box.add(body.box.high);
        }
      for (unsigned int b = 0; b < groups.size(); ++b)
        for (const unsigned int g : groups[b])
          inspection.bodies[b].groups.push_back(in_words(file.groups[g]));
      inspection.n_unused_points =
        std::count(is_used.begin(), is_used.end(), false);
    }



    template <int dim>
    void
    look_at_curved_cells(const MeshFile                 &file,
                         const std::vector<std::size_t> &cells,
                         MeshInspection                 &inspection)
    {
      const auto curved =
        curved_cells<dim>(file, cells, "--inspect-mesh: the mesh ");
      if (!curved)
        return;
      const CellsInsideOut<dim> bad = cells_inside_out(*curved);
      inspection.n_inside_out       = bad.n_cells;
      for (unsigned int d = 0; d < dim; ++d)
        inspection.inside_out_place[d] = bad.place[d];
    }



    void
    look_at_groups(const MeshFile &file, MeshInspection &inspection)
    {
      const unsigned int dim = inspection.dimension;
      for (const MeshGroup &group : file.groups)
        inspection.groups.push_back({group.dimension == dim       ? "cells"
                                     : group.dimension + 1 == dim ? "faces"
                                     : group.dimension == 0       ? "points"
                                                                  : "edges",
                                     group.number,
                                     group.name,
                                     0,
                                     PointBox()});
      for (std::size_t e = 0; e < file.n_elements(); ++e)
        for (const unsigned int g : file.groups_of(e))
          {
            ++inspection.groups[g].n_elements;
            for (const unsigned int node : file.nodes(e))
              inspection.groups[g].box.add(file.points[node]);
          }
      for (const auto &[name, points] : file.point_sets)
        {
          inspection.groups.push_back(
            {"points", -1, name, points.size(), PointBox()});
          for (const unsigned int point : points)
            inspection.groups.back().box.add(file.points[point]);
        }
    }



    void
    add_warnings(const MeshFile &file, MeshInspection &inspection)
    {
      const auto warn = [&](const std::string &text) {
        inspection.warnings.push_back(text);
      };
      const auto place = [](const Point<3> &x) {
        std::ostringstream text;
        text << "(" << x[0] << ", " << x[1] << ", " << x[2] << ")";
        return text.str();
      };
      if (inspection.n_inverted > 0)
        warn(std::to_string(inspection.n_inverted) +
             " cells are inverted or degenerate");
      else if (inspection.worst_quality < 0.2)
        warn("badly shaped cells: scaled Jacobian below 0.2");
      if (inspection.n_inside_out > 0)
        warn(std::to_string(inspection.n_inside_out) +
             " curved cells are turned inside out by their nodes, the first "
             "at " +
             place(inspection.inside_out_place));
      const MeshInterfaces &found = inspection.interfaces;
      if (found.n_crack > 0)
        warn(std::to_string(found.n_crack) +
             " pairs of nodes of one body are at the same place, first at " +
             place(found.crack_place) +
             ": a crack, or nodes that were not merged");
      if (found.n_hanging > 0)
        warn(std::to_string(found.n_hanging) +
             " nodes lie within a face or edge of the same body without being "
             "its vertices, first at " +
             place(found.hanging_place) + ": cells do not fit together");
      if (inspection.n_unused_points > 0)
        warn(std::to_string(inspection.n_unused_points) +
             " nodes belong to no cell");

      double smallest = std::numeric_limits<double>::max(), largest = 0.;
      for (const InspectedBody &body : inspection.bodies)
        {
          smallest = std::min(smallest, body.box.extent());
          largest  = std::max(largest, body.box.extent());
        }
      std::ostringstream text;
      if (largest > 300. * smallest)
        text << "the largest body is " << largest / smallest
             << " times as long as the smallest: are all in the same unit?";
      else if (largest > 0. && largest < 1.)
        text << "the longest body has " << largest
             << " length units. If that is in metres, moduli are in Pa; with "
                "moduli in MPa, lengths are in mm ('Scale = 1000')";
      else if (largest > 1e5)
        text << "the longest body has " << largest
             << " length units. With moduli in MPa that is in mm";
      if (!text.str().empty())
        warn(text.str());
      for (const auto &[name, number] : file.unknown_types)
        warn(std::to_string(number) + " elements of " + name +
             " are not known and were left out");
    }
  } // namespace



  MeshInspection
  inspect_mesh(const std::string &file_name)
  {
    MeshInspection inspection;
    inspection.file      = file_name;
    const MeshFile file  = parse_for_inspection(file_name, inspection.format);
    inspection.dimension = file.dimension();
    inspection.n_points  = file.points.size();
    inspection.cells     = file.elements_in_words(inspection.dimension);
    if (inspection.dimension < 2)
      throw UserError("--inspect-mesh: '" + file_name +
                      "' has no cells of dimension 2 or 3" +
                      (inspection.cells.empty()
                         ? "."
                         : ": it is made of " + inspection.cells + "."));

    std::vector<std::size_t> cells =
      elements_of_groups(file, {}, inspection.dimension, "");
    look_at_groups(file, inspection);
    const bool can_be_used = is_of_usable_cells(file, cells);
    if (can_be_used)
      {
        const auto selection = select_cells(
          file, {}, inspection.dimension, "--inspect-mesh: the mesh ", "");
        cells.clear();
        for (const SelectedCell &cell : selection)
          cells.push_back(cell.element);
      }
    const auto bodies = connected_bodies(file, cells);
    look_at_cells(file, cells, bodies, inspection);
    if (can_be_used)
      {
        const bool   is_plane = inspection.dimension == 2;
        const double extent   = inspection.box.extent();
        inspection.is_of_second_order =
          std::any_of(cells.begin(), cells.end(), [&](const std::size_t cell) {
            return !file.type(cell).is_linear();
          });
        inspection.deviation = deviation_of_nodes(file, cells);
        (is_plane ? look_at_curved_cells<2>
                  : look_at_curved_cells<3>)(file, cells, inspection);
        inspection.interfaces =
          (is_plane ? find_interfaces<2>
                    : find_interfaces<3>)(file, cells, bodies, extent);
      }
    else
      inspection.warnings.push_back(
        "only " + usable_cells_in_words(inspection.dimension) +
        " can be used in a case, of one kind in a body ('Mesh group'); "
        "interfaces were not looked at");
    add_warnings(file, inspection);
    return inspection;
  }
} // namespace stickslip
