#include <stickslip/solid/viscous_stabilization.h>

#include <deal.II/base/mpi.h>

#include <deal.II/grid/grid_tools.h>

#include <memory>

namespace stickslip
{
  namespace
  {
    template <int dim>
    double
    diagonal(const Triangulation<dim> &triangulation)
    {
      const auto corners =
        GridTools::compute_bounding_box(triangulation).get_boundary_points();
      return Utilities::MPI::max(corners.first.distance(corners.second),
                                 triangulation.get_communicator());
    }
  } // namespace



  template <int dim>
  ViscousStabilization<dim>::ViscousStabilization(
    const DoFHandler<dim> &dof_handler)
    : extent(diagonal(dof_handler.get_triangulation()))
    , old_elements(dof_handler.get_fe_collection(),
                   [](const FiniteElement<dim> &fe, const unsigned int) {
                     return std::make_unique<ElementArrays<dim>>(fe);
                   })
  {}



  template <int dim>
  void
  ViscousStabilization<dim>::activate(const double factor,
                                      const double time_scale)
  {
    coefficient = factor * time_scale / (extent * extent);
  }



  template <int dim>
  void
  ViscousStabilization<dim>::set_start(const LA::Vector &displacement)
  {
    u_old = &displacement;
  }



  template <int dim>
  void
  ViscousStabilization<dim>::begin_step(const double size)
  {
    step_size = size;
  }



  template <int dim>
  void
  ViscousStabilization<dim>::add_cell(const CellIterator &cell,
                                      const double        modulus,
                                      const bool          with_tangent,
                                      CellScratch<dim>   &at)
  {
    const double        viscosity   = coefficient * modulus / step_size;
    ElementArrays<dim> &old_element = old_elements[cell];
    old_element.reinit(*u_old, at.dof_indices);
    for (unsigned int q = 0; q < at.n_points(); ++q)
      {
        at.element.add_load(at.fe_values,
                            q,
                            viscosity *
                              (at.element.displacement(at.fe_values, q) -
                               old_element.displacement(at.fe_values, q)),
                            at.element.internal);
        if (with_tangent)
          at.element.add_load_tangent(at.fe_values,
                                      q,
                                      viscosity * unit_symmetric_tensor<dim>());
      }
  }



  template <int dim>
  double
  ViscousStabilization<dim>::work(const CellIterator     &cell,
                                  const double            modulus,
                                  const CellScratch<dim> &at)
  {
    const double        viscosity   = coefficient * modulus / step_size;
    double              sum         = 0.;
    ElementArrays<dim> &old_element = old_elements[cell];
    old_element.reinit(*u_old, at.dof_indices);
    for (unsigned int q = 0; q < at.n_points(); ++q)
      sum += viscosity *
             (at.element.displacement(at.fe_values, q) -
              old_element.displacement(at.fe_values, q))
               .norm_square() *
             at.element.measure(at.fe_values, q);
    return sum;
  }

  template class ViscousStabilization<2>;
  template class ViscousStabilization<3>;
} // namespace stickslip
