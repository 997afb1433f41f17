#ifndef stickslip_simulation_checkpoint_description_h
#define stickslip_simulation_checkpoint_description_h

#include <stickslip/problem/contact_problem.h>

#include <stickslip/simulation/work_balance.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace stickslip
{
  /// The numbers of a state that are not fields.
  struct CheckpointScalars
  {
    double       time      = 0.;
    double       step_size = 0.;
    unsigned int step      = 0;
    WorkBalance  work;
  };



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

    std::string
    text() const;

    /// Reads text(). Returns an empty string, or what is wrong with it.
    std::string
    parse(const std::string &text);
  };
} // namespace stickslip

#endif
