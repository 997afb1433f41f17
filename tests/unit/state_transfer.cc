// A state goes to another mesh: polynomials of the degree of the cells, linear
// multipliers and histories arrive as they were, on refined cells and, as far
// as coarse cells can have them, on coarsened ones; the same on any number of
// ranks.

#include "case_problem.h"
#include "print.h"

#include <stickslip/adaptivity/state_transfer.h>

#include <stickslip/contact/results/contact_results.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>

#include <deal.II/fe/fe_q.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

using namespace stickslip;

namespace
{
  std::string
  in_words(const double error)
  {
    return error < 1e-12 ? "none" : std::to_string(error);
  }



  double
  polynomial(const double x, const unsigned int degree)
  {
    return degree == 1 ? 1. + 2. * x : 1. + 2. * x - 3. * x * x;
  }



  /// One cell and its children, without meshes.
  template <int dim>
  void
  test_cell(const unsigned int degree)
  {
    const FE_Q<dim>         element(degree);
    const QGauss<dim>       quadrature(degree + 1);
    const CellTransfer<dim> transfer(element, quadrature);
    const auto              field = [&](const Point<dim> &x) {
      double value = 1.;
      for (unsigned int d = 0; d < dim; ++d)
        value *= polynomial(x[d], degree);
      return value;
    };
    CellRecord parent;
    for (const Point<dim> &x : element.get_unit_support_points())
      parent.in_body.push_back(field(x));
    parent.on_surfaces.push_back({3, parent.in_body});
    for (unsigned int q = 0; q < quadrature.size(); ++q)
      for (const double number : {1. * q, 100. + q})
        parent.history.push_back(number);
    parent.indicator = 3.;

    const auto          children = transfer.to_children(parent);
    double              error    = 0.;
    std::vector<double> integral_of_children(quadrature.size(), 0.);
    for (unsigned int child = 0; child < children.size(); ++child)
      {
        for (unsigned int i = 0; i < element.n_dofs_per_cell(); ++i)
          {
            const double expected =
              field(GeometryInfo<dim>::child_to_cell_coordinates(
                element.unit_support_point(i), child));
            error = std::max(
              {error,
               std::abs(children[child].in_body[i] - expected),
               std::abs(children[child].on_surfaces[0].values[i] - expected)});
          }
        for (unsigned int q = 0; q < quadrature.size(); ++q)
          integral_of_children[children[child].history[2 * q]] +=
            quadrature.weight(q) / children.size();
      }
    double lost = 0.;
    for (unsigned int q = 0; q < quadrature.size(); ++q)
      lost = std::max(lost,
                      std::abs(integral_of_children[q] - quadrature.weight(q)));
    double of_children = 0.;
    for (const CellRecord &child : children)
      of_children += child.indicator;
    const CellRecord again  = transfer.to_parent(children);
    double           change = 0.;
    for (unsigned int i = 0; i < element.n_dofs_per_cell(); ++i)
      change = std::max(
        {change,
         std::abs(again.in_body[i] - parent.in_body[i]),
         std::abs(again.on_surfaces[0].values[i] - parent.in_body[i])});
    print(std::to_string(dim) + "D, degree " + std::to_string(degree) +
          ": error on children " + in_words(error) + ", of the integral of a " +
          "history " + in_words(lost) + "; on the parent again " +
          in_words(change) + ", history " +
          (again.history == parent.history ? "as it was" : "of other points") +
          "; the indicator falls to " +
          in_words(of_children / parent.indicator) +
          ", on the parent it changes by " +
          in_words(again.indicator - of_children));
  }



  template <int dim>
  std::string
  two_blocks(const unsigned int degree)
  {
    const bool        plane   = dim == 2;
    const std::string n_upper = plane ? "3, 2 : 0, 0 : 3, 2"
                                      : "3, 2, 2 : 0, 0, 0 : 3, 2, 2",
                      n_lower = plane ? "4, 2 : -1, -2 : 4, 0"
                                      : "4, 3, 2 : -1, -1, -2 : 4, 3, 0";
    return "set Dimension = " + std::to_string(dim) +
           "\nset Degree = " + std::to_string(degree) + R"(
      subsection Bodies
        subsection upper
          set Generator = subdivided_hyper_rectangle
          set Arguments = )" +
           n_upper + R"( : true
          set Material = metal
        end
        subsection lower
          set Generator = subdivided_hyper_rectangle
          set Arguments = )" +
           n_lower + R"( : true
          set Material = metal
        end
      end
      subsection Materials
        subsection metal
          set Law = small-strain plasticity
          set Young's modulus = 100
          set Poisson's ratio = 0.3
          set Yield stress = 1
        end
      end
      subsection Contact
        subsection pair
          set Slave body = upper
          set Slave boundary = )" +
           (plane ? "2" : "4") + R"(
          set Master body = lower
          set Master boundary = )" +
           (plane ? "3" : "5") + R"(
          set Friction = Coulomb
          set Friction coefficient = 0.3
        end
      end
      subsection Adaptation
        set Estimator = Kelly
      end
    )";
  }



  template <int dim>
  double
  displacement(const Point<dim> &x, const unsigned int c)
  {
    return 1e-2 * (x[0] * (c + 1.) - (c == dim - 1 ? 1. * x[0] : 0.) -
                   (c == 0 ? 0.5 * x[dim - 1] : 0.));
  }



  /// Largest differences from the planted state.
  template <int dim>
  void
  compare(ContactProblem<dim>   &problem,
          const LA::BlockVector &x,
          const LA::Vector      &rate,
          const double           lambda_slope,
          const Tensor<1, dim>  &Lambda)
  {
    const auto &layout = problem.layout();
    double error = 0., history = 0., lambda_n = 0., tangential = 0., slip = 0.;
    std::vector<types::global_dof_index> dofs(layout.fe().dofs_per_cell);
    for (const auto &cell : layout.dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          cell->get_dof_indices(dofs);
          for (unsigned int i = 0; i < dofs.size(); ++i)
            if (layout.owned.is_element(dofs[i]))
              {
                const Point<dim> p =
                  layout.mapping[0].transform_unit_to_real_cell(
                    cell, layout.fe().unit_support_point(i));
                const unsigned int c =
                  layout.fe().system_to_component_index(i).first;
                error = std::max(
                  {error,
                   std::abs(x.block(0)(dofs[i]) - displacement<dim>(p, c)),
                   std::abs(rate(dofs[i]) - 2. * displacement<dim>(p, c))});
              }
          for (const double value :
               problem.solid().point_history().accepted_of_cell(
                 cell->active_cell_index()))
            history =
              std::max(history, std::abs(value - cell->material_id() - 1.));
        }
    for (const auto &face : contact_results(problem.contact()))
      for (unsigned int j = 0; j < face.lambda_n.size(); ++j)
        {
          lambda_n =
            std::max(lambda_n,
                     std::abs(face.lambda_n[j] + 1. +
                              lambda_slope * face.reference_positions[j][0]));
          tangential = std::max(tangential, (face.Lambda[j] - Lambda).norm());
        }
    for (const auto &point : problem.contact().contact_pairs()[0]->points)
      for (unsigned int c = 0; c < dim; ++c)
        slip = std::max(slip, std::abs(point.accumulated_slip[c] - 0.1 - c));
    const auto over_ranks = [](const double value) {
      return in_words(Utilities::MPI::max(value, MPI_COMM_WORLD));
    };
    print("  " +
          std::to_string(
            layout.dof_handler.get_triangulation().n_global_active_cells()) +
          " cells: errors of displacement and rate " + over_ranks(error) +
          ", history " + over_ranks(history) + ", lambda_n " +
          over_ranks(lambda_n) + ", Lambda " + over_ranks(tangential) +
          ", slip " + over_ranks(slip));
  }



  /// Refines where @p refines says, coarsens elsewhere, and looks.
  template <int dim>
  void
  test_state(const unsigned int degree)
  {
    print(std::to_string(dim) + "D, degree " + std::to_string(degree));
    const TextParameters parameters(two_blocks<dim>(degree));
    Mesh<dim>            mesh =
      build_mesh<dim>(parameters.mesh, parameters.bodies, {}, MPI_COMM_WORLD);
    auto &triangulation =
      dynamic_cast<parallel::distributed::Triangulation<dim> &>(
        *mesh.triangulation);
    const auto make = [&]() {
      return std::make_unique<ContactProblem<dim>>(
        mesh,
        parameters.degree,
        parameters.materials,
        parameters.boundary_conditions,
        parameters.contact_pairs,
        false);
    };
    auto            problem = make();
    LA::BlockVector x       = problem->zero_state();
    LA::Vector      rate    = x.block(0);
    const auto     &layout  = problem->layout();
    {
      std::vector<types::global_dof_index> dofs(layout.fe().dofs_per_cell);
      for (const auto &cell : layout.dof_handler.active_cell_iterators())
        if (cell->is_locally_owned())
          {
            cell->get_dof_indices(dofs);
            for (unsigned int i = 0; i < dofs.size(); ++i)
              if (layout.owned.is_element(dofs[i]))
                {
                  const Point<dim> p =
                    layout.mapping[0].transform_unit_to_real_cell(
                      cell, layout.fe().unit_support_point(i));
                  x.block(0)(dofs[i]) = displacement<dim>(
                    p, layout.fe().system_to_component_index(i).first);
                  rate(dofs[i]) = 2. * x.block(0)(dofs[i]);
                }
            auto      &history = problem->solid().point_history();
            const auto old =
              history.accepted_of_cell(cell->active_cell_index());
            const std::vector<double> values(old.size(),
                                             cell->material_id() + 1.);
            history.set_cell(cell->active_cell_index(),
                             ArrayView<const double>(values.data(),
                                                     values.size()));
          }
    }
    x.block(0).compress(VectorOperation::insert);
    rate.compress(VectorOperation::insert);
    const auto &pair = problem->contact().contact_pairs()[0];
    for (const auto &face : pair->slave_faces)
      for (unsigned int j = 0; j < face.face.n_nodes; ++j)
        {
          x.block(1)(face.multiplier_dofs[j * dim]) =
            -1. - 0.25 * face.face.reference_positions[j][0];
          for (unsigned int c = 1; c < dim; ++c)
            x.block(1)(face.multiplier_dofs[j * dim + c]) = 0.2 * c;
        }
    x.block(1).compress(VectorOperation::insert);
    for (auto &point : pair->points)
      for (unsigned int c = 0; c < dim; ++c)
        point.accumulated_slip[c] = 0.1 + c;
    problem->begin_step(0., x);
    problem->begin_iteration(x);
    Tensor<1, dim> Lambda;
    for (const auto &face : contact_results(problem->contact()))
      Lambda = face.Lambda[0];
    // one of a rank that has some
    const auto all = Utilities::MPI::all_gather(MPI_COMM_WORLD, Lambda);
    for (const auto &one : all)
      if (one.norm() > 0.)
        Lambda = one;
    // the same vector at all nodes, whose frames differ in the deformed state
    for (const auto &point : pair->points)
      {
        const unsigned int l = point.geometry.quadrature_index;
        const auto        &dofs =
          pair->slave_faces[point.geometry.slave_face].multiplier_dofs;
        for (unsigned int b = 0; b + 1 < dim; ++b)
          {
            double component = 0.;
            for (unsigned int a = 0; a + 1 < dim; ++a)
              component += point.nodal_rotations[l][a][b] *
                           (point.pairing.tau[a] * Lambda);
            x.block(1)(dofs[l * dim + 1 + b]) = component;
          }
      }
    x.block(1).compress(VectorOperation::insert);
    problem->begin_step(0., x);
    problem->begin_iteration(x);
    compare(*problem, x, rate, 0.25, Lambda);

    const auto flag_cells = [&](const double border) {
      for (const auto &cell : triangulation.active_cell_iterators())
        if (cell->is_locally_owned())
          {
            if (cell->center()[0] < border && cell->level() < 2)
              cell->set_refine_flag();
            else if (cell->center()[0] > border && cell->level() > 0)
              cell->set_coarsen_flag();
          }
    };
    // of a smooth solution
    const auto smooth_indicators = [&]() {
      Vector<double> indicators(triangulation.n_active_cells());
      for (const auto &cell : triangulation.active_cell_iterators())
        if (cell->is_locally_owned())
          indicators[cell->active_cell_index()] =
            std::pow(2., -(2. * degree + dim) * cell->level());
      return indicators;
    };
    for (const double border : {1.2, 2.1, 0.4, -10.})
      {
        flag_cells(border);
        StateTransfer<dim> transfer(*problem,
                                    0.,
                                    {x, rate, x},
                                    smooth_indicators());
        problem.reset();
        transfer.execute(triangulation);
        if (border == 2.1) // two levels in one transfer
          {
            flag_cells(border);
            transfer.execute(triangulation);
          }
        // on parents they are those of the children
        const auto expected = transfer.expected_indicators();
        const auto smooth   = smooth_indicators();
        double     ratio    = 0.;
        for (const auto &cell : triangulation.active_cell_iterators())
          if (cell->is_locally_owned())
            ratio = std::max(ratio,
                             expected[cell->active_cell_index()] /
                               smooth[cell->active_cell_index()]);
        print("  indicators over those of a smooth solution at most " +
              in_words(Utilities::MPI::max(ratio, MPI_COMM_WORLD)));
        problem               = make();
        const MeshState state = transfer.put_into(*problem, 0.);
        x                     = state.x;
        rate                  = state.rate;
        LA::BlockVector difference(state.guess);
        difference -= x;
        print("  guess like the state", difference.l2_norm() < 1e-12);
        compare(*problem, x, rate, 0.25, Lambda);
      }
  }
} // namespace



int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const unsigned int degree : {1, 2})
    {
      test_cell<2>(degree);
      test_cell<3>(degree);
    }
  for (const unsigned int degree : {1, 2})
    test_state<2>(degree);
  test_state<3>(1);
}
