#include <stickslip/linear_solvers/factorization/factorization_error.h>

#include <stickslip/base/no_convergence.h>

#include <deal.II/base/mpi.templates.h>

#include <map>
#include <utility>

namespace stickslip
{
  namespace
  {
    using Kind = FactorizationError::Kind;



    struct Meaning
    {
      Kind        kind;
      const char *text;
    };



    /// INFOG(1) of MUMPS.
    const std::map<int, Meaning> &
    mumps_meanings()
    {
      static const std::map<int, Meaning> meanings = {
        {-2, {Kind::other, "the number of entries is out of range"}},
        {-3, {Kind::other, "a call in the wrong order"}},
        {-5, {Kind::out_of_memory, "real workspace of the analysis"}},
        {-6, {Kind::singular, "structurally singular"}},
        {-7, {Kind::out_of_memory, "integer workspace of the analysis"}},
        {-8, {Kind::workspace, "integer workspace of the factorisation"}},
        {-9, {Kind::workspace, "real workspace of the factorisation"}},
        {-10, {Kind::singular, "numerically singular"}},
        {-11, {Kind::workspace, "real workspace of the solution"}},
        {-12, {Kind::workspace, "real workspace of the refinement"}},
        {-13, {Kind::out_of_memory, "an array of the factorisation"}},
        {-14, {Kind::workspace, "integer workspace of the solution"}},
        {-15, {Kind::workspace, "integer workspace of the refinement"}},
        {-16, {Kind::other, "the number of rows is out of range"}},
        {-17, {Kind::workspace, "send buffer"}},
        {-18, {Kind::other, "the block size of the right hand sides"}},
        {-19, {Kind::out_of_memory, "the permitted memory"}},
        {-20, {Kind::workspace, "receive buffer"}},
        {-21, {Kind::other, "one rank alone cannot leave out the host"}},
        {-22, {Kind::other, "an array was not provided"}},
        {-23, {Kind::other, "MPI is not running"}},
        {-25, {Kind::other, "the communicator is not valid"}},
        {-38, {Kind::other, "the parallel ordering is not available"}},
        {-50, {Kind::other, "the fill-reducing ordering failed"}},
        {-51, {Kind::other, "the graph is too large for the ordering"}},
        {-52, {Kind::other, "the ordering needs integers of 64 bits"}},
        {-53, {Kind::other, "inconsistent matrices of two calls"}},
        {-90, {Kind::other, "factors could not be written to disk"}},
      };
      return meanings;
    }



    /// Large amounts are counted in millions, with a minus sign.
    std::int64_t
    mumps_amount(const int infog_2)
    {
      return infog_2 < 0 ? -static_cast<std::int64_t>(infog_2) * 1000000
                         : infog_2;
    }



    std::string
    name_of(const DirectLibrary library)
    {
      switch (library)
        {
          case DirectLibrary::mumps:
            return "MUMPS";
          case DirectLibrary::umfpack:
            return "UMFPACK";
        }
      return "";
    }



    /// What the code of an error means, if it is known.
    std::string
    meaning_of(const FactorizationError &error)
    {
      if (error.library == DirectLibrary::mumps)
        {
          const auto meaning = mumps_meanings().find(error.code);
          if (meaning != mumps_meanings().end())
            return meaning->second.text;
        }
      return "";
    }



    /// The code as the library's manual names it.
    std::string
    code_of(const FactorizationError &error)
    {
      return (error.library == DirectLibrary::mumps ? "INFOG(1) = "
                                                    : "status ") +
             std::to_string(error.code);
    }



    /// What the library said.
    std::string
    in_parentheses(const FactorizationError &error, const std::string &amount)
    {
      if (error.code == 0)
        return ""; // not known
      const std::string meaning = meaning_of(error);
      return " (" + code_of(error) + (meaning.empty() ? "" : ": " + meaning) +
             (error.amount != 0 ? ", " + std::to_string(error.amount) + amount
                                : "") +
             ")";
    }
  } // namespace



  FactorizationError
  mumps_error(const int infog_1, const int infog_2)
  {
    FactorizationError error;
    error.library = DirectLibrary::mumps;
    if (infog_1 >= 0)
      return error;
    const auto meaning = mumps_meanings().find(infog_1);
    error.kind =
      meaning == mumps_meanings().end() ? Kind::other : meaning->second.kind;
    error.code   = infog_1;
    error.amount = mumps_amount(infog_2);
    return error;
  }



  FactorizationError
  umfpack_error(const int status)
  {
    // umfpack.h
    constexpr int singular_matrix = 1, out_of_memory = -1;

    FactorizationError error;
    error.library = DirectLibrary::umfpack;
    error.code    = status;
    if (status == singular_matrix)
      error.kind = Kind::singular;
    else if (status == out_of_memory)
      error.kind = Kind::out_of_memory;
    else if (status != 0)
      error.kind = Kind::other;
    return error;
  }



  std::string
  describe(const FactorizationError &error)
  {
    const std::string library = name_of(error.library);
    switch (error.kind)
      {
        case Kind::none:
          return "no error";
        case Kind::singular:
          return "the matrix is singular" +
                 in_parentheses(error, " rows could be eliminated");
        case Kind::workspace:
          return "the workspace of " + library + " is too small" +
                 in_parentheses(error, " numbers missing");
        case Kind::out_of_memory:
          return "out of memory in " + library +
                 in_parentheses(error, " numbers requested on one rank");
        case Kind::other:
          return library + " failed" + in_parentheses(error, " in INFOG(2)");
      }
    return "";
  }



  FactorizationError
  worst_of(const FactorizationError &error, const MPI_Comm communicator)
  {
    const auto severity = [](const FactorizationError &e) {
      return std::make_pair(e.kind, -e.code);
    };
    return Utilities::MPI::all_reduce<FactorizationError>(
      error,
      communicator,
      [&](const FactorizationError &a, const FactorizationError &b) {
        return severity(a) < severity(b) ? b : a;
      });
  }



  void
  throw_if_failed(const FactorizationError &error,
                  const std::string        &where,
                  const std::string        &singular_text)
  {
    if (!error)
      return;
    const bool is_singular = error.kind == Kind::singular;
    throw NoConvergence(where,
                        is_singular ? singular_text : describe(error),
                        is_singular ? FailureCause::singular
                                    : FailureCause::linear_solver);
  }
} // namespace stickslip
