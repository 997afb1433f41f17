#ifndef stickslip_simulation_cell_state_h
#define stickslip_simulation_cell_state_h

#include <stickslip/problem/contact_problem.h>

#include <stickslip/simulation/cell_records.h>

#include <deal.II/distributed/tria.h>

#include <map>
#include <vector>

namespace stickslip
{
  /// The fields of a state; not ghosted.
  struct StateVectors
  {
    LA::Vector displacement;
    LA::Vector nodal_forces;
    LA::Vector contact_forces;
    LA::Vector rate;
    LA::Vector multipliers;
    /// ErrorEstimate::indicators; zero without an estimate.
    Vector<double> indicators;
  };



  /**
   * Names of cells that depend neither on the partition nor on the version of
   * deal.II. CellId::to_binary() nearly does it, but has the order of p4est's
   * coarse cells, which deal.II chooses: this takes the number of the coarse
   * cell in the mesh from which all was made.
   */
  template <int dim>
  class PartitionFreeNames
  {
  public:
    explicit PartitionFreeNames(const Triangulation<dim> &triangulation);

    CellKey
    name_of(const CellId &id) const;

    /// Coarse cell in the first word of CellId::to_binary() to that of a name.
    unsigned int
    coarse_name(const unsigned int coarse_id) const;

    /// The inverse of coarse_name().
    unsigned int
    coarse_id(const unsigned int coarse_name) const;

  private:
    std::vector<types::global_dof_index> names; ///< of coarse cells, by id
    std::vector<types::global_dof_index> ids;   ///< the inverse
  };



  /**
   * Turns all that a state has on a locally owned cell into numbers and back:
   * displacements and forces of its nodes, the accepted history of its points,
   * and of its slave faces (in the order of pairs and faces) the multipliers
   * and the contact points' slip and pairing. Not collective.
   */
  template <int dim>
  class CellState
  {
  public:
    using CellIterator = typename DoFHandler<dim>::active_cell_iterator;

    explicit CellState(ContactProblem<dim> &problem);

    /// @p fields must have the values of all nodes of the cell (ghosts).
    void
    write(const CellIterator  &cell,
          const StateVectors  &fields,
          std::vector<double> &record);

    /**
     * Sets the history and the entries of @p fields, also those that other
     * ranks own: compress(VectorOperation::insert) when all cells are read.
     * False if the record has not the length that this cell has.
     */
    bool
    read(const CellIterator        &cell,
         const std::vector<double> &record,
         StateVectors              &fields);

  private:
    ContactProblem<dim>    &problem;
    PartitionFreeNames<dim> names;

    struct SlaveFaces
    {
      /// By CellId::to_binary().
      std::map<CellId::binary_type, std::vector<unsigned int>> of_cell;
      /// Of each slave face, and the number of points at the end.
      std::vector<unsigned int> first_point;
    };
    std::vector<SlaveFaces> slave_faces; ///< by pair

    std::vector<types::global_dof_index> dof_indices;

    template <class Cursor>
    void
    walk_side(Side &side, Cursor &cursor) const;

    template <class Cursor>
    void
    walk_contact_point(ContactPoint<dim> &point, Cursor &cursor) const;

    /// Reading and writing are the same walk over the numbers.
    template <class Cursor, class Fields>
    void
    walk(const CellIterator &cell, Cursor &cursor, Fields &fields);
  };
} // namespace stickslip

#endif
