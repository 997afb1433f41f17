#ifndef stickslip_adaptivity_refinement_marking_h
#define stickslip_adaptivity_refinement_marking_h

#include <stickslip/adaptivity/adaptation_parameters.h>
#include <stickslip/adaptivity/error_estimate.h>

#include <stickslip/mesh/body.h>

#include <deal.II/distributed/tria.h>

namespace stickslip
{
  /**
   * Sets the refine and coarsen flags of the cells of this rank, and clears
   * those that were there, by what @p estimate says and @p parameters allow:
   *
   * - of an error: by AdaptationParameters::marking. Sums of the squared
   *   indicators are what counts. Cells of rigid bodies get no flag.
   * - of a rule: cells that it selects are refined, all others coarsened.
   *
   * Then buffer layers, the bounds of levels, and the most cells: as long as
   * the refined cells would make more than that, fewer of those with small
   * indicators are refined. What deal.II does to flags afterwards (children
   * that do not all want to be coarser, levels of neighbours) is not looked
   * at. Nothing is executed.
   *
   * Returns, on all ranks, whether any cell has a flag. Collective.
   */
  template <int dim>
  bool
  mark_cells(const ErrorEstimate                       &estimate,
             const AdaptationParameters                &parameters,
             const Bodies                              &bodies,
             parallel::distributed::Triangulation<dim> &triangulation);



  /// Squares of indicators of cells that should be finer and may not, because
  /// of
  struct KeptCoarse
  {
    double by_levels = 0.; ///< AdaptationParameters::most_levels
    double by_cells  = 0.; ///< AdaptationParameters::most_cells
  };

  /// Over all ranks. Leaves no flags. Collective.
  template <int dim>
  KeptCoarse
  find_kept_coarse(const ErrorEstimate                       &estimate,
                   const AdaptationParameters                &parameters,
                   const Bodies                              &bodies,
                   parallel::distributed::Triangulation<dim> &triangulation);
} // namespace stickslip

#endif
