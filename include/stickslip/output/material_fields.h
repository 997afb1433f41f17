#ifndef stickslip_output_material_fields_h
#define stickslip_output_material_fields_h

#include <stickslip/base/types.h>

#include <stickslip/solid/solid_assembler.h>

#include <deal.II/base/symmetric_tensor.h>

#include <deal.II/dofs/dof_handler.h>

#include <functional>
#include <string>
#include <vector>

namespace stickslip
{
  /**
   * Stress, strain and history of the material at the points of
   * cell_quadrature(), as the writers want them.
   */
  template <int dim>
  struct MaterialFields
  {
    /// At the points of one cell. All empty on a rigid body: the fields are
    /// zero there.
    struct Values
    {
      std::vector<SymmetricTensor<2, 3>> cauchy_stress;
      std::vector<SymmetricTensor<2, 3>> strain;
      std::vector<std::vector<double>>   history; ///< [point][name]
    };

    /// Names of the history variables, in the order of Values::history.
    std::vector<std::string> history_names;

    /// For a locally owned cell. An empty function: no fields.
    std::function<Values(
      const typename DoFHandler<dim>::active_cell_iterator &)>
      evaluate;
  };



  /// Those of the bodies with the accepted history. Keeps references to both;
  /// @p displacement is ghosted.
  template <int dim>
  MaterialFields<dim>
  material_fields(SolidAssembler<dim> &solid, const LA::Vector &displacement);
} // namespace stickslip

#endif
