#include <stickslip/contact/assembly/contact_assembler.h>

#include <stickslip/contact/assembly/point_dofs.h>

#include <stickslip/contact/point/tangent_stabilization.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace stickslip
{
  namespace
  {
    /// Gaps and slips are known up to this fraction of the distance from the
    /// origin: they are differences of up to four places, each rounded.
    constexpr double roundoff_of_place =
      4. * std::numeric_limits<double>::epsilon();



    /// Leaves out zeros: a point at a node does not know the others of its
    /// face, and the nodes that only normals depend on bear no force.
    void
    drop_zeros(std::vector<types::global_dof_index> &dofs,
               Vector<double>                       &local)
    {
      unsigned int n = 0;
      for (unsigned int i = 0; i < dofs.size(); ++i)
        if (local[i] != 0.)
          {
            dofs[n]  = dofs[i];
            local[n] = local[i];
            ++n;
          }
      dofs.resize(n);
      local.grow_or_shrink(n);
    }
  } // namespace



  template <int dim>
  ContactAssembler<dim>::ContactAssembler(
    std::vector<std::unique_ptr<ContactPair<dim>>> contact_pairs,
    const IndexSet                                &owned_displacements,
    const IndexSet                                &relevant_displacements,
    const MPI_Comm                                &communicator)
    : pairs(std::move(contact_pairs))
    , n_displacements(owned_displacements.size())
    , relevant_displacements(relevant_displacements)
    , communicator(communicator)
  {
    std::vector<std::vector<types::global_dof_index>> keys;
    std::vector<unsigned int>                         n_components;
    for (const auto &pair : pairs)
      {
        keys.push_back(pair->multiplier_keys());
        n_components.push_back(pair->n_multiplier_components());
      }
    numbering = MultiplierNumbering(owned_displacements,
                                    relevant_displacements,
                                    keys,
                                    n_components,
                                    communicator);
    for (unsigned int p = 0; p < pairs.size(); ++p)
      pairs[p]->set_multiplier_dofs(numbering, p);
  }


  template <int dim>
  IndexSet
  ContactAssembler<dim>::needed_displacements() const
  {
    IndexSet needed = relevant_displacements;
    for (const auto &pair : pairs)
      {
        const auto dofs = pair->patch->dofs();
        needed.add_indices(dofs.begin(), dofs.end());
        const auto &originals = pair->periodic_originals();
        needed.add_indices(originals.begin(), originals.end());
      }
    needed.compress();
    return needed;
  }


  template <int dim>
  bool
  ContactAssembler<dim>::update_patches(const LA::Vector &u, const bool force)
  {
    bool changed = false;
    for (const auto &pair : pairs)
      changed = pair->update_patch(u, force) || changed;
    return changed;
  }


  template <int dim>
  void
  ContactAssembler<dim>::configure(const LA::Vector &u,
                                   const LA::Vector &u_old,
                                   const LA::Vector &multiplier_values)
  {
    this->lambda = multiplier_values;
    for (const auto &pair : pairs)
      {
        pair->update_configuration(u, u_old);
        pair->use_pairings(this->live.geometry ? pair->find_pairings()
                                               : pair->last_pairings());
      }
  }


  template <int dim>
  void
  ContactAssembler<dim>::accept_iterate()
  {
    if (this->live.geometry)
      for (const auto &pair : pairs)
        pair->accept_iterate(true);
  }



  template <int dim>
  void
  ContactAssembler<dim>::accept_step()
  {
    for (const auto &pair : pairs)
      pair->accept_step();
    for_each_point(*this,
                   [this](ContactPair<dim> &pair, ContactPoint<dim> &point) {
                     const auto &state = this->evaluate(pair, point);
                     if (state.status.closed && !pair.parameters.is_tied())
                       point.accumulated_slip += state.kinematics.d_t;
                   });
  }



  template <int dim>
  void
  ContactAssembler<dim>::restore()
  {
    for (const auto &pair : pairs)
      pair->restore();
  }



  template <int dim>
  bool
  ContactAssembler<dim>::choose_sides()
  {
    bool changed = false;
    for (const auto &pair : pairs)
      if (pair->meets_itself())
        changed = pair->choose_sides() || changed;
    return changed;
  }



  template <int dim>
  void
  ContactAssembler<dim>::share_sides()
  {
    for (const auto &pair : pairs)
      if (pair->meets_itself())
        pair->share_sides();
  }



  template <int dim>
  bool
  ContactAssembler<dim>::has_linearized_friction(
    const ContactPair<dim>  &pair,
    const ContactPoint<dim> &point) const
  {
    return pair.mortar && this->live.threshold &&
           pair.parameters.friction == Friction::Coulomb &&
           !pair.parameters.is_bilateral() &&
           point.restrained.directions.empty();
  }



  template <int dim>
  void
  ContactAssembler<dim>::evaluate_local_residual(
    const ContactPair<dim>       &pair,
    const ContactPoint<dim>      &point,
    const ContactEvaluation<dim> &state,
    Vector<double>               &local) const
  {
    if (pair.mortar)
      local_residual(this->mortar_element_of(pair, point), state, local);
    else
      local_residual(this->element_of(pair, point), state, local);
    turn_images_back(pair, point, local);
  }



  template <int dim>
  void
  ContactAssembler<dim>::evaluate_local_tangent(
    const ContactPair<dim>       &pair,
    const ContactPoint<dim>      &point,
    const ContactEvaluation<dim> &state,
    const bool                    linearize_geometry,
    FullMatrix<double>           &local) const
  {
    if (pair.mortar)
      {
        // the most expensive part of a tangent, and most nodes are open
        const bool differentiate =
          linearize_geometry &&
          needs_mortar_derivative(
            point,
            state.response,
            pair.slave_faces[point.geometry.slave_face].face.diameter);
        MortarDerivative<dim> derivative;
        if (differentiate)
          pair.mortar->differentiate(point.geometry.mortar_node,
                                     *pair.patch,
                                     derivative);
        local_tangent(this->mortar_element_of(pair, point),
                      state,
                      differentiate ? &derivative : nullptr,
                      local);
        keep_undetermined_Lambda(
          point, state, {1.}, pair.n_multiplier_components(), local);
      }
    else
      {
        local_tangent(this->element_of(pair, point),
                      state,
                      linearize_geometry && pair.has_smoothed_normals(),
                      local);
        keep_undetermined_Lambda(
          point,
          state,
          pair.table.multiplier[point.geometry.quadrature_index],
          pair.n_multiplier_components(),
          local);
      }
    turn_images_back(pair, point, local);
  }



  template <int dim>
  void
  ContactAssembler<dim>::add_residual(const Constraints &geometric,
                                      LA::BlockVector   &residual,
                                      ContactRowSizes   &sizes)
  {
    Vector<double> local;
    for (const auto &pair : pairs)
      for (auto &point : pair->points)
        {
          const ContactEvaluation<dim> &state = this->evaluate(*pair, point);
          point.observed                      = observe(point, state);
          auto dofs = point_dofs(*pair, point, n_displacements);
          local.reinit(dofs.size());
          evaluate_local_residual(*pair, point, state, local);
          drop_zeros(dofs, local);
          geometric.distribute_local_to_global(local, dofs, residual);

          const SlaveFace<dim> &slave =
            pair->slave_faces[point.geometry.slave_face];
          const auto &L =
            pair->table.multiplier[point.geometry.quadrature_index];
          const unsigned int n_comp = pair->n_multiplier_components();
          const double       friction_scale =
            state.response.threshold > 0.
                    ? state.response.threshold / point.regularization.r_t_law
                    : point.scales.open_row;
          const double normal_stress =
            point.scales.stiffness * slave.face.diameter;
          const double friction_stress =
            friction_scale * point.regularization.r_t_law;
          const double roundoff = // of gaps and slips
            state.status.closed
              ? roundoff_of_place * pair->slave_position(point).x.norm()
              : 0.;
          for (unsigned int l = 0; l < L.size(); ++l)
            for (unsigned int c = 0; c < n_comp; ++c)
              {
                const auto   dof  = slave.multiplier_dofs[l * n_comp + c];
                const double area = point.geometry.weight * std::abs(L[l]);
                sizes.scale(dof) +=
                  area * (c == 0 ? slave.face.diameter : friction_scale);
                sizes.force(dof) +=
                  area * (c == 0 ? normal_stress : friction_stress);
                // rows of friction are slips times the threshold
                sizes.roundoff(dof) +=
                  area * roundoff * (c == 0 ? 1. : state.response.threshold);
              }
        }
  }



  template <int dim>
  void
  ContactAssembler<dim>::add_tangent(const Constraints     &constraints,
                                     const bool             linearize_geometry,
                                     LA::BlockSparseMatrix &matrix,
                                     LA::BlockVector       &rhs)
  {
    Vector<double>     local;
    FullMatrix<double> local_matrix;
    friction.reinit(numbering.locally_owned(), communicator);
    for (const auto &pair : pairs)
      {
        for (auto &point : pair->points)
          {
            ContactEvaluation<dim> &state =
              this->differentiate(*pair, point, linearize_geometry);
            point.observed = observe(point, state);
            assume_stick_before_first_pressure(point, state);
            if (pair->mortar && point.pairing.paired)
              hold_touching_node(point, state);
            auto dofs = point_dofs(*pair, point, n_displacements);
            local.reinit(dofs.size());
            local_matrix.reinit(dofs.size(), dofs.size());
            evaluate_local_residual(*pair, point, state, local);
            local *= -1.;
            evaluate_local_tangent(*pair,
                                   point,
                                   state,
                                   this->live.geometry && linearize_geometry,
                                   local_matrix);
            merge_images(*pair, point, dofs, local, local_matrix);
            constraints.distribute_local_to_global(
              local_matrix, local, dofs, matrix, rhs);
            if (has_linearized_friction(*pair, point))
              {
                const unsigned int i = point.geometry.quadrature_index;
                friction.add_point(pair->slave_faces[point.geometry.slave_face]
                                     .multiplier_dofs[i * dim],
                                   pair->parameters.friction_coefficient,
                                   point,
                                   point.nodal_rotations[i],
                                   state);
              }
          }
        if (pair->mortar)
          pair->mortar->finish_derivatives();
      }
    friction.compress();
  }

  template class ContactAssembler<2>;
  template class ContactAssembler<3>;
} // namespace stickslip
