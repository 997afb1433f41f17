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



    /// A role's own number, or @p common times what `automatic` stands for.
    double
    role_value(const std::string &text,
               const double       common,
               const double       automatic_factor)
    {
      if (text == "automatic")
        return automatic_factor * common;
      if (text == "r_n" || text == "r_t")
        return common;
      return Utilities::string_to_double(text);
    }



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
  } // namespace



  template <int dim>
  void
  update_contact_scales(ContactAssembler<dim> &contact)
  {
    for (const auto &pair : contact.contact_pairs())
      {
        const ContactPairParameters    &parameters = pair->parameters;
        const RegularizationParameters &given      = parameters.regularization;
        const bool                      automatic  = given.scale == "automatic";
        const bool                      points_are_multiplier_nodes =
          parameters.quadrature == "nodal";
        const double augmentation = points_are_multiplier_nodes ? 1. : 1e-4;

        std::vector<double> thresholds;
        double              largest = 0.;
        for (const auto &point : pair->points)
          {
            const bool closed = contact.live_closed(*pair, point);
            double     s      = parameters.tresca_threshold;
            if (parameters.friction == "Coulomb")
              s = closed ? contact.live_threshold(*pair, point) : 0.;
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
            const double unit_n = automatic ? k : 1.;
            const double unit_t = automatic ? k / s : 1.;

            Regularization &r = point.regularization;
            r.r_n_status = unit_n * role_value(given.r_n_status, given.r_n, 1.);
            r.r_n_augmentation =
              unit_n *
              role_value(given.r_n_augmentation, given.r_n, augmentation);
            r.r_n_law    = unit_n * role_value(given.r_n_law, given.r_n, 1.);
            r.r_t_status = unit_t * role_value(given.r_t_status, given.r_t, 1.);
            r.r_t_augmentation =
              unit_t *
              role_value(given.r_t_augmentation, given.r_t, augmentation);
            r.r_t_law    = unit_t * role_value(given.r_t_law, given.r_t, 1.);
            r.open_scale = s / r.r_t_law;
          }
      }
  }

  template void
  update_contact_scales(ContactAssembler<2> &);
  template void
  update_contact_scales(ContactAssembler<3> &);
} // namespace stickslip
