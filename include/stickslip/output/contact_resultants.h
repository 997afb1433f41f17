#ifndef stickslip_output_contact_resultants_h
#define stickslip_output_contact_resultants_h

#include <stickslip/contact/results/contact_result.h>

#include <stickslip/mesh/cross_section.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <string>
#include <utility>
#include <vector>

namespace stickslip
{
  /// Resultants that are like each other in unit and size.
  enum class ResultantFamily
  {
    force,    ///< of all pairs
    moment,   ///< of one pair
    position, ///< of one pair
    single    ///< like no other
  };

  /// A resultant as a column of a table.
  struct NamedResultant
  {
    std::string     name;
    double          value;
    ResultantFamily family;
  };

  /**
   * What one contact pair transmits, as sums over its contact points. Forces
   * act on the slave; in 2D they are per unit thickness, or, of bodies of
   * revolution, all around: then the radial components are sums of those of the
   * points, whose vectors cancel. Closed points are those that stick or slip.
   */
  template <int dim>
  struct ContactResultants
  {
    Tensor<1, dim> normal_force;   ///< sum w p n
    Tensor<1, dim> friction_force; ///< sum w t
    Tensor<1, 3>   moment;         ///< of both about the origin, current lever
    Point<dim> centre_of_pressure; ///< sum w p x / sum w p; 0 if no pressure

    /// Of bodies of revolution: they have no moment.
    bool is_axisymmetric = false;

    double reference_area = 0.; ///< of the closed points
    double current_area   = 0.; ///< of the closed points
    double max_pressure   = 0.; ///< nominal, over the contact points

    /// sum w t . slip of the step: <= 0, its negative has become heat.
    double friction_work = 0.;

    unsigned int n_points   = 0;
    unsigned int n_unpaired = 0;
    unsigned int n_stick    = 0;
    unsigned int n_slip     = 0;
    unsigned int n_frictionless =
      0; ///< closed points of a pair without friction

    Tensor<1, dim>
    force() const
    {
      return normal_force + friction_force;
    }

    unsigned int
    n_closed() const
    {
      return n_stick + n_slip + n_frictionless;
    }

    /// Columns for a statistics table, named "force_x", "contact_area", ...
    std::vector<NamedResultant>
    named_values() const;
  };

  /**
   * The resultants of the pairs 0 ... @p n_pairs - 1 from the locally owned
   * faces. Collective; the same result on all ranks.
   */
  template <int dim>
  std::vector<ContactResultants<dim>>
  compute_contact_resultants(const std::vector<ContactFaceResult<dim>> &faces,
                             const unsigned int                         n_pairs,
                             const MPI_Comm      communicator,
                             const CrossSection &cross_section = {});
} // namespace stickslip

#endif
