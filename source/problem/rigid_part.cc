#include <stickslip/problem/rigid_part.h>

#include <stickslip/solid/rigid_body_modes.h>

#include <deal.II/base/mpi.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <vector>

namespace stickslip
{
  namespace
  {
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



    /// The sums of a least squares fit of n fields to a displacement: their
    /// Gram matrix, then their products with it.
    unsigned int
    n_sums(const unsigned int n)
    {
      return n * n + n;
    }



    /// Adds the vertices of @p cell, with its volume as their weight. @p fields
    /// are functions of a place, @p u has ghosts.
    template <int dim, typename Cell, typename Fields>
    void
    add_vertices(const Cell       &cell,
                 const Fields     &fields,
                 const LA::Vector &u,
                 double           *sums)
    {
      const double volume = cell->measure();
      for (const unsigned int v : cell->vertex_indices())
        {
          const auto         values = fields(cell->vertex(v));
          const unsigned int n      = values.size();
          Tensor<1, dim>     displacement;
          for (unsigned int d = 0; d < dim; ++d)
            displacement[d] =
              u(cell->vertex_dof_index(v, d, cell->active_fe_index()));
          for (unsigned int i = 0; i < n; ++i)
            {
              for (unsigned int j = 0; j < n; ++j)
                sums[i * n + j] += volume * (values[i] * values[j]);
              sums[n * n + i] += volume * (values[i] * displacement);
            }
        }
    }



    Vector<double>
    fitted_factors(const unsigned int n, const double *sums)
    {
      FullMatrix<double> gram(n, n, sums);
      gram.gauss_jordan();
      Vector<double> factors(n);
      gram.vmult(factors, Vector<double>(sums + n * n, sums + n * n + n));
      return factors;
    }



    /// Of each of the motions at a place.
    template <int dim, typename Motion>
    std::vector<Tensor<1, dim>>
    values_of(const Motion begin, const Motion end, const Point<dim> &X)
    {
      std::vector<Tensor<1, dim>> values;
      for (auto motion = begin; motion != end; ++motion)
        {
          Tensor<1, dim> arm(X);
          for (unsigned int d = 0; d < dim; ++d)
            arm[d] -= motion->centre[d];
          values.emplace_back();
          for (unsigned int m = 0; m < motion->factors.size(); ++m)
            values.back() += motion->factors[m] * rigid_mode<dim>(m, arm);
        }
      return values;
    }



    /// Subtracts @p field at the nodes of those bodies.
    template <int dim, typename IsMeant, typename Field>
    void
    subtract(const Field          &field,
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
  mean_rotations(const Bodies         &bodies,
                 const DofLayout<dim> &dofs,
                 const LA::Vector     &u)
  {
    constexpr unsigned int n = RigidBodyModes<dim>::n_modes;
    const auto boxes = body_boxes(dofs.dof_handler.get_triangulation(), bodies);
    std::vector<double> sums(bodies.n_bodies() * n_sums(n));
    visit_cells([](const unsigned int) { return true; },
                bodies,
                dofs,
                [&](const auto &cell) {
                  const unsigned int b = bodies.body_of(cell->material_id());
                  const auto &[lower, upper] = boxes[b];
                  const auto centre          = lower + 0.5 * (upper - lower);
                  const auto modes           = [&](const Point<dim> &X) {
                    std::array<Tensor<1, dim>, n> values;
                    for (unsigned int m = 0; m < n; ++m)
                      values[m] = rigid_mode<dim>(m, X - centre);
                    return values;
                  };
                  add_vertices<dim>(cell, modes, u, &sums[b * n_sums(n)]);
                });
    Utilities::MPI::sum(sums, dofs.dof_handler.get_communicator(), sums);
    std::vector<double> angles;
    for (unsigned int b = 0; b < bodies.n_bodies(); ++b)
      {
        const auto factors = fitted_factors(n, &sums[b * n_sums(n)]);
        double     square  = 0.;
        for (unsigned int m = dim; m < n; ++m)
          square += factors(m) * factors(m);
        // of a finite rotation about an axis they are the sine of the angle
        angles.push_back(std::asin(std::min(1., std::sqrt(square))));
      }
    return angles;
  }



  template <int dim>
  void
  remove_motions(const std::vector<FreeMotion> &motions,
                 const Bodies                  &bodies,
                 const DofLayout<dim>          &dofs,
                 LA::Vector                    &u)
  {
    const MPI_Comm communicator = dofs.dof_handler.get_communicator();
    LA::Vector     ghosted(dofs.owned, dofs.relevant, communicator);
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
        const auto fields = [&](const Point<dim> &X) {
          return values_of<dim>(begin, end, X);
        };
        const unsigned int  n = std::distance(begin, end);
        std::vector<double> sums(n_sums(n));
        ghosted = u;
        visit_cells(is_meant, bodies, dofs, [&](const auto &cell) {
          add_vertices<dim>(cell, fields, ghosted, sums.data());
        });
        Utilities::MPI::sum(sums, communicator, sums);
        const auto factors = fitted_factors(n, sums.data());
        subtract(
          [&](const Point<dim> &X) {
            const auto     values = fields(X);
            Tensor<1, dim> sum;
            for (unsigned int i = 0; i < n; ++i)
              sum += factors(i) * values[i];
            return sum;
          },
          is_meant,
          bodies,
          dofs,
          u);
        u.compress(VectorOperation::add);
        begin = end;
      }
  }

#define INSTANTIATE(dim)                                                       \
  template std::vector<double> mean_rotations(const Bodies &,                  \
                                              const DofLayout<dim> &,          \
                                              const LA::Vector &);             \
  template void                remove_motions(const std::vector<FreeMotion> &, \
                                              const Bodies &,                  \
                                              const DofLayout<dim> &,          \
                                              LA::Vector &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
