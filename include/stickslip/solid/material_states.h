#ifndef stickslip_solid_material_states_h
#define stickslip_solid_material_states_h

#include <stickslip/base/types.h>

#include <stickslip/mesh/body.h>

#include <stickslip/solid/cell_scratch.h>
#include <stickslip/solid/constitutive_law.h>
#include <stickslip/solid/history_fields.h>
#include <stickslip/solid/mean_dilatation.h>
#include <stickslip/solid/point_history.h>

#include <deal.II/base/point.h>
#include <deal.II/base/symmetric_tensor.h>

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/hp/mapping_collection.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace stickslip
{
  /// Stress, strain and history at one quadrature point.
  template <int dim>
  struct MaterialState
  {
    Point<dim>            reference_position;
    double                JxW; ///< reference volume
    SymmetricTensor<2, 3> cauchy_stress;
    SymmetricTensor<2, 3> strain; ///< as the law defines it
    /// First Piola-Kirchhoff stress, in equilibrium with the loads.
    Tensor<2, 3> nominal_stress;

    /// In the order of MaterialStates::history_names(); 0 for those of other
    /// laws.
    std::vector<double> history;
  };



  /**
   * The material states of a cell, for output: evaluated with the accepted
   * history, of which they change nothing. Not collective.
   */
  template <int dim>
  class MaterialStates
  {
  public:
    /**
     * @p laws and @p mean_dilatation are indexed by material id. Keeps
     * references to everything.
     */
    MaterialStates(
      const hp::MappingCollection<dim>                          &mapping,
      const DoFHandler<dim>                                     &dof_handler,
      const Bodies                                              &bodies,
      const std::vector<std::shared_ptr<const ConstitutiveLaw>> &laws,
      const std::vector<std::optional<MeanDilatation<dim>>> &mean_dilatation,
      const PointHistory                                    &history);

    /**
     * At the quadrature points of the locally owned @p cell, with the ghosted
     * displacement @p u. Leaves @p states empty on cells of rigid bodies and
     * where the mean dilatation has no volume; a state that the law has no
     * answer for is zero.
     */
    void
    evaluate(const typename DoFHandler<dim>::active_cell_iterator &cell,
             const LA::Vector                                     &u,
             std::vector<MaterialState<dim>>                      &states);

    /// Names of MaterialState::history.
    const std::vector<std::string> &
    history_names() const
    {
      return history_fields.names();
    }

  private:
    MaterialState<dim>
    state_at(const CellScratch<dim>  &at,
             const unsigned int       q,
             const unsigned int       cell_index,
             const types::material_id material) const;

    const Bodies                                              &bodies;
    const std::vector<std::shared_ptr<const ConstitutiveLaw>> &laws;
    const std::vector<std::optional<MeanDilatation<dim>>>     &mean_dilatation;
    const PointHistory                                        &history;

    const HistoryFields history_fields;

    ByKind<CellScratch<dim>> scratch;
  };
} // namespace stickslip

#endif
