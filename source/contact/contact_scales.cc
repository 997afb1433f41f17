#include <stickslip/contact/contact_scales.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <string>

namespace stickslip
{
  namespace
  {
    /// Strain at which a contact without pressure yet is expected to work.
    constexpr double expected_strain = 1e-3;



    /// Strain below which a pressure is nothing but the roundoff of a gap.
    constexpr double roundoff_strain = 1e-12;



    /// Size of the open Lambda rows beside the closed ones: so small that the
    /// sum over the points of a node hardly jumps when one of them opens.
    constexpr double open_row_factor = 1e-6;



    /// Stick that is assumed before the first pressure, over the stiffness of
    /// the contact: so weak that the first iteration is nearly the frictionless
    /// one, from which fewer points change their status later. Only a pair that
    /// has to hold a body sticks with its full stiffness.
    constexpr double weak_stick = 1e-4;



    /// A role's own number, or the common one.
    double
    role_value(const std::string &text, const double common)
    {
      return text == "r_n" || text == "r_t" ? common
                                            : Utilities::string_to_double(text);
    }



    double
    common_value(const std::string &text, const double automatic)
    {
      return text == "automatic" ? automatic
                                 : Utilities::string_to_double(text);
    }
  } // namespace



  template <int dim>
  double
  contact_stiffness(const ContactPair<dim>  &pair,
                    const ContactPoint<dim> &point)
  {
    double compliance = pair.slave_faces[point.slave_face].face.compliance;
    if (point.frame.paired)
      compliance += pair.patch->face(point.frame.face).compliance;
    // an unpaired rigid slave carries no force: any number will do
    return compliance > 0. ? 1. / compliance : 1.;
  }



  template <int dim>
  void
  update_contact_scales(ContactAssembler<dim> &contact)
  {
    for (const auto &pair : contact.contact_pairs())
      {
        const ContactPairParameters    &parameters = pair->parameters;
        const RegularizationParameters &given      = parameters.regularization;
        const bool                      automatic  = given.scale == "automatic";
        const double                    r_n =
          common_value(given.r_n, parameters.quadrature == "nodal" ? 1. : 0.01);
        const double r_t =
          common_value(given.r_t, automatic_r_t(parameters.quadrature));

        std::vector<double> thresholds;
        double              largest = 0.;
        for (auto &point : pair->points)
          {
            const double height =
              pair->slave_faces[point.slave_face].face.diameter;
            point.regularization.negligible_threshold =
              parameters.friction_coefficient * roundoff_strain *
              contact_stiffness(*pair, point) * height;
            const bool closed = contact.live_closed(*pair, point);
            double     s      = parameters.tresca_threshold;
            if (parameters.friction == "Coulomb")
              s = closed ? contact.live_threshold(*pair, point) : 0.;
            if (s <= point.regularization.negligible_threshold)
              s = 0.;
            thresholds.push_back(s);
            largest = std::max(largest, s);
          }
        largest = Utilities::MPI::max(largest, contact.get_communicator());

        for (unsigned int i = 0; i < pair->points.size(); ++i)
          {
            ContactPoint<dim> &point = pair->points[i];
            const double       k     = contact_stiffness(*pair, point);
            const double       height =
              pair->slave_faces[point.slave_face].face.diameter;
            double s = std::max(thresholds[i], 0.01 * largest);
            if (s == 0.)
              s = std::max(parameters.friction_coefficient, 1e-3) *
                  expected_strain * k * height;
            Regularization &r   = point.regularization;
            r.natural_r_n       = k;
            r.natural_r_t       = k / s;
            const double unit_n = point.cure.r_n_factor * (automatic ? k : 1.);
            const double unit_t =
              point.cure.r_t_factor * (automatic ? r.natural_r_t : 1.);
            r.r_n_status = unit_n * role_value(given.r_n_status, r_n);
            r.r_n_augmentation =
              unit_n * role_value(given.r_n_augmentation, r_n);
            r.r_n_law    = unit_n * role_value(given.r_n_law, r_n);
            r.r_t_status = unit_t * role_value(given.r_t_status, r_t);
            r.r_t_augmentation =
              unit_t * role_value(given.r_t_augmentation, r_t);
            r.r_t_law           = unit_t * role_value(given.r_t_law, r_t);
            r.threshold_scale   = s;
            r.initial_stiffness = 0.;
            if (parameters.has_friction() && largest == 0.)
              r.initial_stiffness = k * (pair->has_to_hold ? 1. : weak_stick);
            r.open_scale = open_row_factor * s / r.r_t_law;
          }
      }
  }

  template double
  contact_stiffness(const ContactPair<2> &, const ContactPoint<2> &);
  template double
  contact_stiffness(const ContactPair<3> &, const ContactPoint<3> &);
  template void
  update_contact_scales(ContactAssembler<2> &);
  template void
  update_contact_scales(ContactAssembler<3> &);
} // namespace stickslip
