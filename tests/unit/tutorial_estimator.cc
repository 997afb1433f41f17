// An estimator of one's own: cells with a stress above a limit. The manual
// shows it (doc/developers.md).

#include "print.h"
#include "solved_case.h"

#include <stickslip/adaptivity/error_estimator.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <string>
#include <vector>

using namespace stickslip;

namespace
{
  // [estimator]
  /// Rule: the deformable cells in which the von Mises stress exceeds a limit.
  template <int dim>
  class StressAbove : public ErrorEstimator<dim>
  {
  public:
    /// @p limit [stress]
    explicit StressAbove(const double limit)
      : limit(limit)
    {}

    Vector<double>
    indicators(ContactProblem<dim> &problem,
               const LA::BlockVector & /*x*/) const override
    {
      const auto    &dof_handler = problem.layout().dof_handler;
      Vector<double> ones(dof_handler.get_triangulation().n_active_cells());
      std::vector<MaterialState<dim>> states; // none on rigid bodies
      for (const auto &cell : dof_handler.active_cell_iterators())
        if (cell->is_locally_owned())
          {
            problem.solid().evaluate_point_states(
              cell, problem.ghosted_displacement(), states);
            for (const auto &state : states)
              if (std::sqrt(1.5) * deviator(state.cauchy_stress).norm() > limit)
                ones[cell->active_cell_index()] = 1.;
          }
      return ones;
    }

    bool
    is_rule() const override
    {
      return true; // ones, and no errors
    }

  private:
    const double limit;
  };
  // [end of estimator]



  /// A cantilever of 10 cells, bent by a traction at its end.
  const std::string cantilever = R"(
    set Dimension = 2
    subsection Bodies
      subsection beam
        set Generator = subdivided_hyper_rectangle
        set Arguments = 10, 1 : 0, 0 : 10, 1 : true
        set Material = steel
      end
    end
    subsection Materials
      subsection steel
        set Law = linear elastic
        set Young's modulus = 1000
      end
    end
    subsection Boundary conditions
      subsection hold
        set Body = beam
        set Boundary = 0
        set Type = displacement
        set Value = 0; 0
      end
      subsection bend
        set Body = beam
        set Boundary = 1
        set Type = traction
        set Value = 0; 1
      end
    end
  )";
} // namespace



int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  SolvedCase<2>                    solved(cantilever, 1);
  const auto                       n_above = [&solved](const double limit) {
    const ErrorEstimate estimate =
      estimate_error(StressAbove<2>(limit), solved.problem, solved.x);
    return Utilities::MPI::sum(estimate.indicators.l1_norm(), MPI_COMM_WORLD);
  };
  print("all cells exceed zero", n_above(0.) == 10.);
  print("more exceed a small limit than a large one",
        n_above(5.) > n_above(15.));
  print("none exceeds a very large one", n_above(1e4) == 0.);
}
