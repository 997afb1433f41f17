#include <stickslip/contact/cycling/status_cycle_treatment.h>

#include <stickslip/base/expert_parameter.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

namespace stickslip
{
  namespace
  {
    /// Another r has to be nearer to the default by this factor.
    constexpr double no_change = 1.01;

    /// Changes of r above this factor are a reason to try a step again.
    constexpr double clear_change = 2.;

    /// Treatments of a point in one solve after which it is left as it is.
    constexpr unsigned int most_treatments = 3;



    /// As factors.
    double
    distance(const double a, const double b)
    {
      return std::abs(std::log(a / b));
    }



    /// The status of a point alternates, not its pairing.
    bool
    concerns_status(const CycleKind kind)
    {
      return kind != CycleKind::facet && kind != CycleKind::pairing;
    }



    /// Whether another pairing would follow from hysteresis.
    template <int dim>
    bool
    would_act(const ContactPoint<dim>     &point,
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
      expert(
        "Points whose statuses were proven to cycle get another "
        "regularization parameter, the nearest to the automatic one that gives "
        "the last two states the same status (paper, eqs. 29 and 32). If a "
        "solve fails all the same, all take the automatic one. Only with "
        "'Quadrature = segments' or 'nodal', where the answer does not depend "
        "on it."));
    prm.add_parameter(
      "Round corners",
      round_corners,
      expert(
        "Where the residual has not become smaller for some iterations, the "
        "corners of the contact law (closed or open, stick or slip) are "
        "rounded and made sharp again while Newton's method converges; what is "
        "accepted satisfies the exact law."));
    prm.add_parameter("Hold statuses",
                      fix_statuses,
                      expert(
                        "Points that cycle with any other r, too, have a fixed "
                        "status until the rest has converged; all statuses are "
                        "then free again before a state is accepted."));
  }



  template <int dim>
  StatusCycleTreatment<dim>::StatusCycleTreatment(
    const CyclingParameters &parameters,
    ContactAssembler<dim>   &contact)
    : parameters(parameters)
    , contact(contact)
  {}



  template <int dim>
  void
  StatusCycleTreatment<dim>::begin_step()
  {
    for (const auto &pair : contact.contact_pairs())
      for (auto &point : pair->points)
        point.hysteresis.set_active(false);
  }



  template <int dim>
  void
  StatusCycleTreatment<dim>::begin_solve()
  {
    statuses.clear();
    now.clear();
    for (const auto &pair : contact.contact_pairs())
      for (auto &point : pair->points)
        {
          point.treatment.release();
          point.treatment.n_treatments = 0;
          point.treatment.n_fixed      = 0;
        }
  }



  template <int dim>
  void
  StatusCycleTreatment<dim>::read_states()
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
  StatusCycleTreatment<dim>::scales_may_change(
    const ContactPair<dim> &pair) const
  {
    return parameters.adapt_scales &&
           pair.parameters.is_independent_of_regularization();
  }



  template <int dim>
  bool
  StatusCycleTreatment<dim>::adapt_scale(const PointCycle &cycle)
  {
    const ContactPair<dim> &pair = *contact.contact_pairs()[cycle.pair];
    if (!scales_may_change(pair) || before.empty())
      return false;
    ContactPoint<dim> &point =
      contact.contact_pairs()[cycle.pair]->points[cycle.point];
    const auto           &a         = before[cycle.pair][cycle.point];
    const auto           &b         = now[cycle.pair][cycle.point];
    const Regularization &r         = point.regularization;
    const bool            is_normal = cycle.kind == CycleKind::contact;
    const double          present   = is_normal ? r.r_n_status : r.r_t_status;
    const double          natural =
      is_normal ? point.scales.default_r_n : point.scales.default_r_t;
    const double better =
      is_normal ? admissible_r_n(a, b, natural) : admissible_r_t(a, b, natural);
    // farther from the default another r only makes another cycle
    if (better == 0. || distance(better, natural) + std::log(no_change) >
                          distance(present, natural))
      return false;
    (is_normal ? point.treatment.r_n_factor : point.treatment.r_t_factor) *=
      better / present;
    statuses.note_treatment(cycle.pair,
                            cycle.point,
                            is_normal ? PointTreatment::other_r_n
                                      : PointTreatment::other_r_t);
    return true;
  }



  template <int dim>
  void
  StatusCycleTreatment<dim>::fix_status(const PointCycle &cycle)
  {
    auto &treatment =
      contact.contact_pairs()[cycle.pair]->points[cycle.point].treatment;
    const bool first_side = treatment.n_fixed % 2 == 0;
    ++treatment.n_fixed;
    const bool is_normal = cycle.kind == CycleKind::contact;
    (is_normal ? treatment.fixed_closed : treatment.fixed_stick) = first_side;
    statuses.note_treatment(cycle.pair,
                            cycle.point,
                            is_normal
                              ? (first_side ? PointTreatment::fixed_closed
                                            : PointTreatment::fixed_open)
                              : (first_side ? PointTreatment::fixed_stick
                                            : PointTreatment::fixed_slip));
  }



  template <int dim>
  CycleReport
  StatusCycleTreatment<dim>::treat(const std::vector<PointCycle> &cycles)
  {
    CycleReport result;
    for (const PointCycle &cycle : cycles)
      {
        ++result.n_cycling[static_cast<unsigned int>(cycle.kind)];
        auto &treatment =
          contact.contact_pairs()[cycle.pair]->points[cycle.point].treatment;
        if (!concerns_status(cycle.kind) ||
            treatment.n_treatments >= most_treatments)
          continue;
        if (treatment.n_treatments == 0 && adapt_scale(cycle))
          ++result.n_other_r;
        else if (parameters.fix_statuses)
          {
            fix_status(cycle);
            ++result.n_fixed;
          }
        else
          continue;
        ++treatment.n_treatments;
      }
    const MPI_Comm communicator = contact.get_communicator();
    result.n_other_r = Utilities::MPI::sum(result.n_other_r, communicator);
    result.n_fixed   = Utilities::MPI::sum(result.n_fixed, communicator);
    for (unsigned int &n : result.n_cycling)
      n = Utilities::MPI::sum(n, communicator);
    return result;
  }



  template <int dim>
  CycleTreatment
  StatusCycleTreatment<dim>::observe(const bool act)
  {
    statuses.record(contact);
    read_states();
    report.reset();
    const std::vector<PointCycle> cycles = statuses.cycling_points();
    if (!act || Utilities::MPI::max(cycles.empty() ? 0 : 1,
                                    contact.get_communicator()) == 0)
      return CycleTreatment::none;
    report = treat(cycles);
    ++counts.cycles;
    counts.adapted_scales += report->n_other_r;
    counts.fixed_statuses += report->n_fixed;
    if (!report->any_treated())
      return CycleTreatment::untreatable;
    statuses.forget_records();
    return CycleTreatment::treated;
  }



  template <int dim>
  bool
  StatusCycleTreatment<dim>::release()
  {
    bool any = false;
    for (const auto &pair : contact.contact_pairs())
      for (auto &point : pair->points)
        any = point.treatment.release() || any;
    any = Utilities::MPI::max(any ? 1 : 0, contact.get_communicator()) > 0;
    if (any)
      statuses.forget_records();
    return any;
  }



  template <int dim>
  bool
  StatusCycleTreatment<dim>::hysteresis_would_help() const
  {
    bool any = false;
    for (const auto &pair : contact.contact_pairs())
      for (const auto &point : pair->points)
        any = any || (!point.hysteresis.active() &&
                      would_act(point, pair->parameters));
    return Utilities::MPI::max(any ? 1 : 0, contact.get_communicator()) > 0;
  }



  template <int dim>
  void
  StatusCycleTreatment<dim>::activate_hysteresis()
  {
    for (const auto &pair : contact.contact_pairs())
      for (auto &point : pair->points)
        point.hysteresis.set_active(true);
  }



  template <int dim>
  bool
  StatusCycleTreatment<dim>::default_scales_differ() const
  {
    double largest = 0.;
    for (const auto &pair : contact.contact_pairs())
      if (scales_may_change(*pair))
        for (const auto &point : pair->points)
          {
            const Regularization &r = point.regularization;
            largest =
              std::max(largest,
                       distance(point.scales.default_r_n, r.r_n_status));
            if (pair->parameters.has_friction())
              largest =
                std::max(largest,
                         distance(point.scales.default_r_t, r.r_t_status));
          }
    return Utilities::MPI::max(largest, contact.get_communicator()) >
           std::log(clear_change);
  }



  template <int dim>
  void
  StatusCycleTreatment<dim>::use_default_scales()
  {
    for (const auto &pair : contact.contact_pairs())
      if (scales_may_change(*pair))
        for (auto &point : pair->points)
          {
            const Regularization &r = point.regularization;
            point.treatment.r_n_factor *=
              point.scales.default_r_n / r.r_n_status;
            point.treatment.r_t_factor *=
              point.scales.default_r_t / r.r_t_status;
          }
  }

  template class StatusCycleTreatment<2>;
  template class StatusCycleTreatment<3>;
} // namespace stickslip
