#ifndef stickslip_contact_pairing_gap_offsets_h
#define stickslip_contact_pairing_gap_offsets_h

#include <stickslip/base/space_time_function.h>

#include <stickslip/contact/pairing/mortar_surface.h>
#include <stickslip/contact/point/contact_parameters.h>

#include <string>
#include <vector>

namespace stickslip
{
  /// What is added to the gaps of a pair: the user's function, and what becomes
  /// of gaps and overlaps that are there at the start.
  template <int dim>
  class GapOffsets
  {
  public:
    /// @p path: of the pair's section. Throws UserError for a function that
    /// cannot be parsed.
    GapOffsets(const ContactPairParameters &parameters,
               const std::string           &path);

    /// How far each point is behind its partner where nothing is deformed
    /// [length]; negative: an open gap; 0 if it has none.
    void
    set_depths_at_start(const std::vector<double> &depths)
    {
      depths_at_start = depths;
    }

    /// Sets those of the @p points and of the @p mortar surface, if there is
    /// one, at @p time. Throws UserError (same on all ranks) if the function is
    /// not a number somewhere. Collective.
    void
    apply(const double                    time,
          const MPI_Comm                 &communicator,
          std::vector<ContactPoint<dim>> &points,
          MortarSurface<dim>             *mortar) const;

  private:
    const InitialGaps      initial_gaps;
    const bool             keeps_gaps; ///< of surfaces that cannot part
    const bool             has_function;
    SpaceTimeFunction<dim> function;
    std::string            path; ///< of the function
    std::vector<double>    depths_at_start;
  };
} // namespace stickslip

#endif
