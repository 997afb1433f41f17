#ifndef stickslip_adaptivity_surface_transfer_h
#define stickslip_adaptivity_surface_transfer_h

#include <stickslip/adaptivity/cell_transfer.h>

#include <stickslip/contact/results/contact_result.h>

#include <stickslip/problem/contact_problem.h>

#include <array>
#include <vector>

namespace stickslip
{
  /// The states of which a record has multipliers.
  enum WhichState : unsigned int
  {
    accepted_state,
    guessed_state,
    n_states
  };



  /// What a node of a slave surface has in a record: lambda_n and Lambda of
  /// both states and the accumulated slip, as vectors, whose components no
  /// frame changes.
  template <int dim>
  struct CarriedValues
  {
    static constexpr unsigned int n_components = n_states * (1 + dim) + dim;

    std::array<double, n_states>         lambda_n{};
    std::array<Tensor<1, dim>, n_states> Lambda;
    Tensor<1, dim>                       slip;

    /// Calls @p visit(component, value).
    template <typename Visitor>
    void
    for_each_component(const Visitor &visit)
    {
      for (unsigned int k = 0; k < n_states; ++k)
        visit(k, lambda_n[k]);
      for (unsigned int c = 0; c < dim; ++c)
        {
          for (unsigned int k = 0; k < n_states; ++k)
            visit(n_states + k * dim + c, Lambda[k][c]);
          visit(n_states * (1 + dim) + c, slip[c]);
        }
    }
  };



  template <int dim>
  using ContactStates =
    std::array<std::vector<ContactFaceResult<dim>>, n_states>;

  /// Adds what @p results, those of all slave faces in both states, say at their
  /// nodes to the records of the cells. Not collective.
  template <int dim>
  void
  add_surfaces(ContactProblem<dim>      &problem,
               const ContactStates<dim> &results,
               std::vector<CellRecord>  &records);

  /// What records have on the nodes of all slave faces of this rank:
  /// [pair][face][node].
  template <int dim>
  using AllCarriedValues =
    std::vector<std::vector<std::vector<CarriedValues<dim>>>>;

  template <int dim>
  AllCarriedValues<dim>
  carried_values(ContactProblem<dim>           &problem,
                 const std::vector<CellRecord> &records);

  /// The accumulated slip of all contact points.
  template <int dim>
  void
  set_slip(const ContactAssembler<dim> &contact,
           const AllCarriedValues<dim> &all);

  /// The multipliers of @p state, whose displacements @p x has already;
  /// @p problem is then ready for an iteration at it. Collective.
  template <int dim>
  void
  set_multipliers(ContactProblem<dim>         &problem,
                  const AllCarriedValues<dim> &all,
                  const WhichState             state,
                  const double                 time,
                  LA::BlockVector             &x);
} // namespace stickslip

#endif
