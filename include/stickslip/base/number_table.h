#ifndef stickslip_base_number_table_h
#define stickslip_base_number_table_h

#include <deal.II/base/mpi.h>

#include <string>
#include <utility>
#include <vector>

namespace stickslip
{
  /// Points (x_i, y_i), line by line.
  using NumberTable = std::vector<std::pair<double, double>>;

  /**
   * Reads two columns of a file of numbers that are separated by commas,
   * semicolons or blanks, on one rank for all. A first line without numbers
   * has the names of the columns; what follows a # and empty lines are left
   * out. @p file_name is relative to @p directory, @p columns are the two,
   * counted from 1. Collective. Throws UserError, on all ranks, which names
   * the line and @p path, the parameter that names the file.
   */
  NumberTable
  read_number_table(const std::string               &file_name,
                    const std::string               &directory,
                    const std::vector<unsigned int> &columns,
                    const std::string               &path,
                    const MPI_Comm                   communicator);
} // namespace stickslip

#endif
