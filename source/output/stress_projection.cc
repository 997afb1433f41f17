#include <stickslip/output/stress_projection.h>

#include <stickslip/mesh/by_kind.h>
#include <stickslip/mesh/reference_cells.h>

#include <deal.II/fe/fe_values.h>

#include <deal.II/lac/full_matrix.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace stickslip
{
  double
  von_mises_stress(const SymmetricTensor<2, 3> &stress)
  {
    return std::sqrt(1.5) * deviator(stress).norm();
  }



  namespace
  {
    /// (int N_i N_j)^-1 int N_j q: nodal values of the projection on one cell.
    template <int dim>
    FullMatrix<double>
    cell_projection_matrix(const FEValues<dim> &fe_values)
    {
      const unsigned int n_nodes  = fe_values.dofs_per_cell;
      const unsigned int n_points = fe_values.n_quadrature_points;
      FullMatrix<double> projection(n_nodes, n_points);
      if (n_points == 1) // the stress is constant
        {
          for (unsigned int i = 0; i < n_nodes; ++i)
            projection(i, 0) = 1.;
          return projection;
        }

      FullMatrix<double> mass(n_nodes, n_nodes), load(n_nodes, n_points);
      for (unsigned int q = 0; q < n_points; ++q)
        for (unsigned int i = 0; i < n_nodes; ++i)
          {
            load(i, q) = fe_values.shape_value(i, q) * fe_values.JxW(q);
            for (unsigned int j = 0; j < n_nodes; ++j)
              mass(i, j) += load(i, q) * fe_values.shape_value(j, q);
          }
      mass.gauss_jordan();
      mass.mmult(projection, load);
      return projection;
    }

    /// Value at a node from those at the points, which are numbers, tensors or
    /// (by @p value_at) a member of something.
    template <typename Result, typename ValueAt>
    Result
    apply_row(const FullMatrix<double> &projection,
              const unsigned int        node,
              const ValueAt            &value_at)
    {
      Result result = Result();
      for (unsigned int q = 0; q < projection.n(); ++q)
        result += projection(node, q) * value_at(q);
      return result;
    }



    /// Components of stress and strain, in the order of
    /// StressProjection::names().
    template <int dim>
    void
    get_components(const SymmetricTensor<2, 3> &stress,
                   const SymmetricTensor<2, 3> &strain,
                   std::vector<double>         &result)
    {
      result.clear();
      for (const SymmetricTensor<2, 3> *tensor : {&stress, &strain})
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int j = 0; j < 3; ++j)
            result.push_back((*tensor)[i][j]);
      result.push_back(von_mises_stress(stress));
      if (dim == 2)
        {
          result.push_back(stress[2][2]);
          result.push_back(strain[2][2]);
        }
    }



    /// All components of a node: those of stress and strain, then the history.
    template <int dim>
    void
    get_node_components(const FullMatrix<double>                   &projection,
                        const unsigned int                          node,
                        const typename MaterialFields<dim>::Values &values,
                        std::vector<double>                        &result)
    {
      AssertDimension(values.cauchy_stress.size(), projection.n());
      const auto tensor = [&](const std::vector<SymmetricTensor<2, 3>> &list) {
        return apply_row<SymmetricTensor<2, 3>>(
          projection, node, [&](const unsigned int q) { return list[q]; });
      };
      get_components<dim>(tensor(values.cauchy_stress),
                          tensor(values.strain),
                          result);
      for (unsigned int h = 0; h < values.history[0].size(); ++h)
        result.push_back(
          apply_row<double>(projection, node, [&](const unsigned int q) {
            return values.history[q][h];
          }));
    }
  } // namespace



  template <int dim>
  StressProjection<dim>::StressProjection(
    const hp::MappingCollection<dim> &mapping,
    const DoFHandler<dim>            &displacement_dof_handler,
    const MaterialFields<dim>        &material)
    : history_names(material.history_names)
    , dof_handler(displacement_dof_handler.get_triangulation())
  {
    hp::FECollection<dim> elements;
    for (const auto &displacement :
         displacement_dof_handler.get_fe_collection())
      elements.push_back(
        *make_discontinuous_element<dim>(displacement.reference_cell()));
    distribute_dofs(elements, dof_handler);
    const IndexSet &owned = dof_handler.locally_owned_dofs();
    fields.assign(names().size(), Field(owned, dof_handler.get_communicator()));

    const ByKind<FEValues<dim>> values_of(
      elements,
      [&](const FiniteElement<dim> &element, const unsigned int kind) {
        return std::make_unique<FEValues<dim>>(
          mapping[kind],
          element,
          cell_quadrature<dim>(element.reference_cell(),
                               displacement_dof_handler.get_fe().degree),
          update_values | update_JxW_values);
      });

    std::vector<types::global_dof_index> dof_indices;
    std::vector<double>                  node_values(fields.size());
    for (const auto &cell : displacement_dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          const auto cell_values = material.evaluate(cell);

          FEValues<dim> &fe_values = values_of[cell];
          fe_values.reinit(typename Triangulation<dim>::cell_iterator(cell));
          const FullMatrix<double> projection =
            cell_projection_matrix(fe_values);
          dof_indices.resize(fe_values.dofs_per_cell);
          typename DoFHandler<dim>::active_cell_iterator(
            &dof_handler.get_triangulation(),
            cell->level(),
            cell->index(),
            &dof_handler)
            ->get_dof_indices(dof_indices);

          std::fill(node_values.begin(), node_values.end(), 0.);
          for (unsigned int node = 0; node < projection.m(); ++node)
            {
              if (!cell_values.cauchy_stress.empty())
                get_node_components<dim>(projection,
                                         node,
                                         cell_values,
                                         node_values);
              const auto i = owned.index_within_set(dof_indices[node]);
              for (unsigned int c = 0; c < node_values.size(); ++c)
                fields[c].local_element(i) = node_values[c];
            }
        }
  }



  template <int dim>
  const DoFHandler<dim> &
  StressProjection<dim>::get_dof_handler() const
  {
    return dof_handler;
  }



  template <int dim>
  const std::vector<typename StressProjection<dim>::Field> &
  StressProjection<dim>::get_fields() const
  {
    return fields;
  }



  template <int dim>
  void
  StressProjection<dim>::clear_fields()
  {
    fields.clear();
  }



  template <int dim>
  std::vector<std::string>
  StressProjection<dim>::names() const
  {
    std::vector<std::string> result(9, "cauchy_stress");
    result.insert(result.end(), 9, "strain");
    result.push_back("von_mises_stress");
    if (dim == 2)
      {
        result.push_back("cauchy_stress_zz");
        result.push_back("strain_zz");
      }
    result.insert(result.end(), history_names.begin(), history_names.end());
    return result;
  }



  template class StressProjection<2>;
  template class StressProjection<3>;
} // namespace stickslip
