#ifndef stickslip_tests_solid_problem_h
#define stickslip_tests_solid_problem_h

// One or two small blocks with boundary conditions and an assembler, for the
// tests of solid/.

#include "print.h"

#include <stickslip/base/user_error.h>

#include <stickslip/solid/isotropic_hardening.h>
#include <stickslip/solid/linear_elastic.h>
#include <stickslip/solid/plane_stress.h>
#include <stickslip/solid/rigid_body_check.h>
#include <stickslip/solid/saint_venant_kirchhoff.h>
#include <stickslip/solid/solid_assembler.h>

#include <deal.II/base/function.h>
#include <deal.II/base/mpi.h>

#include <deal.II/distributed/tria.h>

#include <deal.II/dofs/dof_tools.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/mapping_q.h>

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

#include <deal.II/lac/trilinos_solver.h>

#include <deal.II/numerics/vector_tools.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

namespace solid_test
{
  using namespace stickslip;

  /// Prints the error that @p action throws, on all ranks or on none.
  inline void
  print_error(const std::function<void()> &action)
  {
    std::string text = "no error";
    try
      {
        action();
      }
    catch (const UserError &error)
      {
        text = error.what();
      }
    const auto texts = Utilities::MPI::all_gather(MPI_COMM_WORLD, text);
    for (const std::string &other : texts)
      if (other != text)
        text = "the ranks disagree";
    print(text);
  }



  template <int dim>
  class VectorFunction : public Function<dim>
  {
  public:
    using Formula = std::function<Tensor<1, dim>(const Point<dim> &)>;

    explicit VectorFunction(const Formula &formula)
      : Function<dim>(dim)
      , formula(formula)
    {}

    double
    value(const Point<dim> &p, const unsigned int component) const override
    {
      return formula(p)[component];
    }

  private:
    const Formula formula;
  };



  inline BoundaryConditionParameters
  condition(const std::string               &type,
            const std::vector<unsigned int> &boundary,
            const std::string               &value = "")
  {
    BoundaryConditionParameters parameters;
    parameters.body = "block";
    parameters.type = value_of(type, all_boundary_condition_types());
    for (const unsigned int id : boundary)
      parameters.boundary.push_back(std::to_string(id));
    parameters.value = value;
    return parameters;
  }



  /// One or two blocks with everything that an assembly needs.
  template <int dim>
  class Problem
  {
  public:
    /// Both get the boundary ids 0, ..., 2 dim - 1.
    Problem(const unsigned int degree, const bool with_rigid_body = false)
      : triangulation(MPI_COMM_WORLD)
      , fe(FE_Q<dim>(degree), dim)
      , mapping(MappingQ<dim>(1))
      , dof_handler(triangulation)
    {
      add_body("block", false);
      Triangulation<dim> block, second, both;
      make_block(block, 0.);
      if (with_rigid_body)
        {
          add_body("tool", true);
          make_block(second, 2.);
          for (const auto &cell : second.active_cell_iterators())
            cell->set_material_id(1);
          GridGenerator::merge_triangulations(block, second, both);
          colorize(both);
          triangulation.copy_triangulation(both);
        }
      else
        triangulation.copy_triangulation(block);
    }

    void
    transform(const std::function<Point<dim>(const Point<dim> &)> &formula)
    {
      GridTools::transform(formula, triangulation);
    }

    void
    distort()
    {
      transform([](const Point<dim> &p) {
        Point<dim> moved = p;
        moved[0] += 0.15 * std::sin(2. * p[1] + 0.3);
        moved[1] += 0.1 * p[0] * p[0] - 0.05 * p[0];
        if (dim == 3)
          moved[2] += 0.1 * std::cos(3. * p[0]) * p[1];
        return moved;
      });
    }

    void
    refine_one_cell()
    {
      for (const auto &cell : triangulation.active_cell_iterators())
        if (cell->is_locally_owned() && cell->center().norm() < 0.5)
          cell->set_refine_flag();
      triangulation.execute_coarsening_and_refinement();
    }

    void
    finish(const std::shared_ptr<const ConstitutiveLaw> &law,
           const NamedList<BoundaryConditionParameters> &conditions,
           const bool with_mean_dilatation = false)
    {
      use_global_ids();
      dof_handler.distribute_dofs(fe);
      owned = dof_handler.locally_owned_dofs();
      DoFTools::extract_locally_relevant_dofs(dof_handler, relevant);
      u.reinit(owned, relevant, MPI_COMM_WORLD);

      boundary_conditions =
        std::make_unique<BoundaryConditions<dim>>(conditions, bodies);
      std::vector<std::shared_ptr<const ConstitutiveLaw>> laws(
        bodies.regions.size());
      laws[0]   = law;
      assembler = std::make_unique<SolidAssembler<dim>>(
        mapping,
        dof_handler,
        bodies,
        laws,
        *boundary_conditions,
        std::vector<bool>(laws.size(), with_mean_dilatation));

      geometric.reinit(relevant);
      DoFTools::make_hanging_node_constraints(dof_handler, geometric);
      geometric.close();
    }

    Constraints
    increment_constraints(const double time)
    {
      Constraints constraints(relevant);
      DoFTools::make_hanging_node_constraints(dof_handler, constraints);
      boundary_conditions->add_prescribed_displacements(
        mapping, dof_handler, PeriodicNodes<dim>(), time, u, constraints);
      constraints.close();
      return constraints;
    }

    void
    interpolate(const typename VectorFunction<dim>::Formula &formula)
    {
      LA::Vector owned_u(owned, MPI_COMM_WORLD);
      VectorTools::interpolate(mapping,
                               dof_handler,
                               VectorFunction<dim>(formula),
                               owned_u);
      geometric.distribute(owned_u);
      u = owned_u;
    }

    /// internal - external, and external.
    LA::Vector
    residual(const double time, LA::Vector *external_only = nullptr)
    {
      LA::Vector internal, external;
      internal.reinit(owned, relevant, MPI_COMM_WORLD, true);
      external.reinit(owned, relevant, MPI_COMM_WORLD, true);
      assembler->add_residual(u, time, geometric, internal, external);
      internal.compress(VectorOperation::add);
      external.compress(VectorOperation::add);
      LA::Vector result(owned, MPI_COMM_WORLD), force(owned, MPI_COMM_WORLD);
      result = internal;
      force  = external;
      if (external_only != nullptr)
        *external_only = force;
      result -= force;
      return result;
    }

    void
    assemble_tangent(const double       time,
                     const Constraints &constraints,
                     LA::SparseMatrix  &matrix,
                     LA::Vector        &rhs)
    {
      LA::SparsityPattern pattern(owned, owned, relevant, MPI_COMM_WORLD);
      DoFTools::make_sparsity_pattern(dof_handler,
                                      pattern,
                                      constraints,
                                      true,
                                      Utilities::MPI::this_mpi_process(
                                        MPI_COMM_WORLD));
      pattern.compress();
      matrix.reinit(pattern);
      LA::Vector writable;
      writable.reinit(owned, relevant, MPI_COMM_WORLD, true);
      assembler->add_tangent(u, time, constraints, matrix, writable);
      matrix.compress(VectorOperation::add);
      writable.compress(VectorOperation::add);
      rhs.reinit(owned, MPI_COMM_WORLD);
      rhs = writable;
    }

    /// Newton's method; returns the norm of the last increment.
    double
    solve(const double time, const unsigned int n_iterations)
    {
      double last = 0.;
      for (unsigned int i = 0; i < n_iterations; ++i)
        {
          const Constraints constraints = increment_constraints(time);
          LA::SparseMatrix  matrix;
          LA::Vector        rhs, increment(owned, MPI_COMM_WORLD);
          assemble_tangent(time, constraints, matrix, rhs);
          SolverControl                  control;
          TrilinosWrappers::SolverDirect solver(control);
          solver.solve(matrix, increment, rhs);
          constraints.distribute(increment);
          LA::Vector sum(owned, MPI_COMM_WORLD);
          sum = u;
          sum += increment;
          u    = sum;
          last = increment.l2_norm();
        }
      return last;
    }

    /// Largest deviation of the Cauchy stress from @p expected.
    double
    stress_error(const SymmetricTensor<2, 3> &expected)
    {
      double                                                worst = 0.;
      std::vector<typename SolidAssembler<dim>::PointState> states;
      for (const auto &cell : dof_handler.active_cell_iterators())
        if (cell->is_locally_owned())
          {
            assembler->evaluate_point_states(cell, u, states);
            for (const auto &state : states)
              worst = std::max(worst, (state.cauchy_stress - expected).norm());
          }
      return Utilities::MPI::max(worst, MPI_COMM_WORLD);
    }

    double
    displacement_error(const typename VectorFunction<dim>::Formula &exact)
    {
      const LA::Vector ours = u;
      interpolate(exact);
      LA::Vector difference(owned, MPI_COMM_WORLD), owned_u(difference);
      difference = ours;
      owned_u    = u;
      difference -= owned_u;
      u = ours;
      return difference.linfty_norm();
    }

    parallel::distributed::Triangulation<dim> triangulation;
    Bodies                                    bodies;
    const FESystem<dim>                       fe;
    const hp::MappingCollection<dim>          mapping;
    DoFHandler<dim>                           dof_handler;
    IndexSet                                  owned, relevant;
    Constraints                               geometric;
    LA::Vector                                u; ///< ghosted
    std::unique_ptr<BoundaryConditions<dim>>  boundary_conditions;
    std::unique_ptr<SolidAssembler<dim>>      assembler;

  private:
    void
    add_body(const std::string &name, const bool is_rigid)
    {
      Body body;
      body.name     = name;
      body.is_rigid = is_rigid;
      for (unsigned int id = 0; id < 2 * dim; ++id)
        body.boundary_ids.insert(id);
      bodies.regions.push_back({static_cast<unsigned int>(bodies.bodies.size()),
                                is_rigid ? "" : "steel"});
      bodies.bodies.push_back(body);
    }

    /// As build_mesh() does: those of the first body begin at 1.
    void
    use_global_ids()
    {
      const unsigned int first = bodies.global_boundary_id(0, 0);
      for (const auto &cell : triangulation.cell_iterators())
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary())
            face->set_boundary_id(face->boundary_id() + first);
    }

    /// The ids of the unit blocks at y = 0 and y = 2, which merging forgets.
    static void
    colorize(Triangulation<dim> &blocks)
    {
      for (const auto &cell : blocks.active_cell_iterators())
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary())
            {
              const bool is_second = (cell->material_id() == 1);
              Point<dim> center    = face->center();
              center[1] -= is_second ? 2. : 0.;
              for (unsigned int d = 0; d < dim; ++d)
                for (unsigned int side = 0; side < 2; ++side)
                  if (std::abs(center[d] - side) < 1e-10)
                    face->set_boundary_id(2 * d + side +
                                          (is_second ? 2 * dim : 0));
            }
    }

    static void
    make_block(Triangulation<dim> &block, const double shift)
    {
      Point<dim> corner;
      for (unsigned int d = 0; d < dim; ++d)
        corner[d] = 1.;
      Point<dim> origin;
      origin[1] += shift;
      corner[1] += shift;
      GridGenerator::subdivided_hyper_rectangle(
        block, std::vector<unsigned int>(dim, 2), origin, corner, true);
      // Colorizing numbers the octants, too.
      for (const auto &cell : block.active_cell_iterators())
        cell->set_material_id(0);
    }
  };



  template <typename Law>
  std::shared_ptr<Law>
  steel(const double E = 100., const double nu = 0.3)
  {
    const auto law                = std::make_shared<Law>();
    law->constants.youngs_modulus = E;
    law->constants.poissons_ratio = nu;
    return law;
  }



  template <int dim>
  std::string
  case_name(const std::string &what, const unsigned int degree)
  {
    return std::to_string(dim) + "D Q" + std::to_string(degree) + " " + what;
  }



  template <typename Law>
  std::shared_ptr<Law>
  plastic()
  {
    const auto law              = steel<Law>();
    law->hardening.type         = HardeningType::linear;
    law->hardening.yield_stress = 0.1;
    law->hardening.modulus      = 10.;
    return law;
  }



  /// Tangent against central differences of the residual, in one direction.
  template <int dim>
  void
  test_differences(Problem<dim>      &problem,
                   const std::string &name,
                   const unsigned int degree,
                   const double       tolerance)
  {
    const auto state = [](const Point<dim> &p) {
      Tensor<1, dim> u;
      for (unsigned int d = 0; d < dim; ++d)
        u[d] = 0.1 * std::sin(p[d] + 2. * p[(d + 1) % dim]);
      return u;
    };
    const auto direction = [](const Point<dim> &p) {
      Tensor<1, dim> u;
      for (unsigned int d = 0; d < dim; ++d)
        u[d] = std::cos(3. * p[d] - p[(d + 1) % dim]) + p[0] * p[1];
      return u;
    };

    problem.interpolate(state);
    LA::SparseMatrix matrix;
    LA::Vector       minus_residual;
    problem.assemble_tangent(0.5, problem.geometric, matrix, minus_residual);
    LA::Vector sum = problem.residual(0.5);
    sum += minus_residual;
    print(case_name<dim>(name + "rhs of the tangent is minus the residual",
                         degree),
          sum.linfty_norm() < 1e-12);

    problem.interpolate(direction);
    LA::Vector v(problem.owned, MPI_COMM_WORLD), product(v);
    v = problem.u;
    // Hanging nodes have been eliminated from the matrix.
    problem.geometric.set_zero(v);
    matrix.vmult(product, v);
    problem.geometric.set_zero(product);

    const double h                  = 1e-5;
    const auto   displaced_residual = [&](const double step) {
      problem.interpolate([&](const Point<dim> &p) {
        return Tensor<1, dim>(state(p) + step * direction(p));
      });
      return problem.residual(0.5);
    };
    LA::Vector difference = displaced_residual(h);
    difference -= displaced_residual(-h);
    difference /= 2. * h;
    problem.geometric.set_zero(difference);
    difference -= product;
    std::ostringstream text;
    text << name << "tangent within " << tolerance << " of differences";
    print(case_name<dim>(text.str(), degree),
          difference.l2_norm() < tolerance * product.l2_norm());
  }
} // namespace solid_test

#endif
