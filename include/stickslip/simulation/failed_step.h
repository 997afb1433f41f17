#ifndef stickslip_simulation_failed_step_h
#define stickslip_simulation_failed_step_h

#include <stickslip/base/no_convergence.h>
#include <stickslip/base/parameter_file.h>

#include <stickslip/contact/cycling/point_diagnosis.h>
#include <stickslip/contact/point/contact_parameters.h>

#include <stickslip/solid/rigid_body_check.h>

#include <stickslip/strategy/newton_parameters.h>
#include <stickslip/strategy/newton_problem.h>

#include <functional>
#include <string>
#include <vector>

namespace stickslip
{
  /// What a failed attempt at a load step has left behind.
  template <int dim>
  struct FailedStep
  {
    const NoConvergence                    &failure;
    const std::vector<NewtonIteration>     &iterations; ///< last solve
    const NewtonParameters                 &newton;
    StatusCycle                             cycle;  ///< of all points
    const std::vector<PointDiagnosis<dim>> &points; ///< of this rank
    const NamedList<ContactPairParameters> &pairs;
    std::vector<FreeMotion> free_motions; ///< that contact alone can prevent
    std::vector<FreeMotion> weakly_held;  ///< by springs below roundoff

    /// Beside contact, with an algorithm that needs bodies held without it.
    std::vector<FreeMotion> held_by_springs;
  };



  /// The contact points with some property: how many, and of the pair that has
  /// most of them the box around their current positions.
  template <int dim>
  struct PointGroup
  {
    unsigned int n      = 0; ///< of all pairs
    unsigned int pair   = 0;
    unsigned int n_pair = 0; ///< of this pair
    Point<dim>   lower, upper;
  };

  /// Collective.
  template <int dim>
  PointGroup<dim>
  find_group(
    const FailedStep<dim>                                  &step,
    const std::function<bool(const PointDiagnosis<dim> &)> &has_property,
    const MPI_Comm                                          communicator);

  /// The path of a parameter of the group's pair, in quotes.
  template <int dim>
  std::string
  parameter_of(const PointGroup<dim> &group,
               const FailedStep<dim> &step,
               const std::string     &name)
  {
    return "'Contact/" + step.pairs[group.pair].first + "/" + name + "'";
  }

  /// "3 points of pair 'x', between (...) and (...)."
  template <int dim>
  std::string
  describe(const PointGroup<dim> &group, const FailedStep<dim> &step);
} // namespace stickslip

#endif
