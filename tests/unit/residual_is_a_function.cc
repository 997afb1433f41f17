// The residual and the tangent's right hand side are functions of the state:
// evaluated at several states in any order, with trial states, verifications
// and other statuses between, they have the same bits. Only accepted iterates
// and what is frozen may change them.

#include "case_problem.h"
#include "print.h"

#include <stickslip/problem/verification.h>

#include <deal.II/dofs/dof_tools.h>

#include <cmath>
#include <map>
#include <string>
#include <vector>

using namespace stickslip;

namespace
{
  /// Two blocks with wavy surfaces that do not match; the upper one, the slave,
  /// hangs over. @p normals are those of nodal points, or `segments`.
  std::string
  wavy_blocks(const unsigned int dim, const std::string &normals)
  {
    const bool        is_2d = dim == 2;
    const std::string wave  = is_2d ? "sin(9*x)" : "sin(9*x + 2*z)";
    return "set Dimension = " + std::to_string(dim) +
           "\nsubsection Bodies\nsubsection upper\n"
           "set Generator = subdivided_hyper_rectangle\nset Arguments = " +
           (is_2d ? "7, 2 : 0.1, 1.06 : 1.52, 2 : true"
                  : "4, 1, 2 : 0.1, 1.06, 0.1 : 1.52, 2, 0.95 : true") +
           "\nset Coordinates = x; y + 0.03*" + wave + (is_2d ? "" : "; z") +
           "\nset Material = m\nend\nsubsection lower\n"
           "set Generator = subdivided_hyper_rectangle\nset Arguments = " +
           (is_2d ? "9, 2 : 0, 0 : 1.5, 1 : true"
                  : "5, 1, 3 : 0, 0, 0 : 1.5, 1, 1 : true") +
           "\nset Coordinates = x; y + 0.03*y*" + wave + (is_2d ? "" : "; z") +
           "\nset Material = m\nend\nend\n"
           "subsection Materials\nsubsection m\n"
           "set Law = linear elastic\nset Young's modulus = 10\nend\nend\n"
           "subsection Contact\nsubsection pair\nset Slave body = upper\n"
           "set Slave boundary = 2\nset Master body = lower\n"
           "set Master boundary = 3\nset Friction = Coulomb\n"
           "set Friction coefficient = 0.4\nset Facet overlap = 0.1\n"
           "set Quadrature = " +
           (normals == "segments" ? "segments"
                                  : "nodal\nset Normals = " + normals) +
           "\nend\nend\n";
  }



  /// The upper block moves, both bend a little.
  template <int dim>
  LA::BlockVector
  moved(const ContactProblem<dim> &problem,
        const double               along,
        const double               down)
  {
    const auto                                   &layout = problem.layout();
    std::map<types::global_dof_index, Point<dim>> places;
    DoFTools::map_dofs_to_support_points(layout.mapping,
                                         layout.dof_handler,
                                         places);
    LA::BlockVector                      x = problem.zero_state();
    std::vector<types::global_dof_index> dofs(layout.fe().n_dofs_per_cell());
    for (const auto &cell : layout.dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          cell->get_dof_indices(dofs);
          for (unsigned int i = 0; i < dofs.size(); ++i)
            if (layout.owned.is_element(dofs[i]))
              {
                const Point<dim>  &p = places.at(dofs[i]);
                const unsigned int c =
                  layout.fe().system_to_component_index(i).first;
                const double is_upper = cell->center()[1] > 1. ? 1. : 0.;
                x.block(0)(dofs[i]) =
                  0.004 * std::sin(3. * p[0] + 2. * p[1] + c) +
                  is_upper * (c == 0   ? along
                              : c == 1 ? -down
                                       : 0.);
              }
        }
    for (const auto i : x.block(1).locally_owned_elements())
      x.block(1)(i) = i % dim == 0 ? -1. - 0.3 * std::sin(0.7 * i)
                                   : 0.6 * std::sin(1.3 * i + 40. * along);
    x.compress(VectorOperation::insert);
    return x;
  }



  /// All that the problem says about a state.
  struct Answer
  {
    ResidualNorms   norms;
    LA::Vector      forces;
    LA::BlockVector rhs;

    bool
    has_same_bits_as(const Answer &other) const
    {
      bool same = norms.equilibrium == other.norms.equilibrium &&
                  norms.contact == other.norms.contact &&
                  norms.prescribed == other.norms.prescribed;
      for (const auto i : forces.locally_owned_elements())
        same = same && forces(i) == other.forces(i) &&
               rhs.block(0)(i) == other.rhs.block(0)(i);
      for (const auto i : rhs.block(1).locally_owned_elements())
        same = same && rhs.block(1)(i) == other.rhs.block(1)(i);
      return Utilities::MPI::min(same ? 1 : 0, MPI_COMM_WORLD) == 1;
    }
  };



  template <int dim>
  Answer
  answer(ContactProblem<dim> &problem, const LA::BlockVector &x)
  {
    Answer result;
    result.norms  = problem.residual(x);
    result.forces = problem.nodal_forces();
    problem.assemble(x);
    result.rhs = problem.right_hand_side();
    return result;
  }



  /// Names of the master facets of this rank's points.
  template <int dim>
  std::vector<FaceId>
  facets(ContactProblem<dim> &problem, const LA::BlockVector &x)
  {
    problem.configure(x, true);
    std::vector<FaceId> result;
    for_each_point(problem.contact(), [&](const auto &, const auto &point) {
      result.push_back(point.pairing.paired ? point.pairing.face_id : FaceId());
    });
    return result;
  }



  template <int dim>
  void
  test(const std::string &normals)
  {
    for (unsigned int combination = 0; combination < 8; ++combination)
      {
        CaseProblem<dim>     blocks(wavy_blocks(dim, normals));
        ContactProblem<dim> &problem = blocks.problem;
        problem.begin_step(1., moved(problem, 0., 0.03));
        // points that switch facets take notice of it
        for_each_point(problem.contact(), [](const auto &, auto &point) {
          point.hysteresis.set_active(true);
        });
        std::string  name = std::to_string(dim) + "D, " + normals + ", frozen:";
        unsigned int i    = 0;
        for (FreezableQuantity *quantity : problem.quantities())
          {
            quantity->set_live(false);
            quantity->evaluate(moved(problem, 0.05, 0.04));
            quantity->accept();
            const bool is_live = (combination >> i++) % 2 == 0;
            quantity->set_live(is_live);
            name += is_live ? "" : " " + quantity->name();
          }
        const std::vector<LA::BlockVector> states = {moved(problem, 0.1, 0.05),
                                                     moved(problem, 0.31, 0.06),
                                                     moved(problem, 0.52, 0.02),
                                                     moved(problem, -0.2, 0.4)};
        bool is_function = true, is_changed = false;
        for (const unsigned int iterate : {0, 1})
          {
            // accepted back and forth, so that points keep the facet that they
            // remember
            for (unsigned int i = 0; i < 20 * iterate; ++i)
              problem.begin_iteration(states[i % 2 == 0 ? 2 : 0]);
            problem.begin_iteration(states[iterate]);
            std::vector<Answer> first;
            for (const auto &x : states)
              first.push_back(answer(problem, x));
            const auto check = [&](const unsigned int k) {
              is_function =
                is_function &&
                answer(problem, states[k]).has_same_bits_as(first[k]);
            };
            // back and forth, often enough to be taken for a point at a kink
            for (unsigned int round = 0; round < 10; ++round)
              for (const unsigned int k : {2, 0, 3, 1})
                {
                  check(k);
                  for (const double step : {1., 0.5, 0.25})
                    {
                      LA::BlockVector trial = states[k];
                      trial.sadd(1. - step, step, states[(k + 1) % 4]);
                      problem.residual(trial);
                    }
                  if (round < 2)
                    verify_state(problem, states[(k + 2) % 4], {});
                  if (round == 2)
                    {
                      const StatusRuleScope<dim> scope(problem.contact(),
                                                       StatusRule::all_stick);
                      problem.assemble(states[k]);
                    }
                  check(k);
                }
            is_changed =
              facets(problem, states[0]) != facets(problem, states[2]);
          }
        is_changed =
          Utilities::MPI::max(is_changed ? 1 : 0, MPI_COMM_WORLD) == 1;
        print(name + (is_changed ? " (points change their facets)" : ""));
        print("  the same bits in any order", is_function);
      }
  }
} // namespace



int
main(int argc, char *argv[])
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const std::string normals : {"facet", "smoothed", "segments"})
    {
      test<2>(normals);
      test<3>(normals);
    }
}
