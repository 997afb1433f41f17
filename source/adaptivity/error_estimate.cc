#include <stickslip/adaptivity/error_estimate.h>

#include <stickslip/adaptivity/linear_moduli.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <vector>

namespace stickslip
{
  namespace
  {
    /// int sigma : C^-1 : sigma over the cells of this rank.
    template <int dim>
    double
    square_of_stress(ContactProblem<dim> &problem)
    {
      const LinearModuliOf<dim>       moduli(problem);
      std::vector<MaterialState<dim>> states;
      double                          sum = 0.;
      for (const auto &cell :
           problem.layout().dof_handler.active_cell_iterators())
        if (cell->is_locally_owned() && moduli.is_deformable(cell))
          {
            problem.solid().evaluate_point_states(
              cell, problem.ghosted_displacement(), states);
            for (const auto &state : states)
              sum += moduli.of(cell).square(state.cauchy_stress) * state.JxW;
          }
      return sum;
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
    return {indicators, is_rule, is_rule ? 0. : std::sqrt(sum), energy_norm};
  }



  template <int dim>
  ErrorEstimate
  estimate_error(const ErrorEstimator<dim> &estimator,
                 ContactProblem<dim>       &problem,
                 const LA::BlockVector     &x)
  {
    const MPI_Comm communicator =
      problem.layout().dof_handler.get_communicator();
    return estimate_of(rounded(estimator.indicators(problem, x)),
                       estimator.is_rule(),
                       std::sqrt(Utilities::MPI::sum(square_of_stress(problem),
                                                     communicator)),
                       communicator);
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
