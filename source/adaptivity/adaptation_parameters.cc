#include <stickslip/adaptivity/adaptation_parameters.h>

#include <stickslip/adaptivity/error_estimator.h>

#include <stickslip/base/user_error.h>

#include <deal.II/base/patterns.h>

#include <sstream>

namespace stickslip
{
  const Choices<Marking> &
  all_markings()
  {
    static const Choices<Marking> choices = {
      {"fixed fraction", Marking::fixed_fraction},
      {"fixed number", Marking::fixed_number},
      {"error target", Marking::error_target}};
    return choices;
  }



  const Choices<Repetition> &
  all_repetitions()
  {
    static const Choices<Repetition> choices = {
      {"never", Repetition::never},
      {"first step", Repetition::first_step},
      {"every step", Repetition::every_step}};
    return choices;
  }



  void
  AdaptationParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Estimator",
                      estimator,
                      "Adapts the mesh: where the error of the states is. " +
                        error_estimator_descriptions(),
                      Patterns::Selection(error_estimator_selection()));
    add_choice(prm,
               "Marking",
               marking,
               all_markings(),
               "Which cells an estimated error wants finer or coarser. 'fixed "
               "fraction': those with the largest indicators, the squares of "
               "which have about Refine fraction of the sum of all squares, "
               "and those with the smallest, which have about Coarsen "
               "fraction of it. 'fixed number': these fractions of the cells. "
               "'error target': those with more than the share of Error "
               "target that falls to each cell (with four times as much where "
               "the whole error is below the target), by up to three levels, "
               "and those with much less. Cells of rigid bodies do not count. "
               "('contact zone' and "
               "'contact edge' mark "
               "their cells, whatever stands here.)");
    prm.add_parameter(
      "Every",
      every,
      "The mesh is adapted after every so many steps; the state "
      "is carried over and brought to equilibrium before the "
      "load goes on. 0: never after a step.",
      Patterns::Integer(0));
    add_choice(prm,
               "Repeat",
               repetition,
               all_repetitions(),
               "Which steps are solved once more, from where they began, on a "
               "mesh that is finer where their solution wants that, until it "
               "does not, or for few cells only. 'first step': the first in "
               "which anything is strained, or a rule selects cells, and later "
               "ones whose estimated error is more than five times the largest "
               "before, as when contact begins between bodies that a weak "
               "spring or gravity has held.");
    prm.add_parameter("Most repetitions",
                      most_repetitions,
                      "Of one step.",
                      Patterns::Integer(1, 100));
    prm.add_parameter("Refine fraction",
                      refine_fraction,
                      "Of the squared error, or of the cells.",
                      Patterns::Double(0., 1.));
    prm.add_parameter("Coarsen fraction",
                      coarsen_fraction,
                      "Likewise.",
                      Patterns::Double(0., 1.));
    prm.add_parameter("Error target",
                      error_target,
                      "Estimated error over the energy norm of the state.",
                      Patterns::Double(1e-12));
    prm.add_parameter("Least levels",
                      least_levels,
                      "Cells are not made coarser than this many levels after "
                      "'Mesh/Global refinements'.",
                      Patterns::Integer(0, 12));
    prm.add_parameter("Most levels",
                      most_levels,
                      "Cells are not made finer than this many levels after "
                      "'Mesh/Global refinements'.",
                      Patterns::Integer(0, 12));
    prm.add_parameter("Most cells",
                      most_cells,
                      "Of all bodies. Where more would be wanted, only those "
                      "with the largest indicators are refined. (What keeps "
                      "the levels of neighbours within one comes on top.)",
                      Patterns::Integer(1));
    prm.add_parameter("Buffer layers",
                      buffer_layers,
                      "Layers of cells around those that are refined which "
                      "are refined with them.",
                      Patterns::Integer(0, 20));
    prm.add_parameter("Distance",
                      distance,
                      "'contact zone' and 'contact edge': how far around it "
                      "[length].",
                      Patterns::Double(0.));
  }



  void
  AdaptationParameters::check(const std::string &path,
                              const bool         has_contact) const
  {
    if (least_levels > most_levels)
      throw UserError(path + "/Least levels = " + std::to_string(least_levels) +
                      ": it must not be larger than 'Most levels' = " +
                      std::to_string(most_levels) + ".");
    if (refine_fraction + coarsen_fraction > 1.)
      {
        std::ostringstream text;
        text << path << "/Coarsen fraction = " << coarsen_fraction
             << ": with 'Refine fraction' = " << refine_fraction
             << " it must not be larger than " << 1. - refine_fraction
             << ", so that no cell is in both.";
        throw UserError(text.str());
      }
    if (is_about_contact() && !has_contact)
      throw UserError(path + "/Estimator = " + estimator +
                      ": there is no contact. Add a pair to section 'Contact', "
                      "or take an estimator of errors: 'residual', "
                      "'recovery', 'Kelly'.");
    if (distance > 0. && !is_about_contact())
      throw UserError(path + "/Distance is given, but 'Estimator = " +
                      estimator + "' has no use for it.");
  }
} // namespace stickslip
