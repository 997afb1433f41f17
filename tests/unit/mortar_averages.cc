// Averaged gaps of slave faces that have a master opposite over a part s of
// their length only. Averages of a gap that the slave's shape functions can
// have are its values at the nodes, however small s is; but the sum of what
// they are weighted with, without signs, over that with signs, grows: the
// spread of the dual functions, which is printed (negative: so is their
// integral). Nodes with a spread of more than 20, or less than a hundredth of
// their area, have no partner.

#include "case_problem.h"
#include "print.h"

#include <stickslip/contact/pairing/mortar_integrals.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <string>
#include <vector>

namespace
{
  using namespace stickslip;

  /// A slave of one cell below a master that ends at s and whose lower side is
  /// a straight line at the height 1.1 + 0.2 x.
  std::string
  prm_of(const unsigned int degree, const double s)
  {
    std::ostringstream text;
    text << "set Dimension = 2\nset Degree = " << degree << "\n"
         << "subsection Bodies\n  subsection slave\n"
         << "    set Generator = subdivided_hyper_rectangle\n"
         << "    set Arguments = 1, 1 : 0, 0 : 1, 1 : true\n"
         << "    set Material  = rubber\n  end\n  subsection master\n"
         << "    set Generator   = subdivided_hyper_rectangle\n"
         << "    set Arguments   = 3, 1 : -1, 0 : " << s << ", 1 : true\n"
         << "    set Coordinates = x; y + 1.1 + 0.2*x\n"
         << "    set Material    = rubber\n  end\nend\n"
         << "subsection Materials\n  subsection rubber\n"
         << "    set Young's modulus = 1\n  end\nend\n"
         << "subsection Contact\n  subsection pair\n"
         << "    set Slave body      = slave\n    set Slave boundary  = 3\n"
         << "    set Master body     = master\n    set Master boundary = 2\n"
         << "  end\nend\n";
    return text.str();
  }



  /// The nodes of the slave face that have a partner, and their averaged gaps
  /// minus those at the nodes.
  std::string
  averages_of(CaseProblem<2> &model)
  {
    auto            &contact = model.problem.contact();
    const auto      &dofs    = model.problem.layout();
    const LA::Vector start(dofs.owned, dofs.relevant, MPI_COMM_WORLD);
    contact.update_patches(start, true);
    const LA::Vector u(dofs.owned,
                       contact.needed_displacements(),
                       MPI_COMM_WORLD);
    contact.configure(u,
                      u,
                      LA::Vector(contact.multipliers().locally_owned(),
                                 contact.multipliers().locally_relevant(),
                                 MPI_COMM_WORLD));
    const ContactPair<2> &pair    = *contact.contact_pairs()[0];
    std::string           partner = "x =";
    double                error   = 0.;
    for (const double x : {0., 0.5, 1.}) // nodes by place
      for (const auto &point : pair.points)
        {
          const auto &node = pair.mortar->node(point.geometry.mortar_node);
          const auto &average =
            pair.mortar->average(point.geometry.mortar_node);
          const auto  &around = node.faces.front();
          const double place  = pair.mortar->mortar_faces()[around.face]
                                 .positions[around.displacement][0];
          if (std::abs(place - x) > 1e-12 || !average.paired)
            continue;
          std::ostringstream text;
          text << ' ' << x;
          partner += text.str();
          error = std::max(error, std::abs(-average.r[1] - (0.1 + 0.2 * x)));
        }
    return partner + (error < 1e-12 ? "; gaps are those of the nodes"
                                    : "; gaps are WRONG");
  }



  /// The spread at all nodes of an edge whose first part @p s has a master.
  std::string
  spread(const unsigned int degree, const double s)
  {
    const FaceShape<2>    shape(degree);
    const QIterated<1>    fine(QGauss<1>(2), 500); // for absolute values
    std::vector<Point<1>> places;
    std::vector<double>   areas;
    for (unsigned int q = 0; q < fine.size(); ++q)
      {
        places.push_back(s * fine.point(q));
        areas.push_back(s * fine.weight(q));
      }
    MissingNodes none;
    none.is_missing.assign(shape.n_nodes(), false);
    const auto psi = weighting_functions<2>(
      WeightingFunctions::dual, shape, none, Quadrature<1>(places), areas);
    std::ostringstream  text;
    std::vector<double> L;
    text << std::setprecision(3);
    for (unsigned int l = 0; l < shape.n_nodes(); ++l)
      {
        double sum = 0., without_signs = 0.;
        for (unsigned int q = 0; q < places.size(); ++q)
          {
            shape.evaluate_values(places[q], L);
            const double value = areas[q] * combination(psi, l, L);
            sum += value;
            without_signs += std::abs(value);
          }
        text << ' ' << without_signs / sum;
      }
    return text.str();
  }
} // namespace

int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const unsigned int degree : {1, 2})
    for (const double s : {0.1, 0.12, 0.16, 0.25, 0.3, 0.7, 0.8, 1.})
      {
        CaseProblem<2>     model(prm_of(degree, s));
        std::ostringstream title;
        title << "degree " << degree << ", s = " << s << ": partners at ";
        print(title.str() + averages_of(model) + "; spread" +
              spread(degree, s));
      }
}
