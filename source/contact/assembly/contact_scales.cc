#include <stickslip/contact/assembly/contact_scales.h>

#include <stickslip/contact/pairing/segment_depth.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <vector>

namespace stickslip
{
  namespace
  {
    /// Strain at which a contact without pressure yet is expected to work.
    constexpr double expected_strain = 1e-3;



    /// Strain below which a pressure is nothing but the roundoff of a gap.
    constexpr double roundoff_strain = 1e-12;



    /// The least threshold that r_t follows, over the largest of the pair.
    constexpr double least_threshold = 0.01;



    /// The least friction coefficient that r_t follows before the first
    /// pressure.
    constexpr double least_friction_coefficient = 1e-3;



    /// Size of the open Lambda rows beside the closed ones: so small that the
    /// sum over the points of a node hardly jumps when one of them opens.
    constexpr double open_row_factor = 1e-6;



    /// Surfaces closer than this fraction of a slave face touch.
    constexpr double touching_gap = 1e-6;



    /// True if the slave surface touches the master at the node of @p point,
    /// although the gap averaged around it is open, as where round bodies meet.
    template <int dim>
    bool
    touches_at_node(const ContactPair<dim>  &pair,
                    const ContactPoint<dim> &point)
    {
      const auto depth = node_depth(pair, point);
      return depth &&
             *depth >=
               -touching_gap *
                 pair.slave_faces[point.geometry.slave_face].face.diameter;
    }



    /// What the factors of a point multiply.
    struct ScaleUnits
    {
      double n = 1.; ///< [stress/length]
      double t = 1.; ///< [1/length]
    };



    template <int dim>
    ScaleUnits
    units_of(const ContactPair<dim> &pair, const ContactScales &scales)
    {
      const RegularizationScale scale = pair.parameters.regularization.scale;
      if (scale == RegularizationScale::automatic)
        return {scales.stiffness, scales.stiffness_over_threshold};
      if (scale == RegularizationScale::plain)
        return {};
      const double mu = pair.parameters.friction == Friction::Tresca
                          ? 1.
                          : pair.parameters.friction_coefficient;
      // frictionless: r_t is not used, but it is divided by
      return {100. * pair.softest_modulus,
              10. * (mu > 0. ? mu : 1.) * pair.softest_modulus};
    }
  } // namespace



  template <int dim>
  double
  contact_stiffness(const ContactPair<dim>  &pair,
                    const ContactPoint<dim> &point)
  {
    double compliance =
      pair.slave_faces[point.geometry.slave_face].face.compliance;
    if (point.pairing.paired)
      compliance += pair.patch->face(point.pairing.face).compliance;
    // an unpaired rigid slave carries no force: any number will do
    return compliance > 0. ? 1. / compliance : 1.;
  }



  template <int dim>
  void
  update_contact_scales(ContactAssembler<dim> &contact)
  {
    for (const auto &pair : contact.contact_pairs())
      {
        const ContactPairParameters &parameters = pair->parameters;
        const RegularizationFactors  factor =
          parameters.regularization.factors(parameters.quadrature);
        const auto [default_r_n, default_r_t] =
          default_factors(parameters.quadrature);

        std::vector<double> thresholds;
        double              largest  = 0.;
        unsigned int        n_closed = 0;
        for (auto &point : pair->points)
          {
            const double height =
              pair->slave_faces[point.geometry.slave_face].face.diameter;
            point.scales.negligible_pressure =
              roundoff_strain * contact_stiffness(*pair, point) * height;
            const bool closed = contact.live_closed(*pair, point);
            n_closed += closed ? 1 : 0;
            double s = parameters.tresca_threshold;
            if (parameters.is_tied())
              s = pair->softest_modulus;
            else if (parameters.friction == Friction::Coulomb)
              s = closed ? contact.live_threshold(*pair, point) : 0.;
            if (s <= parameters.friction_coefficient *
                       point.scales.negligible_pressure)
              s = 0.;
            thresholds.push_back(s);
            largest = std::max(largest, s);
          }
        largest = Utilities::MPI::max(largest, contact.get_communicator());
        // Where nothing is closed yet, the nodes that touch hold the body: the
        // load is to close them.
        const bool touching_nodes_hold =
          pair->mortar && pair->has_to_hold &&
          Utilities::MPI::sum(n_closed, contact.get_communicator()) == 0;

        for (unsigned int i = 0; i < pair->points.size(); ++i)
          {
            ContactPoint<dim> &point = pair->points[i];
            const double       k     = contact_stiffness(*pair, point);
            const double       height =
              pair->slave_faces[point.geometry.slave_face].face.diameter;
            double s = std::max(thresholds[i], least_threshold * largest);
            if (s == 0.)
              s = std::max(parameters.friction_coefficient,
                           least_friction_coefficient) *
                  expected_strain * k * height;
            Regularization &r               = point.regularization;
            ContactScales  &scales          = point.scales;
            scales.stiffness                = k;
            scales.threshold                = s;
            scales.stiffness_over_threshold = k / s;
            scales.default_r_n              = default_r_n * k;
            scales.default_r_t              = default_r_t * k / s;
            const ScaleUnits units          = units_of(*pair, scales);
            const double     n = point.treatment.r_n_factor * units.n;
            const double     t = point.treatment.r_t_factor * units.t;
            r.r_n_status       = n * factor.r_n_status;
            r.r_n_augmentation = n * factor.r_n_augmentation;
            r.r_n_law          = n * factor.r_n_law;
            r.r_t_status       = t * factor.r_t_status;
            r.r_t_augmentation = t * factor.r_t_augmentation;
            r.r_t_law          = t * factor.r_t_law;
            const bool is_first_pressure_to_come =
              parameters.has_friction() && largest == 0.;
            scales.initial_stick =
              is_first_pressure_to_come && pair->has_to_hold ? k : 0.;
            scales.initial_contact = touching_nodes_hold &&
                                         point.pairing.paired &&
                                         touches_at_node(*pair, point)
                                       ? k
                                       : 0.;
            scales.open_row        = open_row_factor * s / r.r_t_law;
          }
      }
  }

  template <int dim>
  double
  negligible_pressure(const ContactAssembler<dim> &contact)
  {
    double largest = 0.;
    for_each_point(
      contact,
      [&](const ContactPair<dim> &pair, const ContactPoint<dim> &point) {
        const double height =
          pair.slave_faces[point.geometry.slave_face].face.diameter;
        largest =
          std::max(largest,
                   roundoff_strain * contact_stiffness(pair, point) * height);
      });
    return Utilities::MPI::max(largest, contact.get_communicator());
  }

  template double
  contact_stiffness(const ContactPair<2> &, const ContactPoint<2> &);
  template double
  contact_stiffness(const ContactPair<3> &, const ContactPoint<3> &);
  template double
  negligible_pressure(const ContactAssembler<2> &);
  template double
  negligible_pressure(const ContactAssembler<3> &);
  template void
  update_contact_scales(ContactAssembler<2> &);
  template void
  update_contact_scales(ContactAssembler<3> &);
} // namespace stickslip
