#include <stickslip/contact/contact_check.h>
#include <stickslip/contact/contact_scales.h>

#include <deal.II/base/array_view.h>
#include <deal.II/base/mpi.h>

#include <algorithm>
#include <array>

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
      if (point.frame.paired || !point.start.paired)
        return false;
      const Tensor<1, dim> motion =
        pair.slave_position(point).x - point.start.master_position;
      const double depth = motion * point.start.n;
      return depth > std::max(pair.slave_faces[point.slave_face].face.diameter,
                              (motion - depth * point.start.n).norm());
    }
  } // namespace



  template <int dim>
  void
  note_partners(ContactAssembler<dim> &contact)
  {
    for (const auto &pair : contact.contact_pairs())
      for (auto &point : pair->points)
        {
          const ContactFrame<dim> frame = pair->find_frame(point);
          point.start.paired            = frame.paired;
          if (!frame.paired)
            continue;
          MasterPoint<dim> master;
          evaluate_master_point(pair->patch->face(frame.face),
                                pair->patch->configuration(frame.face),
                                pair->patch->face_shape(),
                                frame.xi,
                                master);
          point.start.n               = frame.n;
          point.start.master_position = master.x;
        }
  }



  template <int dim>
  ContactViolation
  contact_violation(ContactAssembler<dim> &contact)
  {
    // one entry per member of ContactViolation, in its order
    std::array<double, 7> worst{};
    unsigned int          fallen_through = 0;
    const auto            see = [](double &entry, const double value) {
      entry = std::max(entry, value);
    };
    const MPI_Comm &communicator = contact.get_communicator();
    for (const auto &pair : contact.contact_pairs())
      {
        std::array<double, 2> scales{}; // pressure, threshold
        std::array<double, 2> errors{};
        for (const auto &point : pair->points)
          {
            fallen_through += has_fallen_through(*pair, point);
            if (!point.frame.paired)
              continue;
            const auto  &state    = contact.evaluate(*pair, point);
            const auto  &d_n      = state.kinematics.d_n;
            const auto  &d_t      = state.kinematics.d_t;
            const auto  &lambda_n = state.multipliers.lambda_n;
            const double k        = contact_stiffness(*pair, point);
            const double noticeable =
              noticeable_motion * k *
              pair->slave_faces[point.slave_face].face.diameter;
            see(worst[0], d_n);
            see(worst[1], lambda_n);
            see(scales[0], -lambda_n);
            const double error_n = normal_error(lambda_n, d_n, k);
            if (error_n > noticeable)
              see(errors[0], error_n);
            if (!state.status.closed || !pair->parameters.has_friction())
              continue;
            const double         s = state.response.threshold;
            const Tensor<1, dim> Lambda =
              tangential_vector<dim>(state.multipliers.Lambda,
                                     state.kinematics.tau);
            const double slip = d_t.norm();
            see(worst[2], Lambda.norm() - 1.);
            if (state.status.stick)
              see(worst[3], slip);
            else if (slip > 0.)
              see(worst[4], (Lambda - d_t / slip).norm());
            see(scales[1], s);
            const double error_t = friction_error(Lambda, d_t, s, k);
            if (s > 0. && error_t > noticeable && point.held_directions.empty())
              see(errors[1], error_t);
          }
        for (double &scale : scales)
          scale = Utilities::MPI::max(scale, communicator);
        if (pair->parameters.quadrature == "nodal")
          for (unsigned int e = 0; e < 2; ++e)
            if (errors[e] > 0.)
              see(worst[5 + e], errors[e] / std::max(scales[e], errors[e]));
      }
    Utilities::MPI::max(ArrayView<const double>(worst.data(), worst.size()),
                        communicator,
                        ArrayView<double>(worst.data(), worst.size()));
    return {worst[0],
            worst[1],
            worst[2],
            worst[3],
            worst[4],
            worst[5],
            worst[6],
            Utilities::MPI::sum(fallen_through, communicator)};
  }

#define INSTANTIATE(dim)                                            \
  template void             note_partners(ContactAssembler<dim> &); \
  template ContactViolation contact_violation(ContactAssembler<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
