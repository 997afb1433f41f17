#ifndef stickslip_contact_assembly_point_evaluator_h
#define stickslip_contact_assembly_point_evaluator_h

#include <stickslip/base/types.h>

#include <stickslip/contact/pairing/contact_pair.h>
#include <stickslip/contact/point/contact_element.h>
#include <stickslip/contact/point/mortar_element.h>

namespace stickslip
{
  /// Which contact quantities are recomputed in every residual.
  struct Liveness
  {
    bool geometry  = true;
    bool threshold = true;
    bool status    = true;
  };



  /// What statuses are taken for.
  enum class StatusRule
  {
    contact_law, ///< live, frozen or fixed, as the point has it
    all_stick    ///< paired points are closed and stick, without augmentation
  };



  /**
   * Evaluates the contact law at single points, from their present pairing and
   * the multipliers of the last configuration. Not collective.
   */
  template <int dim>
  class PointEvaluator
  {
  public:
    Liveness    live;
    StatusRule  status_rule = StatusRule::contact_law;
    LawRounding rounding; ///< of points whose status is live and not fixed

    /// State of a point in the present configuration, without derivatives.
    /// Valid until the next call.
    const ContactEvaluation<dim> &
    evaluate(const ContactPair<dim> &pair, const ContactPoint<dim> &point);

    /// With derivatives; those of the geometry only with
    /// @p linearize_geometry.
    ContactEvaluation<dim> &
    differentiate(const ContactPair<dim>  &pair,
                  const ContactPoint<dim> &point,
                  const bool               linearize_geometry);

    /// S_c from the present multipliers and gap, frozen or not.
    bool
    live_closed(const ContactPair<dim> &pair, const ContactPoint<dim> &point);

    /// Coulomb threshold of a paired point from the present state, else 0.
    double
    live_threshold(const ContactPair<dim>  &pair,
                   const ContactPoint<dim> &point);

    /// lambda_n at displacement node @p j of a slave face.
    double
    lambda_n_at_node(const ContactPair<dim> &pair,
                     const unsigned int      slave_face,
                     const unsigned int      j) const;

    /// Multipliers at a point from the ghosted @p values.
    Multipliers<dim>
    multipliers_at(const ContactPair<dim>  &pair,
                   const ContactPoint<dim> &point,
                   const LA::Vector        &values) const;

  protected:
    LA::Vector lambda; ///< ghosted, of the present configuration

    /// The point's data for contact_element.h. Points into the pair.
    ContactElement<dim>
    element_of(const ContactPair<dim>  &pair,
               const ContactPoint<dim> &point) const;

    /// Likewise for mortar_element.h, in pairs with segments.
    MortarElement<dim>
    mortar_element_of(const ContactPair<dim>  &pair,
                      const ContactPoint<dim> &point) const;

  private:
    ContactEvaluation<dim> state;
    MasterPoint<dim>       old_master;

    void
    evaluate_kinematics(const ContactPair<dim>  &pair,
                        const ContactPoint<dim> &point,
                        const bool               linearize_geometry,
                        const bool               with_derivatives);

    void
    evaluate_point(const ContactPair<dim>  &pair,
                   const ContactPoint<dim> &point,
                   const bool               linearize_geometry,
                   const bool               with_derivatives);

    PointLaw
    law_at(const ContactPair<dim> &pair, const ContactPoint<dim> &point) const;
  };



  /// While it lives, statuses follow another rule. What points have frozen or
  /// fixed stays as it is.
  template <int dim>
  class StatusRuleScope
  {
  public:
    StatusRuleScope(PointEvaluator<dim> &contact, const StatusRule rule)
      : contact(contact)
      , before(contact.status_rule)
    {
      contact.status_rule = rule;
    }

    ~StatusRuleScope()
    {
      contact.status_rule = before;
    }

    StatusRuleScope(const StatusRuleScope &) = delete;
    StatusRuleScope &
    operator=(const StatusRuleScope &) = delete;

  private:
    PointEvaluator<dim> &contact;
    const StatusRule     before;
  };



  /// While it lives, nothing is frozen.
  template <int dim>
  class LiveScope
  {
  public:
    explicit LiveScope(PointEvaluator<dim> &contact)
      : contact(contact)
      , before(contact.live)
    {
      contact.live = Liveness();
    }

    ~LiveScope()
    {
      contact.live = before;
    }

    LiveScope(const LiveScope &) = delete;
    LiveScope &
    operator=(const LiveScope &) = delete;

  private:
    PointEvaluator<dim> &contact;
    const Liveness       before;
  };
} // namespace stickslip

#endif
