#include <stickslip/linear_solvers/block_gauss_seidel.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

namespace stickslip
{
  namespace
  {
    /// Pivots below this share of their diagonal entry are zero.
    constexpr double zero_pivot = 1e-12;

    constexpr unsigned int n_power_steps = 10;



    /// Gauss-Jordan in place; without pivoting, as the blocks are definite.
    void
    invert(double *const a, const unsigned int n)
    {
      std::vector<double> diagonal(n);
      for (unsigned int k = 0; k < n; ++k)
        diagonal[k] = a[k * n + k];
      for (unsigned int k = 0; k < n; ++k)
        {
          const double pivot = a[k * n + k];
          if (std::abs(pivot) <= zero_pivot * std::abs(diagonal[k]))
            {
              for (unsigned int i = 0; i < n; ++i)
                a[k * n + i] = a[i * n + k] = 0.;
              continue;
            }
          a[k * n + k] = 1.;
          for (unsigned int j = 0; j < n; ++j)
            a[k * n + j] /= pivot;
          for (unsigned int i = 0; i < n; ++i)
            if (i != k)
              {
                const double factor = a[i * n + k];
                a[i * n + k]        = 0.;
                for (unsigned int j = 0; j < n; ++j)
                  a[i * n + j] -= factor * a[k * n + j];
              }
        }
    }
  } // namespace



  void
  BlockGaussSeidel::reinit(const BlockMatrix<double> &A)
  {
    matrix               = &A;
    const unsigned int n = A.n_rows();
    inverse_begins.assign(1, 0);
    inverses.clear();
    n_before.resize(n);
    unsigned int highest = 0;
    for (unsigned int node = 0; node < n; ++node)
      {
        const unsigned int size = A.height(node);
        highest                 = std::max(highest, size);
        inverse_begins.push_back(inverse_begins.back() + size * size);
      }
    inverses.assign(inverse_begins.back(), 0.);
    for (unsigned int node = 0; node < n; ++node)
      {
        const unsigned int size   = A.height(node);
        unsigned int       offset = 0;
        std::size_t        k      = A.column_begin(node);
        while (k < A.column_begin(node + 1) && A.column(k) != node)
          offset += A.block_width(k++);
        n_before[node] = k - A.column_begin(node);
        if (k == A.column_begin(node + 1))
          continue; // an empty row
        double *const block = inverses.data() + inverse_begins[node];
        for (unsigned int r = 0; r < size; ++r)
          std::copy_n(A.panel(node) + r * A.width(node) + offset,
                      size,
                      block + r * size);
        invert(block, size);
      }
    defect.resize(highest);
  }



  void
  BlockGaussSeidel::scale(const unsigned int node, double *y) const
  {
    const double *const block = inverse(node);
    const unsigned int  n     = matrix->height(node);
    defect.assign(y, y + n);
    for (unsigned int r = 0; r < n; ++r)
      {
        y[r] = 0.;
        for (unsigned int c = 0; c < n; ++c)
          y[r] += block[r * n + c] * defect[c];
      }
  }



  void
  BlockGaussSeidel::relax(const unsigned int         node,
                          const unsigned int         n_columns,
                          std::vector<double>       &x,
                          const std::vector<double> &b) const
  {
    matrix->row_residual(node, n_columns, x, b, defect.data());
    const double      *block  = inverse(node);
    const unsigned int n      = matrix->height(node);
    double *const      values = x.data() + matrix->row_begin(node);
    for (unsigned int r = 0; r < n; ++r, block += n)
      for (unsigned int c = 0; c < n; ++c)
        values[r] += block[c] * defect[c];
  }



  void
  BlockGaussSeidel::sweep_backwards(std::vector<double>       &x,
                                    const std::vector<double> &b) const
  {
    matrix->column_space().update_ghosts(x);
    for (unsigned int node = matrix->n_rows(); node-- > 0;)
      relax(node,
            matrix->column_begin(node + 1) - matrix->column_begin(node),
            x,
            b);
  }



  void
  BlockGaussSeidel::solve(std::vector<double>       &x,
                          const std::vector<double> &b) const
  {
    const NodeSpace &space = matrix->column_space();
    x.assign(space.begin(space.n_local()), 0.);
    // x is zero in all nodes that follow
    for (unsigned int node = 0; node < matrix->n_rows(); ++node)
      relax(node, n_before[node], x, b);
    sweep_backwards(x, b);
  }



  void
  BlockGaussSeidel::smooth(std::vector<double>       &x,
                           const std::vector<double> &b) const
  {
    matrix->column_space().update_ghosts(x);
    for (unsigned int node = 0; node < matrix->n_rows(); ++node)
      relax(node,
            matrix->column_begin(node + 1) - matrix->column_begin(node),
            x,
            b);
    sweep_backwards(x, b);
  }



  double
  BlockGaussSeidel::largest_eigenvalue() const
  {
    const NodeSpace          &space = matrix->column_space();
    const unsigned int        n     = space.n_owned_unknowns();
    std::vector<double>       x(space.begin(space.n_local()), 0.), y(n);
    const std::vector<double> zero(n, 0.);
    // the same on any number of ranks
    const auto first = n > 0 ? space.owned_unknowns().nth_index_in_set(0) : 0;
    for (unsigned int i = 0; i < n; ++i)
      x[i] = std::sin(1. + 7. * (first + i));
    double value = 1.;
    for (unsigned int step = 0; step < n_power_steps; ++step)
      {
        space.update_ghosts(x);
        matrix->residual(y, x, zero);
        double before = 0., after = 0.;
        for (unsigned int node = 0; node < matrix->n_rows(); ++node)
          scale(node, y.data() + matrix->row_begin(node));
        for (unsigned int i = 0; i < n; ++i)
          {
            before += x[i] * x[i];
            after += y[i] * y[i];
          }
        before = Utilities::MPI::sum(before, space.communicator());
        after  = Utilities::MPI::sum(after, space.communicator());
        if (after <= 0.)
          break;
        value = std::sqrt(after / before);
        for (unsigned int i = 0; i < n; ++i)
          x[i] = y[i] / std::sqrt(after);
      }
    return value;
  }
} // namespace stickslip
