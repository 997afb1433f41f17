#ifndef stickslip_problem_residual_norms_h
#define stickslip_problem_residual_norms_h

#include <stickslip/base/types.h>

#include <stickslip/contact/assembly/contact_row_sizes.h>

#include <deal.II/base/mpi.h>

namespace stickslip
{
  using namespace dealii;

  /// How far a state is from solving the discrete equations.
  struct ResidualNorms
  {
    /// ||F_int + F_contact - F_ext|| over ||F_ext|| or the reactions,
    /// whichever is larger (paper, eq. 25).
    double equilibrium = 0.;
    /// Largest gap over face size, or |Lambda| mismatch, of any contact row,
    /// beyond what the roundoff of positions makes of it.
    double contact = 0.;
    /// Largest prescribed displacement that is not yet applied.
    double prescribed = 0.;
    /// Norm of the unbalanced forces and of the contact rows as forces: gaps of
    /// closed points times the stiffness of the contact, tractions that miss
    /// the law of friction. Over nothing, so that it compares between states.
    double merit = 0.;
  };



  /// What a residual is made of; vectors of locally owned entries.
  struct ResidualParts
  {
    const LA::Vector      &unbalanced; ///< forces minus loads
    const LA::Vector      &loads;
    const LA::Vector      &contact_rows;
    const ContactRowSizes &row_sizes;
  };

  /**
   * The norms of a residual, all but ResidualNorms::prescribed. Rows that
   * @p increment constrains are reactions, or no equations. Forces are measured
   * against at least @p force_floor. Collective.
   */
  ResidualNorms
  residual_norms(const ResidualParts &parts,
                 const Constraints   &increment,
                 const double         force_floor,
                 const MPI_Comm      &communicator);
} // namespace stickslip

#endif
