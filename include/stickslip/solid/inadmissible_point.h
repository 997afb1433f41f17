#ifndef stickslip_solid_inadmissible_point_h
#define stickslip_solid_inadmissible_point_h

#include <stickslip/base/no_convergence.h>

#include <stickslip/mesh/body.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/point.h>

#include <string>

namespace stickslip
{
  /**
   * Remembers where an evaluation of the bodies failed: one point, the same
   * one on any number of ranks.
   */
  template <int dim>
  class InadmissiblePoint
  {
  public:
    /// A point of this rank, with its reference position and body. Without
    /// @p has_volume det F <= 0, otherwise the law found no stress.
    void
    record(const dealii::Point<dim> &position,
           const unsigned int        body,
           const bool                has_volume);

    /// Collective.
    bool
    exists(const MPI_Comm communicator) const;

    /// What happened, with body and position; empty texts if there is no such
    /// point. Collective.
    InadmissibleState
    describe(const MPI_Comm communicator, const Bodies &bodies) const;

  private:
    bool               happened = false;
    dealii::Point<dim> position;
    unsigned int       body       = 0;
    bool               has_volume = true;
  };
} // namespace stickslip

#endif
