#ifndef stickslip_output_contact_points_table_h
#define stickslip_output_contact_points_table_h

#include <stickslip/contact/results/contact_result.h>

#include <deal.II/base/mpi.h>

#include <string>
#include <vector>

namespace stickslip
{
  using namespace dealii;

  /**
   * Writes all contact points of @p faces with every digit into the file
   * @p path, ordered by pair and reference position, whatever the number of
   * ranks. Rank 0 collects them. Collective; throws UserError on all ranks if
   * the file cannot be written.
   */
  template <int dim>
  void
  write_contact_points(const std::string                         &path,
                       const std::vector<ContactFaceResult<dim>> &faces,
                       const MPI_Comm                             communicator);
} // namespace stickslip

#endif
