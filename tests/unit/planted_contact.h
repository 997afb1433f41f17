// Shared by tests: two blocks in contact (2D, nodal rule unless the case says
// otherwise) whose multipliers are put in by hand.

#ifndef stickslip_tests_planted_contact_h
#define stickslip_tests_planted_contact_h

#include "case_problem.h"

#include <functional>
#include <string>
#include <vector>

namespace
{
  /// The upper block: 3 x 1, three cells, modulus 10. The lower one: width x 2,
  /// cells of width 1, modulus 40. Poisson's ratio 0, so that these are the
  /// longitudinal moduli as well.
  inline std::string
  two_blocks(const std::string &contact,
             const std::string &boundary_conditions = "",
             const unsigned int lower_width         = 3)
  {
    const auto block = [](const std::string &name,
                          const unsigned int width,
                          const std::string &low,
                          const std::string &high) {
      const std::string w = std::to_string(width);
      return "subsection " + name +
             "\nset Generator = subdivided_hyper_rectangle\nset Arguments = " +
             w + ", 1 : 0, " + low + " : " + w + ", " + high +
             " : true\nset Material = " + name + "\nend\n";
    };
    const auto material = [](const std::string &name,
                             const std::string &modulus) {
      return "subsection " + name +
             "\nset Law = linear elastic\nset Poisson's ratio = 0\n"
             "set Young's modulus = " +
             modulus + "\nend\n";
    };
    return "set Dimension = 2\nsubsection Bodies\n" +
           block("upper", 3, "0", "1") +
           block("lower", lower_width, "-2", "0") +
           "end\nsubsection Materials\n" + material("upper", "10") +
           material("lower", "40") + "end\nsubsection Boundary conditions\n" +
           boundary_conditions +
           "end\nsubsection Contact\nsubsection pair\nset Slave body = upper\n"
           "set Slave boundary = 2\nset Master body = lower\n"
           "set Master boundary = 3\nset Normals = facet\n" +
           contact + "end\nend\n";
  }



  /// The case at the beginning of its first step, undeformed.
  class PlantedContact : public CaseProblem<2>
  {
  public:
    explicit PlantedContact(const std::string &prm_text)
      : CaseProblem<2>(prm_text)
    {
      problem.begin_step(1., problem.zero_state());
      problem.configure(problem.zero_state(), true);
      record_initial_pairings(problem.contact());
      press([](const double) { return 0.; });
    }

    std::vector<ContactPoint<2>> &
    points()
    {
      return problem.contact().contact_pairs()[0]->points;
    }

    const ContactPair<2> &
    pair()
    {
      return *problem.contact().contact_pairs()[0];
    }

    /// Begins an iteration where nothing has moved and lambda_n is this
    /// function of x.
    void
    press(const std::function<double(const double x)> &lambda_n)
    {
      LA::BlockVector x = problem.zero_state();
      for (const auto &slave : pair().slave_faces)
        {
          const unsigned int n_components = pair().n_multiplier_components();
          for (unsigned int j = 0; j < slave.face.n_nodes; ++j)
            x.block(1)(slave.multiplier_dofs[j * n_components]) =
              lambda_n(slave.face.reference_positions[j][0]);
        }
      x.compress(VectorOperation::insert);
      problem.begin_iteration(x);
      problem.residual(x);
    }
  };
} // namespace

#endif
