#include <stickslip/linear_solvers/overlapping_parts.h>

#include <stickslip/linear_solvers/multigrid/block_matrix.h>
#include <stickslip/linear_solvers/multigrid/read_blocks.h>

#include <deal.II/base/mpi.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparsity_pattern.h>
#include <deal.II/lac/sparsity_tools.h>

#include <algorithm>
#include <new>
#include <utility>

namespace stickslip
{
  namespace
  {
    constexpr unsigned int outside = -1;
  }



  struct OverlappingParts::Rows
  {
    std::vector<std::size_t>  begins{0};
    std::vector<unsigned int> columns; ///< or outside of what this rank sees
    std::vector<double>       values;
    std::vector<double>       is_multiplier; ///< 1 or 0, by row

    void
    append(const BlockRows<double> &rows, const NodeSpace &space)
    {
      for (unsigned int row = 0; row < rows.n_rows(); ++row)
        begins.push_back(begins.back() + rows.width(row));
      for (const auto column : rows.columns)
        columns.push_back(space.sees(column) ? space.local(column) : outside);
      values.insert(values.end(), rows.values.begin(), rows.values.end());
    }

    template <typename Visitor>
    void
    visit(const unsigned int row, const Visitor &visitor) const
    {
      for (std::size_t k = begins[row]; k < begins[row + 1]; ++k)
        visitor(columns[k], values[k]);
    }
  };



  OverlappingParts::OverlappingParts(const unsigned int largest)
    : largest(largest)
  {}



  OverlappingParts::~OverlappingParts() = default;



  void
  OverlappingParts::clear()
  {
    parts.clear();
  }



  FactorizationError
  OverlappingParts::factorise(const LA::SparseMatrix  &matrix,
                              const std::vector<bool> &is_multiplier)
  {
    parts.clear();
    const Rows                rows = see_rows(matrix, is_multiplier);
    std::vector<unsigned int> place(space.n_local(), outside);
    FactorizationError        error;
    try
      {
        choose_parts(matrix);
        start_parts();
        for (auto part = parts.begin(); part != parts.end() && !error; ++part)
          {
            add_surroundings(rows, place, *part);
            error = factorise_part(rows, place, *part);
          }
      }
    catch (const std::bad_alloc &)
      {
        error.library = DirectLibrary::umfpack;
        error.kind    = FactorizationError::Kind::out_of_memory;
      }
    // all ranks leave together
    return worst_of(error, space.communicator());
  }



  OverlappingParts::Rows
  OverlappingParts::see_rows(const LA::SparseMatrix  &matrix,
                             const std::vector<bool> &is_multiplier)
  {
    const auto owned = read_square_blocks(matrix, 1);
    space     = NodeSpace(std::vector<unsigned int>(is_multiplier.size(), 1),
                      matrix.get_mpi_communicator());
    auto seen = foreign_columns(owned, space);
    space.set_ghosts(seen);
    const auto flags = [&]() {
      std::vector<double> values(is_multiplier.begin(), is_multiplier.end());
      values.resize(space.n_local());
      space.update_ghosts(values);
      return values;
    };
    // and what multipliers of other ranks touch
    const auto neighbours = ghost_rows(owned, space);
    const auto is_one     = flags();
    for (unsigned int row = 0; row < neighbours.n_rows(); ++row)
      if (is_one[space.n_owned() + row] > 0.)
        for (auto k = neighbours.column_begins[row];
             k < neighbours.column_begins[row + 1];
             ++k)
          if (!space.owns(neighbours.columns[k]))
            seen.push_back(neighbours.columns[k]);
    space.set_ghosts(seen);
    Rows rows;
    rows.append(owned, space);
    rows.append(ghost_rows(owned, space), space);
    rows.is_multiplier = flags();
    return rows;
  }



  void
  OverlappingParts::choose_parts(const LA::SparseMatrix &matrix)
  {
    const unsigned int n_owned = space.n_owned();
    n_parts                    = (n_owned + largest - 1) / largest;
    part_of.assign(n_owned, 0);
    if (n_parts < 2)
      return;
    DynamicSparsityPattern graph(n_owned, n_owned);
    const auto             first = space.global(0);
    for (unsigned int row = 0; row < n_owned; ++row)
      LA::visit_row(matrix, first + row, [&](const auto column, const double) {
        if (space.owns(column))
          {
            graph.add(row, column - first);
            graph.add(column - first, row);
          }
      });
    SparsityPattern pattern;
    pattern.copy_from(graph);
    SparsityTools::partition(pattern, n_parts, part_of);
  }



  void
  OverlappingParts::start_parts()
  {
    parts.resize(n_parts);
    for (unsigned int row = 0; row < part_of.size(); ++row)
      parts[part_of[row]].rows.push_back(row);
    // METIS may leave some empty
    parts.erase(std::remove_if(parts.begin(),
                               parts.end(),
                               [](const Part &part) {
                                 return part.rows.empty();
                               }),
                parts.end());
    for (Part &part : parts)
      part.n_own = part.rows.size();
  }



  void
  OverlappingParts::add_surroundings(const Rows                &rows,
                                     std::vector<unsigned int> &place,
                                     Part                      &part) const
  {
    const auto include = [&](const unsigned int row) {
      if (place[row] == outside)
        {
          place[row] = part.rows.size();
          part.rows.push_back(row);
        }
    };
    for (unsigned int i = 0; i < part.n_own; ++i)
      place[part.rows[i]] = i;
    for (unsigned int i = 0; i < part.n_own; ++i)
      rows.visit(part.rows[i], [&](const unsigned int column, const double) {
        include(column);
      });
    const unsigned int n_next = part.rows.size();
    for (unsigned int i = part.n_own; i < n_next; ++i)
      if (rows.is_multiplier[part.rows[i]] > 0.)
        rows.visit(part.rows[i], [&](const unsigned int column, const double) {
          if (column != outside && rows.is_multiplier[column] == 0.)
            include(column);
        });
    for (const unsigned int row : part.rows)
      place[row] = outside;
  }



  FactorizationError
  OverlappingParts::factorise_part(const Rows                &rows,
                                   std::vector<unsigned int> &place,
                                   Part                      &part) const
  {
    for (unsigned int i = 0; i < part.rows.size(); ++i)
      place[part.rows[i]] = i;
    std::vector<long>                    begins(1, 0), columns;
    std::vector<double>                  values;
    std::vector<std::pair<long, double>> entries;
    for (const unsigned int row : part.rows)
      {
        entries.clear();
        rows.visit(row, [&](const unsigned int column, const double value) {
          if (column != outside && place[column] != outside)
            entries.emplace_back(place[column], value);
        });
        std::sort(entries.begin(), entries.end());
        for (const auto &[column, value] : entries)
          {
            columns.push_back(column);
            values.push_back(value);
          }
        begins.push_back(columns.size());
      }
    for (const unsigned int row : part.rows)
      place[row] = outside;
    return part.factors.factorise(std::move(begins),
                                  std::move(columns),
                                  std::move(values));
  }



  void
  OverlappingParts::solve(LA::Vector &x, const LA::Vector &b) const
  {
    std::vector<double> values(b.begin(), b.end());
    values.resize(space.n_local());
    space.update_ghosts(values);
    double *const       solution = x.begin();
    std::vector<double> local_x, local_b;
    for (const Part &part : parts)
      {
        local_b.clear();
        for (const unsigned int row : part.rows)
          local_b.push_back(values[row]);
        const FactorizationError error = part.factors.solve(local_x, local_b);
        AssertThrow(!error, ExcMessage(describe(error)));
        for (unsigned int i = 0; i < part.n_own; ++i)
          solution[part.rows[i]] = local_x[i];
      }
  }
} // namespace stickslip
