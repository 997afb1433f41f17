#ifndef stickslip_adaptivity_cell_transfer_h
#define stickslip_adaptivity_cell_transfer_h

#include <deal.II/base/quadrature.h>

#include <deal.II/fe/fe.h>

#include <vector>

namespace stickslip
{
  using namespace dealii;

  /**
   * What one cell has of a state, in a form that its children and its parent
   * can have, too.
   */
  struct CellRecord
  {
    /// Values at the nodes of the cell, in the order of the scalar element:
    /// component c at node i is at [c * n_nodes + i].
    using NodalField = std::vector<double>;

    /// Fields on a slave surface, at the nodes of the cell's slave faces; zero
    /// at the other nodes.
    struct OnSurface
    {
      unsigned int pair = 0; ///< number of the contact pair
      NodalField   values;

      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &pair &values;
      }
    };

    NodalField             in_body;
    std::vector<double>    history; ///< of the quadrature points, one by one
    std::vector<OnSurface> on_surfaces;
    /// ErrorEstimator::indicators() where there is an estimate: its own or,
    /// after a transfer, the one to expect.
    double indicator = 0.;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &in_body &history &on_surfaces &indicator;
    }
  };



  /**
   * Carries records between a cell and its children. Nodal fields are
   * interpolated: exactly on children, with a loss on parents. History
   * variables are taken over, never averaged: each point has those of the
   * nearest point that was there, so that they are as admissible as before
   * (a mean of two plastic deformation gradients is none). In cells of degree 1
   * each of the four (eight) points goes to one child, which keeps integrals.
   * Indicators are squares of errors, of which smooth solutions leave a fourth
   * of each degree on children, all in all; at kinks and edges they leave more.
   * A parent has those of its children: what has become coarser since it was
   * right enough is not to become finer in the same transfer.
   *
   * Pure; hypercubes only.
   */
  template <int dim>
  class CellTransfer
  {
  public:
    /// @p element is scalar, @p quadrature that of the histories.
    CellTransfer(const FiniteElement<dim> &element,
                 const Quadrature<dim>    &quadrature);

    std::vector<CellRecord>
    to_children(const CellRecord &parent) const;

    CellRecord
    to_parent(const std::vector<CellRecord> &children) const;

  private:
    /// A quadrature point of a child.
    struct ChildPoint
    {
      unsigned int child, point;
    };

    const FiniteElement<dim>              &element;
    const unsigned int                     n_points;
    const double                           smooth_decrease;   ///< of indicators
    std::vector<std::vector<unsigned int>> nearest_of_parent; ///< [child][q]
    std::vector<ChildPoint>                nearest_of_children; ///< [q]

    CellRecord::NodalField
    on_child(const CellRecord::NodalField &parent,
             const unsigned int            child) const;

    /// Sets what the parent has of the nodes of @p child.
    void
    take_from(const CellRecord::NodalField &child_values,
              const unsigned int            child,
              CellRecord::NodalField       &parent) const;
  };
} // namespace stickslip

#endif
