#include <stickslip/adaptivity/error_estimate.h>

#include <stickslip/adaptivity/linear_moduli.h>

#include <deal.II/base/mpi.h>

#include <deal.II/grid/grid_tools.h>

#include <cmath>
#include <numeric>
#include <vector>

namespace stickslip
{
  namespace
  {
    /// Strains below this part of what the displacements would be over the
    /// whole model are what is left of rigid motions.
    constexpr double strain_of_roundoff = 1e-8;



    /// Of each body, over the cells of all ranks.
    struct StressNorms
    {
      std::vector<double> squares;   ///< int sigma : C^-1 : sigma
      std::vector<double> stiffness; ///< int 2 mu, the square of a strain of 1
    };



    /// Collective.
    template <int dim>
    StressNorms
    norms_of_stress(ContactProblem<dim> &problem)
    {
      const LinearModuliOf<dim>       moduli(problem);
      const Bodies                   &bodies = problem.bodies();
      std::vector<MaterialState<dim>> states;
      StressNorms norms = {std::vector<double>(bodies.bodies.size(), 0.),
                           std::vector<double>(bodies.bodies.size(), 0.)};
      for (const auto &cell :
           problem.layout().dof_handler.active_cell_iterators())
        if (cell->is_locally_owned() && moduli.is_deformable(cell))
          {
            const unsigned int body = bodies.body_of(cell->material_id());
            problem.solid().evaluate_point_states(
              cell, problem.ghosted_displacement(), states);
            for (const auto &state : states)
              {
                norms.squares[body] +=
                  moduli.of(cell).square(state.cauchy_stress) * state.JxW;
                norms.stiffness[body] += 2. * moduli.of(cell).shear * state.JxW;
              }
          }
      const MPI_Comm communicator =
        problem.layout().dof_handler.get_communicator();
      for (auto *sums : {&norms.squares, &norms.stiffness})
        {
          const std::vector<double> of_this_rank = *sums;
          Utilities::MPI::sum(of_this_rank, communicator, *sums);
        }
      return norms;
    }



    /// Whether bodies have moved and nothing else: an estimate would be one of
    /// roundoff, and different on each number of ranks. Collective.
    template <int dim>
    bool
    is_unstrained(const StressNorms     &norms,
                  ContactProblem<dim>   &problem,
                  const LA::BlockVector &x)
    {
      const auto &dofs = problem.layout().dof_handler;
      const auto  box =
        GridTools::compute_bounding_box(dofs.get_triangulation());
      const auto [lowest, highest] = box.get_boundary_points();
      const double size =
        Utilities::MPI::max(lowest.distance(highest), dofs.get_communicator());
      const double roundoff =
        strain_of_roundoff * x.block(0).linfty_norm() / size;
      for (unsigned int body = 0; body < norms.squares.size(); ++body)
        if (norms.squares[body] > roundoff * roundoff * norms.stiffness[body])
          return false;
      return true;
    }



    /// To 20 bits: cells that are alike by symmetry then have the same
    /// indicators, and so the same flags on any number of ranks.
    Vector<double>
    rounded(Vector<double> values)
    {
      for (double &value : values)
        {
          int          exponent = 0;
          const double fraction = std::frexp(value, &exponent);
          value =
            std::ldexp(std::round(std::ldexp(fraction, 20)), exponent - 20);
        }
      return values;
    }
  } // namespace



  double
  ErrorEstimate::relative() const
  {
    return error > 0. ? error / energy_norm : 0.;
  }



  ErrorEstimate
  estimate_of(const Vector<double> &indicators,
              const bool            is_rule,
              const double          energy_norm,
              const MPI_Comm       &communicator)
  {
    double sum = 0.; // over ghosts, too: they have zeros
    for (const double square : indicators)
      sum += square;
    sum = Utilities::MPI::sum(sum, communicator);
    return {indicators,
            is_rule,
            is_rule ? 0. : std::sqrt(sum),
            energy_norm,
            is_rule ? sum : 0.};
  }



  template <int dim>
  ErrorEstimate
  estimate_error(const ErrorEstimator<dim> &estimator,
                 ContactProblem<dim>       &problem,
                 const LA::BlockVector     &x)
  {
    const StressNorms norms = norms_of_stress(problem);
    const bool        says_nothing =
      !estimator.is_rule() && is_unstrained(norms, problem, x);
    Vector<double> indicators = rounded(estimator.indicators(problem, x));
    if (says_nothing)
      indicators = 0.;
    const double square =
      std::accumulate(norms.squares.begin(), norms.squares.end(), 0.);
    return estimate_of(indicators,
                       estimator.is_rule(),
                       says_nothing ? 0. : std::sqrt(square),
                       problem.layout().dof_handler.get_communicator());
  }

  template ErrorEstimate
  estimate_error(const ErrorEstimator<2> &,
                 ContactProblem<2> &,
                 const LA::BlockVector &);
  template ErrorEstimate
  estimate_error(const ErrorEstimator<3> &,
                 ContactProblem<3> &,
                 const LA::BlockVector &);
} // namespace stickslip
