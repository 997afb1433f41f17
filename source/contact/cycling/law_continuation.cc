#include <stickslip/contact/cycling/law_continuation.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

namespace stickslip
{
  namespace
  {
    /// By which corners become sharper.
    constexpr double sharper = 0.2;

    /// Likewise where the rounded equations are solved.
    constexpr double sharper_when_solved = 0.1;

    /// Share of the merit to which it has to fall before that.
    constexpr double enough = 0.3;

    /// Iterations in which it has to.
    constexpr unsigned int most_iterations = 6;

    /// So many laws for which it has not, and the law is exact.
    constexpr unsigned int most_stuck = 2;

    /// The sharpest corner beside the first one; then the law is exact.
    constexpr double sharpest = 1e-6;
  } // namespace



  template <int dim>
  LawContinuation<dim>::LawContinuation(ContactAssembler<dim> &contact)
    : contact(contact)
  {
    end();
  }



  template <int dim>
  LawContinuation<dim>::~LawContinuation()
  {
    end();
  }



  template <int dim>
  bool
  LawContinuation<dim>::begin()
  {
    if (has_begun || !contact.live.status)
      return false;
    // of closed points
    double sum_of_pressures = 0., n_closed = 0., Lambda = 1.;
    for_each_point(
      contact, [&](const ContactPair<dim> &, const ContactPoint<dim> &p) {
        if (!is_closed(p.observed.state))
          return;
        const auto &state = p.observed.values;
        sum_of_pressures += std::abs(state.lambda_n);
        n_closed += 1.;
        Lambda = std::max(
          Lambda, (state.Lambda + p.regularization.r_t_law * state.d_t).norm());
      });
    const MPI_Comm communicator = contact.get_communicator();
    sum_of_pressures = Utilities::MPI::sum(sum_of_pressures, communicator);
    n_closed         = Utilities::MPI::sum(n_closed, communicator);
    if (sum_of_pressures == 0.)
      return false;
    has_begun        = true;
    contact.rounding = {sum_of_pressures / n_closed,
                        Utilities::MPI::max(Lambda, communicator)};
    first_width      = contact.rounding.pressure;
    law_is_new       = true;
    return true;
  }



  template <int dim>
  void
  LawContinuation<dim>::observe(const double merit)
  {
    if (law_is_new)
      merit_of_new_law = merit;
    law_is_new = false;
    last_merit = merit;
  }



  template <int dim>
  bool
  LawContinuation<dim>::advance()
  {
    ++n_iterations;
    const bool is_good = last_merit < enough * merit_of_new_law;
    if (!is_good && n_iterations < most_iterations)
      return false;
    if (!is_good && ++n_stuck >= most_stuck)
      end();
    else
      change_width(sharper);
    return true;
  }



  template <int dim>
  void
  LawContinuation<dim>::sharpen()
  {
    change_width(sharper_when_solved);
  }



  template <int dim>
  void
  LawContinuation<dim>::end()
  {
    contact.rounding = LawRounding();
    law_is_new       = true;
    n_iterations     = 0;
  }



  template <int dim>
  void
  LawContinuation<dim>::change_width(const double factor)
  {
    contact.rounding.pressure *= factor;
    contact.rounding.disc *= factor;
    law_is_new   = true;
    n_iterations = 0;
    if (contact.rounding.pressure < sharpest * first_width)
      end();
  }

  template class LawContinuation<2>;
  template class LawContinuation<3>;
} // namespace stickslip
