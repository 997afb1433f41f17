// Cells of linear laws, which are summed up once, against the same cells when
// they are evaluated each time: distorted and locally refined meshes, loads,
// prescribed displacements.

#include "solid_problem.h"

#include <algorithm>
#include <memory>
#include <string>

using namespace solid_test;

namespace
{
  /// Linear elasticity that does not say that it is linear.
  class EvaluatedEachTime : public LinearElastic
  {
  public:
    bool
    is_linear() const override
    {
      return false;
    }
  };



  template <int dim>
  void
  finish(Problem<dim>                                 &problem,
         const std::shared_ptr<const ConstitutiveLaw> &law,
         const bool                                    with_mean_dilatation)
  {
    problem.distort();
    problem.refine_one_cell();
    auto spring      = condition("spring", {2});
    spring.stiffness = 7.;
    spring.direction = (dim == 2 ? "1, 2" : "1, 2, -1");
    problem.finish(
      law,
      {{"wall",
        condition("displacement", {0}, dim == 2 ? "0.1*y; 0" : "0.1*y; 0; z")},
       {"gas", condition("follower pressure", {1}, "20*(1+x*y)*t")},
       {"spring", spring},
       {"weight",
        condition("body force", {}, dim == 2 ? "0; -1" : "0; 0; -1")}},
      with_mean_dilatation);
    problem.interpolate([](const Point<dim> &p) {
      Tensor<1, dim> u;
      for (unsigned int d = 0; d < dim; ++d)
        u[d] = 0.1 * std::sin(p[d] + 2. * p[(d + 1) % dim]);
      return u;
    });
  }



  bool
  agree(LA::Vector a, const LA::Vector &b)
  {
    a -= b;
    return a.l2_norm() < 1e-12 * b.l2_norm();
  }



  template <int dim>
  void
  compare(const unsigned int degree, const bool with_mean_dilatation)
  {
    Problem<dim> once(degree), each_time(degree);
    finish(once, steel<LinearElastic>(), with_mean_dilatation);
    finish(each_time, steel<EvaluatedEachTime>(), with_mean_dilatation);
    const std::string suffix = with_mean_dilatation ? ", B-bar" : "";
    print(case_name<dim>("residuals agree" + suffix, degree),
          agree(once.residual(0.5), each_time.residual(0.5)));

    const Constraints constraints = once.increment_constraints(0.5);
    LA::SparseMatrix  matrix, other_matrix;
    LA::Vector        rhs, other_rhs;
    // the second time nothing is left of the first
    once.assemble_tangent(0.5, constraints, matrix, rhs);
    once.assemble_tangent(0.5, constraints, matrix, rhs);
    each_time.assemble_tangent(0.5, constraints, other_matrix, other_rhs);
    constraints.set_zero(rhs);
    constraints.set_zero(other_rhs);
    print(case_name<dim>("right hand sides agree" + suffix, degree),
          agree(rhs, other_rhs));

    LA::Vector v(once.owned, MPI_COMM_WORLD), product(v), other_product(v);
    v = once.u;
    constraints.set_zero(v);
    matrix.vmult(product, v);
    other_matrix.vmult(other_product, v);
    print(case_name<dim>("tangents agree" + suffix, degree),
          agree(product, other_product));

    double smallest = 1e300;
    for (const auto i : once.owned)
      if (constraints.is_constrained(i))
        smallest = std::min(smallest, matrix.diag_element(i));
    print(case_name<dim>("constrained rows have a diagonal" + suffix, degree),
          Utilities::MPI::min(smallest, MPI_COMM_WORLD) > 1.);
  }
} // namespace



int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize initialization(argc, argv, 1);
  compare<2>(1, false);
  compare<2>(2, false);
  compare<2>(1, true);
  compare<3>(1, false);
  compare<3>(2, false);
  compare<3>(1, true);
}
