#include <stickslip/mesh/mesh_from_file.h>

#include <stickslip/base/short_message.h>
#include <stickslip/base/user_error.h>
#include <stickslip/mesh/free_faces.h>
#include <stickslip/mesh/mesh_selection.h>
#include <stickslip/mesh/second_order_nodes.h>

#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace stickslip
{
  namespace
  {
    /// Gives combinations of groups their ids.
    class GroupIds
    {
    public:
      GroupIds(const std::vector<GroupLabel> &labels, LabelledIds &ids)
        : labels(labels)
        , ids(ids)
      {}

      unsigned int
      operator()(const std::vector<unsigned int> &groups)
      {
        const auto known = known_ids.find(groups);
        if (known != known_ids.end())
          return known->second;
        std::vector<GroupLabel> group_labels;
        for (const unsigned int g : groups)
          group_labels.push_back(labels[g]);
        return known_ids[groups] = ids.id_of(group_labels);
      }

      /// Names that no combination has had.
      void
      note_unused_names(const unsigned int dim, const MeshFile &file)
      {
        for (const MeshGroup &group : file.groups)
          if (group.dimension == dim && !group.name.empty() &&
              ids.ids(group.name).empty())
            ids.add_elsewhere(group.name);
      }

    private:
      const std::vector<GroupLabel>                    &labels;
      LabelledIds                                      &ids;
      std::map<std::vector<unsigned int>, unsigned int> known_ids;
    };



    /// Points of the body with new indices. In 2D all must have the same z.
    template <int dim>
    std::vector<Point<dim>>
    vertices_in_use(const MeshFile                 &file,
                    const std::vector<std::size_t> &cells,
                    const std::string              &where,
                    std::vector<unsigned int>      &new_indices)
    {
      new_indices.assign(file.points.size(), numbers::invalid_unsigned_int);
      std::vector<Point<dim>> vertices;
      double z_min = std::numeric_limits<double>::max(), z_max = -z_min;
      double extent = 0.;
      for (const std::size_t e : cells)
        for (const unsigned int node : file.vertices(e))
          if (new_indices[node] == numbers::invalid_unsigned_int)
            {
              new_indices[node] = vertices.size();
              Point<dim> vertex;
              for (unsigned int d = 0; d < dim; ++d)
                vertex[d] = file.points[node][d];
              vertices.push_back(vertex);
              z_min  = std::min(z_min, file.points[node][2]);
              z_max  = std::max(z_max, file.points[node][2]);
              extent = std::max(extent, (vertex - vertices[0]).norm());
            }
      if (dim == 2 && z_max - z_min > 1e-6 * extent)
        throw UserError(where + "has z from " + std::to_string(z_min) + " to " +
                        std::to_string(z_max) +
                        ". A 2D mesh has to lie in a plane z = const.");
      return vertices;
    }



    /// The groups of each free face; node sets count from file.groups.size()
    /// on.
    template <int dim>
    std::vector<std::vector<unsigned int>>
    groups_of_faces(const MeshFile                  &file,
                    const FreeFaces<dim>            &faces,
                    const std::vector<unsigned int> &new_indices)
    {
      std::vector<std::vector<unsigned int>> groups(faces.size());
      for (std::size_t e = 0; e < file.n_elements(); ++e)
        if (file.dimension(e) == dim - 1 && !file.groups_of(e).empty())
          {
            const std::size_t face = faces.find(file, e);
            if (face != faces.size())
              groups[face].insert(groups[face].end(),
                                  file.groups_of(e).begin(),
                                  file.groups_of(e).end());
          }

      unsigned int group = file.groups.size();
      for (const auto &set : file.point_sets)
        {
          std::vector<bool> is_in_set(file.points.size(), false);
          for (const unsigned int point : set.second)
            is_in_set[point] = true;
          bool has_all = true;
          for (std::size_t p = 0; p < new_indices.size(); ++p)
            has_all =
              has_all &&
              (is_in_set[p] || new_indices[p] == numbers::invalid_unsigned_int);
          for (std::size_t f = 0; !has_all && f < faces.size(); ++f)
            {
              bool is_inside = true;
              for (const unsigned int point : faces.vertices(f))
                is_inside = is_inside && is_in_set[point];
              if (is_inside)
                groups[f].push_back(group);
            }
          ++group;
        }
      for (auto &list : groups)
        {
          std::sort(list.begin(), list.end());
          list.erase(std::unique(list.begin(), list.end()), list.end());
        }
      return groups;
    }



    std::vector<GroupLabel>
    all_labels(const MeshFile &file)
    {
      std::vector<GroupLabel> labels;
      for (const MeshGroup &group : file.groups)
        labels.push_back({group.number, group.name});
      for (const auto &set : file.point_sets)
        labels.push_back({-1, set.first});
      return labels;
    }



    template <int structdim>
    CellData<structdim>
    cell_data(const std::vector<unsigned int> &points,
              const std::vector<unsigned int> &new_indices)
    {
      CellData<structdim> data(points.size());
      for (unsigned int v = 0; v < points.size(); ++v)
        data.vertices[v] = new_indices[points[v]];
      return data;
    }



    /// Vertices of a cell of the file in deal.II's order.
    std::vector<unsigned int>
    ordered_vertices(const MeshFile &file, const std::size_t element)
    {
      std::vector<unsigned int> vertices = file.vertices(element);
      if (!is_simplex(file.type(element).shape)) // lexicographic
        for (unsigned int first = 0; first + 3 < vertices.size(); first += 4)
          std::swap(vertices[first + 2], vertices[first + 3]);
      return vertices;
    }
  } // namespace



  template <int dim>
  std::shared_ptr<QuadraticCells<dim>>
  make_triangulation(const MeshFile                 &file,
                     const std::vector<std::string> &groups,
                     const std::string              &where,
                     const std::string              &path,
                     Triangulation<dim>             &triangulation,
                     LabelledIds                    &boundaries,
                     LabelledIds                    &materials)
  {
    const std::vector<SelectedCell> selection =
      select_cells(file, groups, dim, where, path);
    std::vector<std::size_t> elements;
    for (const SelectedCell &cell : selection)
      elements.push_back(cell.element);

    std::vector<unsigned int> new_indices;
    const auto                vertices =
      vertices_in_use<dim>(file, elements, where, new_indices);

    const std::vector<GroupLabel> labels = all_labels(file);
    GroupIds                      material_ids(labels, materials);
    std::vector<CellData<dim>>    cells;
    for (const SelectedCell &cell : selection)
      {
        cells.push_back(
          cell_data<dim>(ordered_vertices(file, cell.element), new_indices));
        cells.back().material_id = material_ids(cell.groups);
      }
    material_ids.note_unused_names(dim, file);

    const FreeFaces<dim> faces(file, elements, where);
    GroupIds             boundary_ids(labels, boundaries);
    const auto  face_groups = groups_of_faces(file, faces, new_indices);
    SubCellData sub_cells;
    for (std::size_t f = 0; f < faces.size(); ++f)
      if (!face_groups[f].empty())
        {
          auto data        = cell_data<dim - 1>(faces.vertices(f), new_indices);
          data.boundary_id = boundary_ids(face_groups[f]);
          if constexpr (dim == 2)
            sub_cells.boundary_lines.push_back(data);
          else
            sub_cells.boundary_quads.push_back(data);
        }
    boundary_ids.note_unused_names(dim - 1, file);
    try
      {
        GridTools::invert_cells_with_negative_measure(vertices, cells);
        if (!is_simplex(file.type(elements.front()).shape))
          GridTools::consistently_order_cells(cells);
        triangulation.create_triangulation(vertices, cells, sub_cells);
      }
    catch (const ExceptionBase &exception)
      {
        throw UserError(where + "is no mesh whose cells fit together: " +
                        short_message(exception));
      }
    return curved_cells<dim>(file, elements, where);
  }



  template std::shared_ptr<QuadraticCells<2>>
  make_triangulation(const MeshFile &,
                     const std::vector<std::string> &,
                     const std::string &,
                     const std::string &,
                     Triangulation<2> &,
                     LabelledIds &,
                     LabelledIds &);
  template std::shared_ptr<QuadraticCells<3>>
  make_triangulation(const MeshFile &,
                     const std::vector<std::string> &,
                     const std::string &,
                     const std::string &,
                     Triangulation<3> &,
                     LabelledIds &,
                     LabelledIds &);
} // namespace stickslip
