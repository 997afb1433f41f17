#include <stickslip/linear_solvers/factorization/local_factorization.h>

#include <umfpack.h>

#include <array>
#include <type_traits>
#include <utility>

namespace stickslip
{
  static_assert(std::is_same<long, SuiteSparse_long>::value,
                "UMFPACK's indices are expected to be long.");



  struct LocalFactorization::Factors
  {
    std::vector<long>                   begins;
    std::vector<long>                   columns;
    std::vector<double>                 values;
    std::array<double, UMFPACK_CONTROL> control;
    void                               *numeric = nullptr;

    Factors()
    {
      umfpack_dl_defaults(control.data());
    }

    ~Factors()
    {
      umfpack_dl_free_numeric(&numeric);
    }

    Factors(const Factors &) = delete;

    /// UMFPACK stores columns: it gets the transposed matrix.
    FactorizationError
    factorise()
    {
      const long n        = static_cast<long>(begins.size()) - 1;
      void      *symbolic = nullptr;
      long       status   = umfpack_dl_symbolic(n,
                                        n,
                                        begins.data(),
                                        columns.data(),
                                        values.data(),
                                        &symbolic,
                                        control.data(),
                                        nullptr);
      if (status == UMFPACK_OK)
        status = umfpack_dl_numeric(begins.data(),
                                    columns.data(),
                                    values.data(),
                                    symbolic,
                                    &numeric,
                                    control.data(),
                                    nullptr);
      umfpack_dl_free_symbolic(&symbolic);
      return umfpack_error(static_cast<int>(status));
    }
  };



  LocalFactorization::LocalFactorization() = default;

  LocalFactorization::~LocalFactorization() = default;

  LocalFactorization::LocalFactorization(LocalFactorization &&) = default;

  LocalFactorization &
  LocalFactorization::operator=(LocalFactorization &&) = default;



  FactorizationError
  LocalFactorization::factorise(std::vector<long>   &&row_begins,
                                std::vector<long>   &&columns,
                                std::vector<double> &&values)
  {
    factors          = std::make_unique<Factors>();
    factors->begins  = std::move(row_begins);
    factors->columns = std::move(columns);
    factors->values  = std::move(values);
    // an empty matrix is singular, not an argument that is missing
    factors->columns.reserve(1);
    factors->values.reserve(1);
    return factors->factorise();
  }



  FactorizationError
  LocalFactorization::solve(std::vector<double>       &x,
                            const std::vector<double> &b) const
  {
    x.resize(b.size());
    return umfpack_error(
      static_cast<int>(umfpack_dl_solve(UMFPACK_At,
                                        factors->begins.data(),
                                        factors->columns.data(),
                                        factors->values.data(),
                                        x.data(),
                                        b.data(),
                                        factors->numeric,
                                        factors->control.data(),
                                        nullptr)));
  }
} // namespace stickslip
