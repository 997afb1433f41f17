#ifndef stickslip_base_block_system_h
#define stickslip_base_block_system_h

#include <stickslip/base/types.h>

#include <deal.II/base/point.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <vector>

namespace stickslip
{
  /// Where the owned nodes of a space are.
  struct NodePlaces
  {
    std::vector<unsigned int> bodies;
    std::vector<Point<3>>     positions; ///< undeformed; in the plane z is 0
    std::vector<double> reaches; ///< diameter of the largest cell around a node

    /// Whether two nodes may be in one cell. A matrix couples others, too: over
    /// contact and along contact surfaces, by reference points, and the two
    /// sides of periodic boundaries. Always in a body without reaches.
    bool
    may_share_cell(const unsigned int a, const unsigned int b) const
    {
      return bodies[a] == bodies[b] &&
             (reaches.empty() || positions[a].distance(positions[b]) <=
                                   roundoff * std::min(reaches[a], reaches[b]));
    }

  private:
    static constexpr double roundoff = 1.001;
  };



  /// Vectors that the rows of a matrix hardly see, which the coarse levels of a
  /// multigrid method have to represent in each body by itself.
  struct NearNullSpace
  {
    unsigned int        n_vectors = 0;
    std::vector<double> values; ///< [vector * n owned rows + owned row]
    NodePlaces          nodes;
  };



  /**
   * What a solver may want to know of the block system
   * [displacements, multipliers] that its matrix does not tell.
   */
  struct BlockSystemDescription
  {
    /// Renewed when sparsity or constraints changed: the pattern of the matrix
    /// is another one.
    unsigned int layout = 0;

    /// Consecutive displacement dofs that belong to one node.
    unsigned int n_components = 1;

    /// Of the displacement block, or, if there is a prolongation, of the coarse
    /// space; zero at constrained dofs. Another object when constraints
    /// changed: then nothing that was made from an earlier matrix can be used
    /// any more.
    std::shared_ptr<const NearNullSpace> near_null_space;

    /// From linear elements to the displacements; null if these are linear. A
    /// constrained dof at a vertex has one entry, 1, in a column of its own.
    std::shared_ptr<const LA::SparseMatrix> prolongation;

    /// Of the displacements, if there is a prolongation; those of
    /// near_null_space are of the linear elements then.
    NodePlaces nodes;

    /**
     * By multiplier: diagonal D [inverse of stiffness, times the square of the
     * unit of its row] such that B^T D^-1 B is a stiffness like that of the
     * cells behind the contact surface; and that stiffness integrated over the
     * multiplier's share of the surface. Zero where no contact point is.
     */
    LA::Vector regularization;
    LA::Vector stiffness;
  };

  /// Makes the description when a solver asks for it. Collective.
  using SystemDescriber = std::function<const BlockSystemDescription &()>;
} // namespace stickslip

#endif
