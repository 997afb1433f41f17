#include <stickslip/contact/cycling/cycling_cures.h>

#include <deal.II/base/array_view.h>
#include <deal.II/base/mpi.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

namespace stickslip
{
  namespace
  {
    /// Changes of r below this factor are none.
    constexpr double no_change = 1.01;

    /// Changes of r above this factor are a reason to try a step again.
    constexpr double clear_change = 2.;

    /// Treatments of a point in one solve before it counts as incurable.
    constexpr unsigned int most_treatments = 3;



    /// As factors.
    double
    distance(const double a, const double b)
    {
      return std::abs(std::log(a / b));
    }



    /// Whether another pairing would follow from what the point learns.
    template <int dim>
    bool
    can_learn(const ContactPoint<dim>     &point,
              const ContactPairParameters &parameters)
    {
      return (point.hysteresis.switches_facets() &&
              parameters.facet_overlap > 0.) ||
             (point.hysteresis.switches_at_end() &&
              parameters.end_overlap > 0.);
    }
  } // namespace



  void
  CyclingParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter(
      "Adapt r",
      adapt_scales,
      "Points whose statuses were proven to go round in circles get another "
      "regularization parameter, the nearest to the stiffness of the contact "
      "that gives the last two states the same status (paper, eqs. 29 and 32). "
      "If a solve fails all the same, all take that stiffness. Only with "
      "'Quadrature = nodal', where the answer does not depend on it.");
    prm.add_parameter(
      "Hold statuses",
      hold_statuses,
      "Points that no other r helps keep one of their statuses until the rest "
      "has converged; all statuses are then set free again before a state is "
      "accepted.");
  }



  template <int dim>
  CyclingCures<dim>::CyclingCures(const CyclingParameters &parameters,
                                  ContactAssembler<dim>   &contact)
    : parameters(parameters)
    , contact(contact)
  {}



  template <int dim>
  void
  CyclingCures<dim>::begin_step()
  {
    for (const auto &pair : contact.contact_pairs())
      for (auto &point : pair->points)
        point.hysteresis.set_active(false);
  }



  template <int dim>
  void
  CyclingCures<dim>::begin_solve()
  {
    statuses.clear();
    now.clear();
    for (const auto &pair : contact.contact_pairs())
      for (auto &point : pair->points)
        {
          point.cure.release();
          point.cure.n_treatments = 0;
          point.cure.n_holds      = 0;
        }
  }



  template <int dim>
  void
  CyclingCures<dim>::read_states()
  {
    before.swap(now);
    now.clear();
    for (const auto &pair : contact.contact_pairs())
      {
        now.emplace_back();
        for (const auto &point : pair->points)
          now.back().push_back(point.observed.values);
      }
  }



  template <int dim>
  bool
  CyclingCures<dim>::scales_may_change(const ContactPair<dim> &pair) const
  {
    return parameters.adapt_scales &&
           pair.parameters.is_independent_of_regularization();
  }



  template <int dim>
  bool
  CyclingCures<dim>::adapt_scale(const PointCycle &cycle)
  {
    ContactPair<dim>  &pair  = *contact.contact_pairs()[cycle.pair];
    ContactPoint<dim> &point = pair.points[cycle.point];
    if (!pair.parameters.is_independent_of_regularization() || before.empty())
      return false;
    const auto           &a         = before[cycle.pair][cycle.point];
    const auto           &b         = now[cycle.pair][cycle.point];
    const Regularization &r         = point.regularization;
    const bool            is_normal = cycle.kind == CycleKind::contact;
    const double          present   = is_normal ? r.r_n_status : r.r_t_status;
    const double          natural   = is_normal ? point.scales.stiffness
                                                : point.scales.stiffness_over_threshold;
    const double          better =
      is_normal ? admissible_r_n(a, b, natural) : admissible_r_t(a, b, natural);
    // away from the natural scale another r only makes another cycle
    if (better == 0. || distance(better, natural) + std::log(no_change) >
                          distance(present, natural))
      return false;
    (is_normal ? point.cure.r_n_factor : point.cure.r_t_factor) *=
      better / present;
    statuses.note_remedy(cycle.pair,
                         cycle.point,
                         is_normal ? "another r_n" : "another r_t");
    return true;
  }



  template <int dim>
  bool
  CyclingCures<dim>::hold_status(const PointCycle &cycle)
  {
    auto &cure = contact.contact_pairs()[cycle.pair]->points[cycle.point].cure;
    const bool first_choice = cure.n_holds % 2 == 0;
    ++cure.n_holds;
    const bool is_normal = cycle.kind == CycleKind::contact;
    (is_normal ? cure.held_closed : cure.held_stick) = first_choice;
    statuses.note_remedy(cycle.pair,
                         cycle.point,
                         std::string("held ") +
                           (is_normal      ? first_choice ? "closed" : "open"
                            : first_choice ? "in stick"
                                           : "in slip"));
    return true;
  }



  template <int dim>
  CycleTreatment
  CyclingCures<dim>::observe(const bool act)
  {
    statuses.record(contact);
    read_states();
    text.clear();
    const std::vector<PointCycle> cycles = statuses.cycling_points();
    if (!act || Utilities::MPI::max(cycles.empty() ? 0 : 1,
                                    contact.get_communicator()) == 0)
      return CycleTreatment::none;

    std::array<unsigned int, 2>             treated{}; // other r, held
    std::array<unsigned int, n_cycle_kinds> found{};
    for (const PointCycle &cycle : cycles)
      {
        ++found[static_cast<unsigned int>(cycle.kind)];
        auto &cure =
          contact.contact_pairs()[cycle.pair]->points[cycle.point].cure;
        if (cycle.kind == CycleKind::facet ||
            cycle.kind == CycleKind::pairing ||
            cure.n_treatments >= most_treatments)
          continue;
        if (parameters.adapt_scales && cure.n_treatments == 0 &&
            adapt_scale(cycle))
          ++treated[0];
        else if (parameters.hold_statuses && hold_status(cycle))
          ++treated[1];
        else
          continue;
        ++cure.n_treatments;
      }
    Utilities::MPI::sum(
      ArrayView<const unsigned int>(treated.data(), treated.size()),
      contact.get_communicator(),
      ArrayView<unsigned int>(treated.data(), treated.size()));
    Utilities::MPI::sum(ArrayView<const unsigned int>(found.data(),
                                                      found.size()),
                        contact.get_communicator(),
                        ArrayView<unsigned int>(found.data(), found.size()));
    const bool is_cured = treated[0] + treated[1] > 0;
    ++counts.cycles;
    counts.adapted_scales += treated[0];
    counts.held_statuses += treated[1];
    if (is_cured)
      statuses.forget_records();
    std::ostringstream words;
    words << "  statuses repeat (";
    for (unsigned int kind = 0, n_words = 0; kind < n_cycle_kinds; ++kind)
      if (found[kind] > 0)
        words << (n_words++ > 0 ? ", " : "") << found[kind] << " points "
              << name_of(static_cast<CycleKind>(kind));
    words << "): " << treated[0] << " get another r, " << treated[1]
          << " keep a status until the rest has converged";
    text = words.str();
    return is_cured ? CycleTreatment::cured : CycleTreatment::incurable;
  }



  template <int dim>
  bool
  CyclingCures<dim>::release()
  {
    bool any = false;
    for (const auto &pair : contact.contact_pairs())
      for (auto &point : pair->points)
        any = point.cure.release() || any;
    any = Utilities::MPI::max(any ? 1 : 0, contact.get_communicator()) > 0;
    if (any)
      statuses.forget_records();
    return any;
  }



  template <int dim>
  bool
  CyclingCures<dim>::learning_would_help() const
  {
    bool any = false;
    for (const auto &pair : contact.contact_pairs())
      for (const auto &point : pair->points)
        any = any || (!point.hysteresis.active() &&
                      can_learn(point, pair->parameters));
    return Utilities::MPI::max(any ? 1 : 0, contact.get_communicator()) > 0;
  }



  template <int dim>
  void
  CyclingCures<dim>::let_points_learn()
  {
    for (const auto &pair : contact.contact_pairs())
      for (auto &point : pair->points)
        point.hysteresis.set_active(true);
  }



  template <int dim>
  bool
  CyclingCures<dim>::natural_scales_differ() const
  {
    double largest = 0.;
    for (const auto &pair : contact.contact_pairs())
      if (scales_may_change(*pair))
        for (const auto &point : pair->points)
          {
            const Regularization &r = point.regularization;
            largest =
              std::max(largest, distance(point.scales.stiffness, r.r_n_status));
            if (pair->parameters.has_friction())
              largest = std::max(largest,
                                 distance(point.scales.stiffness_over_threshold,
                                          r.r_t_status));
          }
    return Utilities::MPI::max(largest, contact.get_communicator()) >
           std::log(clear_change);
  }



  template <int dim>
  void
  CyclingCures<dim>::use_natural_scales()
  {
    for (const auto &pair : contact.contact_pairs())
      if (scales_may_change(*pair))
        for (auto &point : pair->points)
          {
            const Regularization &r = point.regularization;
            point.cure.r_n_factor *= point.scales.stiffness / r.r_n_status;
            point.cure.r_t_factor *=
              point.scales.stiffness_over_threshold / r.r_t_status;
          }
  }

  template class CyclingCures<2>;
  template class CyclingCures<3>;
} // namespace stickslip
