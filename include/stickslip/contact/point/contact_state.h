#ifndef stickslip_contact_point_contact_state_h
#define stickslip_contact_point_contact_state_h

#include <stickslip/contact/point/contact_parameters.h>

#include <deal.II/base/tensor.h>

namespace stickslip
{
  using namespace dealii;

  /// What a contact point is doing. `unpaired`: no master face in reach, or
  /// only one that is too far away to touch (far_surfaces.h). `closed`: of a
  /// pair without friction; only results tell it from `slip`. `tied`: of a tied
  /// pair; only results tell it from `stick`.
  enum class ContactState
  {
    unpaired = 0,
    open     = 1,
    stick    = 2,
    slip     = 3,
    closed   = 4,
    tied     = 5
  };

  constexpr unsigned int n_contact_states = 6;

  /// True if the surfaces touch.
  inline bool
  is_closed(const ContactState state)
  {
    return state == ContactState::stick || state == ContactState::slip ||
           state == ContactState::closed || state == ContactState::tied;
  }

  /// @p state as results have it, of a pair with these parameters.
  inline ContactState
  shown_state(const ContactState state, const ContactPairParameters &parameters)
  {
    if (!is_closed(state))
      return state;
    if (parameters.is_tied())
      return ContactState::tied;
    return parameters.has_friction() ? state : ContactState::closed;
  }



  /// What decides about the status of a contact point in one iterate.
  template <int dim>
  struct StatusState
  {
    double         lambda_n = 0.; ///< [stress]
    double         d_n      = 0.; ///< [length], > 0 in penetration
    Tensor<1, dim> Lambda;
    Tensor<1, dim> d_t; ///< [length]
  };



  /// What the last residual or tangent took a contact point to do.
  template <int dim>
  struct ObservedState
  {
    ContactState state = ContactState::unpaired;
    /// Unit vector of the friction force; zero unless the point slips with
    /// friction.
    Tensor<1, dim>   slip_direction;
    StatusState<dim> values;
  };



  template <int dim>
  struct ContactPoint;

  template <int dim>
  struct ContactEvaluation;

  /// The state of @p point as its @p evaluation has it.
  template <int dim>
  ObservedState<dim>
  observe(const ContactPoint<dim>      &point,
          const ContactEvaluation<dim> &evaluation);
} // namespace stickslip

#endif
