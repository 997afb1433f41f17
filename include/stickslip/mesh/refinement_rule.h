#ifndef stickslip_mesh_refinement_rule_h
#define stickslip_mesh_refinement_rule_h

#include <stickslip/mesh/body.h>
#include <stickslip/mesh/refinement_parameters.h>
#include <stickslip/mesh/sampled_surface.h>

#include <deal.II/base/function_parser.h>

#include <deal.II/grid/tria.h>

#include <memory>
#include <set>
#include <vector>

namespace stickslip
{
  /// Which cells a rule of section `Refinement` wants finer.
  template <int dim>
  class RefinementRule
  {
  public:
    using CellIterator = typename Triangulation<dim>::active_cell_iterator;

    /// Throws UserError for names that do not exist. @p n_global is the level
    /// of all cells before. Not collective; the same on all ranks.
    RefinementRule(const RefinementRequest  &request,
                   const Bodies             &bodies,
                   const Triangulation<dim> &triangulation,
                   const unsigned int        n_global);

    /// Whatever the level of the cell.
    bool
    concerns(const CellIterator &cell) const;

    /// True if all of the cell is concerned, and so are its children (as far
    /// as its vertices and its centre show).
    bool
    covers(const CellIterator &cell) const;

    const RefinementRequest request;

  private:
    /// Surfaces, and the bodies whose cells near them are concerned.
    struct Vicinity
    {
      unsigned int                 body;
      SampledSurface<dim>          surface;
      std::set<types::boundary_id> own; ///< empty: all cells, or those here
    };

    const Bodies                      *bodies;
    std::set<unsigned int>             of_bodies;
    std::unique_ptr<FunctionParser<3>> condition;
    std::vector<Vicinity>              vicinities;
    /// The body whose cells near a rigid tool are concerned.
    unsigned int beside_tool = numbers::invalid_unsigned_int;

    bool
    concerns_body(const CellIterator &cell) const;

    /// Is a part of @p box where the rule says? Conditions see its vertices.
    bool
    meets(const CellIterator &cell, const BoundingBox<dim> &box) const;
  };
} // namespace stickslip

#endif
