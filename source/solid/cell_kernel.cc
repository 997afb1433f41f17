#include <stickslip/solid/cell_kernel.h>

#include <stickslip/solid/tangent_products.h>

#include <algorithm>

namespace stickslip
{
  template <int dim>
  ElementArrays<dim>::ElementArrays(const FiniteElement<dim> &fe,
                                    const CrossSection       &cross_section)
    : internal(fe.n_dofs_per_cell())
    , external(fe.n_dofs_per_cell())
    , n_nodes(fe.base_element(0).n_dofs_per_cell())
    , cross_section(cross_section)
    , dof_of_node(fe.n_dofs_per_cell())
    , values(fe.n_dofs_per_cell())
    , nodal_displacements(fe.n_dofs_per_cell())
    , gradients(fe.n_dofs_per_cell())
    , hoop(n_nodes)
    , stiffness(fe.n_dofs_per_cell() * fe.n_dofs_per_cell())
    , mean_derivative(fe.n_dofs_per_cell())
    , mean_column(fe.n_dofs_per_cell())
    , mean_row(fe.n_dofs_per_cell())
  {
    AssertDimension(fe.n_dofs_per_cell(), dim * n_nodes);
    for (unsigned int a = 0; a < n_nodes; ++a)
      for (unsigned int i = 0; i < dim; ++i)
        dof_of_node[a * dim + i] = fe.component_to_system_index(i, a);
  }



  template <int dim>
  void
  ElementArrays<dim>::reinit(
    const LA::Vector                           &u,
    const std::vector<types::global_dof_index> &dof_indices)
  {
    u.extract_subvector_to(dof_indices.begin(),
                           dof_indices.end(),
                           values.begin());
    for (unsigned int a = 0; a < n_nodes; ++a)
      for (unsigned int i = 0; i < dim; ++i)
        nodal_displacements[i * n_nodes + a] = values[dof_of_node[a * dim + i]];
    internal = 0.;
    external = 0.;
    std::fill(stiffness.begin(), stiffness.end(), 0.);
  }



  template <int dim>
  double
  ElementArrays<dim>::measure(const FEValuesBase<dim> &fe_values,
                              const unsigned int       q) const
  {
    return cross_section.is_axisymmetric
             ? cross_section.circumference(fe_values.quadrature_point(q)) *
                 fe_values.JxW(q)
             : fe_values.JxW(q);
  }



  template <int dim>
  void
  ElementArrays<dim>::set_gradients(const FEValuesBase<dim> &fe_values,
                                    const unsigned int       q)
  {
    for (unsigned int a = 0; a < n_nodes; ++a)
      {
        const Tensor<1, dim> &gradient = fe_values.shape_grad(a, q);
        for (unsigned int J = 0; J < dim; ++J)
          gradients[J * n_nodes + a] = gradient[J];
      }
    for (unsigned int a = 0; cross_section.is_axisymmetric && a < n_nodes; ++a)
      hoop[a] =
        cross_section.is_on_axis(fe_values.quadrature_point(q))
          ? gradients[a]
          : fe_values.shape_value(a, q) / fe_values.quadrature_point(q)[0];
  }



  template <int dim>
  Tensor<2, 3>
  ElementArrays<dim>::deformation_gradient() const
  {
    Tensor<2, 3> F;
    for (unsigned int i = 0; i < 3; ++i)
      F[i][i] = 1.;
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int J = 0; J < dim; ++J)
        {
          const double *u_i = nodal_displacements.data() + i * n_nodes;
          const double *G_J = gradients.data() + J * n_nodes;
          double        sum = 0.;
          for (unsigned int a = 0; a < n_nodes; ++a)
            sum += u_i[a] * G_J[a];
          F[i][J] += sum;
        }
    if (cross_section.is_axisymmetric)
      for (unsigned int a = 0; a < n_nodes; ++a)
        F[2][2] += nodal_displacements[a] * hoop[a];
    return F;
  }



  template <int dim>
  Tensor<1, dim>
  ElementArrays<dim>::displacement(const FEValuesBase<dim> &fe_values,
                                   const unsigned int       q) const
  {
    Tensor<1, dim> u;
    for (unsigned int a = 0; a < n_nodes; ++a)
      for (unsigned int i = 0; i < dim; ++i)
        u[i] +=
          nodal_displacements[i * n_nodes + a] * fe_values.shape_value(a, q);
    return u;
  }



  template <int dim>
  void
  ElementArrays<dim>::add_stress(const Tensor<2, 3> &P, const double JxW)
  {
    for (unsigned int a = 0; a < n_nodes; ++a)
      for (unsigned int i = 0; i < dim; ++i)
        internal(dof_of_node[a * dim + i]) += contracted(P, a, i) * JxW;
  }



  template <int dim>
  void
  ElementArrays<dim>::add_stress_tangent(const Tensor<4, 3> &dP_dF,
                                         const double        JxW)
  {
    // As plain numbers once per point, with the weight.
    double A[dim][dim][dim][dim];
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int J = 0; J < dim; ++J)
        for (unsigned int k = 0; k < dim; ++k)
          for (unsigned int L = 0; L < dim; ++L)
            A[i][J][k][L] = dP_dF[i][J][k][L] * JxW;
    add_tangent_products(n_nodes, gradients.data(), A, stiffness.data());
    if (cross_section.is_axisymmetric)
      add_hoop_tangent(dP_dF, JxW);
  }



  template <int dim>
  void
  ElementArrays<dim>::add_hoop_tangent(const Tensor<4, 3> &dP_dF,
                                       const double        JxW)
  {
    for (unsigned int a = 0; a < n_nodes; ++a)
      for (unsigned int i = 0; i < dim; ++i)
        {
          double dP_dF_33 = i == 0 ? hoop[a] * dP_dF[2][2][2][2] : 0.;
          for (unsigned int J = 0; J < dim; ++J)
            dP_dF_33 += gradients[J * n_nodes + a] * dP_dF[i][J][2][2];
          double *const row = stiffness_row(a, i);
          for (unsigned int b = 0; b < n_nodes; ++b)
            row[b] += dP_dF_33 * hoop[b] * JxW;
          for (unsigned int L = 0; i == 0 && L < dim; ++L)
            for (unsigned int k = 0; k < dim; ++k)
              for (unsigned int b = 0; b < n_nodes; ++b)
                row[k * n_nodes + b] += hoop[a] * dP_dF[2][2][k][L] *
                                        gradients[L * n_nodes + b] * JxW;
        }
  }



  template <int dim>
  void
  ElementArrays<dim>::clear_mean_dilatation()
  {
    std::fill(mean_derivative.begin(), mean_derivative.end(), 0.);
    std::fill(mean_column.begin(), mean_column.end(), 0.);
    std::fill(mean_row.begin(), mean_row.end(), 0.);
    mean_square = 0.;
  }



  template <int dim>
  void
  ElementArrays<dim>::add_contracted(const Tensor<2, 3>  &X,
                                     const double         weight,
                                     std::vector<double> &vector) const
  {
    for (unsigned int a = 0; a < n_nodes; ++a)
      for (unsigned int i = 0; i < dim; ++i)
        vector[a * dim + i] += contracted(X, a, i) * weight;
  }



  template <int dim>
  void
  ElementArrays<dim>::add_to_mean_dilatation(const Tensor<2, 3> &X,
                                             const double        weight)
  {
    add_contracted(X, weight, mean_derivative);
  }



  template <int dim>
  void
  ElementArrays<dim>::add_mean_pressure(const double p, const double JxW)
  {
    for (unsigned int n = 0; n < mean_derivative.size(); ++n)
      internal(dof_of_node[n]) += p * JxW * mean_derivative[n];
  }



  template <int dim>
  void
  ElementArrays<dim>::add_mean_dilatation_response(const Tensor<2, 3> &column,
                                                   const Tensor<2, 3> &row,
                                                   const double        square,
                                                   const double        JxW)
  {
    add_contracted(column, JxW, mean_column);
    add_contracted(row, JxW, mean_row);
    mean_square += square * JxW;
  }



  template <int dim>
  void
  ElementArrays<dim>::add_mean_dilatation_tangent()
  {
    for (unsigned int a = 0; a < n_nodes; ++a)
      for (unsigned int i = 0; i < dim; ++i)
        {
          const double m   = mean_derivative[a * dim + i];
          const double c   = mean_column[a * dim + i] + mean_square * m;
          double      *row = stiffness_row(a, i);
          for (unsigned int k = 0; k < dim; ++k)
            for (unsigned int b = 0; b < n_nodes; ++b)
              row[k * n_nodes + b] +=
                c * mean_derivative[b * dim + k] + m * mean_row[b * dim + k];
        }
  }



  template <int dim>
  void
  ElementArrays<dim>::add_load(const FEValuesBase<dim> &fe_values,
                               const unsigned int       q,
                               const Tensor<1, dim>    &t,
                               Vector<double>          &force) const
  {
    const double JxW = measure(fe_values, q);
    for (unsigned int a = 0; a < n_nodes; ++a)
      {
        const double weight = fe_values.shape_value(a, q) * JxW;
        for (unsigned int i = 0; i < dim; ++i)
          force(dof_of_node[a * dim + i]) += t[i] * weight;
      }
  }



  template <int dim>
  void
  ElementArrays<dim>::add_load_gradient_tangent(
    const FEValuesBase<dim> &fe_values,
    const unsigned int       q,
    const Tensor<3, dim>    &dt_dF,
    const Tensor<1, dim>    &dt_dF_33)
  {
    const double JxW = measure(fe_values, q);
    for (unsigned int a = 0; a < n_nodes; ++a)
      {
        const double weight = fe_values.shape_value(a, q) * JxW;
        if (weight == 0.)
          continue; // not a node of this face
        for (unsigned int i = 0; i < dim; ++i)
          {
            double *const row = stiffness_row(a, i);
            for (unsigned int k = 0; k < dim; ++k)
              for (unsigned int L = 0; L < dim; ++L)
                for (unsigned int b = 0; b < n_nodes; ++b)
                  row[k * n_nodes + b] +=
                    weight * dt_dF[i][k][L] * gradients[L * n_nodes + b];
            for (unsigned int b = 0; b < n_nodes; ++b)
              row[b] += weight * dt_dF_33[i] * hoop[b];
          }
      }
  }



  template <int dim>
  void
  ElementArrays<dim>::add_load_tangent(const FEValuesBase<dim> &fe_values,
                                       const unsigned int       q,
                                       const Tensor<2, dim>    &dt_du)
  {
    const double JxW = measure(fe_values, q);
    for (unsigned int a = 0; a < n_nodes; ++a)
      {
        const double weight = fe_values.shape_value(a, q) * JxW;
        for (unsigned int i = 0; i < dim; ++i)
          for (unsigned int k = 0; k < dim; ++k)
            {
              double *block = stiffness_row(a, i) + k * n_nodes;
              for (unsigned int b = 0; b < n_nodes; ++b)
                block[b] += weight * dt_du[i][k] * fe_values.shape_value(b, q);
            }
      }
  }



  template <int dim>
  void
  ElementArrays<dim>::copy_stiffness(FullMatrix<double> &matrix) const
  {
    const double *entry = stiffness.data();
    for (unsigned int a = 0; a < n_nodes; ++a)
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int k = 0; k < dim; ++k)
          for (unsigned int b = 0; b < n_nodes; ++b, ++entry)
            matrix(dof_of_node[a * dim + i], dof_of_node[b * dim + k]) = *entry;
  }



  template class ElementArrays<2>;
  template class ElementArrays<3>;
} // namespace stickslip
