#include <stickslip/contact/point/contact_element.h>

#include <vector>

namespace stickslip
{
  namespace
  {
    /// How a local unknown enters the generalized coordinates. Mostly zeros.
    template <int dim>
    using Column = typename GeneralizedCoordinates<dim>::Row;



    template <int dim>
    void
    add_master_columns(const SurfaceFace<dim>         &face,
                       const MasterConfiguration<dim> &configuration,
                       const MasterPoint<dim>         &master,
                       const bool                      with_nodal_normals,
                       Column<dim>                    *columns)
    {
      using G = GeneralizedCoordinates<dim>;
      std::vector<Tensor<2, dim>> D_n_j;
      for (unsigned int j = 0; j < face.n_nodes; ++j)
        {
          const double M_j = master.shape.value[j];
          for (unsigned int c = 0; c < dim; ++c)
            {
              Column<dim> &column = columns[j * dim + c];
              column[G::W + c]    = -M_j;
              for (unsigned int d = 0; d < dim - 1; ++d)
                column[G::C + d * dim + c] = master.shape.gradient[j][d];
            }
          if (!with_nodal_normals || M_j == 0.)
            continue;
          nodal_normal_derivatives(face, configuration, j, D_n_j);
          for (unsigned int k = 0; k < D_n_j.size(); ++k)
            for (unsigned int c = 0; c < dim; ++c)
              for (unsigned int i = 0; i < dim; ++i)
                columns[k * dim + c][G::M + i] += M_j * D_n_j[k][i][c];
        }
    }



    template <int dim>
    std::vector<Column<dim>>
    make_columns(const ContactElement<dim> &element,
                 const MasterPoint<dim>    &master,
                 const bool                 with_nodal_normals)
    {
      using G                    = GeneralizedCoordinates<dim>;
      const auto              &N = element.slave_shape;
      const auto              &L = element.multiplier_shape;
      std::vector<Column<dim>> columns(element.n_dofs(), Column<dim>{});
      for (unsigned int j = 0; j < N.size(); ++j)
        for (unsigned int c = 0; c < dim; ++c)
          {
            columns[j * dim + c][G::W + c] = N[j];
            if (dim == 3)
              columns[j * dim + c][G::E + c] =
                element.point.geometry.direction_gradients[j];
          }
      unsigned int first = N.size() * dim;
      if (element.master != nullptr)
        {
          add_master_columns(*element.master,
                             *element.master_configuration,
                             master,
                             with_nodal_normals,
                             &columns[first]);
          first += element.master->n_stencil_nodes() * dim;
        }
      const unsigned int n_comp = element.n_multiplier_components;
      for (unsigned int l = 0; l < L.size(); ++l)
        {
          columns[first + l * n_comp][G::lambda] = L[l];
          for (unsigned int b = 0; b + 1 < n_comp; ++b)
            for (unsigned int a = 0; a < dim - 1; ++a)
              columns[first + l * n_comp + 1 + b][G::Lambda + a] =
                L[l] * element.point.nodal_rotations[l][a][b];
        }
      return columns;
    }
  } // namespace



  template <int dim>
  unsigned int
  ContactElement<dim>::n_dofs() const
  {
    return slave_shape.size() * dim +
           (master != nullptr ? master->n_stencil_nodes() * dim : 0) +
           multiplier_shape.size() * n_multiplier_components;
  }



  template <int dim>
  Multipliers<dim>
  interpolate_multipliers(const ContactElement<dim> &element,
                          const std::vector<double> &nodal_values)
  {
    const auto        &L      = element.multiplier_shape;
    const unsigned int n_comp = element.n_multiplier_components;
    Multipliers<dim>   values;
    for (unsigned int l = 0; l < L.size(); ++l)
      {
        values.lambda_n += L[l] * nodal_values[l * n_comp];
        for (unsigned int b = 0; b + 1 < n_comp; ++b)
          for (unsigned int a = 0; a < dim - 1; ++a)
            values.Lambda[a] += L[l] * element.point.nodal_rotations[l][a][b] *
                                nodal_values[l * n_comp + 1 + b];
      }
    return values;
  }



  template <int dim>
  void
  local_residual(const ContactElement<dim>    &element,
                 const ContactEvaluation<dim> &state,
                 Vector<double>               &local)
  {
    const auto &N        = element.slave_shape;
    const auto &L        = element.multiplier_shape;
    const auto &response = state.response;
    local                = 0.;
    for (unsigned int j = 0; j < N.size(); ++j)
      for (unsigned int c = 0; c < dim; ++c)
        local[j * dim + c] =
          element.point.geometry.weight * N[j] * response.traction[c];
    unsigned int first = N.size() * dim;
    if (element.master != nullptr)
      {
        const SurfaceFace<dim> &face = *element.master;
        for (unsigned int j = 0; j < face.n_nodes; ++j)
          for (unsigned int c = 0; c < dim; ++c)
            local[first + j * dim + c] = -element.point.geometry.weight *
                                         state.master.shape.value[j] *
                                         response.traction[c];
        first += face.n_stencil_nodes() * dim;
      }
    const unsigned int n_comp = element.n_multiplier_components;
    for (unsigned int l = 0; l < L.size(); ++l)
      {
        local[first + l * n_comp] =
          element.point.geometry.weight * L[l] * response.row_lambda;
        for (unsigned int b = 0; b + 1 < n_comp; ++b)
          for (unsigned int a = 0; a < dim - 1; ++a)
            local[first + l * n_comp + 1 + b] +=
              element.point.geometry.weight * L[l] *
              element.point.nodal_rotations[l][a][b] * response.row_Lambda[a];
      }
  }



  template <int dim>
  void
  local_tangent(const ContactElement<dim>    &element,
                const ContactEvaluation<dim> &state,
                const bool                    with_nodal_normals,
                FullMatrix<double>           &local)
  {
    const auto        &N        = element.slave_shape;
    const auto        &L        = element.multiplier_shape;
    const auto        &response = state.response;
    const unsigned int n_comp   = element.n_multiplier_components;
    const auto         columns =
      make_columns(element, state.master, with_nodal_normals);
    for (unsigned int k = 0; k < columns.size(); ++k)
      {
        Tensor<1, dim>     D_t;
        Tensor<1, dim - 1> D_xi, D_row_Lambda;
        double             D_row_lambda = 0.;
        bool               is_zero      = true;
        for (unsigned int g = 0; g < columns[k].size(); ++g)
          {
            const double coefficient = columns[k][g];
            if (coefficient == 0.)
              continue;
            is_zero = false;
            for (unsigned int i = 0; i < dim; ++i)
              D_t[i] += coefficient * response.D_traction[i][g];
            D_row_lambda += coefficient * response.D_row_lambda[g];
            for (unsigned int d = 0; d < dim - 1; ++d)
              {
                D_xi[d] += coefficient * state.kinematics.D_xi[d][g];
                D_row_Lambda[d] += coefficient * response.D_row_Lambda[d][g];
              }
          }
        if (is_zero) // a point at a node does not know the others of its face
          continue;
        for (unsigned int j = 0; j < N.size(); ++j)
          for (unsigned int c = 0; c < dim; ++c)
            local(j * dim + c, k) =
              element.point.geometry.weight * N[j] * D_t[c];
        unsigned int first = N.size() * dim;
        if (element.master != nullptr)
          {
            // -M_j D t, and t . D(dw) = -t . M_j,alpha D xi^alpha
            const SurfaceFace<dim> &face         = *element.master;
            const auto             &master_shape = state.master.shape;
            for (unsigned int j = 0; j < face.n_nodes; ++j)
              for (unsigned int c = 0; c < dim; ++c)
                local(first + j * dim + c, k) =
                  -element.point.geometry.weight *
                  (master_shape.value[j] * D_t[c] +
                   response.traction[c] * (master_shape.gradient[j] * D_xi));
            first += face.n_stencil_nodes() * dim;
          }
        for (unsigned int l = 0; l < L.size(); ++l)
          {
            local(first + l * n_comp, k) =
              element.point.geometry.weight * L[l] * D_row_lambda;
            for (unsigned int b = 0; b + 1 < n_comp; ++b)
              for (unsigned int a = 0; a < dim - 1; ++a)
                local(first + l * n_comp + 1 + b, k) +=
                  element.point.geometry.weight * L[l] *
                  element.point.nodal_rotations[l][a][b] * D_row_Lambda[a];
          }
      }
  }

#define INSTANTIATE(dim)                                       \
  template struct ContactElement<dim>;                         \
  template Multipliers<dim> interpolate_multipliers(           \
    const ContactElement<dim> &, const std::vector<double> &); \
  template void local_residual(const ContactElement<dim> &,    \
                               const ContactEvaluation<dim> &, \
                               Vector<double> &);              \
  template void local_tangent(const ContactElement<dim> &,     \
                              const ContactEvaluation<dim> &,  \
                              const bool,                      \
                              FullMatrix<double> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
