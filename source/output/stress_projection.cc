#include <stickslip/output/stress_projection.h>

#include <deal.II/base/quadrature_lib.h>

#include <deal.II/fe/fe_dgq.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_values.h>

#include <deal.II/lac/full_matrix.h>

#include <cmath>

namespace stickslip
{
  namespace
  {
    using TensorValues = std::vector<SymmetricTensor<2, 3>>;

    /// (int N_i N_j)^-1 int N_j q: nodal values of the projection on one cell.
    template <int dim>
    FullMatrix<double>
    cell_projection_matrix(const FEValues<dim> &fe_values)
    {
      const unsigned int n_nodes  = fe_values.dofs_per_cell;
      const unsigned int n_points = fe_values.n_quadrature_points;

      FullMatrix<double> mass(n_nodes, n_nodes), load(n_nodes, n_points);
      for (unsigned int q = 0; q < n_points; ++q)
        for (unsigned int i = 0; i < n_nodes; ++i)
          {
            load(i, q) = fe_values.shape_value(i, q) * fe_values.JxW(q);
            for (unsigned int j = 0; j < n_nodes; ++j)
              mass(i, j) += load(i, q) * fe_values.shape_value(j, q);
          }
      mass.gauss_jordan();
      FullMatrix<double> projection(n_nodes, n_points);
      mass.mmult(projection, load);
      return projection;
    }

    SymmetricTensor<2, 3>
    apply_row(const FullMatrix<double> &projection,
              const unsigned int        node,
              const TensorValues       &values)
    {
      AssertDimension(values.size(), projection.n());
      SymmetricTensor<2, 3> result;
      for (unsigned int q = 0; q < values.size(); ++q)
        result += projection(node, q) * values[q];
      return result;
    }
  } // namespace



  double
  von_mises_stress(const SymmetricTensor<2, 3> &stress)
  {
    return std::sqrt(1.5) * deviator(stress).norm();
  }



  template <int dim>
  StressProjection<dim>::StressProjection(
    const Mapping<dim>        &mapping,
    const DoFHandler<dim>     &displacement_dof_handler,
    const StressFunction<dim> &stresses)
    : dof_handler(displacement_dof_handler.get_triangulation())
  {
    const FE_DGQ<dim> scalar_element(1);
    dof_handler.distribute_dofs(FESystem<dim>(scalar_element, names().size()));
    const FiniteElement<dim> &element = dof_handler.get_fe();
    values.reinit(dof_handler.locally_owned_dofs(),
                  dof_handler.get_communicator());

    const QGauss<dim> quadrature(displacement_dof_handler.get_fe().degree + 1);
    FEValues<dim>     fe_values(mapping,
                            scalar_element,
                            quadrature,
                            update_values | update_JxW_values);

    TensorValues                         stress, strain;
    std::vector<types::global_dof_index> dof_indices(element.n_dofs_per_cell());
    for (const auto &cell : displacement_dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          stress.clear();
          strain.clear();
          stresses(cell, stress, strain);

          fe_values.reinit(typename Triangulation<dim>::cell_iterator(cell));
          const FullMatrix<double> projection =
            cell_projection_matrix(fe_values);
          typename DoFHandler<dim>::active_cell_iterator(
            &dof_handler.get_triangulation(),
            cell->level(),
            cell->index(),
            &dof_handler)
            ->get_dof_indices(dof_indices);

          for (unsigned int node = 0; node < projection.m(); ++node)
            {
              const std::vector<double> node_values =
                stress.empty()
                  ? std::vector<double>(names().size(), 0.)
                  : components(apply_row(projection, node, stress),
                               apply_row(projection, node, strain));
              for (unsigned int c = 0; c < node_values.size(); ++c)
                values(
                  dof_indices[element.component_to_system_index(c, node)]) =
                  node_values[c];
            }
        }
    values.compress(VectorOperation::insert);
  }



  template <int dim>
  const DoFHandler<dim> &
  StressProjection<dim>::get_dof_handler() const
  {
    return dof_handler;
  }



  template <int dim>
  const LA::Vector &
  StressProjection<dim>::get_values() const
  {
    return values;
  }



  template <int dim>
  std::vector<std::string>
  StressProjection<dim>::names()
  {
    std::vector<std::string> result(dim * dim, "cauchy_stress");
    result.insert(result.end(), dim * dim, "strain");
    result.push_back("von_mises_stress");
    if (dim == 2)
      {
        result.push_back("cauchy_stress_zz");
        result.push_back("strain_zz");
      }
    return result;
  }



  template <int dim>
  std::vector<DataComponentInterpretation::DataComponentInterpretation>
  StressProjection<dim>::interpretations()
  {
    std::vector<DataComponentInterpretation::DataComponentInterpretation>
      result(names().size(), DataComponentInterpretation::component_is_scalar);
    std::fill_n(result.begin(),
                2 * dim * dim,
                DataComponentInterpretation::component_is_part_of_tensor);
    return result;
  }



  template <int dim>
  std::vector<double>
  StressProjection<dim>::components(const SymmetricTensor<2, 3> &stress,
                                    const SymmetricTensor<2, 3> &strain)
  {
    std::vector<double> result;
    for (const SymmetricTensor<2, 3> &tensor : {stress, strain})
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = 0; j < dim; ++j)
          result.push_back(tensor[i][j]);
    result.push_back(von_mises_stress(stress));
    if (dim == 2)
      {
        result.push_back(stress[2][2]);
        result.push_back(strain[2][2]);
      }
    return result;
  }



  template class StressProjection<2>;
  template class StressProjection<3>;
} // namespace stickslip
