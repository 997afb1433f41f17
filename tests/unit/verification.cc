// What the examination of a converged state accepts and what it rejects:
// states are made by hand, one violation of the contact law at a time.

#include "case_problem.h"
#include "print.h"

#include <stickslip/problem/verification.h>

#include <functional>
#include <iomanip>
#include <sstream>
#include <vector>

using namespace stickslip;

namespace
{
  /// Two blocks of height 1 with three cells each along x, one on the other.
  std::string
  two_blocks(const unsigned int dim, const std::string &quadrature)
  {
    const auto block = [dim](const std::string &name, const unsigned int y) {
      const std::string low = std::to_string(y), high = std::to_string(y + 1);
      return "subsection " + name +
             "\nset Generator = subdivided_hyper_rectangle\nset Arguments = " +
             (dim == 2 ? "3, 1 : 0, " + low + " : 3, " + high
                       : "3, 1, 1 : 0, " + low + ", 0 : 3, " + high + ", 1") +
             " : true\nset Material = m\nend\n";
    };
    return "set Dimension = " + std::to_string(dim) + "\nsubsection Bodies\n" +
           block("lower", 0) + block("upper", 1) +
           "end\nsubsection Materials\nsubsection m\n"
           "set Law = linear elastic\nset Young's modulus = 10\nend\nend\n"
           "subsection Contact\nsubsection pair\nset Slave body = upper\n"
           "set Slave boundary = 2\nset Master body = lower\n"
           "set Master boundary = 3\nset Friction = Coulomb\n"
           "set Friction coefficient = 0.5\nset Quadrature = " +
           quadrature + "\nset Normals = facet\nend\nend\n";
  }



  template <int dim>
  class Blocks : public CaseProblem<dim>
  {
  public:
    using CaseProblem<dim>::problem;

    explicit Blocks(const std::string &quadrature)
      : CaseProblem<dim>(two_blocks(dim, quadrature))
    {
      problem.begin_step(1., problem.zero_state());
      problem.configure(problem.zero_state(), true);
      record_initial_pairings(problem.contact());
      problem.begin_iteration(problem.zero_state());
    }

    /// The upper block moves by @p motion; @p lambda_n and @p Lambda (along x)
    /// are the same everywhere.
    LA::BlockVector
    state(const Tensor<1, dim> &motion,
          const double          lambda_n,
          const double          Lambda)
    {
      LA::BlockVector                      x      = problem.zero_state();
      const auto                          &layout = problem.layout();
      std::vector<types::global_dof_index> dofs(
        layout.dof_handler.get_fe().n_dofs_per_cell());
      for (const auto &cell : layout.dof_handler.active_cell_iterators())
        if (cell->is_locally_owned() && cell->center()[1] > 1.)
          {
            cell->get_dof_indices(dofs);
            for (unsigned int i = 0; i < dofs.size(); ++i)
              x.block(0)(dofs[i]) = motion[layout.dof_handler.get_fe()
                                             .system_to_component_index(i)
                                             .first];
          }
      x.compress(VectorOperation::insert);
      // component of Lambda along x: the nodal tangents are not known here
      problem.configure(x, true);
      for (const auto &node : problem.contact().multipliers().owned_nodes())
        x.block(1)(node.first_dof) = lambda_n;
      x.compress(VectorOperation::insert);
      set_Lambda(x, Lambda);
      return x;
    }

  private:
    /// The first tangent is along x, forward or backward, on flat faces.
    void
    set_Lambda(LA::BlockVector &x, const double Lambda)
    {
      double forward = 0.;
      for (const auto &point : problem.contact().contact_pairs()[0]->points)
        if (point.pairing.paired)
          forward = point.pairing.tau[0][0] > 0. ? 1. : -1.;
      forward = Utilities::MPI::sum(forward, MPI_COMM_WORLD) > 0. ? 1. : -1.;
      for (const auto &node : problem.contact().multipliers().owned_nodes())
        x.block(1)(node.first_dof + 1) = forward * Lambda;
      x.compress(VectorOperation::insert);
    }
  };



  /// What is wrong with a state, and whether it is rejected for that.
  template <int dim>
  void
  look(const std::string &title, Blocks<dim> &blocks, const LA::BlockVector &x)
  {
    // the bodies are not in equilibrium: only the contact law is of interest
    VerificationParameters parameters;
    parameters.residual_tolerance = 1e10;
    const Verification      found = verify_state(blocks.problem, x, parameters);
    const ContactViolation &v     = found.violation;
    std::ostringstream      text;
    text << "  " << title << ": " << std::fixed << std::setprecision(6)
         << "normal " << v.normal_law << ", friction " << v.friction_law
         << ", |Lambda| - 1 " << v.friction_cone_excess << ", fallen "
         << v.fallen_through
         << (found.errors.empty() ? ": accepted" : ": rejected");
    print(text.str());
  }



  template <int dim>
  void
  test(const std::string &quadrature)
  {
    print(std::to_string(dim) + "D, " + quadrature);
    Blocks<dim>          blocks(quadrature);
    const Tensor<1, dim> rest;
    const auto           motion = [](const double x, const double y) {
      Tensor<1, dim> m;
      m[0] = x;
      m[1] = y;
      return m;
    };
    const auto look_at = [&](const std::string    &title,
                             const Tensor<1, dim> &m,
                             const double          lambda_n,
                             const double          Lambda) {
      look(title, blocks, blocks.state(m, lambda_n, Lambda));
    };
    look_at("at rest", rest, 0., 0.);
    look_at("pressed", rest, -1., 0.);
    look_at("apart", motion(0., 0.1), 0., 0.);
    look_at("penetration", motion(0., -0.1), 0., 0.);
    look_at("tension", rest, 1., 0.);
    look_at("pressure across a gap", motion(0., 0.1), -1., 0.);
    look_at("sticks, in the disc", rest, -1., 0.7);
    look_at("outside of the disc", rest, -1., 1.3);
    look_at("slips along Lambda", motion(0.1, 0.), -1., 1.);
    look_at("slips against Lambda", motion(0.1, 0.), -1., -1.);
    look_at("slips within the disc", motion(0.1, 0.), -1., 0.5);
    look_at("a motion too small to notice", motion(1e-9, -1e-9), -1., 0.5);
    look_at("has fallen through", motion(0., -6.), 0., 0.);
  }



  /// Nothing of what an algorithm has frozen changes by an examination.
  void
  test_restoration()
  {
    Blocks<2>             blocks("nodal");
    auto                 &contact = blocks.problem.contact();
    const LA::BlockVector x = blocks.state(Tensor<1, 2>({1.5, -0.01}), -1., 0.);
    contact.live            = {false, false, false};
    const auto frames       = [&]() {
      std::ostringstream text;
      for (const auto &point : contact.contact_pairs()[0]->points)
        text << point.pairing.paired << point.pairing.xi << point.pairing.face
             << ' ';
      return text.str();
    };
    blocks.problem.configure(blocks.problem.zero_state(), true);
    const std::string before = frames();
    look("examined elsewhere", blocks, x);
    const bool is_restored = before == frames() && !contact.live.geometry &&
                             !contact.live.threshold && !contact.live.status;
    print("  all is as it was", is_restored);
  }
} // namespace



int
main(int argc, char *argv[])
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test<2>("nodal");
  test<3>("nodal");
  test<2>("Gauss"); // the law holds weakly: no complaint about points
  print("frozen quantities");
  test_restoration();
}
