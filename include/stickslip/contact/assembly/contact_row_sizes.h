#ifndef stickslip_contact_assembly_contact_row_sizes_h
#define stickslip_contact_assembly_contact_row_sizes_h

#include <stickslip/base/types.h>

namespace stickslip
{
  using namespace dealii;

  /// What the residuals of contact rows are measured against. Vectors of the
  /// multipliers, of locally owned entries.
  struct ContactRowSizes
  {
    /// Zeros, with the entries of @p multipliers.
    explicit ContactRowSizes(const LA::Vector &multipliers)
      : scale(multipliers.locally_owned_elements(),
              multipliers.get_mpi_communicator())
      , force(scale)
      , roundoff(scale)
    {}

    /// Adds up what ranks have added to each other's rows. Collective.
    void
    compress()
    {
      for (LA::Vector *const v : {&scale, &force, &roundoff})
        v->compress(VectorOperation::add);
    }

    LA::Vector scale; ///< the row for a gap of one face diameter, or |Lambda|
                      ///< off by one
    LA::Vector force; ///< what this gap, closed by the stiffness of the
                      ///< contact, and this Lambda are as forces
    LA::Vector roundoff; ///< the row for gaps and slips that are the roundoff
                         ///< of the places they are differences of
  };
} // namespace stickslip

#endif
