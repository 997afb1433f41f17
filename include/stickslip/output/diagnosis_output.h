#ifndef stickslip_output_diagnosis_output_h
#define stickslip_output_diagnosis_output_h

#include <stickslip/contact/cycling/point_diagnosis.h>

#include <string>
#include <vector>

namespace stickslip
{
  /**
   * Writes what the contact points did in a failed attempt at step @p step into
   * @p directory: diagnosis-0007.csv (every digit; rank 0 collects and sorts
   * the rows of all points) and diagnosis-0007.vtu (a vertex per point at its
   * current position). A later failed attempt at the same step replaces
   * both. @p pair_names by index. Returns the names without directory, or ""
   * if there are no contact points at all. Collective; throws UserError on all
   * ranks if the files cannot be written.
   */
  template <int dim>
  std::string
  write_diagnosis(const std::string                      &directory,
                  const unsigned int                      step,
                  const std::vector<PointDiagnosis<dim>> &points,
                  const std::vector<std::string>         &pair_names,
                  const MPI_Comm                          communicator);
} // namespace stickslip

#endif
