#include <stickslip/linear_solvers/overlapping_parts.h>

#include <stickslip/linear_solvers/multigrid/block_matrix.h>

#include <deal.II/base/mpi.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/sparsity_pattern.h>
#include <deal.II/lac/sparsity_tools.h>

#include <algorithm>

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



  void
  OverlappingParts::factorise(const LA::SparseMatrix  &matrix,
                              const std::vector<bool> &is_multiplier,
                              const bool               new_pattern)
  {
    parts.clear();
    const Rows                rows = see_rows(matrix, is_multiplier);
    std::vector<unsigned int> place(space.n_local(), outside);
    bool                      failed = false;
    try
      {
        if (new_pattern)
          choose_parts(matrix);
        start_parts();
        for (Part &part : parts)
          {
            add_surroundings(rows, place, part);
            factorise_part(rows, place, part);
          }
      }
    catch (const ExceptionBase &)
      {
        failed = true;
      }
    // all ranks leave together
    AssertThrow(Utilities::MPI::max(failed ? 1 : 0, space.communicator()) == 0,
                ExcMessage("A part of the zone is singular."));
  }



  OverlappingParts::Rows
  OverlappingParts::see_rows(const LA::SparseMatrix  &matrix,
                             const std::vector<bool> &is_multiplier)
  {
    const auto owned = read_blocks<double>({&matrix}, 1, true);
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
    // with zeros, which later matrices may fill
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



  void
  OverlappingParts::factorise_part(const Rows                &rows,
                                   std::vector<unsigned int> &place,
                                   Part                      &part) const
  {
    const unsigned int n = part.rows.size();
    for (unsigned int i = 0; i < n; ++i)
      place[part.rows[i]] = i;
    const auto visit_row = [&](const unsigned int i, const auto &visitor) {
      rows.visit(part.rows[i],
                 [&](const unsigned int column, const double value) {
                   if (column != outside && place[column] != outside)
                     visitor(place[column], value);
                 });
    };
    DynamicSparsityPattern entries(n, n);
    for (unsigned int i = 0; i < n; ++i)
      visit_row(i,
                [&](const unsigned int j, const double) { entries.add(i, j); });
    SparsityPattern pattern;
    pattern.copy_from(entries);
    SparseMatrix<double> matrix(pattern);
    for (unsigned int i = 0; i < n; ++i)
      visit_row(i, [&](const unsigned int j, const double value) {
        matrix.set(i, j, value);
      });
    for (const unsigned int row : part.rows)
      place[row] = outside;
    part.factors = std::make_unique<SparseDirectUMFPACK>();
    part.factors->initialize(matrix);
  }



  void
  OverlappingParts::solve(LA::Vector &x, const LA::Vector &b) const
  {
    std::vector<double> values(b.begin(), b.end());
    values.resize(space.n_local());
    space.update_ghosts(values);
    double *const  solution = x.begin();
    Vector<double> local;
    for (const Part &part : parts)
      {
        local.reinit(part.rows.size(), true);
        for (unsigned int i = 0; i < part.rows.size(); ++i)
          local(i) = values[part.rows[i]];
        part.factors->solve(local);
        for (unsigned int i = 0; i < part.n_own; ++i)
          solution[part.rows[i]] = local(i);
      }
  }
} // namespace stickslip
