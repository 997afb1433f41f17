#include <stickslip/linear_solvers/multigrid/block_gauss_seidel.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace stickslip
{
  namespace
  {
    constexpr unsigned int n_power_steps = 10;

    /// Some ten microseconds of work at least, beside which a call of MPI is
    /// nothing.
    constexpr unsigned int clusters_between_calls = 64;
  } // namespace



  void
  BlockGaussSeidel::set_order(const BlockMatrix &A)
  {
    std::vector<bool> has_earlier(clusters.n(), false);
    std::vector<bool> has_later(clusters.n(), false);
    const auto mark = [&](const unsigned int node, const unsigned int rank) {
      (exchange.is_earlier(rank) ? has_earlier
                                 : has_later)[clusters.of_node[node]] = true;
    };
    for (const auto &[rank, nodes] : space.seen_elsewhere())
      for (const auto node : nodes)
        mark(space.local(node), rank);
    // mostly the same ones
    for (unsigned int row = 0; row < A.n_rows(); ++row)
      for (auto k = A.column_begin(row); k < A.column_begin(row + 1); ++k)
        if (A.column(k) >= space.n_owned())
          mark(row, space.rank_of(space.global(A.column(k))));

    order.clear();
    const auto append = [&](const bool earlier, const bool later) {
      for (unsigned int cluster = 0; cluster < clusters.n(); ++cluster)
        if (has_earlier[cluster] == earlier && has_later[cluster] == later)
          order.push_back(cluster);
      return order.size();
    };
    const auto n_first  = append(false, true);
    const auto n_inner  = append(false, false) - n_first;
    const auto n_inside = n_first + n_inner;
    middle_begin        = n_first + exchange.turn() * n_inner;
    middle_end          = middle_begin + append(true, true) - n_inside;
    std::rotate(order.begin() + middle_begin,
                order.begin() + n_inside,
                order.end());
    append(true, false);
  }



  void
  BlockGaussSeidel::reinit(BlockMatrix &A, NodeClusters &&of_nodes)
  {
    space    = A.column_space();
    clusters = std::move(of_nodes);
    exchange.reinit(space);
    set_order(A);
    std::vector<unsigned int> place(space.n_local());
    for (unsigned int k = 0; k < order.size(); ++k)
      for (const unsigned int node : clusters.nodes(order[k]))
        place[node] = k + 1;
    for (unsigned int node = space.n_owned(); node < space.n_local(); ++node)
      place[node] = exchange.is_earlier(space.rank_of(space.global(node)))
                      ? 0
                      : order.size() + 1;
    A.sort_columns(place);
    diagonal.reinit(A, clusters);
    lower_residual.resize(A.row_begin(A.n_rows()));
    defect.resize(diagonal.largest_size());
    product.resize(diagonal.largest_size());
    copy_triangles(A);
  }



  void
  BlockGaussSeidel::copy_triangles(const BlockMatrix &A)
  {
    CycleMatrix::Part below, above;
    for (unsigned int node = 0; node < A.n_rows(); ++node)
      {
        // the columns are sorted
        const unsigned int cluster = clusters.of_node[node];
        std::size_t        k       = A.column_begin(node);
        below.begin.push_back(k);
        while (!clusters.has(cluster, A.column(k)))
          ++k;
        below.end.push_back(k);
        while (k < A.column_begin(node + 1) &&
               clusters.has(cluster, A.column(k)))
          ++k;
        above.begin.push_back(k);
        above.end.push_back(A.column_begin(node + 1));
      }
    std::vector<unsigned int> nodes;
    for (const unsigned int cluster : order)
      for (const unsigned int node : clusters.nodes(cluster))
        nodes.push_back(node);
    lower = CycleMatrix(A, below, nodes);
    upper = CycleMatrix(A, above, {nodes.rbegin(), nodes.rend()});
  }



  void
  BlockGaussSeidel::scale(const unsigned int cluster, double *y) const
  {
    std::copy_n(y, diagonal.size(cluster), defect.begin());
    diagonal.solve(cluster, defect, y);
  }



  void
  BlockGaussSeidel::set_from_defect(const unsigned int   cluster,
                                    std::vector<double> &x) const
  {
    const auto nodes = clusters.nodes(cluster);
    if (nodes.size() == 1)
      {
        diagonal.solve(cluster, defect, x.data() + space.begin(nodes[0]));
        return;
      }
    diagonal.solve(cluster, defect, product.data());
    const double *value = product.data();
    for (const unsigned int node : nodes)
      {
        std::copy_n(value, space.size(node), x.begin() + space.begin(node));
        value += space.size(node);
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
        if (k % clusters_between_calls == 0)
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
        if (k % clusters_between_calls == 0)
          exchange.progress();
      }
  }



  void
  BlockGaussSeidel::sweep_forwards(std::vector<double>       &x,
                                   const std::vector<double> &b,
                                   const double *const        upper_part) const
  {
    std::copy_n(b.begin(), lower_residual.size(), lower_residual.begin());
    const auto relax = [&](const unsigned int cluster) {
      double *value = defect.data();
      for (const unsigned int node : clusters.nodes(cluster))
        {
          const unsigned int begin = space.begin(node);
          double *const      rest  = lower_residual.data() + begin;
          lower.add_product(node, -1., x, rest);
          for (unsigned int c = 0; c < space.size(node); ++c)
            *value++ =
              upper_part == nullptr ? rest[c] : rest[c] - upper_part[begin + c];
        }
      set_from_defect(cluster, x);
    };
    visit_forwards(0, middle_begin, relax);
    exchange.receive(x, OrderedExchange::Neighbours::earlier);
    visit_forwards(middle_begin, middle_end, relax);
    exchange.send(x, OrderedExchange::Neighbours::later);
    visit_forwards(middle_end, order.size(), relax);
  }



  void
  BlockGaussSeidel::sweep_backwards(std::vector<double> &x) const
  {
    const auto relax = [&](const unsigned int cluster) {
      // against the order of the matrix, as its rows are stored
      const auto nodes = clusters.nodes(cluster);
      double    *value = defect.data() + diagonal.size(cluster);
      for (std::size_t k = nodes.size(); k-- > 0;)
        {
          const unsigned int node = nodes[k];
          value -= space.size(node);
          std::copy_n(lower_residual.begin() + space.begin(node),
                      space.size(node),
                      value);
          upper.add_product(node, -1., x, value);
        }
      set_from_defect(cluster, x);
    };
    visit_backwards(middle_end, order.size(), relax);
    exchange.receive(x, OrderedExchange::Neighbours::later);
    visit_backwards(middle_begin, middle_end, relax);
    exchange.send(x, OrderedExchange::Neighbours::earlier);
    visit_backwards(0, middle_begin, relax);
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
    residual.resize(lower_residual.size());
    for (unsigned int i = 0; i < residual.size(); ++i)
      residual[i] = b[i] - lower_residual[i];
    const auto subtract = [&](const unsigned int cluster) {
      for (const unsigned int node : clusters.nodes(cluster))
        lower.add_product(node, -1., x, residual.data() + space.begin(node));
    };
    visit_forwards(0, middle_begin, subtract);
    exchange.receive(x, OrderedExchange::Neighbours::earlier);
    visit_forwards(middle_begin, order.size(), subtract);
  }



  void
  BlockGaussSeidel::smooth(std::vector<double>       &x,
                           const std::vector<double> &b) const
  {
    // what the forward sweep sees of the given x
    exchange.send(x, OrderedExchange::Neighbours::earlier);
    // U x before the sweep, which would read U against its order
    upper_part.assign(lower_residual.size(), 0.);
    const auto multiply = [&](const unsigned int cluster) {
      const auto nodes = clusters.nodes(cluster);
      for (std::size_t n = nodes.size(); n-- > 0;)
        upper.add_product(nodes[n],
                          1.,
                          x,
                          upper_part.data() + space.begin(nodes[n]));
    };
    visit_backwards(middle_end, order.size(), multiply);
    exchange.receive(x, OrderedExchange::Neighbours::later);
    visit_backwards(0, middle_end, multiply);
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
        for (const unsigned int cluster : order)
          {
            double *value = product.data();
            for (const unsigned int node : clusters.nodes(cluster))
              {
                std::fill_n(value, space.size(node), 0.);
                lower.add_product(node, 1., x, value);
                upper.add_product(node, 1., x, value);
                value += space.size(node);
              }
            scale(cluster, product.data());
            value = product.data();
            for (const unsigned int node : clusters.nodes(cluster))
              {
                std::copy_n(value,
                            space.size(node),
                            y.begin() + space.begin(node));
                value += space.size(node);
              }
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
