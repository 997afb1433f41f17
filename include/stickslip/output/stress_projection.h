#ifndef stickslip_output_stress_projection_h
#define stickslip_output_stress_projection_h

#include <stickslip/output/material_fields.h>

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/hp/mapping_collection.h>

#include <deal.II/lac/la_parallel_vector.h>

#include <string>
#include <vector>

namespace stickslip
{
  /// sqrt(3/2 s:s), s the deviator of @p stress.
  double
  von_mises_stress(const SymmetricTensor<2, 3> &stress);

  /**
   * Cauchy stress, von Mises stress, strain and history variables as
   * discontinuous finite element fields of degree 1, in the precision of the
   * files: the cell-wise L2 projection
   * of values at quadrature points (over the undeformed cell). The von Mises
   * stress is that of the projected tensor, so it is consistent with it and
   * never negative.
   */
  template <int dim>
  class StressProjection
  {
  public:
    /// Collective. The triangulation of @p displacement_dof_handler is used.
    StressProjection(const hp::MappingCollection<dim> &mapping,
                     const DoFHandler<dim>            &displacement_dof_handler,
                     const MaterialFields<dim>        &material);

    using Field = LinearAlgebra::distributed::Vector<float>;

    /// Of any of the fields, which are scalar.
    const DoFHandler<dim> &
    get_dof_handler() const;

    /// Locally owned values by component, without ghosts.
    const std::vector<Field> &
    get_fields() const;

    /// Frees the fields.
    void
    clear_fields();

    /// Names of the components. Those of a tensor, nine whatever the dimension
    /// (so that files have zz in 2D, too), share a name: xx, xy, ..., zz.
    std::vector<std::string>
    names() const;

  private:
    const std::vector<std::string> history_names;

    DoFHandler<dim>    dof_handler;
    std::vector<Field> fields;
  };
} // namespace stickslip

#endif
