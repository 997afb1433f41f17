#ifndef stickslip_solid_coupling_masters_h
#define stickslip_solid_coupling_masters_h

#include <deal.II/base/mpi.h>
#include <deal.II/base/tensor.h>
#include <deal.II/base/types.h>

#include <deal.II/lac/full_matrix.h>

#include <array>
#include <vector>

namespace stickslip
{
  using namespace dealii;

  /// A node whose displacements may stand for the motion of a rigid body.
  template <int dim>
  struct MasterCandidate
  {
    std::array<types::global_dof_index, dim> dofs;
    Tensor<1, dim>                           arm;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int /*version*/)
    {
      archive &dofs &arm;
    }
  };

  /**
   * Nodes far apart from each other: the outermost of all ranks' @p nodes along
   * some directions, at most 26 of them. Collective; the same on all ranks.
   */
  template <int dim>
  std::vector<MasterCandidate<dim>>
  outermost_nodes(const std::vector<MasterCandidate<dim>> &nodes,
                  const MPI_Comm                           communicator);

  /**
   * As many rows of @p map as it has columns, such that they determine the
   * columns well: each time the row that is farthest from the span of those
   * chosen (elimination with complete pivoting of rows). Fewer if the others
   * are within roundoff.
   */
  std::vector<unsigned int>
  independent_rows(const FullMatrix<double> &map);

  /// The least distance of one of @p rows of @p map from the span of those
  /// before it; zero if they are fewer than the columns.
  double
  independence_of(const std::vector<unsigned int> &rows,
                  const FullMatrix<double>        &map);
} // namespace stickslip

#endif
