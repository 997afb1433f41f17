#ifndef stickslip_solid_cell_scratch_h
#define stickslip_solid_cell_scratch_h

#include <stickslip/base/types.h>

#include <stickslip/mesh/by_kind.h>
#include <stickslip/mesh/reference_cells.h>

#include <stickslip/solid/cell_deformation.h>
#include <stickslip/solid/cell_kernel.h>

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping.h>

#include <deal.II/hp/mapping_collection.h>

#include <memory>
#include <vector>

namespace stickslip
{
  /// What the evaluation of the law at the points of cell_quadrature() needs,
  /// for cells of one kind.
  template <int dim>
  struct CellScratch
  {
    /// @p fe is an FESystem of dim equal scalar elements.
    CellScratch(const Mapping<dim>       &mapping,
                const FiniteElement<dim> &fe,
                const CrossSection       &cross_section)
      : fe_values(mapping,
                  fe.base_element(0),
                  cell_quadrature<dim>(fe.reference_cell(), fe.degree),
                  update_values | update_gradients | update_quadrature_points |
                    update_JxW_values)
      , element(fe, cross_section)
      , deformation(fe_values.n_quadrature_points)
      , dof_indices(fe.n_dofs_per_cell())
    {}

    /// Goes to @p cell; displacements are read from the ghosted @p u.
    void
    reinit(const typename DoFHandler<dim>::active_cell_iterator &cell,
           const LA::Vector                                     &u)
    {
      cell->get_dof_indices(dof_indices);
      element.reinit(u, dof_indices);
      fe_values.reinit(typename Triangulation<dim>::active_cell_iterator(cell));
    }

    unsigned int
    n_points() const
    {
      return fe_values.n_quadrature_points;
    }

    FEValues<dim>                        fe_values;
    ElementArrays<dim>                   element;
    CellDeformation<dim>                 deformation;
    std::vector<types::global_dof_index> dof_indices;
  };



  /// One for each kind of cells.
  template <int dim>
  ByKind<CellScratch<dim>>
  make_cell_scratch(const hp::MappingCollection<dim> &mapping,
                    const DoFHandler<dim>            &dof_handler,
                    const CrossSection               &cross_section)
  {
    return {dof_handler.get_fe_collection(),
            [&](const FiniteElement<dim> &fe, const unsigned int kind) {
              return std::make_unique<CellScratch<dim>>(mapping[kind],
                                                        fe,
                                                        cross_section);
            }};
  }
} // namespace stickslip

#endif
