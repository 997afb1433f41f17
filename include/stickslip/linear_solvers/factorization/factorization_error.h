#ifndef stickslip_linear_solvers_factorization_factorization_error_h
#define stickslip_linear_solvers_factorization_factorization_error_h

#include <deal.II/base/mpi.h>

#include <cstdint>
#include <string>

namespace stickslip
{
  using namespace dealii;

  /// The libraries that factorise matrices.
  enum class DirectLibrary
  {
    mumps,
    umfpack
  };

  /**
   * What a library reported when it factorised a matrix or solved with the
   * factors: data for those who decide what to do next. `describe` makes a
   * sentence of it.
   */
  struct FactorizationError
  {
    /// From the least to the most severe, see worst_of().
    enum class Kind
    {
      none,
      singular,      ///< the matrix has no inverse
      workspace,     ///< an estimate was too small; more workspace may help
      out_of_memory, ///< the system has no more
      other          ///< invalid input, or an error in the library
    };

    Kind          kind    = Kind::none;
    DirectLibrary library = DirectLibrary::mumps;
    /// As the library's manual calls it: INFOG(1), or a status.
    int code = 0;
    /// Numbers that are missing (workspace) or were requested (memory), rows
    /// that could be eliminated (singular), or another detail; 0: unknown.
    std::int64_t amount = 0;

    explicit operator bool() const
    {
      return kind != Kind::none;
    }
  };

  /// Decodes INFOG(1) and INFOG(2) of MUMPS (MUMPS 5.5.1 users' guide, section
  /// 8). Positive values are warnings, and no error.
  FactorizationError
  mumps_error(const int infog_1, const int infog_2);

  /// Decodes a status of UMFPACK (umfpack.h). A singular matrix is a warning
  /// there; here it is an error.
  FactorizationError
  umfpack_error(const int status);

  /// In words, with the library's own code.
  std::string
  describe(const FactorizationError &error);

  /// The most severe of the ranks' errors, on all of them. Collective.
  FactorizationError
  worst_of(const FactorizationError &error, const MPI_Comm communicator);

  /**
   * Throws NoConvergence if there is an @p error, which must be the same on all
   * ranks. @p where names the solver. @p singular_text says what a singular
   * matrix means there; only then is the cause FailureCause::singular, else it
   * is FailureCause::linear_solver.
   */
  void
  throw_if_failed(const FactorizationError &error,
                  const std::string        &where,
                  const std::string        &singular_text);
} // namespace stickslip

#endif
