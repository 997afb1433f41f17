#include <stickslip/adaptivity/cell_stresses.h>

#include <stickslip/mesh/reference_cells.h>

#include <deal.II/fe/fe_dgq.h>
#include <deal.II/fe/fe_simplex_p.h>

#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <optional>

namespace stickslip
{
  namespace
  {
    /// Polynomials for stresses of displacements of degree @p p.
    template <int dim>
    std::unique_ptr<FiniteElement<dim>>
    stress_space(const ReferenceCell &cell, const unsigned int p)
    {
      if (cell.is_simplex())
        return std::make_unique<FE_SimplexDGP<dim>>(std::max(1U, p - 1));
      return std::make_unique<FE_DGQ<dim>>(p);
    }



    /// (A^T A)^-1 A^T with A_qi = N_i(x_q): nodal values of the polynomial that
    /// is nearest to values at the points, or goes through them.
    template <int dim>
    FullMatrix<double>
    interpolation_matrix(const FiniteElement<dim> &element,
                         const Quadrature<dim>    &points)
    {
      const unsigned int n_nodes = element.n_dofs_per_cell();
      FullMatrix<double> result(n_nodes, points.size());
      if (points.size() == 1) // the stress is constant
        {
          for (unsigned int i = 0; i < n_nodes; ++i)
            result(i, 0) = 1.;
          return result;
        }
      FullMatrix<double> A(points.size(), n_nodes), squares(n_nodes, n_nodes);
      for (unsigned int q = 0; q < points.size(); ++q)
        for (unsigned int i = 0; i < n_nodes; ++i)
          A(q, i) = element.shape_value(i, points.point(q));
      A.Tmmult(squares, A);
      squares.gauss_jordan();
      squares.mTmult(result, A);
      return result;
    }



    std::vector<double>
    pack(const std::vector<Tensor<2, 3>> &tensors)
    {
      std::vector<double> numbers;
      for (const Tensor<2, 3> &tensor : tensors)
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int j = 0; j < 3; ++j)
            numbers.push_back(tensor[i][j]);
      return numbers;
    }



    std::vector<Tensor<2, 3>>
    unpack(const std::vector<double> &numbers)
    {
      std::vector<Tensor<2, 3>> tensors(numbers.size() / 9);
      for (unsigned int k = 0; k < numbers.size(); ++k)
        tensors[k / 9][k % 9 / 3][k % 3] = numbers[k];
      return tensors;
    }
  } // namespace



  template <int dim>
  CellStresses<dim>::CellStresses(ContactProblem<dim> &problem,
                                  const StressMeasure  measure)
    : element(
        stress_space<dim>(problem.layout().cells(), problem.layout().degree()))
    , nodal_values(
        problem.layout().dof_handler.get_triangulation().n_active_cells())
  {
    const DoFHandler<dim>   &dof_handler = problem.layout().dof_handler;
    const FullMatrix<double> to_nodes =
      interpolation_matrix(*element,
                           cell_quadrature<dim>(problem.layout().cells(),
                                                problem.layout().degree()));
    std::vector<MaterialState<dim>> states;
    for (const auto &cell : dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          problem.solid().evaluate_point_states(cell,
                                                problem.ghosted_displacement(),
                                                states);
          auto &values = nodal_values[cell->active_cell_index()];
          if (!states.empty())
            values.resize(element->n_dofs_per_cell());
          for (unsigned int i = 0; i < values.size(); ++i)
            for (unsigned int q = 0; q < states.size(); ++q)
              values[i] +=
                to_nodes(i, q) * (measure == StressMeasure::nominal
                                    ? states[q].nominal_stress
                                    : Tensor<2, 3>(states[q].cauchy_stress));
        }
    GridTools::exchange_cell_data_to_ghosts<std::vector<double>,
                                            DoFHandler<dim>>(
      dof_handler,
      [this](const auto &cell) {
        return std::optional<std::vector<double>>(pack(of(cell)));
      },
      [this](const auto &cell, const std::vector<double> &numbers) {
        nodal_values[cell->active_cell_index()] = unpack(numbers);
      });
  }

  template class CellStresses<2>;
  template class CellStresses<3>;
} // namespace stickslip
