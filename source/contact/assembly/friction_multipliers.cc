#include <stickslip/contact/assembly/friction_multipliers.h>

#include <cmath>

namespace stickslip
{
  namespace
  {
    /// The longest Lambda: outside of the disc, so that the point goes on to
    /// slip.
    constexpr double longest_multiplier = 5.;
  } // namespace



  template <int dim>
  void
  shorten_friction_multipliers(const ContactAssembler<dim> &contact,
                               LA::Vector                  &multipliers)
  {
    for (const MultiplierNode &node : contact.multipliers().owned_nodes())
      {
        const auto &parameters = contact.contact_pairs()[node.pair]->parameters;
        if (!parameters.has_friction() ||
            !has_one_multiplier_per_point(parameters.quadrature))
          continue;
        double square = 0.;
        for (unsigned int c = 1; c < dim; ++c)
          square += std::pow(multipliers(node.first_dof + c), 2);
        if (square <= longest_multiplier * longest_multiplier)
          continue;
        const double factor = longest_multiplier / std::sqrt(square);
        for (unsigned int c = 1; c < dim; ++c)
          {
            const double Lambda             = multipliers(node.first_dof + c);
            multipliers(node.first_dof + c) = factor * Lambda;
          }
      }
    multipliers.compress(VectorOperation::insert);
  }

  template void
  shorten_friction_multipliers(const ContactAssembler<2> &, LA::Vector &);
  template void
  shorten_friction_multipliers(const ContactAssembler<3> &, LA::Vector &);
} // namespace stickslip
