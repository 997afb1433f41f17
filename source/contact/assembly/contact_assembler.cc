#include <stickslip/contact/assembly/contact_assembler.h>

#include <stickslip/contact/point/tangent_stabilization.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace stickslip
{
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
        for (auto &point : pair->points)
          point.pairing = this->live.geometry ? pair->find_pairing(point)
                                              : pair->last_pairing(point);
      }
  }


  template <int dim>
  void
  ContactAssembler<dim>::accept_iterate()
  {
    if (!this->live.geometry)
      return;
    for_each_point(*this, [](ContactPair<dim> &pair, ContactPoint<dim> &point) {
      if (point.hysteresis.accept_iterate(point.pairing))
        point.pairing = pair.find_pairing(point);
    });
  }



  template <int dim>
  void
  ContactAssembler<dim>::accept_step()
  {
    for_each_point(*this,
                   [this](ContactPair<dim> &pair, ContactPoint<dim> &point) {
                     point.hysteresis.accept_step(point.pairing);
                     const auto &state = this->evaluate(pair, point);
                     if (state.status.closed)
                       point.accumulated_slip += state.kinematics.d_t;
                   });
  }



  template <int dim>
  void
  ContactAssembler<dim>::restore()
  {
    for_each_point(*this, [](ContactPair<dim> &pair, ContactPoint<dim> &point) {
      point.hysteresis.restore();
      point.pairing = pair.last_pairing(point);
    });
  }



  template <int dim>
  std::vector<types::global_dof_index>
  ContactAssembler<dim>::point_dofs(const ContactPair<dim>  &pair,
                                    const ContactPoint<dim> &point) const
  {
    const SlaveFace<dim> &slave = pair.slave_faces[point.geometry.slave_face];
    std::vector<types::global_dof_index> dofs = slave.face.dofs;
    if (point.pairing.paired)
      {
        const auto &master = pair.patch->face(point.pairing.face).dofs;
        dofs.insert(dofs.end(), master.begin(), master.end());
      }
    for (const auto dof : slave.multiplier_dofs)
      dofs.push_back(n_displacements + dof);
    return dofs;
  }



  template <int dim>
  void
  ContactAssembler<dim>::add_residual(const Constraints &geometric,
                                      LA::BlockVector   &residual,
                                      LA::Vector        &row_scale)
  {
    Vector<double> local;
    for (const auto &pair : pairs)
      for (auto &point : pair->points)
        {
          const ContactEvaluation<dim> &state = this->evaluate(*pair, point);
          point.observed                      = observe(point, state);
          const auto dofs                     = point_dofs(*pair, point);
          local.reinit(dofs.size());
          local_residual(this->element_of(*pair, point), state, local);
          geometric.distribute_local_to_global(local, dofs, residual);

          const SlaveFace<dim> &slave =
            pair->slave_faces[point.geometry.slave_face];
          const auto &L =
            pair->table.multiplier[point.geometry.quadrature_index];
          const unsigned int n_comp = pair->n_multiplier_components();
          const double       friction_scale =
            state.status.closed && state.response.threshold > 0.
                    ? state.response.threshold / point.regularization.r_t_law
                    : point.scales.open_row;
          for (unsigned int l = 0; l < L.size(); ++l)
            for (unsigned int c = 0; c < n_comp; ++c)
              row_scale(slave.multiplier_dofs[l * n_comp + c]) +=
                point.geometry.weight * std::abs(L[l]) *
                (c == 0 ? slave.face.diameter : friction_scale);
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
    for (const auto &pair : pairs)
      for (auto &point : pair->points)
        {
          ContactEvaluation<dim> &state =
            this->differentiate(*pair, point, linearize_geometry);
          point.observed = observe(point, state);
          assume_stick_before_first_pressure(point, state);
          const auto dofs = point_dofs(*pair, point);
          local.reinit(dofs.size());
          local_matrix.reinit(dofs.size(), dofs.size());
          const ContactElement<dim> element = this->element_of(*pair, point);
          local_residual(element, state, local);
          local *= -1.;
          local_tangent(element,
                        state,
                        this->live.geometry && linearize_geometry &&
                          pair->parameters.has_smoothed_normals(),
                        local_matrix);
          keep_undetermined_Lambda(element, state, local_matrix);
          constraints.distribute_local_to_global(
            local_matrix, local, dofs, matrix, rhs);
        }
  }

  template class ContactAssembler<2>;
  template class ContactAssembler<3>;
} // namespace stickslip
