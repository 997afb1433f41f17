#include <stickslip/linear_solvers/multigrid/block_rows.h>

#include <deal.II/base/mpi.h>

#include <boost/serialization/utility.hpp>

#include <algorithm>
#include <map>
#include <utility>

namespace stickslip
{
  namespace
  {
    using Index = NodeSpace::Index;



    /// Adds a row to one that has all its columns.
    void
    add_row(const BlockRows<double> &from,
            const unsigned int       from_row,
            BlockRows<double>       &to,
            const unsigned int       to_row)
    {
      const unsigned int width    = from.width(from_row),
                         to_width = to.width(to_row);
      const unsigned int height =
        width > 0
          ? (from.value_begins[from_row + 1] - from.value_begins[from_row]) /
              width
          : 0;
      unsigned int offset = 0, to_offset = 0;
      auto         l = to.column_begins[to_row];
      for (auto k = from.column_begins[from_row];
           k < from.column_begins[from_row + 1];
           ++k)
        {
          for (; to.columns[l] != from.columns[k]; ++l)
            to_offset += to.widths[l];
          add_block(from.panel(from_row) + offset,
                    width,
                    height,
                    from.widths[k],
                    to.panel(to_row) + to_offset,
                    to_width);
          offset += from.widths[k];
        }
    }
  } // namespace



  template <typename Number>
  BlockRows<Number>
  ghost_rows(const BlockRows<Number> &owned, const NodeSpace &space)
  {
    std::map<unsigned int, BlockRows<Number>> messages;
    for (const auto &[rank, nodes] : space.seen_elsewhere())
      for (const Index node : nodes)
        messages[rank].append(owned, space.local(node));
    BlockRows<Number> rows;
    // ascending ranks have ascending nodes
    for (const auto &[rank, received] :
         Utilities::MPI::some_to_some(space.communicator(), messages))
      for (unsigned int row = 0; row < received.n_rows(); ++row)
        rows.append(received, row);
    return rows;
  }



  BlockRows<double>
  sum_to_owners(BlockRows<double> &&local, const NodeSpace &space)
  {
    if (Utilities::MPI::n_mpi_processes(space.communicator()) == 1)
      return std::move(local);
    using Message = std::pair<std::vector<Index>, BlockRows<double>>;
    std::map<unsigned int, Message> messages;
    for (unsigned int row = space.n_owned(); row < space.n_local(); ++row)
      {
        Message &message = messages[space.rank_of(space.global(row))];
        message.first.push_back(space.global(row));
        message.second.append(local, row);
      }
    const auto received =
      Utilities::MPI::some_to_some(space.communicator(), messages);

    // where the rows are that belong together
    std::vector<std::vector<std::pair<const BlockRows<double> *, unsigned int>>>
      parts(space.n_owned());
    for (unsigned int row = 0; row < space.n_owned(); ++row)
      parts[row].emplace_back(&local, row);
    for (const auto &[rank, message] : received)
      for (unsigned int k = 0; k < message.first.size(); ++k)
        parts[space.local(message.first[k])].emplace_back(&message.second, k);

    BlockRows<double>                            sum;
    std::vector<std::pair<Index, unsigned char>> columns;
    for (unsigned int row = 0; row < space.n_owned(); ++row)
      {
        columns.clear();
        for (const auto &[part, k] : parts[row])
          for (auto l = part->column_begins[k]; l < part->column_begins[k + 1];
               ++l)
            columns.emplace_back(part->columns[l], part->widths[l]);
        std::sort(columns.begin(), columns.end());
        columns.erase(std::unique(columns.begin(), columns.end()),
                      columns.end());
        for (const auto &[column, width] : columns)
          {
            sum.columns.push_back(column);
            sum.widths.push_back(width);
          }
        sum.end_row(space.size(row));
        sum.allocate();
        for (const auto &[part, k] : parts[row])
          add_row(*part, k, sum, row);
      }
    return sum;
  }



  template BlockRows<float>
  ghost_rows(const BlockRows<float> &, const NodeSpace &);
  template BlockRows<double>
  ghost_rows(const BlockRows<double> &, const NodeSpace &);
} // namespace stickslip
