#ifndef stickslip_output_surface_values_h
#define stickslip_output_surface_values_h

#include <stickslip/contact/results/contact_result.h>

#include <deal.II/base/mpi.h>

#include <string>
#include <vector>

namespace stickslip
{
  /// A place on the undeformed slave surface of a contact pair.
  template <int dim>
  struct SurfacePoint
  {
    unsigned int pair; ///< index
    Point<dim>   reference_position;
    std::string  path; ///< the parameter that names it
  };



  /// What contact does there; tractions act on the slave, per reference area.
  template <int dim>
  struct SurfaceValues
  {
    Tensor<1, dim> displacement;
    double         pressure = 0.; ///< -lambda_n
    double         gap      = 0.; ///< >= 0 open; 0 where nothing is paired
    Tensor<1, dim> tangential_traction;
  };



  /**
   * The nodal fields of the slave faces (ContactNodalFields), interpolated at
   * @p points. A point belongs to the nearest face, may be off by 5 % of its
   * size (on a curved surface), and gets the mean where faces meet, so that
   * results do not depend on the number of ranks. @p faces are the locally
   * owned ones. Collective; the same values on all ranks. Throws UserError on
   * all ranks for a point that is not on the surface.
   */
  template <int dim>
  std::vector<SurfaceValues<dim>>
  values_on_surface(const std::vector<SurfacePoint<dim>>      &points,
                    const std::vector<ContactFaceResult<dim>> &faces,
                    const MPI_Comm                             communicator);
} // namespace stickslip

#endif
