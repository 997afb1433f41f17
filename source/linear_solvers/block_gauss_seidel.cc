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
    diagonals.resize(n);
    lower_widths.resize(n);
    lower_residual.resize(A.row_begin(n));
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
        diagonals[node]    = k;
        lower_widths[node] = offset;
        AssertThrow(k < A.column_begin(node + 1),
                    ExcMessage("A diagonal block is zero."));
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
  BlockGaussSeidel::set_from_defect(const unsigned int   node,
                                    std::vector<double> &x) const
  {
    const double      *block  = inverse(node);
    const unsigned int n      = matrix->height(node);
    double *const      values = x.data() + matrix->row_begin(node);
    for (unsigned int r = 0; r < n; ++r, block += n)
      {
        double sum = 0.;
        for (unsigned int c = 0; c < n; ++c)
          sum += block[c] * defect[c];
        values[r] = sum;
      }
  }



  void
  BlockGaussSeidel::subtract_lower(const unsigned int         node,
                                   const std::vector<double> &x,
                                   double                    *y) const
  {
    matrix->subtract_product(
      node, matrix->column_begin(node), diagonals[node], 0, x, y);
  }



  void
  BlockGaussSeidel::subtract_upper(const unsigned int         node,
                                   const std::vector<double> &x,
                                   double                    *y) const
  {
    matrix->subtract_product(node,
                             diagonals[node] + 1,
                             matrix->column_begin(node + 1),
                             lower_widths[node] + matrix->height(node),
                             x,
                             y);
  }



  void
  BlockGaussSeidel::subtract_ghosts_behind(const unsigned int         node,
                                           const std::vector<double> &x,
                                           double                    *y) const
  {
    std::size_t       first  = matrix->column_begin(node + 1);
    unsigned int      offset = matrix->width(node);
    const std::size_t end    = first;
    while (first > diagonals[node] + 1 &&
           matrix->column(first - 1) >= matrix->n_rows())
      offset -= matrix->block_width(--first);
    matrix->subtract_product(node, first, end, offset, x, y);
  }



  void
  BlockGaussSeidel::sweep_backwards(std::vector<double> &x) const
  {
    for (unsigned int node = matrix->n_rows(); node-- > 0;)
      {
        std::copy_n(lower_residual.begin() + matrix->row_begin(node),
                    matrix->height(node),
                    defect.begin());
        subtract_upper(node, x, defect.data());
        set_from_defect(node, x);
      }
  }



  void
  BlockGaussSeidel::solve(std::vector<double>       &x,
                          std::vector<double>       &residual,
                          const std::vector<double> &b) const
  {
    const NodeSpace &space = matrix->column_space();
    x.assign(space.begin(space.n_local()), 0.);
    std::copy_n(b.begin(), lower_residual.size(), lower_residual.begin());
    for (unsigned int node = 0; node < matrix->n_rows(); ++node)
      {
        double *const rest = lower_residual.data() + matrix->row_begin(node);
        subtract_lower(node, x, rest);
        std::copy_n(rest, matrix->height(node), defect.begin());
        set_from_defect(node, x);
      }
    sweep_backwards(x);
    space.update_ghosts(x);
    residual.resize(lower_residual.size());
    for (unsigned int i = 0; i < residual.size(); ++i)
      residual[i] = b[i] - lower_residual[i];
    for (unsigned int node = 0; node < matrix->n_rows(); ++node)
      {
        double *const rest = residual.data() + matrix->row_begin(node);
        subtract_lower(node, x, rest);
        subtract_ghosts_behind(node, x, rest);
      }
  }



  void
  BlockGaussSeidel::smooth(std::vector<double>       &x,
                           const std::vector<double> &b) const
  {
    matrix->column_space().update_ghosts(x);
    std::copy_n(b.begin(), lower_residual.size(), lower_residual.begin());
    for (unsigned int node = 0; node < matrix->n_rows(); ++node)
      {
        double *const rest = lower_residual.data() + matrix->row_begin(node);
        subtract_lower(node, x, rest);
        std::copy_n(rest, matrix->height(node), defect.begin());
        subtract_upper(node, x, defect.data());
        set_from_defect(node, x);
      }
    sweep_backwards(x);
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
