#include <stickslip/linear_solvers/projected_conjugate_gradient.h>

#include <stickslip/base/no_convergence.h>

#include <stickslip/linear_solvers/factorization/distributed_factorization.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace stickslip
{
  namespace
  {
    const char *const solver_name = "Projected conjugate gradient";

    /// Fraction of the disc's radius within which a point is on its edge.
    constexpr double on_the_edge = 1e-12;

    /// Displacements that multipliers cause, with one factorization.
    class DualOperator
    {
    public:
      DualOperator(const LA::BlockSparseMatrix &matrix,
                   const LA::BlockVector       &rhs)
        : matrix(matrix)
        , rhs(rhs)
        , force(rhs.block(0))
      {
        check(factorization.factorise(matrix.block(0, 0)));
      }

      /// K du = r_u - B^T dy.
      void
      solve(const LA::Vector &dy, LA::Vector &du)
      {
        matrix.block(0, 1).vmult(force, dy);
        force.sadd(-1., rhs.block(0));
        invert(du);
      }

      /// B K^-1 B^T p.
      void
      apply(const LA::Vector &p, LA::Vector &du, LA::Vector &result)
      {
        matrix.block(0, 1).vmult(force, p);
        invert(du);
        matrix.block(1, 0).vmult(result, du);
      }

      /// B du - r_y.
      void
      gap(const LA::Vector &du, LA::Vector &result) const
      {
        matrix.block(1, 0).vmult(result, du);
        result -= rhs.block(1);
      }

      unsigned int n_solves = 0;

    private:
      const LA::BlockSparseMatrix &matrix;
      const LA::BlockVector       &rhs;
      DistributedFactorization     factorization;
      LA::Vector                   force;

      static void
      check(const FactorizationError &error)
      {
        throw_if_failed(error,
                        solver_name,
                        "the stiffness of the bodies alone is singular; "
                        "'Algorithm/Name = GCP' needs bodies that are held "
                        "without contact");
      }

      void
      invert(LA::Vector &du)
      {
        check(factorization.solve(du, force));
        ++n_solves;
      }
    };
  } // namespace



  void
  AdmissibleMultipliers::project(LA::Vector &y) const
  {
    for (const Node &node : nodes)
      {
        double square = 0.;
        for (unsigned int c = 0; c < node.n_components; ++c)
          {
            if (!node.has_contact || (c > 0 && !node.has_friction))
              y(node.first_dof + c) = 0.;
            const double value = y(node.first_dof + c);
            if (c > 0)
              square += value * value;
          }
        y(node.first_dof) = std::min<double>(y(node.first_dof), 0.);
        if (square > 1.)
          for (unsigned int c = 1; c < node.n_components; ++c)
            y(node.first_dof + c) = y(node.first_dof + c) / std::sqrt(square);
      }
    y.compress(VectorOperation::insert);
  }



  double
  AdmissibleMultipliers::largest_change(const LA::Vector &y,
                                        const LA::Vector &change) const
  {
    double normal = 0., tangential = 0., pressure = 0.;
    for (const Node &node : nodes)
      for (unsigned int c = 0; c < node.n_components; ++c)
        {
          const double value   = std::abs(change(node.first_dof + c));
          double      &largest = c == 0 ? normal : tangential;
          largest              = std::max(largest, value);
          if (c == 0)
            pressure = std::max(pressure, std::abs(y(node.first_dof)));
        }
    const MPI_Comm communicator = y.get_mpi_communicator();
    normal                      = Utilities::MPI::max(normal, communicator);
    tangential                  = Utilities::MPI::max(tangential, communicator);
    pressure                    = Utilities::MPI::max(pressure, communicator);
    return std::max(normal > 0. ? normal / std::max(pressure, normal) : 0.,
                    tangential);
  }



  void
  AdmissibleMultipliers::project_direction(const LA::Vector &y,
                                           LA::Vector       &direction) const
  {
    for (const Node &node : nodes)
      {
        double square = 0., outward = 0.;
        for (unsigned int c = 0; c < node.n_components; ++c)
          {
            if (!node.has_contact || (c > 0 && !node.has_friction))
              direction(node.first_dof + c) = 0.;
            if (c == 0)
              continue;
            square += y(node.first_dof + c) * y(node.first_dof + c);
            outward += y(node.first_dof + c) * direction(node.first_dof + c);
          }
        if (y(node.first_dof) >= 0. && direction(node.first_dof) > 0.)
          direction(node.first_dof) = 0.;
        if (square >= 1. - on_the_edge && outward > 0.)
          for (unsigned int c = 1; c < node.n_components; ++c)
            direction(node.first_dof + c) =
              direction(node.first_dof + c) -
              outward / square * y(node.first_dof + c);
      }
    direction.compress(VectorOperation::insert);
  }



  ProjectedConjugateGradient::ProjectedConjugateGradient(
    const double       tolerance,
    const unsigned int max_iterations)
    : tolerance(tolerance)
    , max_iterations(max_iterations)
  {}



  ProjectedSolve
  ProjectedConjugateGradient::solve(const LA::BlockSparseMatrix &matrix,
                                    const LA::BlockVector       &rhs,
                                    const LA::Vector            &diagonal,
                                    const AdmissibleMultipliers &admissible,
                                    const LA::Vector            &y0,
                                    LA::BlockVector &increment) const
  {
    DualOperator dual(matrix, rhs);
    LA::Vector   inverse(diagonal);
    for (const auto i : inverse.locally_owned_elements())
      inverse(i) = diagonal(i) > 0. ? 1. / diagonal(i) : 0.;
    inverse.compress(VectorOperation::insert);

    LA::Vector y(y0), dy(y0), v(y0), w(y0), z(y0), p(y0), Wp(y0), trial(y0);
    LA::Vector du(rhs.block(0)), scratch(rhs.block(0));
    admissible.project(y);
    p  = 0.;
    Wp = 0.;
    for (unsigned int iteration = 0; iteration <= max_iterations; ++iteration)
      {
        // the gradient of the dual energy: minus the weighted gap, and the slip
        dy = y;
        dy -= y0;
        dual.solve(dy, du);
        dual.gap(du, v);

        w = v;
        w.scale(inverse);
        trial = y;
        trial += w;
        admissible.project(trial);
        trial -= y;
        if (admissible.largest_change(y, trial) <= tolerance)
          {
            increment.block(0) = du;
            increment.block(1) = dy;
            return {iteration, dual.n_solves};
          }

        admissible.project_direction(y, w);
        z = p;
        admissible.project_direction(y, z);
        const double curvature = p * Wp;
        const double beta      = curvature > 0. ? -(w * Wp) / curvature : 0.;
        p                      = w;
        p.add(beta, z);
        if (v * p <= 0.)
          p = w;
        dual.apply(p, scratch, Wp);
        const double length = p * Wp;
        y.add(length > 0. ? (v * p) / length : 1., p);
        admissible.project(y);
      }
    throw NoConvergence(solver_name,
                        "no convergence in " + std::to_string(max_iterations) +
                          " iterations",
                        FailureCause::linear_solver);
  }
} // namespace stickslip
