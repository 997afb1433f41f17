// Anderson's acceleration of linear fixed-point iterations: slow, divergent
// and in several directions at once.

#include "print.h"

#include <stickslip/strategy/fixed_point_acceleration.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace stickslip;

namespace
{
  /// Two blocks of equal size, distributed over the ranks.
  LA::BlockVector
  zero(const unsigned int n)
  {
    const unsigned int rank = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
    const unsigned int size = Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
    IndexSet           owned(n);
    owned.add_range(n * rank / size, n * (rank + 1) / size);
    return LA::BlockVector({owned, owned}, MPI_COMM_WORLD);
  }



  /// Passes of x -> fixed + factors (x - fixed) until the error of both blocks
  /// is below 1e-8; 0 if a hundred are not enough. The second block follows the
  /// first one, as multipliers follow displacements.
  unsigned int
  n_passes(const std::vector<double> &factors, const bool accelerated)
  {
    LA::BlockVector        x = zero(factors.size()), start(x);
    FixedPointAcceleration acceleration;
    for (unsigned int pass = 1; pass <= 100; ++pass)
      {
        start        = x;
        double error = 0.;
        for (const auto i : x.block(0).locally_owned_elements())
          {
            const double fixed = 1. + i;
            const double value =
              fixed + factors[i] * (start.block(0)(i) - fixed);
            x.block(0)(i) = value;
            x.block(1)(i) = 2. * value;
            error         = std::max({error,
                                      std::abs(value - fixed),
                                      std::abs(x.block(1)(i) - 2. * fixed)});
          }
        x.compress(VectorOperation::insert);
        if (Utilities::MPI::max(error, MPI_COMM_WORLD) < 1e-8)
          return pass;
        if (accelerated)
          acceleration.improve(start, x);
      }
    return 0;
  }
} // namespace



int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const std::vector<double>        slow(6, 0.9), faster(6, 0.5);
  const std::vector<double>        slower(6, 0.97), divergent(6, 1.2);
  const std::vector<double>        mixed{{0.9, 0.3, -0.4, 0.9, 0.3, -0.4}};

  print("plain passes with factor 0.9 do not settle",
        n_passes(slow, false) == 0);
  print("accelerated ones do in 3", n_passes(slow, true) == 3);
  print("factor 0.5: in 3 as well", n_passes(faster, true) == 3);
  print("factor 0.97, beyond the longest correction: passes " +
          std::to_string(n_passes(slower, true)),
        n_passes(slower, true) > 3);
  print("factor 1.2, which diverges otherwise: in at most 10",
        n_passes(divergent, false) == 0 && n_passes(divergent, true) > 0 &&
          n_passes(divergent, true) <= 10);
  print("three factors at once: in 5", n_passes(mixed, true) == 5);
  return 0;
}
