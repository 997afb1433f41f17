// Shared by tests of the multigrid: elastic bodies made of springs.

#ifndef stickslip_tests_lattice_h
#define stickslip_tests_lattice_h

#include <stickslip/base/block_system.h>

#include <stickslip/linear_solvers/multigrid/aggregation.h>

#include <stickslip/solid/rigid_body_modes.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace
{
  using namespace stickslip;

  /**
   * A lattice of n x n x 2n nodes at distance 1, with central springs between
   * neighbours (edges, and diagonals of faces and of the cubes): an elastic
   * body. All springs across the middle are weaker by @p coupling, and so are
   * those of the upper half by @p contrast. The lowest layer is held. With
   * @p stretch distances in the plane are larger, and springs are weaker by the
   * square of their lengths.
   */
  class Lattice
  {
  public:
    Lattice(const unsigned int n,
            const double       coupling,
            const double       contrast,
            const MPI_Comm     communicator = MPI_COMM_WORLD,
            const double       stretch      = 1.)
      : n(n)
      , stretch(stretch)
    {
      const unsigned int n_nodes = 2 * n * n * n;
      const unsigned int n_ranks =
                           Utilities::MPI::n_mpi_processes(communicator),
                         rank = Utilities::MPI::this_mpi_process(communicator);
      // ranks of different sizes, so that none ends where the bodies meet
      const auto first = [&](const unsigned int r) {
        return n_nodes * r * (r + 1) / (n_ranks * (n_ranks + 1));
      };
      const unsigned int begin = first(rank), end = first(rank + 1);
      owned.set_size(3 * n_nodes);
      owned.add_range(3 * begin, 3 * end);
      LA::SparsityPattern pattern(owned, owned, communicator, 81);
      visit_springs(begin, end, [&](const auto i, const auto j, const auto &) {
        for (unsigned int c = 0; c < 3; ++c)
          for (unsigned int d = 0; d < 3; ++d)
            {
              pattern.add(3 * i + c, 3 * i + d);
              pattern.add(3 * i + c, 3 * j + d);
            }
      });
      pattern.compress();
      matrix.reinit(pattern);
      visit_springs(
        begin, end, [&](const auto i, const auto j, const auto &step) {
          const bool   upper_i = height(i) >= n, upper_j = height(j) >= n;
          const double stiffness =
            upper_i != upper_j ? coupling : (upper_i ? contrast : 1.);
          add_spring(i, j, stiffness, step);
        });
      matrix.compress(VectorOperation::add);

      description.n_components = 3;
      auto modes               = std::make_shared<NearNullSpace>();
      modes->n_vectors         = 6;
      modes->values.assign(6 * owned.n_elements(), 0.);
      for (unsigned int i = begin; i < end; ++i)
        {
          modes->nodes.bodies.push_back(body(i));
          for (unsigned int c = 0; c < 3; ++c)
            for (unsigned int m = 0; m < 6 && height(i) > 0; ++m)
              modes->values[m * owned.n_elements() +
                            owned.index_within_set(3 * i + c)] =
                rigid_mode<3>(m, stretched(i) / n)[c];
          modes->nodes.positions.push_back(stretched(i));
          modes->nodes.reaches.push_back(
            std::sqrt(2. * stretch * stretch + 1.));
        }
      description.near_null_space = modes;
    }

    unsigned int
    height(const unsigned int node) const
    {
      return node / (n * n);
    }

    unsigned int
    body(const unsigned int node) const
    {
      return height(node) >= n ? 1 : 0;
    }

    /// Those of the description, as the hierarchy takes them.
    Modes
    modes() const
    {
      const auto        &given   = *description.near_null_space;
      const unsigned int n_owned = owned.n_elements();
      Modes              result;
      result.n_vectors = given.n_vectors;
      for (unsigned int i = 0; i < n_owned; ++i)
        for (unsigned int m = 0; m < given.n_vectors; ++m)
          result.values.push_back(given.values[m * n_owned + i]);
      result.nodes = given.nodes;
      return result;
    }

    const unsigned int     n;
    const double           stretch;
    IndexSet               owned;
    LA::SparseMatrix       matrix;
    BlockSystemDescription description;

  private:
    Point<3>
    position(const unsigned int node) const
    {
      return Point<3>(node % n, node / n % n, height(node));
    }

    Point<3>
    stretched(const unsigned int node) const
    {
      const Point<3> place = position(node);
      return Point<3>(stretch * place[0], stretch * place[1], place[2]);
    }

    /// All neighbours of owned nodes.
    template <typename Visitor>
    void
    visit_springs(const unsigned int begin,
                  const unsigned int end,
                  const Visitor     &visit) const
    {
      for (unsigned int i = begin; i < end; ++i)
        for (int k = 0; k < 27; ++k)
          {
            const int          layer = k / 9, row = k / 3 % 3;
            const Tensor<1, 3> step =
              Point<3>(k % 3, row, layer) - Point<3>(1., 1., 1.);
            const Point<3> neighbour = position(i) + step;
            if (k != 13 &&
                std::min({neighbour[0], neighbour[1], neighbour[2]}) >= 0. &&
                std::max(neighbour[0], neighbour[1]) < n &&
                neighbour[2] < 2. * n)
              visit(i,
                    static_cast<unsigned int>(
                      neighbour[0] + n * (neighbour[1] + n * neighbour[2])),
                    step);
          }
    }

    void
    add_spring(const unsigned int  i,
               const unsigned int  j,
               const double        stiffness,
               const Tensor<1, 3> &step)
    {
      Tensor<1, 3> direction = step;
      direction[0] *= stretch;
      direction[1] *= stretch;
      const double weight =
        stiffness * step.norm_square() / direction.norm_square();
      direction /= direction.norm();
      for (unsigned int c = 0; c < 3; ++c)
        for (unsigned int d = 0; d < 3; ++d)
          {
            const double value = weight * direction[c] * direction[d];
            if (height(i) == 0) // held
              matrix.add(3 * i + c, 3 * i + d, c == d ? 1. : 0.);
            else
              {
                matrix.add(3 * i + c, 3 * i + d, value);
                if (height(j) > 0)
                  matrix.add(3 * i + c, 3 * j + d, -value);
              }
          }
    }
  };
} // namespace

#endif
