#include <stickslip/linear_solvers/block_matrix.h>
#include <stickslip/linear_solvers/overlapping_parts.h>

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
  OverlappingParts::factorise(const LA::SparseMatrix  &matrix,
                              const std::vector<bool> &is_multiplier,
                              const bool               new_pattern)
  {
    parts.clear();
    const unsigned int n_owned = is_multiplier.size();
    Rows               rows;
    {
      const auto owned = read_blocks<double>({&matrix}, 1, true);
      space            = NodeSpace(std::vector<unsigned int>(n_owned, 1),
                        matrix.get_mpi_communicator());
      space.set_ghosts(foreign_columns(owned, space));
      rows.append(owned, space);
      rows.append(ghost_rows(owned, space), space);
    }
    if (new_pattern)
      choose_parts(rows);
    parts.resize(n_parts);
    for (unsigned int row = 0; row < n_owned; ++row)
      parts[part_of[row]].rows.push_back(row);
    std::vector<double> is_constraint(is_multiplier.begin(),
                                      is_multiplier.end());
    is_constraint.resize(space.n_local());
    space.update_ghosts(is_constraint);
    std::vector<unsigned int> place(space.n_local(), outside);
    bool                      is_singular = false;
    for (Part &part : parts)
      {
        part.n_own = part.rows.size();
        add_surroundings(rows, is_constraint, place, part);
        try
          {
            factorise_part(rows, place, part);
          }
        catch (const ExceptionBase &)
          {
            is_singular = true;
          }
      }
    // all ranks leave together
    AssertThrow(Utilities::MPI::max(is_singular ? 1 : 0,
                                    space.communicator()) == 0,
                ExcMessage("A part is singular."));
  }



  void
  OverlappingParts::choose_parts(const Rows &rows)
  {
    const unsigned int n_owned = space.n_owned();
    n_parts                    = (n_owned + largest - 1) / largest;
    part_of.assign(n_owned, 0);
    if (n_parts < 2)
      return;
    DynamicSparsityPattern graph(n_owned, n_owned);
    for (unsigned int row = 0; row < n_owned; ++row)
      rows.visit(row, [&](const unsigned int column, const double) {
        if (column < n_owned)
          {
            graph.add(row, column);
            graph.add(column, row);
          }
      });
    SparsityPattern pattern;
    pattern.copy_from(graph);
    SparsityTools::partition(pattern, n_parts, part_of);
  }



  void
  OverlappingParts::add_surroundings(const Rows                &rows,
                                     const std::vector<double> &is_multiplier,
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
    std::vector<unsigned int> candidates;
    for (unsigned int i = 0; i < part.n_own; ++i)
      rows.visit(part.rows[i], [&](const unsigned int column, const double) {
        if (is_multiplier[column] == 0.)
          include(column);
        else
          candidates.push_back(column);
      });
    for (const unsigned int row : candidates)
      {
        bool is_complete = true;
        rows.visit(row, [&](const unsigned int column, const double) {
          is_complete =
            is_complete && column != outside &&
            (is_multiplier[column] > 0. || place[column] != outside);
        });
        if (is_complete)
          include(row);
      }
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
