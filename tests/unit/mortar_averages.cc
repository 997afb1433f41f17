// Averaged gaps of slave faces that have a master opposite over a part s of
// their length only. Averages of a gap that the slave's shape functions can
// have are its values at the nodes, however small s is; but the sum of what
// they are weighted with, without signs, over that with signs, grows: the
// spread of the dual functions, which is printed (negative: so is their
// integral). Nodes with a spread of more than 20, or less than a hundredth of
// their area, have no partner. Then gaps that are no polynomials.

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

  /// A @p slave, of one cell, below a master with @p n cells that ends at s and
  /// whose lower side has the height 1 + @p gap.
  std::string
  prm_of(const unsigned int degree,
         const double       s,
         const std::string &gap,
         const std::string &slave = "1, 1 : 0, 0 : 1, 1 : true",
         const unsigned int n     = 30)
  {
    std::ostringstream text;
    text << "set Dimension = 2\nset Degree = " << degree << "\n"
         << "subsection Bodies\n  subsection slave\n"
         << "    set Generator = subdivided_hyper_rectangle\n"
         << "    set Arguments = " << slave << "\n"
         << "    set Material  = rubber\n  end\n  subsection master\n"
         << "    set Generator   = subdivided_hyper_rectangle\n"
         << "    set Arguments   = " << n << ", 1 : -1, 0 : " << s
         << ", 1 : true\n"
         << "    set Coordinates = x; y + 1 + " << gap << "\n"
         << "    set Material    = rubber\n  end\nend\n"
         << "subsection Materials\n  subsection rubber\n"
         << "    set Young's modulus = 1\n  end\nend\n"
         << "subsection Contact\n  subsection pair\n"
         << "    set Slave body      = slave\n    set Slave boundary  = 3\n"
         << "    set Master body     = master\n    set Master boundary = 2\n"
         << "    set Search distance = 20\n  end\nend\n";
    return text.str();
  }



  const std::string straight = "0.1 + 0.2*x";

  struct Averages
  {
    std::string partners;   ///< the nodes of the slave face that have one
    std::string gaps  = ""; ///< averaged
    double      error = 0.; ///< of these against `straight` at the nodes
  };

  Averages
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
    const ContactPair<2> &pair = *contact.contact_pairs()[0];
    Averages              result;
    result.partners = "x =";
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
          std::ostringstream text, gap;
          text << ' ' << x;
          gap << ' ' << std::setprecision(3) << -average.r[1];
          result.partners += text.str();
          result.gaps += gap.str();
          result.error =
            std::max(result.error, std::abs(-average.r[1] - (0.1 + 0.2 * x)));
        }
    return result;
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



  void
  show(const std::string &what, const std::string &prm)
  {
    CaseProblem<2> model(prm);
    const Averages averages = averages_of(model);
    print(what + ": partners at " + averages.partners + "; averages" +
          averages.gaps);
  }



  /// An edge of 1 after one of 0.4, below a gap that begins to rise steeply
  /// within it.
  std::string
  kink(const double gap)
  {
    return prm_of(1,
                  1.,
                  std::to_string(gap) + " + 8*max(x - 0.4, 0)",
                  "3, 1 : -1, 0 : 2, 1 : true\n"
                  "    set Coordinates = max(x, 0) + 0.4*min(x, 0); y");
  }



  /// A node that has touched in a step keeps its partner.
  void
  test_memory()
  {
    CaseProblem<2>  model(kink(0.48));
    ContactPair<2> &pair = *model.problem.contact().contact_pairs()[0];
    const auto show_with = [&](const std::string &what, const double more) {
      pair.mortar->update_gap_offsets([&](const Point<2> &) { return more; });
      const Averages averages = averages_of(model);
      print(what + ": partners at " + averages.partners);
    };
    show_with("near", 0.);
    show_with("  farther, from there", 0.1);
    show_with("near", 0.);
    pair.mortar->accept_iterate();
    show_with("  farther, from an accepted iterate", 0.1);
    pair.mortar->accept_iterate();
    show_with("  and farther", 0.2);
    pair.mortar->accept_iterate();
    show_with("  open", 0.7);
    pair.mortar->accept_iterate();
    show_with("  back", 0.2);
    show_with("near", 0.);
    pair.mortar->accept_iterate();
    pair.mortar->accept_step();
    show_with("  farther, from an accepted step", 0.1);
    show_with("near", 0.);
    pair.mortar->accept_iterate();
    pair.mortar->restore();
    show_with("  farther, in a repeated step", 0.1);
  }
} // namespace

int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const unsigned int degree : {1, 2})
    for (const double s : {0.1, 0.12, 0.16, 0.25, 0.3, 0.7, 0.8, 1.})
      {
        CaseProblem<2>     model(prm_of(degree, s, straight));
        const Averages     averages = averages_of(model);
        std::ostringstream title;
        title << "degree " << degree << ", s = " << s << ": partners at ";
        print(title.str() + averages.partners +
              (averages.error < 1e-12 ? "; gaps are those of the nodes"
                                      : "; gaps are WRONG") +
              "; spread" + spread(degree, s));
      }
  // The average of the node where the gap is small says closed, or hardly open.
  // Nothing touches if it is farther away than half of the edge.
  for (const double gap : {1.1, 0.9, 0.52, 0.48})
    show("kink above " + std::to_string(gap).substr(0, 4), kink(gap));
  // Edges that are inclined by so much that all of their integration points are
  // farther away, and touch with an end.
  show("touches", prm_of(1, 1., "8*x - 0.01", "1, 1 : 0, 0 : 1, 1 : true", 2));
  show("touches with a corner",
       prm_of(1, 1., "8*abs(x) - 0.01", "2, 1 : -1, 0 : 1, 1 : true", 2));
  for (const double s : {0.3, 0.55})
    show("the master ends at " + std::to_string(s).substr(0, 4) +
           ", where its extension would touch",
         prm_of(1, s, "3 - 4*x"));
  test_memory();
}
