#ifndef stickslip_output_contact_lines_h
#define stickslip_output_contact_lines_h

#include <stickslip/output/output_parameters.h>
#include <stickslip/output/statistics_table.h>
#include <stickslip/output/surface_values.h>

#include <string>
#include <vector>

namespace stickslip
{
  /**
   * Contact along straight lines on slave surfaces: for each line of
   * Output/Contact lines a table line_NAME.csv with a row for each of its
   * points in each step with fields: step, time, distance from the first point,
   * undeformed and current position, pressure, gap, tangential traction.
   */
  template <int dim>
  class ContactLines
  {
  public:
    /// The names of pairs in @p parameters are those of all, in their order.
    ContactLines(const OutputParameters &parameters,
                 const MPI_Comm          communicator);

    /// Continues the tables of an earlier run after @p time. Collective.
    void
    resume(const double time);

    /// @p faces are the locally owned ones. Collective; throws UserError on all
    /// ranks for a point off the surface or a file that cannot be written.
    void
    write(const unsigned int                         step,
          const double                               time,
          const std::vector<ContactFaceResult<dim>> &faces);

  private:
    struct Line
    {
      std::vector<SurfacePoint<dim>> points;
      StatisticsTable                table;
    };

    const MPI_Comm    communicator;
    std::vector<Line> lines;
  };
} // namespace stickslip

#endif
