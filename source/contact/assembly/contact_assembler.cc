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
    lambda = multiplier_values;
    for (const auto &pair : pairs)
      {
        pair->update_configuration(u, u_old);
        if (live.geometry)
          for (auto &point : pair->points)
            point.set_frame(pair->find_frame(point));
      }
  }


  template <int dim>
  ContactElement<dim>
  ContactAssembler<dim>::element_of(const ContactPair<dim>  &pair,
                                    const ContactPoint<dim> &point) const
  {
    const unsigned int  q = point.quadrature_index;
    ContactElement<dim> element{point,
                                pair.table.displacement[q].value,
                                pair.table.multiplier[q],
                                pair.n_multiplier_components()};
    if (point.frame.paired)
      {
        element.master = &pair.patch->face(point.frame.face);
        element.master_configuration =
          &pair.patch->configuration(point.frame.face);
      }
    return element;
  }



  template <int dim>
  Multipliers<dim>
  ContactAssembler<dim>::multipliers_at(const ContactPair<dim>  &pair,
                                        const ContactPoint<dim> &point,
                                        const LA::Vector        &values) const
  {
    std::vector<double> nodal_values;
    for (const auto dof : pair.slave_faces[point.slave_face].multiplier_dofs)
      nodal_values.push_back(values(dof));
    return interpolate_multipliers(element_of(pair, point), nodal_values);
  }



  template <int dim>
  double
  ContactAssembler<dim>::lambda_n_at_node(const ContactPair<dim> &pair,
                                          const unsigned int      slave_face,
                                          const unsigned int      j) const
  {
    std::vector<double> L;
    pair.multiplier_shape.evaluate_values(pair.displacement_shape.node(j), L);
    const auto        &dofs   = pair.slave_faces[slave_face].multiplier_dofs;
    const unsigned int n_comp = pair.n_multiplier_components();
    double             value  = 0.;
    for (unsigned int l = 0; l < L.size(); ++l)
      value += L[l] * lambda(dofs[l * n_comp]);
    return value;
  }



  template <int dim>
  void
  ContactAssembler<dim>::evaluate_kinematics(const ContactPair<dim>  &pair,
                                             const ContactPoint<dim> &point,
                                             const bool linearize_geometry,
                                             const bool differentiate)
  {
    scratch.multipliers             = multipliers_at(pair, point, lambda);
    scratch.multipliers.kept_Lambda = point.kept_Lambda;
    if (!point.frame.paired)
      {
        scratch.kinematics = ContactKinematics<dim>();
        return;
      }
    const unsigned int f = point.frame.face;
    evaluate_master_point(pair.patch->face(f),
                          pair.patch->configuration(f),
                          pair.patch->face_shape(),
                          point.frame.xi,
                          scratch.master);
    evaluate_master_point(pair.patch->face(f),
                          pair.patch->old_configuration(f),
                          pair.patch->face_shape(),
                          point.frame.xi,
                          old_master);
    evaluate_contact_kinematics(point.frame,
                                scratch.master,
                                old_master,
                                pair.slave_position(point),
                                pair.parameters.has_smoothed_normals(),
                                live.geometry && linearize_geometry,
                                differentiate,
                                scratch.kinematics);
    hold_slip(point.held_directions, differentiate, scratch.kinematics);
  }



  template <int dim>
  bool
  ContactAssembler<dim>::live_closed(const ContactPair<dim>  &pair,
                                     const ContactPoint<dim> &point)
  {
    evaluate_kinematics(pair, point, false, false);
    return point.frame.paired && is_closed(scratch.multipliers.lambda_n,
                                           scratch.kinematics.d_n,
                                           point.regularization);
  }



  template <int dim>
  ContactStatus
  ContactAssembler<dim>::present_status(const ContactPair<dim>  &pair,
                                        const ContactPoint<dim> &point) const
  {
    ContactStatus result;
    result.closed = point.frame.paired &&
                    point.cure.held_closed.value_or(
                      live.status ? is_closed(scratch.multipliers.lambda_n,
                                              scratch.kinematics.d_n,
                                              point.regularization)
                                  : point.closed);
    if (result.closed && pair.parameters.has_friction())
      result.stick = point.cure.held_stick.value_or(
        is_stick(tangential_vector<dim>(scratch.multipliers.Lambda,
                                        scratch.kinematics.tau),
                 scratch.kinematics.d_t,
                 point.regularization));
    return result;
  }



  template <int dim>
  double
  ContactAssembler<dim>::live_threshold(const ContactPair<dim>  &pair,
                                        const ContactPoint<dim> &point)
  {
    if (pair.parameters.friction != Friction::Coulomb || !point.frame.paired)
      return 0.;
    evaluate_kinematics(pair, point, false, false);
    // A frozen status may still be wrong, and its gap r_n times too large.
    const bool is_exact =
      !live.status && pair.parameters.is_independent_of_regularization();
    const double r = is_exact ? 0. : point.regularization.r_n_augmentation;
    const double pressure =
      scratch.multipliers.lambda_n - r * scratch.kinematics.d_n;
    return std::max(0., -pair.parameters.friction_coefficient * pressure);
  }



  template <int dim>
  void
  ContactAssembler<dim>::accept_step()
  {
    for (const auto &pair : pairs)
      for (auto &point : pair->points)
        {
          point.accept_frame();
          if (evaluate(*pair, point).status.closed)
            point.accumulated_slip += scratch.kinematics.d_t;
        }
  }



  template <int dim>
  void
  ContactAssembler<dim>::restore()
  {
    for (const auto &pair : pairs)
      for (auto &point : pair->points)
        point.restore_frame();
  }



  template <int dim>
  Threshold
  ContactAssembler<dim>::threshold_kind(const ContactPair<dim> &pair) const
  {
    if (!pair.parameters.has_friction())
      return Threshold::none;
    if (pair.parameters.friction == Friction::Tresca || !live.threshold)
      return Threshold::given;
    return pair.parameters.threshold_form == ThresholdForm::plain
             ? Threshold::plain
             : Threshold::augmented;
  }



  template <int dim>
  const ContactEvaluation<dim> &
  ContactAssembler<dim>::evaluate(const ContactPair<dim>  &pair,
                                  const ContactPoint<dim> &point)
  {
    evaluate_point(pair, point, false, false);
    return scratch;
  }



  template <int dim>
  void
  ContactAssembler<dim>::evaluate_point(const ContactPair<dim>  &pair,
                                        const ContactPoint<dim> &point,
                                        const bool linearize_geometry,
                                        const bool differentiate)
  {
    evaluate_kinematics(pair, point, linearize_geometry, differentiate);
    scratch.status = present_status(pair, point);
    evaluate_contact_law(scratch.kinematics,
                         scratch.multipliers,
                         scratch.status,
                         threshold_kind(pair),
                         pair.parameters.friction_coefficient,
                         pair.parameters.friction == Friction::Tresca
                           ? pair.parameters.tresca_threshold
                           : point.threshold,
                         point.regularization,
                         differentiate,
                         scratch.response);
  }



  template <int dim>
  std::vector<types::global_dof_index>
  ContactAssembler<dim>::point_dofs(const ContactPair<dim>  &pair,
                                    const ContactPoint<dim> &point) const
  {
    const SlaveFace<dim> &slave = pair.slave_faces[point.slave_face];
    std::vector<types::global_dof_index> dofs = slave.face.dofs;
    if (point.frame.paired)
      {
        const auto &master = pair.patch->face(point.frame.face).dofs;
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
          evaluate_point(*pair, point, false, false);
          point.observed  = observe(point, scratch);
          const auto dofs = point_dofs(*pair, point);
          local.reinit(dofs.size());
          local_residual(element_of(*pair, point), scratch, local);
          geometric.distribute_local_to_global(local, dofs, residual);

          const SlaveFace<dim> &slave = pair->slave_faces[point.slave_face];
          const auto        &L = pair->table.multiplier[point.quadrature_index];
          const unsigned int n_comp = pair->n_multiplier_components();
          const auto        &r      = point.regularization;
          const double       friction_scale =
            scratch.status.closed && scratch.response.threshold > 0.
                    ? scratch.response.threshold / r.r_t_law
                    : r.open_scale;
          for (unsigned int l = 0; l < L.size(); ++l)
            for (unsigned int c = 0; c < n_comp; ++c)
              row_scale(slave.multiplier_dofs[l * n_comp + c]) +=
                point.weight * std::abs(L[l]) *
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
          evaluate_point(*pair, point, linearize_geometry, true);
          point.observed = observe(point, scratch);
          assume_stick_before_first_pressure(point, scratch);
          const auto dofs = point_dofs(*pair, point);
          local.reinit(dofs.size());
          local_matrix.reinit(dofs.size(), dofs.size());
          const ContactElement<dim> element = element_of(*pair, point);
          local_residual(element, scratch, local);
          local *= -1.;
          local_tangent(element,
                        scratch,
                        live.geometry && linearize_geometry &&
                          pair->parameters.has_smoothed_normals(),
                        local_matrix);
          keep_undetermined_Lambda(element, scratch, local_matrix);
          constraints.distribute_local_to_global(
            local_matrix, local, dofs, matrix, rhs);
        }
  }

  template class ContactAssembler<2>;
  template class ContactAssembler<3>;
} // namespace stickslip
