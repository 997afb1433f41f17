#include <stickslip/linear_solvers/flexible_gmres.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>

namespace stickslip
{
  namespace
  {
    using Entries = FlexibleGmres::Entries;



    double
    local_product(const Entries &x, const Entries &y)
    {
      return std::inner_product(x.begin(), x.end(), y.begin(), 0.);
    }



    void
    add(Entries &y, const double factor, const Entries &x)
    {
      for (std::size_t i = 0; i < y.size(); ++i)
        y[i] += factor * x[i];
    }



    void
    scale(Entries &x, const double factor)
    {
      for (double &value : x)
        value *= factor;
    }
  } // namespace



  /**
   * The directions since the last restart, and the least squares problem
   * min |residual e_0 - H y| of their coefficients y, reduced to a triangle by
   * rotations.
   */
  struct FlexibleGmres::Basis
  {
    const MPI_Comm                         communicator;
    std::vector<Entries>                   directions;     ///< orthonormal
    std::vector<Entries>                   preconditioned; ///< one less
    std::vector<std::vector<double>>       triangle;       ///< by column
    std::vector<std::pair<double, double>> rotations;      ///< cosine, sine
    std::vector<double>                    rhs;

    Basis(const MPI_Comm communicator, Entries &&residual, const double length)
      : communicator(communicator)
      , rhs(1, length)
    {
      scale(residual, 1. / length);
      directions.push_back(std::move(residual));
    }

    /// Takes out of @p w what it has of the directions, adds that to @p column
    /// and returns the square of what is left.
    double
    orthogonalize(Entries &w, std::vector<double> &column) const
    {
      const std::size_t   n = directions.size();
      std::vector<double> products(n + 1);
      for (std::size_t i = 0; i < n; ++i)
        products[i] = local_product(directions[i], w);
      products[n] = local_product(w, w);
      std::vector<double> sums(n + 1);
      Utilities::MPI::sum(products, communicator, sums);
      double square = sums[n];
      for (std::size_t i = 0; i < n; ++i)
        {
          add(w, -sums[i], directions[i]);
          column[i] += sums[i];
          square -= sums[i] * sums[i];
        }
      return square;
    }

    /// Adds @p w, the product of the matrix with the last preconditioned
    /// direction. Returns the norm of the residual.
    double
    append(Entries &&w)
    {
      const std::size_t   n = directions.size();
      std::vector<double> column(n + 1, 0.);
      orthogonalize(w, column);
      column[n] = std::sqrt(std::max(0., orthogonalize(w, column)));
      if (column[n] > 0.)
        scale(w, 1. / column[n]);
      directions.push_back(std::move(w));
      for (std::size_t i = 0; i < rotations.size(); ++i)
        rotate(rotations[i], column[i], column[i + 1]);
      const double length = std::hypot(column[n - 1], column[n]);
      rotations.emplace_back(length > 0. ? column[n - 1] / length : 1.,
                             length > 0. ? column[n] / length : 0.);
      rotate(rotations.back(), column[n - 1], column[n]);
      rhs.push_back(0.);
      rotate(rotations.back(), rhs[n - 1], rhs[n]);
      triangle.push_back(std::move(column));
      return std::abs(rhs[n]);
    }

    /// Adds the best combination of the preconditioned directions to @p x.
    void
    add_solution(Entries &x) const
    {
      std::vector<double> y(triangle.size());
      for (std::size_t i = triangle.size(); i-- > 0;)
        {
          y[i] = rhs[i];
          for (std::size_t j = i + 1; j < triangle.size(); ++j)
            y[i] -= triangle[j][i] * y[j];
          // zero if the matrix is singular
          y[i] = triangle[i][i] != 0. ? y[i] / triangle[i][i] : 0.;
        }
      for (std::size_t i = 0; i < y.size(); ++i)
        add(x, y[i], preconditioned[i]);
    }

  private:
    static void
    rotate(const std::pair<double, double> &rotation, double &a, double &b)
    {
      const auto &[cosine, sine] = rotation;
      const double before        = a;
      a                          = cosine * before + sine * b;
      b                          = cosine * b - sine * before;
    }
  };



  FlexibleGmres::FlexibleGmres(const MPI_Comm     communicator,
                               const unsigned int max_directions)
    : communicator(communicator)
    , max_directions(max_directions)
  {}



  double
  FlexibleGmres::norm(const Entries &x, const MPI_Comm communicator)
  {
    return std::sqrt(Utilities::MPI::sum(local_product(x, x), communicator));
  }



  FlexibleGmres::Result
  FlexibleGmres::solve(const Operation      &matrix,
                       const Preconditioner &preconditioner,
                       Entries              &x,
                       const Entries        &b,
                       const double          tolerance,
                       const unsigned int    max_iterations) const
  {
    Result  result;
    Entries product;
    x.assign(b.size(), 0.);
    Entries residual = b;
    while (true)
      {
        double length    = norm(residual, communicator);
        result.converged = length <= tolerance;
        if (result.converged || !std::isfinite(length) ||
            result.iterations >= max_iterations)
          return result;
        Basis basis(communicator, std::move(residual), length);
        while (length > tolerance && result.iterations < max_iterations &&
               basis.preconditioned.size() < max_directions)
          {
            basis.preconditioned.emplace_back();
            preconditioner(basis.preconditioned.back(),
                           product,
                           basis.directions.back());
            length = basis.append(std::move(product));
            ++result.iterations;
          }
        if (!std::isfinite(length))
          return result;
        basis.add_solution(x);
        if (length <= tolerance)
          {
            result.converged = true;
            return result;
          }
        matrix(residual, x);
        for (std::size_t i = 0; i < residual.size(); ++i)
          residual[i] = b[i] - residual[i];
      }
  }
} // namespace stickslip
