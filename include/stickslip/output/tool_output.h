#ifndef stickslip_output_tool_output_h
#define stickslip_output_tool_output_h

#include <stickslip/contact/pairing/contact_pair.h>

#include <stickslip/output/output_parameters.h>
#include <stickslip/output/output_series.h>

#include <deal.II/base/mpi.h>

#include <memory>
#include <vector>

namespace stickslip
{
  /**
   * The rigid tools without facets that contact pairs meet, as files for
   * ParaView: pieces of their surfaces where these are. Field: displacement.
   * What is computed with is the surface itself.
   */
  template <int dim>
  class ToolOutput
  {
  public:
    using Pairs = std::vector<std::unique_ptr<ContactPair<dim>>>;

    ToolOutput(const OutputParameters &parameters, const MPI_Comm communicator);

    /// Continues the series of an earlier run after @p time. Collective.
    void
    resume(const double time);

    /**
     * Writes one step, with ghosted displacements; nothing if no pair has a
     * tool. Collective; throws UserError on all ranks if writing fails.
     */
    void
    write(const unsigned int step,
          const double       time,
          const Pairs       &pairs,
          const LA::Vector  &displacement);

  private:
    const bool   deformed;
    OutputSeries series;
  };
} // namespace stickslip

#endif
