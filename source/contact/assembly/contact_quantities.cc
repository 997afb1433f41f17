#include <stickslip/contact/assembly/contact_quantities.h>

#include <stickslip/base/mixed_bits.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

namespace stickslip
{
  template <int dim, typename Value>
  PointQuantity<dim, Value>::PointQuantity(const std::string &name,
                                           bool Liveness::*const   flag,
                                           ContactAssembler<dim>  &contact,
                                           const ConfigureContact &configure)
    : contact(contact)
    , label(name)
    , flag(flag)
    , configure(configure)
  {}



  template <int dim, typename Value>
  void
  PointQuantity<dim, Value>::evaluate(const LA::BlockVector &x)
  {
    configure(x, false);
    values.clear();
    for_each_point(contact, [this](const auto &pair, const auto &point) {
      values.push_back(value_at(pair, point));
    });
  }



  template <int dim, typename Value>
  void
  PointQuantity<dim, Value>::accept()
  {
    for_each_value(
      [this](auto &point, const Value &value) { freeze(point, value); });
  }



  template <int dim, typename Value>
  template <typename Visitor>
  void
  PointQuantity<dim, Value>::for_each_value(const Visitor &visit) const
  {
    std::size_t i = 0;
    for_each_point(contact, [&](const auto &, auto &point) {
      AssertIndexRange(i, values.size());
      visit(point, values[i++]);
    });
  }



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
      pairings.push_back(pair->find_pairings());
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
      {
        contact.contact_pairs()[p]->use_pairings(pairings[p]);
        contact.contact_pairs()[p]->accept_iterate(false);
      }
    accepted_at = evaluated_at;
  }



  template <int dim>
  FrictionThresholdField<dim>::FrictionThresholdField(
    ContactAssembler<dim>  &contact,
    const ConfigureContact &configure)
    : PointQuantity<dim, double>("threshold",
                                 &Liveness::threshold,
                                 contact,
                                 configure)
  {}



  template <int dim>
  double
  FrictionThresholdField<dim>::change() const
  {
    double difference = 0., largest = 0.;
    this->for_each_value([&](const auto &point, const double threshold) {
      const double frozen = point.frozen.threshold;
      difference          = std::max(difference, std::abs(threshold - frozen));
      largest             = std::max({largest, threshold, frozen});
    });
    const MPI_Comm &communicator = this->contact.get_communicator();
    difference = Utilities::MPI::max(difference, communicator);
    largest    = Utilities::MPI::max(largest, communicator);
    return largest > 0. ? difference / largest : 0.;
  }



  template <int dim>
  ContactStatusField<dim>::ContactStatusField(ContactAssembler<dim>  &contact,
                                              const ConfigureContact &configure)
    : PointQuantity<dim, bool>("status", &Liveness::status, contact, configure)
  {}



  template <int dim>
  double
  ContactStatusField<dim>::change() const
  {
    unsigned int flips = 0;
    this->for_each_value([&flips](const auto &point, const bool closed) {
      flips += closed != point.frozen.closed;
    });
    return Utilities::MPI::sum(flips, this->contact.get_communicator());
  }



  template <int dim>
  std::uint64_t
  ContactStatusField<dim>::fingerprint() const
  {
    // a sum of one random number per closed point, whatever the order
    const MPI_Comm     &communicator = this->contact.get_communicator();
    const std::uint64_t rank = Utilities::MPI::this_mpi_process(communicator);
    std::uint64_t       sum  = 1;
    unsigned int        seed = 0;
    for_each_point(this->contact, [&](const auto &, const auto &point) {
      ++seed;
      if (point.frozen.closed)
        sum += mixed_bits(rank << 32 | seed);
    });
    return Utilities::MPI::sum(sum, communicator);
  }

  template class ContactGeometry<2>;
  template class ContactGeometry<3>;
  template class FrictionThresholdField<2>;
  template class FrictionThresholdField<3>;
  template class ContactStatusField<2>;
  template class ContactStatusField<3>;
} // namespace stickslip
