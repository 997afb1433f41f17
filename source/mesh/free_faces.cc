#include <stickslip/mesh/free_faces.h>

#include <stickslip/base/user_error.h>

#include <algorithm>
#include <limits>
#include <sstream>
#include <utility>

namespace stickslip
{
  template <int dim>
  FreeFaces<dim>::FreeFaces(const MeshFile                 &file,
                            const std::vector<std::size_t> &cells,
                            const std::string              &where)
    : file(file)
  {
    std::vector<Face> all;
    for (const std::size_t cell : cells)
      {
        const auto &sides = sides_of(file.type(cell).shape);
        for (unsigned int s = 0; s < sides.size(); ++s)
          {
            std::vector<unsigned int> vertices;
            for (const unsigned int v : sides[s])
              vertices.push_back(file.nodes(cell)[v]);
            all.push_back({sorted_vertices(vertices), cell, s});
          }
      }
    std::sort(all.begin(), all.end());

    for (std::size_t i = 0; i < all.size();)
      {
        std::size_t end = i + 1;
        while (end < all.size() && all[end].sorted == all[i].sorted)
          ++end;
        if (end == i + 1)
          faces.push_back(all[i]);
        else if (end > i + 2)
          {
            std::ostringstream text;
            text << where << "has " << end - i
                 << " cells with a common face, near ("
                 << file.points[all[i].sorted[0]]
                 << "); a face can belong to two cells at most. Cells overlap "
                    "or have been written twice.";
            throw UserError(text.str());
          }
        i = end;
      }
  }



  template <int dim>
  typename FreeFaces<dim>::Vertices
  FreeFaces<dim>::sorted_vertices(const std::vector<unsigned int> &vertices)
  {
    Vertices sorted;
    sorted.fill(std::numeric_limits<unsigned int>::max());
    std::copy(vertices.begin(), vertices.end(), sorted.begin());
    std::sort(sorted.begin(), sorted.end());
    return sorted;
  }



  template <int dim>
  std::size_t
  FreeFaces<dim>::find(const MeshFile &file, const std::size_t element) const
  {
    const auto nodes = file.nodes(element).begin();
    const Face face{sorted_vertices(
                      {nodes, nodes + n_vertices_of(file.type(element).shape)}),
                    0,
                    0};
    const auto found = std::lower_bound(faces.begin(), faces.end(), face);
    return found != faces.end() && found->sorted == face.sorted
             ? found - faces.begin()
             : size();
  }



  template <int dim>
  std::vector<unsigned int>
  FreeFaces<dim>::vertices(const std::size_t face) const
  {
    const std::size_t         cell = faces[face].cell;
    std::vector<unsigned int> points;
    for (const unsigned int v :
         sides_of(file.type(cell).shape)[faces[face].side])
      points.push_back(file.nodes(cell)[v]);
    if (points.size() == 4)
      std::swap(points[2], points[3]);
    return points;
  }



  template class FreeFaces<2>;
  template class FreeFaces<3>;
} // namespace stickslip
