#ifndef stickslip_output_linear_simplices_h
#define stickslip_output_linear_simplices_h

#include <deal.II/base/data_out_base.h>

#include <vector>

namespace stickslip
{
  using namespace dealii;

  /**
   * deal.II 9.4 cannot write quadratic triangles and tetrahedra: cuts each of
   * the @p patches, which must be such cells with their points in the order of
   * FE_SimplexP(2), into 4 or 8 linear ones between these points.
   */
  template <int dim, int spacedim>
  void
  cut_into_linear_simplices(
    std::vector<DataOutBase::Patch<dim, spacedim>> &patches);
} // namespace stickslip

#endif
