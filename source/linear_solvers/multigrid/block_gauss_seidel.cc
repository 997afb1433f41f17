#include <stickslip/linear_solvers/multigrid/block_gauss_seidel.h>

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

    /// Some ten microseconds of work, beside which a call of MPI is nothing.
    constexpr unsigned int nodes_between_calls = 64;



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
  BlockGaussSeidel::set_order(const BlockMatrix &A)
  {
    std::vector<bool> is_first(space.n_owned(), false);
    for (const auto &[rank, nodes] : space.seen_elsewhere())
      for (const auto node : nodes)
        is_first[space.local(node)] = true;
    // mostly the same ones
    for (unsigned int row = 0; row < A.n_rows(); ++row)
      for (auto k = A.column_begin(row); k < A.column_begin(row + 1); ++k)
        if (A.column(k) >= space.n_owned())
          is_first[row] = true;
    order.clear();
    for (unsigned int node = 0; node < space.n_owned(); ++node)
      if (is_first[node])
        order.push_back(node);
    n_first = order.size();
    for (unsigned int node = 0; node < space.n_owned(); ++node)
      if (!is_first[node])
        order.push_back(node);
  }



  void
  BlockGaussSeidel::reinit(BlockMatrix &A)
  {
    space = A.column_space();
    set_order(A);
    exchange.reinit(space);
    std::vector<unsigned int> place(space.n_local());
    for (unsigned int k = 0; k < order.size(); ++k)
      place[order[k]] = k + 1;
    for (unsigned int node = space.n_owned(); node < space.n_local(); ++node)
      place[node] = exchange.is_earlier(space.rank_of(space.global(node)))
                      ? 0
                      : order.size() + 1;
    A.sort_columns(place);
    copy_triangles(A, invert_diagonal(A));
  }



  std::vector<std::size_t>
  BlockGaussSeidel::invert_diagonal(const BlockMatrix &A)
  {
    const unsigned int n = A.n_rows();
    inverse_begins.assign(1, 0);
    std::vector<std::size_t> diagonals(n);
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
        diagonals[node] = k;
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
    return diagonals;
  }



  void
  BlockGaussSeidel::copy_triangles(const BlockMatrix              &A,
                                   const std::vector<std::size_t> &diagonals)
  {
    CycleMatrix::Part below, above;
    for (unsigned int node = 0; node < A.n_rows(); ++node)
      {
        below.begin.push_back(A.column_begin(node));
        below.end.push_back(diagonals[node]);
        above.begin.push_back(diagonals[node] + 1);
        above.end.push_back(A.column_begin(node + 1));
      }
    lower = CycleMatrix(A, below, order);
    upper = CycleMatrix(A, above, {order.rbegin(), order.rend()});
  }



  void
  BlockGaussSeidel::scale(const unsigned int node,
                          const unsigned int n,
                          double            *y) const
  {
    const double *const block = inverse(node);
    std::copy_n(y, n, defect.begin());
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
    const unsigned int n      = space.size(node);
    double *const      values = x.data() + space.begin(node);
    for (unsigned int r = 0; r < n; ++r, block += n)
      {
        double sum = 0.;
        for (unsigned int c = 0; c < n; ++c)
          sum += block[c] * defect[c];
        values[r] = sum;
      }
  }



  template <typename Visitor>
  void
  BlockGaussSeidel::visit_forwards(const unsigned int first,
                                   const unsigned int end,
                                   const Visitor     &visit) const
  {
    for (unsigned int k = first; k < end; ++k)
      {
        visit(order[k]);
        if (k % nodes_between_calls == 0)
          exchange.progress();
      }
  }



  template <typename Visitor>
  void
  BlockGaussSeidel::visit_backwards(const unsigned int first,
                                    const unsigned int end,
                                    const Visitor     &visit) const
  {
    for (unsigned int k = end; k-- > first;)
      {
        visit(order[k]);
        if (k % nodes_between_calls == 0)
          exchange.progress();
      }
  }



  void
  BlockGaussSeidel::sweep_forwards(std::vector<double>       &x,
                                   const std::vector<double> &b,
                                   const double *const        upper_part) const
  {
    std::copy_n(b.begin(), lower_residual.size(), lower_residual.begin());
    const auto relax = [&](const unsigned int node) {
      const unsigned int begin = space.begin(node);
      double *const      rest  = lower_residual.data() + begin;
      lower.add_product(node, -1., x, rest);
      for (unsigned int c = 0; c < space.size(node); ++c)
        defect[c] =
          upper_part == nullptr ? rest[c] : rest[c] - upper_part[begin + c];
      set_from_defect(node, x);
    };
    exchange.receive(x, OrderedExchange::Neighbours::earlier);
    visit_forwards(0, n_first, relax);
    exchange.send(x, OrderedExchange::Neighbours::later);
    visit_forwards(n_first, order.size(), relax);
  }



  void
  BlockGaussSeidel::sweep_backwards(std::vector<double> &x) const
  {
    const auto relax = [&](const unsigned int node) {
      std::copy_n(lower_residual.begin() + space.begin(node),
                  space.size(node),
                  defect.begin());
      upper.add_product(node, -1., x, defect.data());
      set_from_defect(node, x);
    };
    visit_backwards(n_first, order.size(), relax);
    exchange.receive(x, OrderedExchange::Neighbours::later);
    visit_backwards(0, n_first, relax);
    exchange.send(x, OrderedExchange::Neighbours::earlier);
  }



  void
  BlockGaussSeidel::solve(std::vector<double>       &x,
                          std::vector<double>       &residual,
                          const std::vector<double> &b) const
  {
    x.assign(space.begin(space.n_local()), 0.);
    sweep_forwards(x, b, nullptr);
    sweep_backwards(x);
    exchange.send(x, OrderedExchange::Neighbours::later);
    exchange.receive(x, OrderedExchange::Neighbours::earlier);
    residual.resize(lower_residual.size());
    for (unsigned int i = 0; i < residual.size(); ++i)
      residual[i] = b[i] - lower_residual[i];
    visit_forwards(0, order.size(), [&](const unsigned int node) {
      lower.add_product(node, -1., x, residual.data() + space.begin(node));
    });
  }



  void
  BlockGaussSeidel::smooth(std::vector<double>       &x,
                           const std::vector<double> &b) const
  {
    // what the forward sweep sees of the given x
    exchange.send(x, OrderedExchange::Neighbours::earlier);
    exchange.receive(x, OrderedExchange::Neighbours::later);
    // U x before the sweep, which would read U against its order
    upper_part.assign(lower_residual.size(), 0.);
    visit_backwards(0, order.size(), [&](const unsigned int node) {
      upper.add_product(node, 1., x, upper_part.data() + space.begin(node));
    });
    sweep_forwards(x, b, upper_part.data());
    sweep_backwards(x);
  }



  double
  BlockGaussSeidel::largest_eigenvalue() const
  {
    const unsigned int  n = space.n_owned_unknowns();
    std::vector<double> x(space.begin(space.n_local()), 0.), y(n);
    // the same on any number of ranks
    const auto first = n > 0 ? space.owned_unknowns().nth_index_in_set(0) : 0;
    for (unsigned int i = 0; i < n; ++i)
      x[i] = std::sin(1. + 7. * (first + i));
    double value = 1.;
    for (unsigned int step = 0; step < n_power_steps; ++step)
      {
        space.update_ghosts(x);
        std::fill(y.begin(), y.end(), 0.);
        for (const unsigned int node : order)
          lower.add_product(node, 1., x, y.data() + space.begin(node));
        for (auto node = order.rbegin(); node != order.rend(); ++node)
          {
            upper.add_product(*node, 1., x, y.data() + space.begin(*node));
            scale(*node, space.size(*node), y.data() + space.begin(*node));
          }
        std::vector<double> squares(2, 0.); // before and after
        for (unsigned int i = 0; i < n; ++i)
          {
            y[i] += x[i]; // D^-1 D (of zero pivots it is 0, below the largest)
            squares[0] += x[i] * x[i];
            squares[1] += y[i] * y[i];
          }
        Utilities::MPI::sum(squares, space.communicator(), squares);
        if (squares[1] <= 0.)
          break;
        value = std::sqrt(squares[1] / squares[0]);
        for (unsigned int i = 0; i < n; ++i)
          x[i] = y[i] / std::sqrt(squares[1]);
      }
    return value;
  }
} // namespace stickslip
