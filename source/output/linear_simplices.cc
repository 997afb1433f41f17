#include <stickslip/output/linear_simplices.h>

namespace stickslip
{
  namespace
  {
    /// The points of the parts of a quadratic simplex.
    template <int dim>
    const std::vector<std::vector<unsigned int>> &
    parts_of_quadratic_simplex()
    {
      static const std::vector<std::vector<unsigned int>> parts =
        dim == 2
          ? std::vector<std::vector<unsigned int>>{{0, 3, 5},
                                                   {3, 1, 4},
                                                   {5, 4, 2},
                                                   {3, 4, 5}}
          :
          // those at the vertices, then the octahedron around its diagonal 4-9
          std::vector<std::vector<unsigned int>>{{0, 4, 6, 7},
                                                 {4, 1, 5, 8},
                                                 {6, 5, 2, 9},
                                                 {7, 8, 9, 3},
                                                 {4, 9, 5, 6},
                                                 {4, 9, 6, 7},
                                                 {4, 9, 7, 8},
                                                 {4, 9, 8, 5}};
      return parts;
    }
  } // namespace



  template <int dim, int spacedim>
  void
  cut_into_linear_simplices(
    std::vector<DataOutBase::Patch<dim, spacedim>> &patches)
  {
    std::vector<DataOutBase::Patch<dim, spacedim>> parts;
    for (const auto &patch : patches)
      {
        if (patch.reference_cell != ReferenceCells::get_simplex<dim>())
          {
            parts.push_back(patch);
            parts.back().patch_index = parts.size() - 1;
            continue;
          }
        Assert(patch.points_are_available, ExcInternalError());
        const unsigned int n_values = patch.data.n_rows() - spacedim;
        for (const auto &points : parts_of_quadratic_simplex<dim>())
          {
            AssertIndexRange(points.back(), patch.data.n_cols());
            DataOutBase::Patch<dim, spacedim> part;
            part.reference_cell = ReferenceCells::get_simplex<dim>();
            part.n_subdivisions = 1;
            part.patch_index    = parts.size();
            part.data.reinit(n_values, dim + 1);
            for (unsigned int v = 0; v <= dim; ++v)
              {
                for (unsigned int row = 0; row < n_values; ++row)
                  part.data(row, v) = patch.data(row, points[v]);
                // the positions are the last rows: deal.II's convention
                for (unsigned int d = 0; d < spacedim; ++d)
                  part.vertices[v][d] = patch.data(n_values + d, points[v]);
              }
            parts.push_back(part);
          }
      }
    patches.swap(parts);
  }



  template void
  cut_into_linear_simplices(std::vector<DataOutBase::Patch<2, 2>> &);
  template void
  cut_into_linear_simplices(std::vector<DataOutBase::Patch<3, 3>> &);
  template void
  cut_into_linear_simplices(std::vector<DataOutBase::Patch<2, 3>> &);
} // namespace stickslip
