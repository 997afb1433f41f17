#ifndef stickslip_output_contact_output_h
#define stickslip_output_contact_output_h

#include <stickslip/contact/results/contact_result.h>
#include <stickslip/output/contact_lines.h>
#include <stickslip/output/output_parameters.h>
#include <stickslip/output/output_series.h>

#include <deal.II/base/mpi.h>

#include <string>
#include <vector>

namespace stickslip
{
  /**
   * The slave surfaces of all contact pairs as files for ParaView. Fields:
   * displacement, pressure (-lambda_n), tangential_traction, gap, slip,
   * traction (pressure on the slave plus tangential_traction),
   * accumulated_slip, normal (of the master), lambda_n, Lambda, paired, status
   * and pair. On request all contact points as a table beside them, and tables
   * along lines (ContactLines).
   *
   * Multipliers and displacement are nodal by nature. What is known at contact
   * points (traction, gap, slips, normal) is brought to the nodes of each face
   * as the weighted mean sum(N_i w q) / sum(N_i w) over its points with
   * N_i > 0, which cannot overshoot the values at the points. Gap and normal
   * are those of the paired points, and 0 at nodes without any; `paired` is
   * the part of a node's points that are paired. `status` is the
   * state of the largest part of the face's area, constant on the face, so
   * that its colours are states (0 unpaired, 1 open, 2 stick, 3 slip,
   * 4 closed without friction) and not
   * something between them.
   */
  template <int dim>
  class ContactOutput
  {
  public:
    ContactOutput(const OutputParameters &parameters,
                  const MPI_Comm          communicator);

    /// Continues the series of an earlier run after @p time. Collective.
    void
    resume(const double time);

    /**
     * Writes one step; @p faces are the locally owned ones (none is fine).
     * Collective; throws UserError on all ranks if writing fails.
     */
    void
    write(const unsigned int                         step,
          const double                               time,
          const std::vector<ContactFaceResult<dim>> &faces);

  private:
    const bool        deformed;
    const bool        higher_order_cells;
    const bool        writes_points;
    const std::string directory;
    const MPI_Comm    communicator;

    OutputSeries      series;
    ContactLines<dim> lines;
  };

  /**
   * The fields of one face at its nodes, as written to files.
   */
  template <int dim>
  struct ContactNodalFields
  {
    explicit ContactNodalFields(const ContactFaceResult<dim> &face);

    std::vector<Tensor<1, dim>> tangential_traction;
    std::vector<double>         gap;
    std::vector<double>         paired; ///< 0 ... 1
    std::vector<Tensor<1, dim>> slip;
    std::vector<Tensor<1, dim>> accumulated_slip;
    std::vector<Tensor<1, dim>> normal;
    ContactState                state; ///< of the largest part of the face
  };
} // namespace stickslip

#endif
