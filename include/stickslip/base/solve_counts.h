#ifndef stickslip_base_solve_counts_h
#define stickslip_base_solve_counts_h

namespace stickslip
{
  /// What solving a load step took; the same names in log and statistics.
  struct SolveCounts
  {
    unsigned int geometry_loops    = 0;
    unsigned int threshold_loops   = 0;
    unsigned int status_loops      = 0;
    unsigned int newton_iterations = 0;
    unsigned int pairings          = 0; ///< times all points were paired anew
    unsigned int linear_iterations = 0; ///< of Krylov solvers
    unsigned int multigrid_setups  = 0;
    unsigned int direct_fallbacks  = 0; ///< of an iteration that failed
    unsigned int sparsity_rebuilds = 0;
    double       assembly_seconds  = 0.;
    double       contact_seconds   = 0.; ///< search, pairing, contact assembly
    double       setup_seconds     = 0.; ///< factorization or AMG set-up
    double       solve_seconds     = 0.;
  };
} // namespace stickslip

#endif
