#include <stickslip/contact/assembly/friction_multipliers.h>

#include <algorithm>
#include <cmath>

namespace stickslip
{
  namespace
  {
    /// The longest Lambda: outside of the disc, so that the point goes on to
    /// slip.
    constexpr double longest_multiplier = 5.;



    bool
    can_be_shortened(const ContactPairParameters &parameters)
    {
      return parameters.has_friction() &&
             has_one_multiplier_per_point(parameters.quadrature);
    }
  } // namespace



  template <int dim>
  void
  shorten_friction_multipliers(const ContactAssembler<dim> &contact,
                               LA::Vector                  &multipliers)
  {
    const auto &pairs = contact.contact_pairs();
    if (std::none_of(pairs.begin(), pairs.end(), [](const auto &pair) {
          return can_be_shortened(pair->parameters);
        }))
      return; // and nobody waits
    for (const MultiplierNode &node : contact.multipliers().owned_nodes())
      {
        if (!can_be_shortened(pairs[node.pair]->parameters))
          continue;
        double square = 0.;
        for (unsigned int c = 1; c < dim; ++c)
          {
            const double Lambda = multipliers(node.first_dof + c);
            square += Lambda * Lambda;
          }
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
