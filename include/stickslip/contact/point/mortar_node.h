#ifndef stickslip_contact_point_mortar_node_h
#define stickslip_contact_point_mortar_node_h

#include <stickslip/contact/point/contact_kinematics.h>
#include <stickslip/contact/surface/surface_face.h>

#include <deal.II/lac/full_matrix.h>

#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace stickslip
{
  /**
   * A contact point of the rule `segments`: a multiplier node j, at which the
   * contact law holds for the averages of gap and slip over the slave faces
   * around it, with the weighting function psi_j. What does not depend on the
   * configuration.
   */
  template <int dim>
  struct MortarNode : StencilNodes<dim>
  {
    /// One of the slave faces around the node.
    struct Around
    {
      unsigned int face         = 0; ///< number of the mortar face
      unsigned int multiplier   = 0; ///< the node's number among multipliers
      unsigned int displacement = 0; ///< its number among displacement nodes
      std::vector<unsigned int> stencil; ///< number in the stencil, per node

      /// Columns of the displacements of the face's nodes, and of those of a
      /// master face; columns of master node k begin at (n_slave + k) * dim.
      std::vector<unsigned int>
      columns(const unsigned int               n_slave,
              const std::vector<unsigned int> &master_nodes) const
      {
        std::vector<unsigned int> result;
        for (const unsigned int k : stencil)
          for (unsigned int c = 0; c < dim; ++c)
            result.push_back(k * dim + c);
        for (const unsigned int k : master_nodes)
          for (unsigned int c = 0; c < dim; ++c)
            result.push_back((n_slave + k) * dim + c);
        return result;
      }
    };

    /// A border of one of these faces where the slave surface ends: from the
    /// node to another one of the face (2D: itself).
    struct Border
    {
      unsigned int around    = 0; ///< number of the face around the node
      unsigned int neighbour = 0; ///< among the displacement nodes of the face
    };

    std::vector<Around> faces;
    /// Derivative along the direction E that carries the tangent basis (3D), a
    /// direction of the face @p direction_around, per node of the stencil.
    std::vector<double> direction;
    unsigned int        direction_around = 0;
    /// Where it is set it takes the place of that direction, which then has no
    /// derivative.
    std::optional<Tensor<1, dim>> fixed_direction;
    double                        area = 0.; ///< integral of psi_j, undeformed
    double gap_offset = 0.; ///< of its own, beside that of the nodes [length]
    /// Of a tied node: what r has along the tangents of its frame, and is to
    /// keep [length].
    std::optional<Tensor<1, dim - 1>> tie_offset;
    /// Onto the symmetry planes that the node lies on: its normal is in them,
    /// which the facets of one half do not know.
    Tensor<2, dim>      projection = unit_symmetric_tensor<dim>();
    bool                is_corner  = false; ///< find_corners()
    std::vector<Border> borders;            ///< likewise

    unsigned int
    n_stencil_nodes() const
    {
      return this->n_nodes_of_dofs();
    }
  };



  template <int dim>
  unsigned int
  n_symmetry_planes(const MortarNode<dim> &node)
  {
    return dim - std::lround(trace(node.projection));
  }



  /// Frame of a mortar node: the averaged outward normal of the slave surface,
  /// or at its corners that of find_corner_normal(), and tangents.
  template <int dim>
  struct MortarFrame
  {
    Tensor<1, dim> n;
    double         length = 1.; ///< of the sum M of the facets' unit normals
    std::array<Tensor<1, dim>, dim - 1> tau;
    bool is_of_corner = false; ///< M is that of find_corner_normal()
  };



  /**
   * Integrals over the part of the slave surface around a node that has a
   * master opposite, over the undeformed area, in one configuration:
   * D_k of psi_j N_k, M_l of psi_j N_l(master). Their sums are equal, so that
   * action equals reaction.
   */
  template <int dim>
  struct MortarAverage
  {
    double area   = 0.; ///< integral of psi_j; small: the node is not paired
    bool   paired = false;
    std::vector<double>         D; ///< per node of the stencil
    std::vector<double>         M; ///< per master node
    StencilNodes<dim>           masters;
    std::vector<Tensor<1, dim>> master_positions; ///< now
    std::vector<Tensor<1, dim>> master_motions;   ///< in this step
    std::vector<Tensor<1, dim>> slave_positions;  ///< of the stencil
    std::vector<Tensor<1, dim>> slave_motions;
    std::vector<double>         slave_gap_offsets;

    Tensor<1, dim> r;                ///< averaged x_s - x_m
    Tensor<1, dim> w;                ///< averaged motion of the step, s - m
    Tensor<1, dim> x;                ///< averaged x_s
    double         rise        = 0.; ///< averaged, of both surfaces' facets
    double         gap_offset  = 0.; ///< averaged, less that rise
    unsigned int   main_master = 0;  ///< face with the largest share

    unsigned int
    n_master_nodes() const
    {
      return M.size();
    }
  };



  /**
   * Derivatives of the averages with respect to the columns [stencil nodes *
   * dim, master nodes * dim].
   *
   * The integration points are taken to stay where they are on the slave
   * surface while their partners move over the master surface. That is the
   * derivative of the integrals: the borders of segments move as well, but what
   * is integrated is continuous across them, so that what one segment gains its
   * neighbour loses. Exact where the rule is. Only where the master surface
   * ends there is no neighbour: what the motion of that border changes is
   * added.
   */
  template <int dim>
  struct MortarDerivative
  {
    FullMatrix<double>  D_M;    ///< [master node][column]
    FullMatrix<double>  D_D;    ///< [node of the stencil][column]; or empty
    std::vector<double> D_area; ///< [column]; or empty: no end of the master
    std::vector<double> D_rise; ///< [column], of psi_j times the facets' rise
    /// Of the sum of unit normals, per node of the stencil and per master node.
    std::vector<Tensor<2, dim>> D_normal;
  };
} // namespace stickslip

#endif
