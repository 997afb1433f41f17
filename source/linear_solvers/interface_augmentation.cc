#include <stickslip/linear_solvers/interface_augmentation.h>

#include <stickslip/linear_solvers/multigrid/galerkin_product.h>
#include <stickslip/linear_solvers/multigrid/read_blocks.h>

#include <algorithm>
#include <utility>

namespace stickslip
{
  void
  InterfaceAugmentation::reinit(const LA::BlockSparseMatrix  &system,
                                const BlockSystemDescription &description,
                                const double                  factor)
  {
    matrix  = &system;
    inverse = description.regularization;
    product.reinit(system.block(1, 0));
    for (const auto i : inverse.locally_owned_elements())
      {
        const double D = inverse(i) / factor +
                         std::max(0., -system.block(1, 1).diag_element(i));
        inverse(i) = D > 0. ? 1. / D : 0.;
      }
    inverse.compress(VectorOperation::insert);
  }



  BlockRows<double>
  InterfaceAugmentation::added_blocks(const unsigned int n) const
  {
    const LA::SparseMatrix &B            = matrix->block(1, 0);
    const MPI_Comm          communicator = B.get_mpi_communicator();
    const NodeSpace         multipliers(inverse.locally_owned_elements(),
                                1,
                                communicator),
      displacements(matrix->block(0, 0).locally_owned_range_indices(),
                    n,
                    communicator);
    BlockRows<double> diagonal;
    for (const auto i : inverse.locally_owned_elements())
      {
        if (inverse(i) > 0.)
          {
            diagonal.columns.push_back(i);
            diagonal.widths.push_back(1);
            diagonal.values.push_back(inverse(i));
          }
        diagonal.end_row(1);
      }
    return galerkin_product(BlockMatrix(std::move(diagonal),
                                        multipliers,
                                        multipliers),
                            read_blocks<double>(B, 1, n),
                            displacements);
  }



  LA::Vector
  InterfaceAugmentation::added_stiffness() const
  {
    LA::Vector stiffness(inverse);
    for (const auto i : inverse.locally_owned_elements())
      {
        double square = 0.;
        LA::visit_row(matrix->block(1, 0),
                      i,
                      [&](const auto, const double value) {
                        square += value * value;
                      });
        stiffness(i) = square * inverse(i);
      }
    stiffness.compress(VectorOperation::insert);
    return stiffness;
  }



  void
  InterfaceAugmentation::add_to(OwnedEntries &entries) const
  {
    const unsigned int  n_multipliers = inverse.locally_owned_size();
    const double *const multipliers =
      entries.data() + entries.size() - n_multipliers;
    const double *const factors = inverse.begin();
    scaled.resize(n_multipliers);
    for (unsigned int i = 0; i < n_multipliers; ++i)
      scaled[i] = factors[i] * multipliers[i];
    product.add_transposed(entries.data(), scaled.data());
  }
} // namespace stickslip
