#include <stickslip/solid/viscous_stabilization.h>

#include <deal.II/base/mpi.h>

#include <deal.II/grid/grid_tools.h>

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
    , old_element(dof_handler.get_fe())
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
  ViscousStabilization<dim>::add_cell(
    const FEValues<dim>                        &fe_values,
    const std::vector<types::global_dof_index> &dof_indices,
    const double                                modulus,
    const bool                                  with_tangent,
    ElementArrays<dim>                         &element)
  {
    const double viscosity = coefficient * modulus / step_size;
    old_element.reinit(*u_old, dof_indices);
    for (const unsigned int q : fe_values.quadrature_point_indices())
      {
        element.add_load(fe_values,
                         q,
                         viscosity * (element.displacement(fe_values, q) -
                                      old_element.displacement(fe_values, q)),
                         element.internal);
        if (with_tangent)
          element.add_load_tangent(fe_values,
                                   q,
                                   viscosity * unit_symmetric_tensor<dim>());
      }
  }



  template <int dim>
  double
  ViscousStabilization<dim>::work(
    const FEValues<dim>                        &fe_values,
    const std::vector<types::global_dof_index> &dof_indices,
    const double                                modulus,
    const ElementArrays<dim>                   &element)
  {
    const double viscosity = coefficient * modulus / step_size;
    double       sum       = 0.;
    old_element.reinit(*u_old, dof_indices);
    for (const unsigned int q : fe_values.quadrature_point_indices())
      sum += viscosity *
             (element.displacement(fe_values, q) -
              old_element.displacement(fe_values, q))
               .norm_square() *
             element.measure(fe_values, q);
    return sum;
  }

  template class ViscousStabilization<2>;
  template class ViscousStabilization<3>;
} // namespace stickslip
