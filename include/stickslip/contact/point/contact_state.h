#ifndef stickslip_contact_point_contact_state_h
#define stickslip_contact_point_contact_state_h

#include <deal.II/base/tensor.h>

namespace stickslip
{
  using namespace dealii;

  /// What a contact point is doing. `unpaired`: no master face in reach.
  /// `closed`: of a pair without friction; only results tell it from `slip`.
  enum class ContactState
  {
    unpaired = 0,
    open     = 1,
    stick    = 2,
    slip     = 3,
    closed   = 4
  };

  constexpr unsigned int n_contact_states = 5;

  /// True if the surfaces touch.
  inline bool
  is_closed(const ContactState state)
  {
    return state == ContactState::stick || state == ContactState::slip ||
           state == ContactState::closed;
  }

  /// @p state as results have it, of a pair with or without friction.
  inline ContactState
  shown_state(const ContactState state, const bool has_friction)
  {
    return is_closed(state) && !has_friction ? ContactState::closed : state;
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
