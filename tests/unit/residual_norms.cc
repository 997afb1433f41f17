// The norms of planted residuals: which unit each has, and what it must not
// depend on.

#include "print.h"

#include <stickslip/problem/residual_norms.h>

#include <sstream>
#include <string>

using namespace stickslip;

namespace
{
  /// Three displacements, of which the last is prescribed, and two multipliers.
  struct Planted
  {
    Planted()
      : rows(complete_index_set(2), MPI_COMM_SELF)
      , sizes(rows)
    {
      for (LA::Vector *v : {&unbalanced, &loads})
        v->reinit(complete_index_set(3), MPI_COMM_SELF);
      increment.add_line(2);
      increment.close();
      unbalanced(0) = 3.;
      unbalanced(2) = 20.; // a reaction
      loads(1)      = 10.;
      // a gap of 0.02 face diameters and a Lambda that is off by 0.5
      rows(0)        = 0.02 * 7.;
      sizes.scale(0) = 7.;
      sizes.force(0) = 100.;
      rows(1)        = 0.5 * 1e-6;
      sizes.scale(1) = 1e-6;
      sizes.force(1) = 4.;
    }

    void
    show(const std::string &title) const
    {
      const ResidualNorms norms = residual_norms(
        {unbalanced, loads, rows, sizes}, increment, 1., MPI_COMM_SELF);
      std::ostringstream text;
      text << title << ": equilibrium " << norms.equilibrium << ", contact "
           << norms.contact << ", merit^2 " << norms.merit * norms.merit;
      print(text.str());
    }

    LA::Vector      unbalanced, loads, rows;
    ContactRowSizes sizes;
    Constraints     increment;
  };
} // namespace



int
main(int argc, char *argv[])
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  Planted().show("planted (3/20, 0.5, 3^2 + 2^2 + 2^2)");

  Planted reaction;
  reaction.unbalanced(2) = 200.;
  reaction.show("a larger reaction: the merit is the same");

  Planted scaled;
  scaled.rows(0) *= 1e3;
  scaled.sizes.scale(0) *= 1e3;
  scaled.show("a contact row in another unit: the same");

  Planted long_Lambda;
  long_Lambda.rows(1) = 300. * 1e-6;
  long_Lambda.show("Lambda of 300: no more force than of 1");

  // The slip is a difference of places that are known up to 2e-7.
  Planted far;
  far.sizes.roundoff(1) = 2e-7;
  far.show("Lambda of 0.5, of which 0.2 is roundoff");
  far.rows(1) = -1.9e-7;
  far.show("Lambda within roundoff: the gap alone (0.02, 3^2 + 2^2)");

  Planted excluded;
  excluded.increment.reinit();
  excluded.increment.add_line(2);
  excluded.increment.add_line(3);
  excluded.increment.close();
  excluded.show("the first row constrained");

  // u_1 = -2 u_0: held along (2, 1), free along (1, -2). The reaction is
  // 1.5 (2, 1); what is left of (3, 1.5) along the free direction is nothing.
  Planted oblique;
  oblique.increment.reinit();
  oblique.increment.add_line(1);
  oblique.increment.add_entry(1, 0, -2.);
  oblique.increment.add_line(2);
  oblique.increment.close();
  oblique.unbalanced(1) = 1.5;
  oblique.show("held along an oblique direction: no imbalance");
}
