#include <stickslip/linear_solvers/multigrid/smoothed_aggregation.h>

#include <stickslip/linear_solvers/multigrid/fewer_ranks.h>
#include <stickslip/linear_solvers/multigrid/galerkin_product.h>

#include <algorithm>
#include <utility>

namespace stickslip
{
  namespace
  {
    /// Unknowns (over all ranks) that are solved for directly.
    constexpr types::global_dof_index largest_coarsest_level = 1000;

    constexpr unsigned int max_levels = 10;

    /// A next level with more than this share of the unknowns is not worth it.
    constexpr double least_coarsening = 0.7;

    /**
     * A level moves if half of its ranks are enough for so many unknowns on
     * each. (With 300, levels of 30 nodes on each rank stayed where they were:
     * two cubes of 125,000 unknowns on 64 ranks sent 1.6 times as many messages
     * and had 774 unknowns on the coarsest level instead of 540. With 1000,
     * cubes of 15,000 took 7 % more iterations on 16 ranks.)
     */
    constexpr types::global_dof_index least_unknowns_per_rank = 500;
  } // namespace



  void
  SmoothedAggregation::clear()
  {
    levels.clear();
    coarsest_factors.clear();
  }



  types::global_dof_index
  SmoothedAggregation::n_unknowns(const unsigned int level) const
  {
    return levels[level]->space.owned_unknowns().size();
  }



  unsigned int
  SmoothedAggregation::n_ranks(const unsigned int level) const
  {
    return levels[level]->space.n_owners();
  }



  void
  SmoothedAggregation::add_level(BlockMatrix &A, const NodePlaces &places)
  {
    levels.push_back(std::make_unique<Level>());
    levels.back()->smoother.reinit(A, find_clusters(A, places));
    levels.back()->space = A.column_space();
  }



  void
  SmoothedAggregation::coarsen(BlockMatrix       &A,
                               BlockRows<float> &&prolongation,
                               const NodeSpace   &coarse,
                               const NodePlaces  &places)
  {
    Level      &fine = *levels.back();
    BlockMatrix next(galerkin_product(A, prolongation, coarse), coarse, coarse);
    fine.prolongation =
      Prolongation(std::move(prolongation), A.column_space(), coarse);
    A = std::move(next);
    add_level(A, places);
  }



  void
  SmoothedAggregation::reinit(BlockMatrix      &&A,
                              BlockRows<float> &&prolongation,
                              NodeSpace        &&second,
                              const NodePlaces  &places,
                              Modes            &&modes)
  {
    clear();
    const auto n_unknowns = [&A] {
      return A.column_space().owned_unknowns().size();
    };
    add_level(A, places);
    if (second.n_global() > 0)
      {
        move_to_fewer_ranks(second, modes, least_unknowns_per_rank);
        coarsen(A, std::move(prolongation), second, modes.nodes);
      }
    bool are_joined = false;
    while (levels.size() < max_levels && n_unknowns() > largest_coarsest_level)
      {
        const Aggregates aggregates =
          find_aggregates(A,
                          levels.back()->smoother.node_clusters(),
                          modes.nodes);
        TentativeProlongation tentative =
          tentative_prolongation(A.column_space(), aggregates, modes);
        if (tentative.coarse.owned_unknowns().size() >
            least_coarsening * n_unknowns())
          {
            if (are_joined)
              break;
            // many small bodies: from here on in one
            std::fill(modes.nodes.bodies.begin(), modes.nodes.bodies.end(), 0);
            modes.nodes.reaches.clear();
            are_joined = true;
            continue;
          }
        set_reaches(A, modes.nodes, aggregates, tentative.coarse_modes.nodes);
        move_to_fewer_ranks(tentative.coarse,
                            tentative.coarse_modes,
                            least_unknowns_per_rank);
        coarsen(A,
                smoothed_prolongation(
                  A, levels.back()->smoother, tentative.rows, tentative.coarse),
                tentative.coarse,
                tentative.coarse_modes.nodes);
        modes = std::move(tentative.coarse_modes);
      }
    factorise_coarsest(A);
  }



  void
  SmoothedAggregation::factorise_coarsest(const BlockMatrix &A)
  {
    const NodeSpace                    &space = A.column_space();
    std::vector<RootFactorization::Row> rows;
    for (unsigned int row = 0; row < A.n_rows(); ++row)
      {
        std::vector<long> columns;
        for (auto k = A.column_begin(row); k < A.column_begin(row + 1); ++k)
          for (auto i = space.begin(A.column(k));
               i < space.begin(A.column(k) + 1);
               ++i)
            columns.push_back(space.global_unknown(i));
        for (unsigned int r = 0; r < A.height(row); ++r)
          {
            const double *const entries = A.panel(row) + r * A.width(row);
            rows.push_back(
              {columns, std::vector<double>(entries, entries + A.width(row))});
          }
      }
    const FactorizationError error =
      coarsest_factors.factorise(rows, space.communicator());
    AssertThrow(!error, ExcMessage("coarsest level: " + describe(error)));
  }



  void
  SmoothedAggregation::cycle(const unsigned int l) const
  {
    if (l + 1 == levels.size())
      {
        coarsest_factors.solve(levels[l]->x, levels[l]->b);
        return;
      }
    const Level &level = *levels[l];
    const Level &next  = *levels[l + 1];
    level.smoother.solve(level.x, level.defect, level.b);
    level.prolongation.restrict_to_coarse(level.coarse, level.defect);
    next.b.assign(level.coarse.begin(),
                  level.coarse.begin() + next.space.n_owned_unknowns());
    cycle(l + 1);
    std::copy_n(next.x.begin(), next.b.size(), level.coarse.begin());
    level.prolongation.add_to_fine(level.x, level.coarse);
    level.smoother.smooth(level.x, level.b);
  }



  void
  SmoothedAggregation::vmult(double *const x, const double *const b) const
  {
    const Level &finest = *levels[0];
    finest.b.assign(b, b + finest.space.n_owned_unknowns());
    cycle(0);
    std::copy_n(finest.x.begin(), finest.b.size(), x);
  }
} // namespace stickslip
