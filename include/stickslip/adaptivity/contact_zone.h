#ifndef stickslip_adaptivity_contact_zone_h
#define stickslip_adaptivity_contact_zone_h

#include <stickslip/adaptivity/error_estimator.h>

namespace stickslip
{
  /**
   * Rule: the cells of both bodies with a face in contact, or less than a
   * distance away from the other surface. A place is in contact if its contact
   * point is closed; its gap is that in the present configuration, so nothing
   * is known of surfaces that are farther apart than the search distance of
   * their pair.
   */
  template <int dim>
  class ContactZone : public ErrorEstimator<dim>
  {
  public:
    /// @p distance: largest gap [length].
    explicit ContactZone(const double distance)
      : distance(distance)
    {}

    Vector<double>
    indicators(ContactProblem<dim>   &problem,
               const LA::BlockVector &x) const override;

    bool
    is_rule() const override
    {
      return true;
    }

  private:
    const double distance;
  };



  /**
   * Rule: the cells of both bodies with a contact face near a place where
   * closed contact points have open ones, or sticking ones slipping ones, for
   * neighbours, on a slave face or at the node between two: closer to it than a
   * distance, in the present configuration, or than a tenth of the face.
   */
  template <int dim>
  class ContactEdge : public ErrorEstimator<dim>
  {
  public:
    /// @p distance [length]
    explicit ContactEdge(const double distance)
      : distance(distance)
    {}

    Vector<double>
    indicators(ContactProblem<dim>   &problem,
               const LA::BlockVector &x) const override;

    bool
    is_rule() const override
    {
      return true;
    }

  private:
    const double distance;
  };
} // namespace stickslip

#endif
