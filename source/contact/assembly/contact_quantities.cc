#include <stickslip/contact/assembly/contact_quantities.h>

#include <stickslip/base/mixed_bits.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

namespace stickslip
{
  template <int dim>
  ContactGeometry<dim>::ContactGeometry(ContactAssembler<dim>  &contact,
                                        const ConfigureContact &configure)
    : contact(contact)
    , configure(configure)
  {}



  template <int dim>
  std::string
  ContactGeometry<dim>::name() const
  {
    return "geometry";
  }



  template <int dim>
  void
  ContactGeometry<dim>::set_live(const bool live)
  {
    contact.live.geometry = live;
  }



  template <int dim>
  void
  ContactGeometry<dim>::evaluate(const LA::BlockVector &x)
  {
    configure(x, true);
    pairings.clear();
    for (const auto &pair : contact.contact_pairs())
      {
        pairings.emplace_back();
        for (const auto &point : pair->points)
          pairings.back().push_back(pair->find_pairing(point));
      }
    evaluated_at = x.block(0);
  }



  template <int dim>
  double
  ContactGeometry<dim>::change() const
  {
    if (accepted_at.size() == 0)
      return 1.;
    LA::Vector difference(evaluated_at);
    difference -= accepted_at;
    const double scale = evaluated_at.linfty_norm();
    return scale > 0. ? difference.linfty_norm() / scale : 0.;
  }



  template <int dim>
  void
  ContactGeometry<dim>::accept()
  {
    for (unsigned int p = 0; p < pairings.size(); ++p)
      for (unsigned int i = 0; i < pairings[p].size(); ++i)
        {
          ContactPoint<dim> &point = contact.contact_pairs()[p]->points[i];
          point.pairing            = pairings[p][i];
          point.hysteresis.accept_iterate(point.pairing);
        }
    accepted_at = evaluated_at;
  }



  template <int dim>
  FrictionThresholdField<dim>::FrictionThresholdField(
    ContactAssembler<dim>  &contact,
    const ConfigureContact &configure)
    : contact(contact)
    , configure(configure)
  {}



  template <int dim>
  std::string
  FrictionThresholdField<dim>::name() const
  {
    return "threshold";
  }



  template <int dim>
  void
  FrictionThresholdField<dim>::set_live(const bool live)
  {
    contact.live.threshold = live;
  }



  template <int dim>
  void
  FrictionThresholdField<dim>::evaluate(const LA::BlockVector &x)
  {
    configure(x, false);
    thresholds.clear();
    for (const auto &pair : contact.contact_pairs())
      {
        thresholds.emplace_back();
        for (const auto &point : pair->points)
          thresholds.back().push_back(contact.live_threshold(*pair, point));
      }
  }



  template <int dim>
  double
  FrictionThresholdField<dim>::change() const
  {
    double difference = 0., largest = 0.;
    for (unsigned int p = 0; p < thresholds.size(); ++p)
      for (unsigned int i = 0; i < thresholds[p].size(); ++i)
        {
          const double frozen =
            contact.contact_pairs()[p]->points[i].frozen.threshold;
          difference =
            std::max(difference, std::abs(thresholds[p][i] - frozen));
          largest = std::max({largest, thresholds[p][i], frozen});
        }
    difference = Utilities::MPI::max(difference, contact.get_communicator());
    largest    = Utilities::MPI::max(largest, contact.get_communicator());
    return largest > 0. ? difference / largest : 0.;
  }



  template <int dim>
  void
  FrictionThresholdField<dim>::accept()
  {
    for (unsigned int p = 0; p < thresholds.size(); ++p)
      for (unsigned int i = 0; i < thresholds[p].size(); ++i)
        contact.contact_pairs()[p]->points[i].frozen.threshold =
          thresholds[p][i];
  }



  template <int dim>
  ContactStatusField<dim>::ContactStatusField(ContactAssembler<dim>  &contact,
                                              const ConfigureContact &configure)
    : contact(contact)
    , configure(configure)
  {}



  template <int dim>
  std::string
  ContactStatusField<dim>::name() const
  {
    return "status";
  }



  template <int dim>
  void
  ContactStatusField<dim>::set_live(const bool live)
  {
    contact.live.status = live;
  }



  template <int dim>
  void
  ContactStatusField<dim>::evaluate(const LA::BlockVector &x)
  {
    configure(x, false);
    closed.clear();
    for (const auto &pair : contact.contact_pairs())
      {
        closed.emplace_back();
        for (const auto &point : pair->points)
          closed.back().push_back(contact.live_closed(*pair, point));
      }
  }



  template <int dim>
  double
  ContactStatusField<dim>::change() const
  {
    unsigned int flips = 0;
    for (unsigned int p = 0; p < closed.size(); ++p)
      for (unsigned int i = 0; i < closed[p].size(); ++i)
        flips +=
          closed[p][i] != contact.contact_pairs()[p]->points[i].frozen.closed;
    return Utilities::MPI::sum(flips, contact.get_communicator());
  }



  template <int dim>
  void
  ContactStatusField<dim>::accept()
  {
    for (unsigned int p = 0; p < closed.size(); ++p)
      for (unsigned int i = 0; i < closed[p].size(); ++i)
        contact.contact_pairs()[p]->points[i].frozen.closed = closed[p][i];
  }



  template <int dim>
  std::uint64_t
  ContactStatusField<dim>::fingerprint() const
  {
    // a sum of one random number per closed point, whatever the order
    const unsigned int rank =
      Utilities::MPI::this_mpi_process(contact.get_communicator());
    std::uint64_t sum  = 1;
    unsigned int  seed = 0;
    for (const auto &pair : contact.contact_pairs())
      for (const auto &point : pair->points)
        {
          ++seed;
          if (point.frozen.closed)
            sum += mixed_bits(std::uint64_t(rank) << 32 | seed);
        }
    return Utilities::MPI::sum(sum, contact.get_communicator());
  }

  template class ContactGeometry<2>;
  template class ContactGeometry<3>;
  template class FrictionThresholdField<2>;
  template class FrictionThresholdField<3>;
  template class ContactStatusField<2>;
  template class ContactStatusField<3>;
} // namespace stickslip
