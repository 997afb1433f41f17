#ifndef stickslip_adaptivity_adaptation_parameters_h
#define stickslip_adaptivity_adaptation_parameters_h

#include <stickslip/base/choice.h>

#include <deal.II/base/parameter_handler.h>

#include <string>

namespace stickslip
{
  using namespace dealii;

  /// Which cells the indicators of an error estimator select.
  enum class Marking
  {
    fixed_fraction, ///< those that hold a fraction of the error
    fixed_number,   ///< a fraction of the cells
    error_target    ///< those with more than their share of the error
  };

  const Choices<Marking> &
  all_markings();

  /// Which steps are solved once more when their solution wants finer cells.
  enum class Repetition
  {
    never,
    first_step,
    every_step
  };

  const Choices<Repetition> &
  all_repetitions();

  /// Section `Adaptation`: when the mesh is adapted, where the error of an
  /// accepted state is, and which cells that wants finer or coarser.
  struct AdaptationParameters
  {
    /// A name of the registry (adaptivity/error_estimator.h), or `none`.
    std::string  estimator        = "none";
    Marking      marking          = Marking::error_target;
    double       refine_fraction  = 0.3;
    double       coarsen_fraction = 0.03;
    double       error_target     = 0.05; ///< relative
    unsigned int least_levels     = 0;    ///< beyond the global refinements
    unsigned int most_levels      = 3;    ///< likewise
    unsigned int most_cells       = 1000000;
    unsigned int buffer_layers    = 1;
    double       distance         = 0.; ///< of contact zone and edge [length]
    Repetition   repetition       = Repetition::first_step;
    unsigned int most_repetitions = 6;
    unsigned int every            = 1; ///< so many steps; 0: never

    /// `Mesh/Global refinements`, from which levels count.
    unsigned int global_refinements = 0;

    /// True if the estimator is a rule about contact.
    bool
    is_about_contact() const
    {
      return estimator == "contact zone" || estimator == "contact edge";
    }

    bool
    is_active() const
    {
      return estimator != "none";
    }

    void
    add_parameters(ParameterHandler &prm);

    /// Throws UserError for what contradicts itself, or the case, which
    /// @p has_contact or not; @p path is the section.
    void
    check(const std::string &path, const bool has_contact) const;
  };
} // namespace stickslip

#endif
