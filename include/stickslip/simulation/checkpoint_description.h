#ifndef stickslip_simulation_checkpoint_description_h
#define stickslip_simulation_checkpoint_description_h

#include <stickslip/problem/contact_problem.h>

#include <stickslip/simulation/work_balance.h>

#include <stickslip/strategy/step_control.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace stickslip
{
  /// What a run has done with its mesh.
  struct AdaptationProgress
  {
    unsigned int adaptations = 0; ///< other cells than at the start
    /// An accepted step had something that cells were marked by: 'first step'
    /// is over.
    bool has_begun = false;
    /// Of the estimates of accepted steps; 0: none, or those of a rule.
    double largest_error = 0.;
  };



  /// The numbers of a state that are not fields.
  struct CheckpointScalars
  {
    StepControlState   control;
    WorkBalance        work;
    AdaptationProgress adaptation;
    /// Of the estimate of the error; negative: there is none.
    double energy_norm = -1.;
  };



  /// Names of parameters and their values, in the order of declaration.
  using ParameterValues = std::vector<std::pair<std::string, std::string>>;

  /// Texts about values that are not the same: "'Contact/a/Friction' was none
  /// and is Coulomb". Numbers are compared as such; what is new or gone counts.
  std::vector<std::string>
  changed_values(const ParameterValues &before, const ParameterValues &now);



  /// Whether both have the same parameters in @p section, with the same values.
  bool
  have_same(const ParameterValues &a,
            const ParameterValues &b,
            const std::string     &section);



  /**
   * What a problem and a checkpoint must have in common: named texts, to be
   * compared word by word, and sums over the mesh that agree up to roundoff.
   * None depends on the partition.
   */
  struct ProblemFingerprint
  {
    std::vector<std::pair<std::string, std::string>> properties;
    std::vector<double> geometry; ///< the last one is the scale of the others

    /// Empty, or the first difference in words; @p other is the checkpoint's.
    std::string
    difference_from(const ProblemFingerprint &other) const;
  };

  /// Collective.
  template <int dim>
  ProblemFingerprint
  fingerprint(ContactProblem<dim> &problem);



  /// The text file of a checkpoint that says what its other files contain.
  struct CheckpointDescription
  {
    std::uint64_t      identity = 0; ///< of this checkpoint's files
    unsigned int       n_files  = 0;
    CheckpointScalars  scalars;
    ProblemFingerprint problem;
    /// What may be another one after a restart, but is worth a warning.
    ParameterValues physics;

    std::string
    text() const;

    /// Empty, or in words that @p text is one of another version of the program.
    static std::string
    other_format(const std::string &text);

    /// Reads text(). Returns an empty string, or what is wrong with it.
    std::string
    parse(const std::string &text);
  };
} // namespace stickslip

#endif
