// Numbers for people.

#include "print.h"

#include <stickslip/base/short_number.h>

#include <deal.II/base/mpi.h>

#include <limits>

using namespace stickslip;
using namespace dealii;

int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const double value : {0., 3e-9, 0.00123, 0.057, 1., 1.26, 9.96, 12.7})
    print(short_number(value) + ": " + rough_number(value));
  for (const double fraction : {0.,
                                0.0571,
                                0.126,
                                0.997,
                                4.9,
                                1234.5,
                                3e6,
                                std::numeric_limits<double>::infinity()})
    print(percent(fraction));
}
