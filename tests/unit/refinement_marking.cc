// Which cells are marked by given indicators: shares of the error and of the
// cells, an error target, rules; levels, buffer layers, most cells.

#include "case_problem.h"
#include "print.h"

#include <stickslip/adaptivity/refinement_marking.h>

#include <stickslip/mesh/agreed_flags.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

using namespace stickslip;

namespace
{
  using DistributedMesh = parallel::distributed::Triangulation<2>;

  /// A square of 4 x 4 cells with side 1, and a rigid body of 4 x 1 below it.
  const std::string two_bodies = R"(
    set Dimension = 2
    subsection Materials
      subsection steel
        set Law = linear elastic
      end
    end
    subsection Bodies
      subsection square
        set Generator = subdivided_hyper_rectangle
        set Arguments = 4, 4 : 0, 1 : 4, 5 : true
        set Material = steel
      end
      subsection table
        set Generator = subdivided_hyper_rectangle
        set Arguments = 4, 1 : 0, 0 : 4, 1 : true
        set Rigid = true
      end
    end
  )";



  /// The lines of cells from the top: r is refined, c coarsened, both if the
  /// children of one differ.
  void
  print_flags(const DistributedMesh &triangulation)
  {
    std::vector<unsigned int> flags(20, 0), sum(20);
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          const unsigned int i =
            static_cast<unsigned int>(cell->center()[0]) +
            4 * static_cast<unsigned int>(5. - cell->center()[1]);
          flags[i] += (cell->refine_flag_set() ? 1 : 0) +
                      (cell->coarsen_flag_set() ? 10 : 0);
        }
    Utilities::MPI::sum(flags, MPI_COMM_WORLD, sum);
    for (unsigned int line = 0; line < 5; ++line)
      {
        std::string text = "  ";
        for (unsigned int i = 4 * line; i < 4 * line + 4; ++i)
          text += sum[i] == 0        ? '.'
                  : sum[i] % 10 == 0 ? 'c'
                  : sum[i] < 10      ? 'r'
                                     : '?';
        print(text);
      }
  }



  void
  mark(const std::string                                 &title,
       const std::function<void(AdaptationParameters &)> &set,
       const std::function<double(const Point<2> &)>     &indicator,
       const bool                                         is_rule,
       Mesh<2>                                           &mesh)
  {
    auto &triangulation = dynamic_cast<DistributedMesh &>(*mesh.triangulation);
    AdaptationParameters parameters;
    parameters.buffer_layers = 0;
    set(parameters);
    ErrorEstimate estimate;
    estimate.is_rule     = is_rule;
    estimate.energy_norm = 100.;
    estimate.indicators.reinit(triangulation.n_active_cells());
    double sum = 0.;
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned() && (is_rule || cell->center()[1] > 1.))
        sum += estimate.indicators[cell->active_cell_index()] =
          indicator(cell->center());
    estimate.error = std::sqrt(Utilities::MPI::sum(sum, MPI_COMM_WORLD));
    const bool any =
      mark_cells(estimate, parameters, mesh.bodies, triangulation);
    print(title + (any ? "" : ": nothing"));
    print_flags(triangulation);
    const KeptCoarse kept =
      find_kept_coarse(estimate, parameters, mesh.bodies, triangulation);
    std::ostringstream text;
    text << "  kept coarse: " << kept.by_levels << " by levels, "
         << kept.by_cells << " by cells";
    if (kept.by_levels + kept.by_cells > 0.)
      print(text.str());
    mark_cells(estimate, parameters, mesh.bodies, triangulation);
  }
} // namespace



int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const TextParameters             text(two_bodies);
  Mesh<2> mesh = build_mesh<2>(text.mesh, text.bodies, {}, MPI_COMM_WORLD);

  // 1 to 16 from the lower left to the upper right, sum 136
  const auto rising = [](const Point<2> &p) {
    return 1. + std::floor(p[0]) + 4. * std::floor(p[1] - 1.);
  };
  mark(
    "half of the error",
    [](AdaptationParameters &a) {
      a.marking          = Marking::fixed_fraction;
      a.refine_fraction  = 0.5;
      a.coarsen_fraction = 0.05; // nothing is coarser than the coarse mesh
    },
    rising,
    false,
    mesh);
  mark(
    "a quarter of the cells, the rigid ones not counted",
    [](AdaptationParameters &a) {
      a.marking         = Marking::fixed_number;
      a.refine_fraction = 0.25;
    },
    rising,
    false,
    mesh);
  mark(
    "a quarter of the cells, at most 30 cells",
    [](AdaptationParameters &a) {
      a.marking         = Marking::fixed_number;
      a.refine_fraction = 0.25;
      a.most_cells      = 30;
    },
    rising,
    false,
    mesh);
  mark(
    "more than the share of 10 % of 100",
    [](AdaptationParameters &a) {
      a.marking      = Marking::error_target;
      a.error_target = 0.1;
    },
    rising,
    false,
    mesh);
  mark(
    "the same with no levels",
    [](AdaptationParameters &a) {
      a.marking      = Marking::error_target;
      a.error_target = 0.1;
      a.most_levels  = 0;
    },
    rising,
    false,
    mesh);
  mark(
    "the same with 29 cells",
    [](AdaptationParameters &a) {
      a.marking      = Marking::error_target;
      a.error_target = 0.1;
      a.most_cells   = 29;
    },
    rising,
    false,
    mesh);
  mark(
    "the target is reached",
    [](AdaptationParameters &a) {
      a.marking      = Marking::error_target;
      a.error_target = 0.2;
    },
    rising,
    false,
    mesh);
  mark(
    "the target is reached, but some have more than four shares",
    [](AdaptationParameters &a) {
      a.marking      = Marking::error_target;
      a.error_target = 0.18;
    },
    [&rising](const Point<2> &p) { return rising(p) > 15.5 ? 200. : 1.; },
    false,
    mesh);
  const auto corner = [](const Point<2> &p) {
    return p[0] < 1. && p[1] < 2. ? 1. : 0.;
  };
  mark(
    "a rule, on both bodies",
    [](AdaptationParameters &) {},
    corner,
    true,
    mesh);
  mark(
    "a rule and two layers",
    [](AdaptationParameters &a) { a.buffer_layers = 2; },
    corner,
    true,
    mesh);
  mark(
    "a rule and two layers, at most 35 cells: none can be told apart",
    [](AdaptationParameters &a) {
      a.buffer_layers = 2;
      a.most_cells    = 35;
    },
    corner,
    true,
    mesh);
  mark(
    "a rule, one layer, then refined once",
    [](AdaptationParameters &a) { a.buffer_layers = 1; },
    corner,
    true,
    mesh);
  mesh.triangulation->execute_coarsening_and_refinement();
  print(std::to_string(mesh.triangulation->n_global_active_cells()) + " cells");
  mark(
    "the same rule again: the others become coarser",
    [](AdaptationParameters &) {},
    corner,
    true,
    mesh);
  mark(
    "with one level at least",
    [](AdaptationParameters &a) { a.least_levels = 1; },
    corner,
    true,
    mesh);
  mark(
    "with one level at most",
    [](AdaptationParameters &a) { a.most_levels = 1; },
    corner,
    true,
    mesh);
  mark(
    "no error, no refinement",
    [](AdaptationParameters &a) {
      a.coarsen_fraction = 0.;
      a.least_levels     = 1;
    },
    [](const Point<2> &) { return 0.; },
    false,
    mesh);

  // Three of four siblings want to be coarser, then all of them do.
  auto &triangulation = dynamic_cast<DistributedMesh &>(*mesh.triangulation);
  for (const double most : {3., 4.})
    {
      for (const auto &cell : triangulation.active_cell_iterators())
        {
          cell->clear_refine_flag();
          cell->clear_coarsen_flag();
          const Point<2> p = cell->center();
          if (cell->is_locally_owned() && cell->level() == 1 && p[0] < 1. &&
              p[1] > 1. && p[1] < 2. && 2. * p[0] + p[1] < most)
            cell->set_coarsen_flag();
        }
      const bool any = agree_on_flags(triangulation);
      print(std::string("a mesh with other cells: ") + (any ? "yes" : "no"));
      print_flags(triangulation);
    }
}
