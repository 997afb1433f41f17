#include <stickslip/adaptivity/refinement_marking.h>

#include <stickslip/base/over_ranks.h>

#include <stickslip/mesh/cell_layers.h>

#include <deal.II/base/mpi.h>

#include <deal.II/distributed/grid_refinement.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace stickslip
{
  namespace
  {
    /// What happens to the cells of this rank.
    struct Flags
    {
      CellFlags refine;
      CellFlags coarsen;
    };



    template <int dim>
    class Marker
    {
    public:
      Marker(const ErrorEstimate                       &estimate,
             const AdaptationParameters                &parameters,
             const Bodies                              &bodies,
             parallel::distributed::Triangulation<dim> &triangulation)
        : estimate(estimate)
        , parameters(parameters)
        , bodies(bodies)
        , triangulation(triangulation)
        , communicator(triangulation.get_communicator())
      {}

      /// What the estimate wants.
      Flags
      wanted() const
      {
        if (estimate.is_rule)
          return by_threshold(0.5, 0.5);
        const double n = triangulation.n_global_active_cells();
        const double n_own =
          number([this](const auto &cell) { return !is_rigid(cell); });
        // Rigid cells have no error: they are among the smallest indicators.
        const double rigid = 1. - n_own / n;
        switch (parameters.marking)
          {
            case Marking::fixed_fraction:
              return by_library([this]() {
                parallel::distributed::GridRefinement::
                  refine_and_coarsen_fixed_fraction(
                    triangulation,
                    estimate.indicators,
                    parameters.refine_fraction,
                    parameters.coarsen_fraction);
              });
            case Marking::fixed_number:
              return by_library([&]() {
                fixed_number(parameters.refine_fraction * (1. - rigid),
                             rigid +
                               parameters.coarsen_fraction * (1. - rigid));
              });
            case Marking::error_target:
              return by_target(n_own);
          }
        return Flags();
      }

      /// Adds the buffer and takes away what the bounds do not allow.
      Flags
      bounded(Flags flags) const
      {
        for (unsigned int i = 0; i < parameters.buffer_layers; ++i)
          add_layer(triangulation, flags.refine);
        const int coarsest =
          parameters.global_refinements + parameters.least_levels;
        const int finest =
          parameters.global_refinements + parameters.most_levels;
        for_each_own_cell([&](const auto &cell, const unsigned int i) {
          // a cell that may not be finer need not be coarser for that
          flags.coarsen[i] =
            flags.coarsen[i] && !flags.refine[i] && cell->level() > coarsest;
          flags.refine[i] = flags.refine[i] && cell->level() < finest;
        });
        return flags;
      }

      /// Of @p wanted, with as few of the smallest indicators left out as the
      /// most cells ask for.
      Flags
      with_most_cells(const Flags &wanted) const
      {
        const double n     = triangulation.n_global_active_cells();
        const double most  = (parameters.most_cells - n) / (children - 1.);
        Flags        few   = wanted;
        Flags        flags = bounded(few);
        double       n_few = count(few.refine);
        while (count(flags.refine) > std::max(most, 0.))
          {
            n_few = std::floor(
              std::min(n_few - 1.,
                       n_few * std::max(most, 0.) / count(flags.refine)));
            const Flags largest =
              by_library([&]() { fixed_number(std::max(n_few, 0.) / n, 0.); });
            for (unsigned int i = 0; i < few.refine.size(); ++i)
              few.refine[i] =
                n_few > 0. && wanted.refine[i] && largest.refine[i];
            flags = bounded(few);
            // as many as there may be: equal indicators cannot be told apart
            n_few = std::min(n_few, count(few.refine));
          }
        return flags;
      }

    private:
      const ErrorEstimate                       &estimate;
      const AdaptationParameters                &parameters;
      const Bodies                              &bodies;
      parallel::distributed::Triangulation<dim> &triangulation;
      const MPI_Comm                             communicator;

      static constexpr double children =
        GeometryInfo<dim>::max_children_per_cell;

      template <typename CellIterator>
      bool
      is_rigid(const CellIterator &cell) const
      {
        return bodies.bodies[bodies.body_of(cell->material_id())].is_rigid;
      }

      template <typename CellIterator>
      bool
      is_tool(const CellIterator &cell) const
      {
        return bodies.bodies[bodies.body_of(cell->material_id())]
          .parameters.is_tool();
      }

      /// Calls @p visit(cell, active_cell_index).
      template <typename Visitor>
      void
      for_each_own_cell(const Visitor &visit) const
      {
        for (const auto &cell : triangulation.active_cell_iterators())
          if (cell->is_locally_owned())
            visit(cell, cell->active_cell_index());
      }

      /// Of cells on all ranks.
      template <typename Predicate>
      double
      number(const Predicate &is_one) const
      {
        double n = 0.;
        for_each_own_cell([&](const auto &cell, const unsigned int) {
          n += is_one(cell) ? 1. : 0.;
        });
        return Utilities::MPI::sum(n, communicator);
      }

      double
      count(const CellFlags &flags) const
      {
        return number([&flags](const auto &cell) {
          return flags[cell->active_cell_index()];
        });
      }

      Flags
      none() const
      {
        const CellFlags no(triangulation.n_active_cells(), false);
        return {no, no};
      }

      void
      fixed_number(const double refine, const double coarsen) const
      {
        parallel::distributed::GridRefinement::refine_and_coarsen_fixed_number(
          triangulation, estimate.indicators, refine, coarsen);
      }

      /// What @p set_flags of deal.II does, without rigid bodies.
      template <typename SetFlags>
      Flags
      by_library(const SetFlags &set_flags) const
      {
        clear();
        set_flags();
        Flags flags = none();
        for_each_own_cell([&](const auto &cell, const unsigned int i) {
          flags.refine[i]  = !is_rigid(cell) && cell->refine_flag_set();
          flags.coarsen[i] = !is_rigid(cell) && cell->coarsen_flag_set();
        });
        clear();
        return flags;
      }

      /// Rigid bodies as well if the estimate is of a rule: their facets. The
      /// cell of a tool has none.
      Flags
      by_threshold(const double refine_above, const double coarsen_below) const
      {
        Flags flags = none();
        for_each_own_cell([&](const auto &cell, const unsigned int i) {
          const bool counts =
            !is_rigid(cell) || (estimate.is_rule && !is_tool(cell));
          flags.refine[i]  = counts && estimate.indicators[i] > refine_above;
          flags.coarsen[i] = counts && estimate.indicators[i] < coarsen_below;
        });
        return flags;
      }

      /// Each of @p n cells has the same share of the target. One with much more
      /// is refined also where the whole error is below it: what moves, as
      /// contact does, leaves the cells that were made for it. A cell may be
      /// coarser if its parent, with linear elements, stays well below the
      /// share: its children have 2^dim indicators, a fourth of whose sum each.
      Flags
      by_target(const double n) const
      {
        const double target = parameters.error_target * estimate.energy_norm;
        const double share  = target * target / n;
        return by_threshold(estimate.error > target ? share : 4. * share,
                            share / (16. * children));
      }

      void
      clear() const
      {
        for (const auto &cell : triangulation.active_cell_iterators())
          {
            cell->clear_refine_flag();
            cell->clear_coarsen_flag();
          }
      }
    };
  } // namespace



  template <int dim>
  bool
  mark_cells(const ErrorEstimate                       &estimate,
             const AdaptationParameters                &parameters,
             const Bodies                              &bodies,
             parallel::distributed::Triangulation<dim> &triangulation)
  {
    const Marker<dim> marker(estimate, parameters, bodies, triangulation);
    const Flags       flags = marker.with_most_cells(marker.wanted());
    bool              any   = false;
    for (const auto &cell : triangulation.active_cell_iterators())
      {
        cell->clear_refine_flag();
        cell->clear_coarsen_flag();
        if (!cell->is_locally_owned())
          continue;
        const unsigned int i = cell->active_cell_index();
        if (flags.refine[i])
          cell->set_refine_flag();
        else if (flags.coarsen[i])
          cell->set_coarsen_flag();
        any = any || flags.refine[i] || flags.coarsen[i];
      }
    return any_rank(any, triangulation.get_communicator());
  }

  template <int dim>
  KeptCoarse
  find_kept_coarse(const ErrorEstimate                       &estimate,
                   const AdaptationParameters                &parameters,
                   const Bodies                              &bodies,
                   parallel::distributed::Triangulation<dim> &triangulation)
  {
    const Marker<dim> marker(estimate, parameters, bodies, triangulation);
    const Flags       wanted  = marker.wanted();
    const Flags       allowed = marker.with_most_cells(wanted);
    const int  finest = parameters.global_refinements + parameters.most_levels;
    KeptCoarse kept;
    for (const auto &cell : triangulation.active_cell_iterators())
      {
        const unsigned int i = cell->active_cell_index();
        if (cell->is_locally_owned() && wanted.refine[i] && !allowed.refine[i])
          (cell->level() < finest ? kept.by_cells : kept.by_levels) +=
            estimate.indicators[i];
      }
    const MPI_Comm communicator = triangulation.get_communicator();
    return {Utilities::MPI::sum(kept.by_levels, communicator),
            Utilities::MPI::sum(kept.by_cells, communicator)};
  }

#define INSTANTIATE(dim)                                                       \
  template bool       mark_cells(const ErrorEstimate &,                        \
                                 const AdaptationParameters &,                 \
                                 const Bodies &,                               \
                                 parallel::distributed::Triangulation<dim> &); \
  template KeptCoarse find_kept_coarse(                                        \
    const ErrorEstimate &,                                                     \
    const AdaptationParameters &,                                              \
    const Bodies &,                                                            \
    parallel::distributed::Triangulation<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
