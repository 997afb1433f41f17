#include <stickslip/adaptivity/kelly_estimator.h>

#include <stickslip/adaptivity/linear_moduli.h>

#include <stickslip/mesh/reference_cells.h>

#include <deal.II/numerics/error_estimator.h>

namespace stickslip
{
  template <int dim>
  Vector<double>
  KellyEstimator<dim>::indicators(ContactProblem<dim> &problem,
                                  const LA::BlockVector & /*x*/) const
  {
    const DofLayout<dim> &dofs          = problem.layout();
    const auto           &triangulation = dofs.dof_handler.get_triangulation();
    const LinearModuliOf<dim> moduli(problem);

    Vector<float> jumps(triangulation.n_active_cells());
    KellyErrorEstimator<dim>::estimate(
      dofs.mapping[0],
      dofs.dof_handler,
      gauss_quadrature<dim - 1>(faces_of<dim>(dofs.cells()), dofs.degree() + 1),
      {},
      problem.ghosted_displacement(),
      jumps);

    Vector<double> squares(triangulation.n_active_cells());
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned() && moduli.is_deformable(cell))
        {
          const double jump = jumps[cell->active_cell_index()];
          squares[cell->active_cell_index()] =
            2. * moduli.of(cell).shear * jump * jump *
            problem.bodies().cross_section.circumference(
              Tensor<1, dim>(cell->center()));
        }
    return squares;
  }

  template class KellyEstimator<2>;
  template class KellyEstimator<3>;
} // namespace stickslip
