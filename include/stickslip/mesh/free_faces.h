#ifndef stickslip_mesh_free_faces_h
#define stickslip_mesh_free_faces_h

#include <stickslip/mesh/file/mesh_file.h>

#include <array>
#include <string>
#include <tuple>
#include <vector>

namespace stickslip
{
  /// The faces of cells of a MeshFile that belong to one cell only.
  template <int dim>
  class FreeFaces
  {
  public:
    /// @p cells are of one kind. Throws UserError that begins
    /// with @p where if three cells share a face.
    FreeFaces(const MeshFile                 &file,
              const std::vector<std::size_t> &cells,
              const std::string              &where);

    std::size_t
    size() const
    {
      return faces.size();
    }

    /// Index of the free face with the vertices of @p element, a line or a
    /// polygon; size() if there is none.
    std::size_t
    find(const MeshFile &file, const std::size_t element) const;

    /// Points of the file, in deal.II's order.
    std::vector<unsigned int>
    vertices(const std::size_t face) const;

    /// The element of the file whose face it is.
    std::size_t
    cell(const std::size_t face) const
    {
      return faces[face].cell;
    }

  private:
    /// Triangles have the largest number at the end.
    using Vertices = std::array<unsigned int, 1 << (dim - 1)>;

    static Vertices
    sorted_vertices(const std::vector<unsigned int> &vertices);

    struct Face
    {
      Vertices     sorted;
      std::size_t  cell;
      unsigned int side;

      bool
      operator<(const Face &other) const
      {
        return std::tie(sorted, cell) < std::tie(other.sorted, other.cell);
      }
    };

    const MeshFile   &file;
    std::vector<Face> faces;
  };
} // namespace stickslip

#endif
