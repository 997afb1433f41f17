#include <stickslip/contact/contact_assembler.h>

#include <deal.II/base/mpi.h>

namespace stickslip
{
  namespace
  {
    /// How a local unknown enters the generalized coordinates.
    using Column = std::vector<std::pair<unsigned int, double>>;



    template <int dim>
    std::vector<Column>
    make_columns(const ContactPair<dim>  &pair,
                 const ContactPoint<dim> &point,
                 const MasterPoint<dim>  &master,
                 const bool               with_nodal_normals)
    {
      using G       = GeneralizedCoordinates<dim>;
      const auto &N = pair.table.displacement[point.quadrature_index].value;
      const auto &L = pair.table.multiplier[point.quadrature_index];
      std::vector<Column> columns;
      for (unsigned int j = 0; j < N.size(); ++j)
        for (unsigned int c = 0; c < dim; ++c)
          if constexpr (dim == 3)
            columns.push_back(
              {{G::W + c, N[j]}, {G::E + c, point.direction_gradients[j]}});
          else
            columns.push_back({{G::W + c, N[j]}});
      if (point.frame.paired)
        {
          const SurfaceFace<dim> &face = pair.patch->face(point.frame.face);
          const unsigned int      first_master = columns.size();
          columns.resize(first_master + face.n_stencil_nodes() * dim);
          for (unsigned int j = 0; j < face.n_nodes; ++j)
            for (unsigned int c = 0; c < dim; ++c)
              {
                Column &column = columns[first_master + j * dim + c];
                column.emplace_back(G::W + c, -master.shape.value[j]);
                for (unsigned int d = 0; d < dim - 1; ++d)
                  column.emplace_back(G::C + d * dim + c,
                                      master.shape.gradient[j][d]);
              }
          std::vector<Tensor<2, dim>> D_n_j;
          if (with_nodal_normals)
            for (unsigned int j = 0; j < face.n_nodes; ++j)
              {
                nodal_normal_derivatives(
                  face, pair.patch->configuration(point.frame.face), j, D_n_j);
                for (unsigned int k = 0; k < D_n_j.size(); ++k)
                  for (unsigned int c = 0; c < dim; ++c)
                    for (unsigned int i = 0; i < dim; ++i)
                      if (D_n_j[k][i][c] != 0.)
                        columns[first_master + k * dim + c].emplace_back(
                          G::M + i, master.shape.value[j] * D_n_j[k][i][c]);
              }
        }
      const unsigned int n_comp = pair.n_multiplier_components();
      for (unsigned int l = 0; l < L.size(); ++l)
        {
          columns.push_back({{G::lambda, L[l]}});
          for (unsigned int b = 0; b + 1 < n_comp; ++b)
            {
              Column column;
              for (unsigned int a = 0; a < dim - 1; ++a)
                column.emplace_back(G::Lambda + a,
                                    L[l] * point.nodal_rotations[l][a][b]);
              columns.push_back(column);
            }
        }
      return columns;
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
                                   const LA::Vector &multiplier_values,
                                   const double      time)
  {
    lambda = multiplier_values;
    for (const auto &pair : pairs)
      {
        pair->update_configuration(u, u_old, time);
        if (live.geometry)
          for (auto &point : pair->points)
            point.frame = pair->find_frame(point);
      }
  }



  template <int dim>
  Multipliers<dim>
  ContactAssembler<dim>::multipliers_at(const ContactPair<dim>  &pair,
                                        const ContactPoint<dim> &point) const
  {
    const auto &L    = pair.table.multiplier[point.quadrature_index];
    const auto &dofs = pair.slave_faces[point.slave_face].multiplier_dofs;
    const unsigned int n_comp = pair.n_multiplier_components();
    Multipliers<dim>   values;
    for (unsigned int l = 0; l < L.size(); ++l)
      {
        values.lambda_n += L[l] * lambda(dofs[l * n_comp]);
        for (unsigned int b = 0; b + 1 < n_comp; ++b)
          for (unsigned int a = 0; a < dim - 1; ++a)
            values.Lambda[a] += L[l] * point.nodal_rotations[l][a][b] *
                                lambda(dofs[l * n_comp + 1 + b]);
      }
    return values;
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
    scratch.multipliers = multipliers_at(pair, point);
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
                                pair.parameters.normals == "smoothed",
                                live.geometry && linearize_geometry,
                                differentiate,
                                scratch.kinematics);
  }



  template <int dim>
  bool
  ContactAssembler<dim>::live_closed(const ContactPair<dim>  &pair,
                                     const ContactPoint<dim> &point)
  {
    if (!point.frame.paired)
      return false;
    evaluate_kinematics(pair, point, false, false);
    return is_closed(scratch.multipliers.lambda_n,
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
                    (live.status ? is_closed(scratch.multipliers.lambda_n,
                                             scratch.kinematics.d_n,
                                             point.regularization)
                                 : point.closed);
    if (result.closed && pair.parameters.has_friction())
      result.stick = is_stick(tangential_vector<dim>(scratch.multipliers.Lambda,
                                                     scratch.kinematics.tau),
                              scratch.kinematics.d_t,
                              point.regularization);
    return result;
  }



  template <int dim>
  double
  ContactAssembler<dim>::live_threshold(const ContactPair<dim>  &pair,
                                        const ContactPoint<dim> &point)
  {
    if (pair.parameters.friction != "Coulomb" || !point.frame.paired)
      return 0.;
    evaluate_kinematics(pair, point, false, false);
    const double pressure =
      scratch.multipliers.lambda_n -
      point.regularization.r_n_augmentation * scratch.kinematics.d_n;
    return std::max(0., -pair.parameters.friction_coefficient * pressure);
  }



  template <int dim>
  void
  ContactAssembler<dim>::accept_step()
  {
    for (const auto &pair : pairs)
      for (auto &point : pair->points)
        if (evaluate(*pair, point).status.closed)
          point.accumulated_slip += scratch.kinematics.d_t;
  }



  template <int dim>
  Threshold
  ContactAssembler<dim>::threshold_kind(const ContactPair<dim> &pair) const
  {
    if (!pair.parameters.has_friction())
      return Threshold::none;
    if (pair.parameters.friction == "Tresca" || !live.threshold)
      return Threshold::given;
    return pair.parameters.threshold_form == "plain" ? Threshold::plain
                                                     : Threshold::augmented;
  }



  template <int dim>
  double
  ContactAssembler<dim>::given_threshold(const ContactPair<dim>  &pair,
                                         const ContactPoint<dim> &point) const
  {
    return pair.parameters.friction == "Tresca"
             ? pair.parameters.tresca_threshold
             : point.threshold;
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
                         given_threshold(pair, point),
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
  ContactAssembler<dim>::local_residual(const ContactPair<dim>  &pair,
                                        const ContactPoint<dim> &point,
                                        Vector<double>          &local) const
  {
    const auto &N = pair.table.displacement[point.quadrature_index].value;
    const auto &L = pair.table.multiplier[point.quadrature_index];
    const auto &response = scratch.response;
    local                = 0.;
    for (unsigned int j = 0; j < N.size(); ++j)
      for (unsigned int c = 0; c < dim; ++c)
        local[j * dim + c] = point.weight * N[j] * response.traction[c];
    unsigned int first = N.size() * dim;
    if (point.frame.paired)
      {
        const SurfaceFace<dim> &face = pair.patch->face(point.frame.face);
        for (unsigned int j = 0; j < face.n_nodes; ++j)
          for (unsigned int c = 0; c < dim; ++c)
            local[first + j * dim + c] = -point.weight *
                                         scratch.master.shape.value[j] *
                                         response.traction[c];
        first += face.n_stencil_nodes() * dim;
      }
    const unsigned int n_comp = pair.n_multiplier_components();
    for (unsigned int l = 0; l < L.size(); ++l)
      {
        local[first + l * n_comp] = point.weight * L[l] * response.row_lambda;
        for (unsigned int b = 0; b + 1 < n_comp; ++b)
          for (unsigned int a = 0; a < dim - 1; ++a)
            local[first + l * n_comp + 1 + b] +=
              point.weight * L[l] * point.nodal_rotations[l][a][b] *
              response.row_Lambda[a];
      }
  }



  template <int dim>
  void
  ContactAssembler<dim>::local_tangent(const ContactPair<dim>  &pair,
                                       const ContactPoint<dim> &point,
                                       FullMatrix<double>      &local) const
  {
    const auto &N = pair.table.displacement[point.quadrature_index].value;
    const auto &L = pair.table.multiplier[point.quadrature_index];
    const auto &response      = scratch.response;
    const unsigned int n_comp = pair.n_multiplier_components();
    const auto         columns =
      make_columns(pair,
                   point,
                   scratch.master,
                   live.geometry && pair.parameters.normals == "smoothed");
    for (unsigned int k = 0; k < columns.size(); ++k)
      {
        Tensor<1, dim>     D_t;
        Tensor<1, dim - 1> D_xi, D_row_Lambda;
        double             D_row_lambda = 0.;
        for (const auto &[g, coefficient] : columns[k])
          {
            for (unsigned int i = 0; i < dim; ++i)
              D_t[i] += coefficient * response.D_traction[i][g];
            D_row_lambda += coefficient * response.D_row_lambda[g];
            for (unsigned int d = 0; d < dim - 1; ++d)
              {
                D_xi[d] += coefficient * scratch.kinematics.D_xi[d][g];
                D_row_Lambda[d] += coefficient * response.D_row_Lambda[d][g];
              }
          }
        for (unsigned int j = 0; j < N.size(); ++j)
          for (unsigned int c = 0; c < dim; ++c)
            local(j * dim + c, k) = point.weight * N[j] * D_t[c];
        unsigned int first = N.size() * dim;
        if (point.frame.paired)
          {
            // -M_j D t, and t . D(dw) = -t . M_j,alpha D xi^alpha
            const SurfaceFace<dim> &face = pair.patch->face(point.frame.face);
            const auto             &master_shape = scratch.master.shape;
            for (unsigned int j = 0; j < face.n_nodes; ++j)
              for (unsigned int c = 0; c < dim; ++c)
                local(first + j * dim + c, k) =
                  -point.weight *
                  (master_shape.value[j] * D_t[c] +
                   response.traction[c] * (master_shape.gradient[j] * D_xi));
            first += face.n_stencil_nodes() * dim;
          }
        for (unsigned int l = 0; l < L.size(); ++l)
          {
            local(first + l * n_comp, k) = point.weight * L[l] * D_row_lambda;
            for (unsigned int b = 0; b + 1 < n_comp; ++b)
              for (unsigned int a = 0; a < dim - 1; ++a)
                local(first + l * n_comp + 1 + b, k) +=
                  point.weight * L[l] * point.nodal_rotations[l][a][b] *
                  D_row_Lambda[a];
          }
      }
  }



  template <int dim>
  void
  ContactAssembler<dim>::add_residual(const Constraints &geometric,
                                      LA::BlockVector   &residual,
                                      LA::Vector        &row_scale)
  {
    Vector<double> local;
    for (const auto &pair : pairs)
      for (const auto &point : pair->points)
        {
          evaluate_point(*pair, point, false, false);
          const auto dofs = point_dofs(*pair, point);
          local.reinit(dofs.size());
          local_residual(*pair, point, local);
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
      for (const auto &point : pair->points)
        {
          evaluate_point(*pair, point, linearize_geometry, true);
          const auto dofs = point_dofs(*pair, point);
          local.reinit(dofs.size());
          local_matrix.reinit(dofs.size(), dofs.size());
          local_residual(*pair, point, local);
          local *= -1.;
          local_tangent(*pair, point, local_matrix);
          constraints.distribute_local_to_global(
            local_matrix, local, dofs, matrix, rhs);
        }
  }

  template class ContactAssembler<2>;
  template class ContactAssembler<3>;
} // namespace stickslip
