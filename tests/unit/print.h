// Shared by tests: lines of output that are the same on any number of ranks.

#ifndef stickslip_tests_print_h
#define stickslip_tests_print_h

#include <deal.II/base/mpi.h>

#include <iostream>
#include <string>

namespace
{
  /// A line from rank 0.
  inline void
  print(const std::string &text)
  {
    if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      std::cout << text << std::endl;
  }



  /// Whether @p holds is true on all ranks. Collective.
  inline void
  print(const std::string &text, const bool holds)
  {
    print(text + ": " +
          (dealii::Utilities::MPI::min(holds ? 1 : 0, MPI_COMM_WORLD) == 1
             ? "yes"
             : "NO"));
  }
} // namespace

#endif
