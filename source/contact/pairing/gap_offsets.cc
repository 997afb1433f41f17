#include <stickslip/contact/pairing/gap_offsets.h>

#include <stickslip/base/user_error.h>

#include <cmath>
#include <sstream>

namespace stickslip
{
  template <int dim>
  GapOffsets<dim>::GapOffsets(const ContactPairParameters &parameters,
                              const std::string           &path_of_pair)
    : initial_gaps(parameters.initial_gaps)
    , keeps_gaps(parameters.is_bilateral())
    , has_function(parameters.gap_offset != "0")
    , function(parameters.gap_offset, 1, path_of_pair + "/Gap offset")
    , path(path_of_pair + "/Gap offset")
  {}



  template <int dim>
  void
  GapOffsets<dim>::apply(const double                    time,
                         const MPI_Comm                 &communicator,
                         std::vector<ContactPoint<dim>> &points,
                         MortarSurface<dim>             *mortar) const
  {
    std::ostringstream error;
    for (unsigned int i = 0; i < points.size(); ++i)
      {
        ContactPoint<dim> &point = points[i];
        point.gap_offset =
          function.value(Point<dim>(point.geometry.reference_position), time);
        if (error.str().empty() && !std::isfinite(point.gap_offset))
          error << "'" << path << "' is not a number at ("
                << point.geometry.reference_position << "), time " << time
                << ".";
        if (depths_at_start.empty() ||
            !(initial_gaps.changes_gaps() || keeps_gaps))
          continue;
        const double of_start =
          keeps_gaps ? initial_gaps.kept_share(time) * depths_at_start[i]
                     : initial_gaps.offset(depths_at_start[i], time);
        point.gap_offset += of_start;
        if (mortar && !keeps_gaps)
          mortar->set_gap_offset(point.geometry.mortar_node, of_start);
      }
    throw_collectively(error.str(), communicator);
    if (mortar && mortar->keeps_partners())
      mortar->set_kept_share(initial_gaps.kept_share(time));
    if (mortar && has_function)
      mortar->update_gap_offsets([this, time](const Point<dim> &position) {
        return function.value(position, time);
      });
  }

  template class GapOffsets<2>;
  template class GapOffsets<3>;
} // namespace stickslip
