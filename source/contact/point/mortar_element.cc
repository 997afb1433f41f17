#include <stickslip/contact/point/mortar_element.h>

#include <array>
#include <cmath>
#include <vector>

namespace stickslip
{
  namespace
  {
    /// Entries of a column: [W, motion, M, E] with dim entries each.
    template <int dim>
    using Columns = std::vector<std::array<double, 4 * dim>>;



    /// What the end of the master surface adds to averaged gap and motion: it
    /// changes the part of the slave surface that is averaged over.
    template <int dim>
    void
    add_end_motion(const MortarElement<dim>    &element,
                   const MortarDerivative<dim> &derivative,
                   Columns<dim>                &columns)
    {
      const MortarAverage<dim> &average = element.average;
      for (unsigned int k = 0; k < columns.size(); ++k)
        {
          const double   D_area = derivative.D_area[k];
          Tensor<1, dim> D_r    = -D_area * average.r;
          Tensor<1, dim> D_w    = -D_area * average.w;
          double         D_gap  = -D_area * average.gap_offset;
          for (unsigned int j = 0; j < average.D.size(); ++j)
            {
              D_r += derivative.D_D(j, k) * average.slave_positions[j];
              D_w += derivative.D_D(j, k) * average.slave_motions[j];
              D_gap += derivative.D_D(j, k) * average.slave_gap_offsets[j];
            }
          // the gap offset counts along n, as r does in the gap
          D_r -= D_gap * element.frame.n;
          for (unsigned int i = 0; i < dim; ++i)
            {
              columns[k][i] += D_r[i] / average.area;
              columns[k][dim + i] += D_w[i] / average.area;
            }
        }
    }



    /// The displacement columns of a node: how each enters the generalized
    /// coordinates.
    template <int dim>
    Columns<dim>
    displacement_columns(const MortarElement<dim>    &element,
                         const MortarDerivative<dim> *derivative)
    {
      const MortarNode<dim>    &node    = element.node;
      const MortarAverage<dim> &average = element.average;
      const double              area    = element.weight();

      Columns<dim> columns(element.n_displacements());
      for (auto &column : columns)
        column.fill(0.);
      const auto move = [&](const unsigned int k, const double share) {
        for (unsigned int c = 0; c < dim; ++c)
          for (const unsigned int first : {0, dim})
            columns[k * dim + c][first + c] = share / area;
      };
      const unsigned int n_slave = node.n_stencil_nodes();
      if (average.paired)
        {
          for (unsigned int k = 0; k < n_slave; ++k)
            move(k, average.D[k]);
          for (unsigned int l = 0; l < average.n_master_nodes(); ++l)
            move(n_slave + l, -average.M[l]);
        }
      if (derivative == nullptr)
        return columns;

      for (unsigned int k = 0; k < derivative->D_normal.size(); ++k)
        for (unsigned int c = 0; c < dim; ++c)
          for (unsigned int i = 0; i < dim; ++i)
            columns[k * dim + c][2 * dim + i] = derivative->D_normal[k][i][c];
      for (unsigned int k = 0; k < n_slave; ++k)
        for (unsigned int c = 0; c < dim; ++c)
          columns[k * dim + c][3 * dim + c] = node.direction[k];
      for (unsigned int l = 0; l < average.n_master_nodes(); ++l)
        for (unsigned int k = 0; k < columns.size(); ++k)
          {
            const double D_share = derivative->D_M(l, k) / area;
            for (unsigned int i = 0; i < dim; ++i)
              {
                columns[k][i] -= D_share * average.master_positions[l][i];
                columns[k][dim + i] -= D_share * average.master_motions[l][i];
              }
          }
      // the rise of facets counts along n, as r does in the gap
      for (unsigned int k = 0; k < derivative->D_rise.size(); ++k)
        for (unsigned int i = 0; i < dim; ++i)
          columns[k][i] += derivative->D_rise[k] / area * element.frame.n[i];
      if (!derivative->D_area.empty())
        add_end_motion(element, *derivative, columns);
      return columns;
    }



    /// Derivatives of what the law gives, along one column.
    template <int dim>
    struct ResponseDerivative
    {
      Tensor<1, dim>     traction;
      double             row_lambda = 0.;
      Tensor<1, dim - 1> row_Lambda;

      void
      add(const ContactResponse<dim> &response,
          const unsigned int          g,
          const double                coefficient)
      {
        for (unsigned int i = 0; i < dim; ++i)
          traction[i] += coefficient * response.D_traction[i][g];
        row_lambda += coefficient * response.D_row_lambda[g];
        for (unsigned int d = 0; d < dim - 1; ++d)
          row_Lambda[d] += coefficient * response.D_row_Lambda[d][g];
      }
    };



    /// What a tied node has along its tangents from the start is no slip.
    template <int dim>
    void
    subtract_tie_offset(const Tensor<1, dim - 1> &offset,
                        const bool                differentiate,
                        ContactKinematics<dim>   &kinematics)
    {
      for (unsigned int b = 0; b < dim - 1; ++b)
        {
          kinematics.d_t -= offset[b] * kinematics.tau[b];
          if (!differentiate)
            continue;
          for (unsigned int i = 0; i < dim; ++i)
            for (unsigned int c = 0; c < kinematics.D_d_t[i].size(); ++c)
              kinematics.D_d_t[i][c] -= offset[b] * kinematics.D_tau[b][i][c];
        }
    }



    /// Writes the rows that the law gives. Row by row, as the matrix is stored:
    /// a large face may see thousands of master nodes.
    template <int dim>
    void
    write_rows(const MortarElement<dim>                   &element,
               const std::vector<ResponseDerivative<dim>> &D,
               FullMatrix<double>                         &local)
    {
      const unsigned int  n_slave = element.node.n_stencil_nodes();
      std::vector<double> along(D.size()); // a component of all columns
      if (element.average.paired)
        for (unsigned int c = 0; c < dim; ++c)
          {
            for (unsigned int k = 0; k < D.size(); ++k)
              along[k] = D[k].traction[c];
            const auto write = [&](const unsigned int node,
                                   const double       share) {
              double *const row = &local(node * dim + c, 0);
              if (share != 0.) // dual functions know their own node only
                for (unsigned int k = 0; k < D.size(); ++k)
                  row[k] = share * along[k];
            };
            for (unsigned int j = 0; j < n_slave; ++j)
              write(j, element.average.D[j]);
            for (unsigned int l = 0; l < element.average.n_master_nodes(); ++l)
              write(n_slave + l, -element.average.M[l]);
          }
      const unsigned int first    = element.n_displacements();
      const auto        &rotation = element.rotation();
      for (unsigned int k = 0; k < D.size(); ++k)
        {
          local(first, k) = element.weight() * D[k].row_lambda;
          for (unsigned int b = 0; b + 1 < element.n_multiplier_components; ++b)
            for (unsigned int a = 0; a < dim - 1; ++a)
              local(first + 1 + b, k) +=
                element.weight() * rotation[a][b] * D[k].row_Lambda[a];
        }
    }



    /// What the end of the master surface changes of the integrals that the
    /// response of the law is multiplied with.
    template <int dim>
    void
    add_end_forces(const MortarElement<dim>    &element,
                   const ContactResponse<dim>  &response,
                   const MortarDerivative<dim> &derivative,
                   FullMatrix<double>          &local)
    {
      const auto        &rotation = element.rotation();
      const unsigned int first    = element.n_displacements();
      for (unsigned int j = 0; j < element.average.D.size(); ++j)
        for (unsigned int c = 0; c < dim; ++c)
          for (unsigned int k = 0; k < derivative.D_area.size(); ++k)
            local(j * dim + c, k) +=
              derivative.D_D(j, k) * response.traction[c];
      for (unsigned int k = 0; k < derivative.D_area.size(); ++k)
        {
          local(first, k) += derivative.D_area[k] * response.row_lambda;
          for (unsigned int b = 0; b + 1 < element.n_multiplier_components; ++b)
            for (unsigned int a = 0; a < dim - 1; ++a)
              local(first + 1 + b, k) +=
                derivative.D_area[k] * rotation[a][b] * response.row_Lambda[a];
        }
    }
  } // namespace



  template <int dim>
  unsigned int
  MortarElement<dim>::n_displacements() const
  {
    return node.dofs.size() + average.masters.dofs.size();
  }



  template <int dim>
  unsigned int
  MortarElement<dim>::n_dofs() const
  {
    return n_displacements() + n_multiplier_components;
  }



  template <int dim>
  void
  evaluate_mortar_kinematics(const MortarElement<dim> &element,
                             const Tensor<1, dim>     &slave_direction,
                             const bool                geometry_is_live,
                             const bool                differentiate,
                             ContactKinematics<dim>   &kinematics)
  {
    using G                       = GeneralizedCoordinates<dim>;
    const bool            is_tied = element.node.tie_offset.has_value();
    RelativePosition<dim> relative;
    relative.r = element.average.r;
    // a tied node compares with the start, not with the last step
    relative.w     = is_tied ? element.average.r : element.average.w;
    kinematics.n   = element.frame.n;
    kinematics.tau = element.frame.tau;
    if (differentiate)
      for (unsigned int i = 0; i < dim; ++i)
        {
          relative.D_r[i].fill(0.);
          relative.D_w[i].fill(0.);
          kinematics.D_n[i].fill(0.);
          relative.D_r[i][G::W + i]                           = 1.;
          relative.D_w[i][is_tied ? G::W + i : G::motion + i] = 1.;
          if (geometry_is_live)
            for (unsigned int k = 0; k < dim; ++k)
              kinematics.D_n[i][G::M + k] =
                ((i == k) - kinematics.n[i] * kinematics.n[k]) /
                element.frame.length;
        }
    evaluate_gap_and_slip(relative,
                          slave_direction,
                          element.average.gap_offset,
                          geometry_is_live,
                          differentiate,
                          kinematics);
    if (is_tied)
      subtract_tie_offset(*element.node.tie_offset, differentiate, kinematics);
  }



  template <int dim>
  void
  local_residual(const MortarElement<dim>     &element,
                 const ContactEvaluation<dim> &state,
                 Vector<double>               &local)
  {
    const auto        &response = state.response;
    const unsigned int n_slave  = element.node.n_stencil_nodes();
    local                       = 0.;
    if (element.average.paired)
      for (unsigned int c = 0; c < dim; ++c)
        {
          for (unsigned int k = 0; k < n_slave; ++k)
            local[k * dim + c] = element.average.D[k] * response.traction[c];
          for (unsigned int l = 0; l < element.average.n_master_nodes(); ++l)
            local[(n_slave + l) * dim + c] =
              -element.average.M[l] * response.traction[c];
        }
    const unsigned int first = element.n_displacements();
    local[first]             = element.weight() * response.row_lambda;
    const auto &rotation     = element.rotation();
    for (unsigned int b = 0; b + 1 < element.n_multiplier_components; ++b)
      for (unsigned int a = 0; a < dim - 1; ++a)
        local[first + 1 + b] +=
          element.weight() * rotation[a][b] * response.row_Lambda[a];
  }



  template <int dim>
  bool
  needs_mortar_derivative(const ContactPoint<dim>    &point,
                          const ContactResponse<dim> &response,
                          const double                diameter)
  {
    using G                     = GeneralizedCoordinates<dim>;
    constexpr double negligible = 1e-8;
    if (response.traction.norm_square() > 0. ||
        std::abs(response.row_lambda) > negligible * diameter ||
        response.row_Lambda.norm() > negligible * point.scales.open_row)
      return true;
    const auto depends = [](const typename ContactResponse<dim>::Row &row) {
      for (const unsigned int first : {G::W, G::motion, G::M, G::E})
        for (unsigned int i = 0; i < dim; ++i)
          if (row[first + i] != 0.)
            return true;
      return false;
    };
    bool needs = depends(response.D_row_lambda);
    for (const auto &row : response.D_traction)
      needs = needs || depends(row);
    for (const auto &row : response.D_row_Lambda)
      needs = needs || depends(row);
    return needs;
  }



  template <int dim>
  void
  local_tangent(const MortarElement<dim>     &element,
                const ContactEvaluation<dim> &state,
                const MortarDerivative<dim>  *derivative,
                FullMatrix<double>           &local)
  {
    using G              = GeneralizedCoordinates<dim>;
    const auto &response = state.response;
    const auto  columns  = displacement_columns(element, derivative);
    std::vector<ResponseDerivative<dim>> D(columns.size());
    for (unsigned int k = 0; k < columns.size(); ++k)
      {
        unsigned int entry = 0;
        for (const unsigned int first : {G::W, G::motion, G::M, G::E})
          for (unsigned int i = 0; i < dim; ++i, ++entry)
            if (columns[k][entry] != 0.)
              D[k].add(response, first + i, columns[k][entry]);
      }
    D.emplace_back();
    D.back().add(response, G::lambda, 1.);
    const auto &rotation = element.rotation();
    for (unsigned int b = 0; b + 1 < element.n_multiplier_components; ++b)
      {
        D.emplace_back();
        for (unsigned int a = 0; a < dim - 1; ++a)
          D.back().add(response, G::Lambda + a, rotation[a][b]);
      }
    write_rows(element, D, local);

    // the forces on the master move from node to node
    if (derivative != nullptr)
      for (unsigned int l = 0; l < element.average.n_master_nodes(); ++l)
        for (unsigned int c = 0; c < dim; ++c)
          for (unsigned int col = 0; col < columns.size(); ++col)
            local(element.node.dofs.size() + l * dim + c, col) -=
              derivative->D_M(l, col) * response.traction[c];
    if (derivative != nullptr && !derivative->D_area.empty())
      add_end_forces(element, response, *derivative, local);
  }

#define INSTANTIATE(dim)                                               \
  template struct MortarElement<dim>;                                  \
  template void evaluate_mortar_kinematics(const MortarElement<dim> &, \
                                           const Tensor<1, dim> &,     \
                                           const bool,                 \
                                           const bool,                 \
                                           ContactKinematics<dim> &);  \
  template void local_residual(const MortarElement<dim> &,             \
                               const ContactEvaluation<dim> &,         \
                               Vector<double> &);                      \
  template bool needs_mortar_derivative(const ContactPoint<dim> &,     \
                                        const ContactResponse<dim> &,  \
                                        const double);                 \
  template void local_tangent(const MortarElement<dim> &,              \
                              const ContactEvaluation<dim> &,          \
                              const MortarDerivative<dim> *,           \
                              FullMatrix<double> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
