#include <stickslip/problem/rigid_part.h>

#include <stickslip/solid/rigid_body_modes.h>

#include <deal.II/base/mpi.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace stickslip
{
  namespace
  {
    template <int dim>
    using Field = std::function<Tensor<1, dim>(const Point<dim> &)>;



    /// Calls visit(cell) for each owned cell of the bodies that @p is_meant.
    template <int dim, typename IsMeant, typename Visit>
    void
    visit_cells(const IsMeant        &is_meant,
                const Bodies         &bodies,
                const DofLayout<dim> &dofs,
                const Visit          &visit)
    {
      for (const auto &cell : dofs.dof_handler.active_cell_iterators())
        if (cell->is_locally_owned() &&
            is_meant(bodies.body_of(cell->material_id())))
          visit(cell);
    }



    /// The factors with which the @p fields come nearest to @p u at the
    /// vertices of those bodies, in the mean square over their volumes.
    template <int dim, typename IsMeant>
    Vector<double>
    nearest_factors(const std::vector<Field<dim>> &fields,
                    const IsMeant                 &is_meant,
                    const Bodies                  &bodies,
                    const DofLayout<dim>          &dofs,
                    const LA::Vector              &u)
    {
      const unsigned int  n = fields.size();
      FullMatrix<double>  gram(n, n);
      std::vector<double> moments(n);
      visit_cells(is_meant, bodies, dofs, [&](const auto &cell) {
        const double volume = cell->measure();
        for (const unsigned int v : cell->vertex_indices())
          {
            std::vector<Tensor<1, dim>> values;
            for (const auto &field : fields)
              values.push_back(field(cell->vertex(v)));
            Tensor<1, dim> displacement;
            for (unsigned int d = 0; d < dim; ++d)
              displacement[d] =
                u(cell->vertex_dof_index(v, d, cell->active_fe_index()));
            for (unsigned int i = 0; i < n; ++i)
              {
                moments[i] += volume * (values[i] * displacement);
                for (unsigned int j = 0; j < n; ++j)
                  gram(i, j) += volume * (values[i] * values[j]);
              }
          }
      });
      const MPI_Comm communicator = dofs.dof_handler.get_communicator();
      Utilities::MPI::sum(gram, communicator, gram);
      Utilities::MPI::sum(moments, communicator, moments);
      gram.gauss_jordan();
      Vector<double> factors(n);
      gram.vmult(factors, Vector<double>(moments.begin(), moments.end()));
      return factors;
    }



    template <int dim>
    Field<dim>
    field_of(const FreeMotion &motion)
    {
      return [&motion](const Point<dim> &X) {
        Point<dim> centre;
        for (unsigned int d = 0; d < dim; ++d)
          centre[d] = motion.centre[d];
        Tensor<1, dim> sum;
        for (unsigned int m = 0; m < motion.factors.size(); ++m)
          sum += motion.factors[m] * rigid_mode<dim>(m, X - centre);
        return sum;
      };
    }



    /// Subtracts @p field at the nodes of those bodies.
    template <int dim, typename IsMeant>
    void
    subtract(const Field<dim>     &field,
             const IsMeant        &is_meant,
             const Bodies         &bodies,
             const DofLayout<dim> &dofs,
             LA::Vector           &u)
    {
      IndexSet                             done(dofs.owned.size());
      std::vector<types::global_dof_index> indices;
      visit_cells(is_meant, bodies, dofs, [&](const auto &cell) {
        const auto &fe      = cell->get_fe();
        const auto &mapping = dofs.mapping[cell->active_fe_index()];
        indices.resize(fe.n_dofs_per_cell());
        cell->get_dof_indices(indices);
        for (unsigned int i = 0; i < indices.size(); ++i)
          if (dofs.owned.is_element(indices[i]) && !done.is_element(indices[i]))
            {
              const Point<dim> X =
                mapping.transform_unit_to_real_cell(cell,
                                                    fe.unit_support_point(i));
              u(indices[i]) -= field(X)[fe.system_to_component_index(i).first];
              done.add_index(indices[i]);
            }
      });
    }
  } // namespace



  template <int dim>
  std::vector<double>
  mean_rotation(const unsigned int    body,
                const Bodies         &bodies,
                const DofLayout<dim> &dofs,
                const LA::Vector     &u)
  {
    constexpr unsigned int n_modes = RigidBodyModes<dim>::n_modes;
    const auto boxes = body_boxes(dofs.dof_handler.get_triangulation(), bodies);
    const Point<dim> centre =
      boxes[body].first + 0.5 * (boxes[body].second - boxes[body].first);
    std::vector<Field<dim>> modes;
    for (unsigned int m = 0; m < n_modes; ++m)
      modes.push_back([m, centre](const Point<dim> &X) {
        return rigid_mode<dim>(m, X - centre);
      });
    const auto factors = nearest_factors(
      modes,
      [body](const unsigned int other) { return other == body; },
      bodies,
      dofs,
      u);
    // of a finite rotation about an axis it is the sine of the angle
    std::vector<double> rotation(factors.begin() + dim, factors.end());
    double              square = 0.;
    for (const double component : rotation)
      square += component * component;
    const double sine = std::min(1., std::sqrt(square));
    for (double &component : rotation)
      component *= sine > 0. ? std::asin(sine) / sine : 1.;
    return rotation;
  }



  template <int dim>
  void
  remove_motions(const std::vector<FreeMotion> &motions,
                 const Bodies                  &bodies,
                 const DofLayout<dim>          &dofs,
                 LA::Vector                    &u)
  {
    LA::Vector ghosted(dofs.owned,
                       dofs.relevant,
                       dofs.dof_handler.get_communicator());
    for (auto begin = motions.begin(); begin != motions.end();)
      {
        const auto end      = std::find_if(begin, motions.end(), [&](auto &m) {
          return m.bodies != begin->bodies;
        });
        const auto is_meant = [&](const unsigned int body) {
          const auto &names = begin->bodies;
          return std::find(names.begin(),
                           names.end(),
                           bodies.bodies[body].name) != names.end();
        };
        std::vector<Field<dim>> fields;
        for (auto motion = begin; motion != end; ++motion)
          fields.push_back(field_of<dim>(*motion));
        ghosted = u;
        const auto factors =
          nearest_factors(fields, is_meant, bodies, dofs, ghosted);
        const Field<dim> sum = [&](const Point<dim> &X) {
          Tensor<1, dim> value;
          for (unsigned int i = 0; i < fields.size(); ++i)
            value += factors(i) * fields[i](X);
          return value;
        };
        subtract(sum, is_meant, bodies, dofs, u);
        u.compress(VectorOperation::add);
        begin = end;
      }
  }

#define INSTANTIATE(dim)                                                       \
  template std::vector<double> mean_rotation(const unsigned int,               \
                                             const Bodies &,                   \
                                             const DofLayout<dim> &,           \
                                             const LA::Vector &);              \
  template void                remove_motions(const std::vector<FreeMotion> &, \
                                              const Bodies &,                  \
                                              const DofLayout<dim> &,          \
                                              LA::Vector &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
