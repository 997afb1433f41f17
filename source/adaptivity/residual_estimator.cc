#include <stickslip/adaptivity/residual_estimator.h>

#include <stickslip/adaptivity/cell_stresses.h>
#include <stickslip/adaptivity/contact_residual.h>
#include <stickslip/adaptivity/free_directions.h>
#include <stickslip/adaptivity/linear_moduli.h>

#include <stickslip/mesh/reference_cells.h>

#include <stickslip/solid/surface_loads.h>

#include <deal.II/fe/fe_values.h>

#include <utility>
#include <vector>

namespace stickslip
{
  namespace
  {
    /// 1 + Grad u, in 2D that of plane strains.
    template <int dim>
    Tensor<2, 3>
    deformation_gradient(const Tensor<2, dim> &gradient)
    {
      Tensor<2, 3> F(unit_symmetric_tensor<3>());
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int J = 0; J < dim; ++J)
          F[i][J] += gradient[i][J];
      return F;
    }



    /// c: brings the estimate near to the error where the solution is smooth
    /// (without it 5 to 10 times as large).
    constexpr double constant = 1. / 36.;



    template <int dim>
    class Residual
    {
    public:
      using CellIterator = typename DoFHandler<dim>::active_cell_iterator;
      using MeshIterator = typename Triangulation<dim>::active_cell_iterator;

      explicit Residual(ContactProblem<dim> &problem)
        : problem(problem)
        , dofs(problem.layout())
        , p(dofs.degree())
        , moduli(problem)
        , stresses(problem, StressMeasure::nominal)
        , contact(problem)
        , cell_rule(gauss_quadrature<dim>(dofs.cells(), p + 1))
        , face_rule(
            gauss_quadrature<dim - 1>(faces_of<dim>(dofs.cells()), p + 1))
        , fe_values(dofs.mapping[0],
                    stresses.space(),
                    cell_rule,
                    update_gradients | update_quadrature_points |
                      update_JxW_values)
        , face(dofs.mapping[0],
               stresses.space(),
               face_rule,
               update_values | update_quadrature_points |
                 update_normal_vectors | update_JxW_values)
        , subface(dofs.mapping[0],
                  stresses.space(),
                  face_rule,
                  update_values | update_normal_vectors | update_JxW_values)
        , other_face(dofs.mapping[0],
                     stresses.space(),
                     face_rule,
                     update_values)
        , other_subface(dofs.mapping[0],
                        stresses.space(),
                        face_rule,
                        update_values)
        , displacements(dofs.mapping[0],
                        dofs.fe(),
                        face_rule,
                        update_values | update_gradients)
      {}

      Vector<double>
      indicators()
      {
        Vector<double> squares = contact.law_errors();
        for (const CellIterator &cell :
             dofs.dof_handler.active_cell_iterators())
          if (cell->is_locally_owned() && moduli.is_deformable(cell) &&
              !stresses.of(cell).empty())
            {
              double &square = squares[cell->active_cell_index()];
              square += in_cell(cell);
              for (const unsigned int f : cell->face_indices())
                square += cell->at_boundary(f) ? on_boundary(cell, f)
                                               : on_inner_face(cell, f);
            }
          else
            squares[cell->active_cell_index()] = 0.;
        return squares;
      }

    private:
      ContactProblem<dim>       &problem;
      const DofLayout<dim>      &dofs;
      const double               p;
      const LinearModuliOf<dim>  moduli;
      const CellStresses<dim>    stresses;
      const ContactResidual<dim> contact;
      const Quadrature<dim>      cell_rule;
      const Quadrature<dim - 1>  face_rule;
      FEValues<dim>              fe_values;
      FEFaceValues<dim>          face;
      FESubfaceValues<dim>       subface;
      FEFaceValues<dim>          other_face;
      FESubfaceValues<dim>       other_subface;
      FEFaceValues<dim>          displacements;

      /// c h / (2 mu p)
      double
      face_weight(const CellIterator &cell, const double h) const
      {
        return constant * h / (2. * moduli.of(cell).shear * p);
      }

      double
      in_cell(const CellIterator &cell)
      {
        const auto &P = stresses.of(cell);
        fe_values.reinit(MeshIterator(cell));
        double square = 0.;
        for (const unsigned int q : fe_values.quadrature_point_indices())
          {
            Tensor<1, dim> r = body_force(cell, fe_values.quadrature_point(q));
            for (unsigned int a = 0; a < P.size(); ++a)
              for (unsigned int i = 0; i < dim; ++i)
                for (unsigned int J = 0; J < dim; ++J)
                  r[i] += P[a][i][J] * fe_values.shape_grad(a, q)[J];
            square += r.norm_square() * fe_values.JxW(q);
          }
        return face_weight(cell, cell->diameter()) * cell->diameter() / p *
               square;
      }

      Tensor<1, dim>
      body_force(const CellIterator &cell, const Point<dim> &X) const
      {
        Tensor<1, dim> force;
        for (const Load<dim> &load : problem.conditions().loads())
          if (!load.is_on_surface() &&
              load.body == problem.bodies().body_of(cell->material_id()))
            force += load.vector(X, problem.present_time());
        return force;
      }

      /// P N of @p cell at a point of @p values, of the face or a part of it.
      Tensor<1, dim>
      traction(const CellIterator      &cell,
               const FEValuesBase<dim> &values,
               const unsigned int       q,
               const Tensor<1, dim>    &N) const
      {
        const auto    &P = stresses.of(cell);
        Tensor<1, dim> t;
        for (unsigned int a = 0; a < P.size(); ++a)
          for (unsigned int i = 0; i < dim; ++i)
            for (unsigned int J = 0; J < dim; ++J)
              t[i] += values.shape_value(a, q) * P[a][i][J] * N[J];
        return t;
      }

      /// int |[P N]|^2 between a cell and another one, that see the same places
      /// with these values.
      double
      jump(const CellIterator      &cell,
           const FEValuesBase<dim> &values,
           const CellIterator      &other,
           const FEValuesBase<dim> &other_values) const
      {
        double square = 0.;
        for (const unsigned int q : values.quadrature_point_indices())
          {
            const Tensor<1, dim> &N = values.normal_vector(q);
            square += (traction(cell, values, q, N) -
                       traction(other, other_values, q, N))
                        .norm_square() *
                      values.JxW(q);
          }
        return square;
      }

      double
      on_inner_face(const CellIterator &cell, const unsigned int f)
      {
        const unsigned int n_parts = cell->face(f)->has_children()
                                       ? cell->face(f)->n_active_descendants()
                                       : 1;
        double             square  = 0.;
        for (unsigned int part = 0; part < n_parts; ++part)
          {
            if (n_parts > 1)
              {
                const CellIterator other =
                  cell->neighbor_child_on_subface(f, part);
                subface.reinit(MeshIterator(cell), f, part);
                other_face.reinit(MeshIterator(other),
                                  cell->neighbor_face_no(f));
                square += jump(cell, subface, other, other_face);
                continue;
              }
            const CellIterator other = cell->neighbor(f);
            face.reinit(MeshIterator(cell), f);
            if (cell->neighbor_is_coarser(f))
              {
                const auto place = cell->neighbor_of_coarser_neighbor(f);
                other_subface.reinit(MeshIterator(other),
                                     place.first,
                                     place.second);
                square += jump(cell, face, other, other_subface);
              }
            else
              {
                other_face.reinit(MeshIterator(other),
                                  cell->neighbor_face_no(f));
                square += jump(cell, face, other, other_face);
              }
          }
        return 0.5 * face_weight(cell, cell->face(f)->diameter()) * square;
      }

      double
      on_boundary(const CellIterator &cell, const unsigned int f)
      {
        if (cell->has_periodic_neighbor(f))
          return 0.;
        face.reinit(MeshIterator(cell), f);
        displacements.reinit(cell, f);
        const std::vector<Tensor<1, dim>> loads = loads_on(cell, f);
        const auto *const tractions             = contact.tractions_on(cell, f);
        const auto        free                  = free_directions_on(cell, f);
        double            square                = 0.;
        for (const unsigned int q : face.quadrature_point_indices())
          {
            const Tensor<1, dim> r =
              loads[q] - traction(cell, face, q, face.normal_vector(q));
            // Contact tractions node by node: a node that a support holds may
            // have none, as the reaction has it.
            Tensor<1, dim> unbalanced;
            for (const auto &[node, projection] : free)
              unbalanced +=
                shape_value(node, q) *
                (projection *
                 (tractions != nullptr ? r + tractions->at(node) : r));
            square += unbalanced.norm_square() * face.JxW(q);
          }
        return face_weight(cell, cell->face(f)->diameter()) * square;
      }

      /// Of a node of the displacements.
      double
      shape_value(const unsigned int node, const unsigned int q) const
      {
        return displacements.shape_value(
          dofs.fe().component_to_system_index(0, node), q);
      }

      /// Forces per area of loads, at the points of `face`.
      std::vector<Tensor<1, dim>>
      loads_on(const CellIterator &cell, const unsigned int f) const
      {
        const FEValuesExtractors::Vector vector(0);
        std::vector<Tensor<1, dim>>      u(face_rule.size()), sum(u.size());
        std::vector<Tensor<2, dim>>      F(face_rule.size());
        displacements[vector].get_function_values(
          problem.ghosted_displacement(), u);
        displacements[vector].get_function_gradients(
          problem.ghosted_displacement(), F);
        for (const Load<dim> &load : problem.conditions().loads())
          if (load.is_on_surface() &&
              load.boundary_ids.count(cell->face(f)->boundary_id()) > 0)
            for (unsigned int q = 0; q < sum.size(); ++q)
              sum[q] += surface_force(load,
                                      face.quadrature_point(q),
                                      face.normal_vector(q),
                                      deformation_gradient(F[q]),
                                      u[q],
                                      problem.present_time());
        return sum;
      }

      /// By node, of those on the face.
      std::vector<std::pair<unsigned int, Tensor<2, dim>>>
      free_directions_on(const CellIterator &cell, const unsigned int f) const
      {
        std::vector<types::global_dof_index> of_cell(
          dofs.fe().n_dofs_per_cell());
        std::vector<types::global_dof_index> of_node(dim);
        cell->get_dof_indices(of_cell);
        std::vector<std::pair<unsigned int, Tensor<2, dim>>> result;
        const FiniteElement<dim> &fe = dofs.fe().base_element(0);
        for (unsigned int node = 0; node < fe.n_dofs_per_cell(); ++node)
          if (has_node_on_face(fe, node, f))
            {
              for (unsigned int c = 0; c < dim; ++c)
                of_node[c] =
                  of_cell[dofs.fe().component_to_system_index(c, node)];
              result.emplace_back(node, free_directions(problem, of_node));
            }
        return result;
      }
    };
  } // namespace



  template <int dim>
  Vector<double>
  ResidualEstimator<dim>::indicators(ContactProblem<dim> &problem,
                                     const LA::BlockVector & /*x*/) const
  {
    return Residual<dim>(problem).indicators();
  }

  template class ResidualEstimator<2>;
  template class ResidualEstimator<3>;
} // namespace stickslip
