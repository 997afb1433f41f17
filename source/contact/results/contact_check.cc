#include <stickslip/contact/results/contact_check.h>

#include <stickslip/contact/assembly/contact_scales.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace stickslip
{
  namespace
  {
    /// A violation that moves a point by less than this fraction of its face
    /// is none.
    constexpr double noticeable_motion = 1e-6;



    /// |lambda_n - min(lambda_n - k d_n, 0)|
    double
    normal_error(const double lambda_n, const double d_n, const double k)
    {
      return std::abs(lambda_n - std::min(lambda_n - k * d_n, 0.));
    }



    /// s |Lambda - P(Lambda + k/s d_t)|
    template <int dim>
    double
    friction_error(const Tensor<1, dim> &Lambda,
                   const Tensor<1, dim> &d_t,
                   const double          s,
                   const double          k)
    {
      Tensor<1, dim> projected = s * Lambda + k * d_t;
      const double   length    = projected.norm();
      if (length > s)
        projected *= s / length;
      return (s * Lambda - projected).norm();
    }



    /// The point lies behind the place where its partner was by more than its
    /// face, and rather behind than beside it.
    template <int dim>
    bool
    has_fallen_through(const ContactPair<dim>  &pair,
                       const ContactPoint<dim> &point)
    {
      if (point.pairing.paired || !point.initial_pairing.paired ||
          pair.parameters.is_bilateral())
        return false;
      const Tensor<1, dim> motion =
        pair.slave_position(point).x - point.initial_pairing.master_position;
      const double depth = motion * point.initial_pairing.n;
      return depth >
             std::max(pair.slave_faces[point.geometry.slave_face].face.diameter,
                      (motion - depth * point.initial_pairing.n).norm());
    }



    void
    raise(double &largest, const double value)
    {
      largest = std::max(largest, value);
    }



    /// At most one, also where there is nothing to compare with.
    double
    relative(const double error, const double scale)
    {
      return error > 0. ? error / std::max(scale, error) : 0.;
    }



    /// What the errors of a pair are compared with, and the largest of them.
    struct PairMaxima
    {
      double pressure       = 0.;
      double threshold      = 0.;
      double normal_error   = 0.;
      double friction_error = 0.;
    };



    /// Takes a paired point into account.
    template <int dim>
    void
    look_at(ContactAssembler<dim>   &contact,
            const ContactPair<dim>  &pair,
            const ContactPoint<dim> &point,
            ContactViolation        &found,
            PairMaxima              &maxima)
    {
      const auto  &state    = contact.evaluate(pair, point);
      const auto  &d_n      = state.kinematics.d_n;
      const auto  &d_t      = state.kinematics.d_t;
      const auto  &lambda_n = state.multipliers.lambda_n;
      const double k        = contact_stiffness(pair, point);
      const double noticeable =
        noticeable_motion * k *
        pair.slave_faces[point.geometry.slave_face].face.diameter;
      if (pair.parameters.is_bilateral())
        {
          // parted, overlapping or, if tied, slipped: all the same error
          const double slip = pair.parameters.is_tied() ? d_t.norm() : 0.;
          raise(found.penetration, d_n);
          raise(maxima.pressure, state.response.traction.norm());
          if (k * std::max(std::abs(d_n), slip) > noticeable)
            raise(maxima.normal_error, k * std::max(std::abs(d_n), slip));
          return;
        }
      raise(found.penetration, d_n);
      raise(found.tension, lambda_n);
      raise(maxima.pressure, -lambda_n);
      const double error_n = normal_error(lambda_n, d_n, k);
      if (error_n > noticeable)
        raise(maxima.normal_error, error_n);
      if (!state.status.closed || !pair.parameters.has_friction())
        return;

      const double         s = state.response.threshold;
      const Tensor<1, dim> Lambda =
        tangential_vector<dim>(state.multipliers.Lambda, state.kinematics.tau);
      const double slip = d_t.norm();
      raise(found.friction_cone_excess, Lambda.norm() - 1.);
      if (state.status.stick)
        raise(found.stick_slip, slip);
      else if (slip > 0.)
        raise(found.direction, (Lambda - d_t / slip).norm());
      raise(maxima.threshold, s);
      const double error_t = friction_error(Lambda, d_t, s, k);
      if (s > 0. && error_t > noticeable && point.restrained.directions.empty())
        raise(maxima.friction_error, error_t);
    }



    /// Two reductions, however many pairs there are.
    void
    take_maxima_over_ranks(ContactViolation        &found,
                           std::vector<PairMaxima> &of_pairs,
                           const MPI_Comm          &communicator)
    {
      std::vector<double *> entries{&found.penetration,
                                    &found.tension,
                                    &found.friction_cone_excess,
                                    &found.stick_slip,
                                    &found.direction};
      for (PairMaxima &pair : of_pairs)
        for (double *entry : {&pair.pressure,
                              &pair.threshold,
                              &pair.normal_error,
                              &pair.friction_error})
          entries.push_back(entry);
      std::vector<double> values;
      for (const double *entry : entries)
        values.push_back(*entry);
      Utilities::MPI::max(values, communicator, values);
      for (unsigned int i = 0; i < entries.size(); ++i)
        *entries[i] = values[i];
      found.fallen_through =
        Utilities::MPI::sum(found.fallen_through, communicator);
    }



    /// Where the partner of a point is in the mean over its segments: on its
    /// own surface a point alone would find its neighbours.
    template <int dim>
    void
    record_mean_partner(const ContactPair<dim> &pair, ContactPoint<dim> &point)
    {
      point.initial_pairing.paired = point.pairing.paired;
      if (!point.pairing.paired)
        return;
      const auto &average = pair.mortar->average(point.geometry.mortar_node);
      point.initial_pairing.n               = point.pairing.n;
      point.initial_pairing.master_position = average.x - average.r;
    }
  } // namespace



  template <int dim>
  void
  record_initial_pairings(ContactAssembler<dim> &contact)
  {
    for_each_point(
      contact, [](ContactPair<dim> &pair, ContactPoint<dim> &point) {
        if (pair.meets_itself())
          return record_mean_partner(pair, point);
        const Pairing<dim> pairing   = pair.find_pairing(point);
        point.initial_pairing.paired = pairing.paired;
        if (!pairing.paired)
          return;
        MasterPoint<dim> master;
        pair.patch->evaluate(pairing,
                             pair.patch->configuration(pairing.face),
                             master);
        point.initial_pairing.n               = pairing.n;
        point.initial_pairing.master_position = master.x;
      });
  }



  template <int dim>
  ContactViolation
  contact_violation(ContactAssembler<dim> &contact)
  {
    ContactViolation        found;
    std::vector<PairMaxima> of_pairs(contact.contact_pairs().size());
    for (unsigned int p = 0; p < of_pairs.size(); ++p)
      {
        const ContactPair<dim> &pair = *contact.contact_pairs()[p];
        for (const auto &point : pair.points)
          {
            found.fallen_through += has_fallen_through(pair, point);
            if (point.pairing.paired)
              look_at(contact, pair, point, found, of_pairs[p]);
          }
      }
    take_maxima_over_ranks(found, of_pairs, contact.get_communicator());
    for (unsigned int p = 0; p < of_pairs.size(); ++p)
      if (contact.contact_pairs()[p]
            ->parameters.is_independent_of_regularization())
        {
          const PairMaxima &maxima = of_pairs[p];
          raise(found.normal_law,
                relative(maxima.normal_error, maxima.pressure));
          raise(found.friction_law,
                relative(maxima.friction_error, maxima.threshold));
        }
    return found;
  }

#define INSTANTIATE(dim)                                                      \
  template void             record_initial_pairings(ContactAssembler<dim> &); \
  template ContactViolation contact_violation(ContactAssembler<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
