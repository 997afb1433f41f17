#include <stickslip/linear_solvers/multigrid/prolongation.h>

#include <utility>

namespace stickslip
{
  Prolongation::Prolongation(BlockRows<float> &&rows,
                             const NodeSpace   &fine,
                             const NodeSpace   &coarse_nodes)
    : coarse(with_local_columns(rows, coarse_nodes))
    , row_begins(begins_of_rows(rows, fine))
    , matrix(std::move(rows), coarse)
  {}



  void
  Prolongation::add_to_fine(std::vector<double> &fine,
                            std::vector<double> &from) const
  {
    coarse.update_ghosts(from);
    for (unsigned int row = 0; row < matrix.n_rows(); ++row)
      matrix.add_product(row, 1., from, fine.data() + row_begins[row]);
  }



  void
  Prolongation::restrict_to_coarse(std::vector<double>       &to,
                                   const std::vector<double> &fine) const
  {
    to.assign(coarse.begin(coarse.n_local()), 0.);
    for (unsigned int row = 0; row < matrix.n_rows(); ++row)
      matrix.add_transposed_product(row, fine.data() + row_begins[row], to);
    coarse.add_ghosts_to_owners(to);
  }
} // namespace stickslip
