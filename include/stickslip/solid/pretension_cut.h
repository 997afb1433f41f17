#ifndef stickslip_solid_pretension_cut_h
#define stickslip_solid_pretension_cut_h

#include <stickslip/base/types.h>

#include <stickslip/mesh/body.h>

#include <stickslip/solid/displacement_constraints.h>
#include <stickslip/solid/prescribed_displacement.h>
#include <stickslip/solid/pretension.h>

#include <deal.II/base/index_set.h>
#include <deal.II/base/mpi.h>

#include <array>
#include <map>
#include <string>
#include <vector>

namespace stickslip
{
  /// What goes through a cut.
  struct CutReaction
  {
    double force;      ///< the tension in the whole bolt
    double shortening; ///< of the bolt: how far the sides overlap
  };



  /**
   * The two sides of a cut through a bolt, nodes opposite nodes. With the
   * normal n of the cut (reference configuration, from the first to the second
   * side) the displacements of opposite nodes differ by the same vector,
   *   u_second - u_first = -s n,
   * where the shortening s is an unknown of which the tension F is the
   * conjugate force, or, once locked, a constant. s stands in the displacements
   * of one pair of nodes, the pivot, along the largest component p of n: all
   * other nodes of the second side follow u_second = u_first + n / n_p
   * (u_second - u_first)_p of the pivot.
   */
  template <int dim>
  class PretensionCut
  {
  public:
    /**
     * @p held are the nodes that other @p conditions ever hold (owned ones),
     * @p geometric the constraints of hanging and periodic nodes. Throws
     * UserError on all ranks if the sides are not plane, if their nodes do not
     * lie at the same places, or if a condition other than a symmetry holds one
     * of them, or one on one side only, or along the bolt. Keeps a copy of all
     * nodes of the first side. Collective.
     */
    PretensionCut(const Pretension<dim>            &condition,
                  const hp::MappingCollection<dim> &mapping,
                  const DoFHandler<dim>            &dof_handler,
                  const Bodies                     &bodies,
                  const std::map<types::global_dof_index, HeldNode<dim>> &held,
                  const std::vector<PrescribedDisplacement<dim>> &conditions,
                  const Constraints                              &geometric);

    const std::string &
    name() const
    {
      return condition.name;
    }

    /// Lines of an increment for the owned nodes of the second side. They are
    /// homogeneous: where they have always held they hold.
    std::vector<ConstraintLine>
    lines(const double time) const;

    /// Degrees of freedom that lines() lead to, of all ranks.
    const IndexSet &
    masters() const
    {
      return all_masters;
    }

    /// Whether a node is on a side of both. Collective.
    bool
    shares_nodes_with(const PretensionCut &other) const;

    /// Adds the tension, as forces on the pivot. Not compressed.
    void
    add_driving_forces(const double time, LA::Vector &forces) const;

    /// For displacements and what internal, contact and external forces leave
    /// (owned entries). Collective.
    CutReaction
    reaction(const LA::Vector &u, const LA::Vector &unbalanced) const;

  private:
    using Dofs = std::array<types::global_dof_index, dim>;

    /// A node of the first side, as other ranks have to know it.
    struct SideNode
    {
      Point<dim>     position;
      Dofs           dofs;
      Tensor<2, dim> held;    ///< projector on the directions held by others
      bool           is_free; ///< of all other constraints

      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int /*version*/)
      {
        archive &position &dofs &held &is_free;
      }
    };

    struct OppositeNodes
    {
      Dofs first, second;
    };

    Pretension<dim> condition;
    MPI_Comm        communicator;
    Tensor<1, dim>  normal;
    unsigned int    p = 0; ///< largest component of the normal

    std::vector<OppositeNodes> pairs; ///< second node owned by this rank
    types::global_dof_index    first_pivot, second_pivot; ///< component p
    IndexSet                   all_masters;
    IndexSet                   second_side; ///< owned by this rank
    IndexSet                   first_side;  ///< of all ranks

    [[noreturn]] void
    refuse(const std::string &problem) const;

    void
    find_normal(const std::vector<HeldNode<dim>> &first_side,
                const Bodies                     &bodies);

    /// Projector on the directions that the conditions hold at a node. Adds to
    /// @p error if they are not in the plane of the cut.
    Tensor<2, dim>
    held_directions(const HeldNode<dim>                            &node,
                    const std::vector<PrescribedDisplacement<dim>> &conditions,
                    std::string &error) const;

    void
    match(const std::vector<SideNode> &first_side,
          const std::vector<SideNode> &second_side,
          const std::vector<double>   &tolerances);
  };
} // namespace stickslip

#endif
