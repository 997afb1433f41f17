#include <stickslip/base/user_error.h>

#include <stickslip/contact/contact_pair.h>
#include <stickslip/contact/contact_quadrature.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <map>

namespace stickslip
{
  namespace
  {
    std::string
    path_of(const std::string &pair_name)
    {
      return "Contact/" + pair_name;
    }



    /// "x,y; x,y" -> points. Throws UserError.
    template <int dim>
    std::vector<Point<dim>>
    parse_points(const std::string &text, const std::string &path)
    {
      std::vector<Point<dim>> points;
      for (const std::string &item : Utilities::split_string_list(text, ';'))
        {
          const auto numbers = Utilities::split_string_list(item, ',');
          try
            {
              AssertThrow(numbers.size() == dim, ExcInternalError());
              Point<dim> point;
              for (unsigned int c = 0; c < dim; ++c)
                point[c] = Utilities::string_to_double(numbers[c]);
              points.push_back(point);
            }
          catch (const std::exception &)
            {
              throw UserError("'" + path + "' has '" + item + "': expected " +
                              std::to_string(dim) +
                              " numbers separated by commas, points separated "
                              "by semicolons.");
            }
        }
      return points;
    }



    /// Turns @p v, orthogonal to the unit vector a, so that it is orthogonal to
    /// the unit vector b, by the smallest rotation.
    template <int dim>
    Tensor<1, dim>
    turn(const Tensor<1, dim> &v,
         const Tensor<1, dim> &a,
         const Tensor<1, dim> &b)
    {
      return v - (b * v) / (1. + a * b) * (a + b);
    }



    /// A tangent of the plane normal to n, chosen by a rule that does not
    /// depend on facets or ranks.
    Tensor<1, 3>
    reference_tangent(const Tensor<1, 3> &n)
    {
      Tensor<1, 3> axis;
      axis[std::abs(n[0]) < 0.6 ? 0 : 1] = 1.;
      const Tensor<1, 3> t               = axis - (axis * n) * n;
      return t / t.norm();
    }
  } // namespace



  template <int dim>
  ContactPair<dim>::ContactPair(
    const std::string                                     &name,
    const ContactPairParameters                           &parameters,
    const std::set<types::boundary_id>                    &slave_boundary,
    const std::set<types::boundary_id>                    &master_boundary,
    const std::set<types::boundary_id>                    &excluded_boundary,
    const Mapping<dim>                                    &mapping,
    const DoFHandler<dim>                                 &dof_handler,
    const std::function<double(const types::material_id)> &modulus,
    const MPI_Comm                                        &communicator)
    : parameters(parameters)
    , name(name)
    , displacement_shape(dof_handler.get_fe().degree)
    , multiplier_shape(parameters.multiplier_space == "vertices"
                         ? 1
                         : dof_handler.get_fe().degree)
    , gap_offset(parameters.gap_offset, 1, path_of(name) + "/Gap offset")
    , communicator(communicator)
  {
    for (const auto id : slave_boundary)
      if (master_boundary.count(id) > 0)
        throw UserError("'" + path_of(name) +
                        "': the slave and the master set share a boundary of "
                        "body '" +
                        parameters.slave_body +
                        "'. A surface cannot be both in one pair.");

    const auto slaves =
      collect_faces(mapping, dof_handler, slave_boundary, modulus, true);
    auto masters =
      collect_faces(mapping, dof_handler, master_boundary, modulus, true);
    if (parameters.normals == "smoothed")
      add_nodal_normals(masters,
                        displacement_shape,
                        parameters.smoothing_angle * numbers::PI / 180.);
    std::vector<SurfaceFace<dim>> owned_masters;
    for (const auto &master : masters)
      if (master.cell->is_locally_owned())
        owned_masters.push_back(master.face);

    for (const auto &slave : slaves)
      if (slave.cell->is_locally_owned())
        {
          slave_faces.push_back({slave.face, {}});
          largest_slave_diameter =
            std::max(largest_slave_diameter, slave.face.diameter);
        }
    largest_slave_diameter =
      Utilities::MPI::max(largest_slave_diameter, communicator);
    margin = 0.5 * largest_slave_diameter;
    patch  = std::make_unique<MasterPatch<dim>>(owned_masters,
                                               displacement_shape,
                                               parameters.search_distance > 0.
                                                  ? parameters.search_distance
                                                  : 4. * largest_slave_diameter,
                                               parameters.projection_tolerance,
                                               parameters.facet_overlap,
                                               communicator);

    exclude_nodes(excluded_boundary, mapping, dof_handler);
    make_points(contact_quadrature<dim - 1>(parameters.quadrature,
                                            parameters.quadrature_order,
                                            multiplier_shape.degree(),
                                            path_of(name)),
                slaves);
    positions.resize(slave_faces.size());
    old_positions.resize(slave_faces.size());
  }



  template <int dim>
  unsigned int
  ContactPair<dim>::n_multiplier_components() const
  {
    return parameters.has_friction() ? dim : 1;
  }



  template <int dim>
  std::vector<types::global_dof_index>
  ContactPair<dim>::multiplier_keys() const
  {
    std::vector<types::global_dof_index> keys;
    const unsigned int                   n      = displacement_shape.degree();
    const unsigned int                   stride = n / multiplier_shape.degree();
    for (const auto &slave : slave_faces)
      for (unsigned int j = 0; j < slave.face.n_nodes; ++j)
        if ((j % (n + 1)) % stride == 0 && (j / (n + 1)) % stride == 0)
          keys.push_back(slave.face.dofs[j * dim]);
    return keys;
  }



  template <int dim>
  void
  ContactPair<dim>::set_multiplier_dofs(const MultiplierNumbering &numbering,
                                        const unsigned int         pair_index)
  {
    const auto         keys   = multiplier_keys();
    const unsigned int n      = multiplier_shape.n_nodes();
    const unsigned int n_comp = n_multiplier_components();
    for (unsigned int f = 0; f < slave_faces.size(); ++f)
      for (unsigned int j = 0; j < n; ++j)
        {
          const auto first = numbering.first_dof(pair_index, keys[f * n + j]);
          for (unsigned int c = 0; c < n_comp; ++c)
            slave_faces[f].multiplier_dofs.push_back(first + c);
        }
  }



  template <int dim>
  void
  ContactPair<dim>::exclude_nodes(const std::set<types::boundary_id> &boundary,
                                  const Mapping<dim>                 &mapping,
                                  const DoFHandler<dim> &dof_handler)
  {
    const auto no_modulus = [](const types::material_id) { return 1.; };
    for (const auto &entry :
         collect_faces<dim>(mapping, dof_handler, boundary, no_modulus, true))
      for (unsigned int j = 0; j < entry.face.n_nodes; ++j)
        excluded.insert(entry.face.dofs[j * dim]);

    const auto points = parse_points<dim>(parameters.excluded_points,
                                          path_of(name) + "/Excluded points");
    for (const Point<dim> &point : points)
      {
        unsigned int found = 0;
        for (const auto &slave : slave_faces)
          for (unsigned int j = 0; j < slave.face.n_nodes; ++j)
            if (slave.face.reference_positions[j].distance(point) <
                1e-6 * slave.face.diameter)
              {
                excluded.insert(slave.face.dofs[j * dim]);
                ++found;
              }
        if (Utilities::MPI::sum(found, communicator) == 0)
          throw UserError("'" + path_of(name) +
                          "/Excluded points': no slave node lies at one of the "
                          "points '" +
                          parameters.excluded_points + "'.");
      }
  }



  template <int dim>
  void
  ContactPair<dim>::make_points(const Quadrature<dim - 1> &quadrature,
                                const std::vector<CollectedFace<dim>> &faces)
  {
    table.displacement.resize(quadrature.size());
    table.multiplier.resize(quadrature.size());
    for (unsigned int q = 0; q < quadrature.size(); ++q)
      {
        displacement_shape.evaluate(quadrature.point(q), table.displacement[q]);
        multiplier_shape.evaluate_values(quadrature.point(q),
                                         table.multiplier[q]);
      }

    // averaged reference normals of the slave nodes: they carry the frames of
    // the nodal Lambda, so all ranks must agree on them
    std::map<types::global_dof_index, Tensor<1, dim>> nodal_normals;
    FaceShapeValues<dim>                              at_node;
    std::vector<Tensor<1, dim>>                       nodes;
    for (const auto &entry : faces)
      for (unsigned int j = 0; j < entry.face.n_nodes; ++j)
        {
          displacement_shape.evaluate(displacement_shape.node(j), at_node);
          std::array<Tensor<1, dim>, dim - 1> a;
          for (unsigned int l = 0; l < entry.face.n_nodes; ++l)
            for (unsigned int d = 0; d < dim - 1; ++d)
              a[d] += at_node.gradient[l][d] *
                      Tensor<1, dim>(entry.face.reference_positions[l]);
          const Tensor<1, dim> v =
            -entry.face.orientation * surface_normal<dim>(a);
          nodal_normals[entry.face.dofs[j * dim]] += v / v.norm();
        }
    for (auto &[key, normal] : nodal_normals)
      normal /= normal.norm();

    const auto keys = multiplier_keys();
    for (unsigned int f = 0; f < slave_faces.size(); ++f)
      for (unsigned int q = 0; q < quadrature.size(); ++q)
        {
          bool carries_multiplier = false;
          for (unsigned int l = 0; l < multiplier_shape.n_nodes(); ++l)
            carries_multiplier =
              carries_multiplier ||
              (std::abs(table.multiplier[q][l]) > 1e-12 &&
               excluded.count(keys[f * multiplier_shape.n_nodes() + l]) == 0);
          if (!carries_multiplier)
            continue;
          ContactPoint<dim> point;
          point.slave_face       = f;
          point.quadrature_index = q;
          const auto &shape      = table.displacement[q];
          nodes.clear();
          for (unsigned int j = 0; j < slave_faces[f].face.n_nodes; ++j)
            nodes.emplace_back(slave_faces[f].face.reference_positions[j]);
          for (unsigned int j = 0; j < nodes.size(); ++j)
            point.reference_position += shape.value[j] * nodes[j];
          point.weight = quadrature.weight(q) *
                         surface_normal<dim>(slave_tangents(nodes, q)).norm();
          set_reference_frames(point, nodal_normals);
          points.push_back(point);
        }
  }



  template <int dim>
  void
  ContactPair<dim>::set_reference_frames(
    ContactPoint<dim>                                       &point,
    const std::map<types::global_dof_index, Tensor<1, dim>> &nodal_normals)
  {
    const unsigned int      n_multipliers = multiplier_shape.n_nodes();
    const SurfaceFace<dim> &face          = slave_faces[point.slave_face].face;
    point.direction_gradients.assign(face.n_nodes, 0.);
    Tensor<2, dim - 1> identity;
    for (unsigned int d = 0; d < dim - 1; ++d)
      identity[d][d] = 1.;
    point.nodal_rotations.assign(n_multipliers, identity);
    if constexpr (dim == 3)
      {
        std::vector<Tensor<1, dim>> nodes;
        for (unsigned int j = 0; j < face.n_nodes; ++j)
          nodes.emplace_back(face.reference_positions[j]);
        const auto   A = slave_tangents(nodes, point.quadrature_index);
        Tensor<1, 3> N = -face.orientation * surface_normal<dim>(A);
        N /= N.norm();
        const Tensor<1, 3> e_1 = reference_tangent(N);
        const Tensor<1, 3> e_2 = cross_product_3d(N, e_1);

        // e_1 = c^alpha A_alpha, so d/de_1 = c^alpha d/dxi_alpha
        Tensor<2, 2> metric;
        for (unsigned int d = 0; d < 2; ++d)
          for (unsigned int e = 0; e < 2; ++e)
            metric[d][e] = A[d] * A[e];
        const Tensor<1, 2> c =
          invert(metric) * Tensor<1, 2>({A[0] * e_1, A[1] * e_1});
        const auto &gradient =
          table.displacement[point.quadrature_index].gradient;
        for (unsigned int j = 0; j < face.n_nodes; ++j)
          point.direction_gradients[j] = c * gradient[j];

        const unsigned int n      = displacement_shape.degree() + 1;
        const unsigned int stride = (n - 1) / multiplier_shape.degree();
        const unsigned int m      = multiplier_shape.degree() + 1;
        for (unsigned int l = 0; l < n_multipliers; ++l)
          {
            const unsigned int j   = (l % m) * stride + (l / m) * stride * n;
            const Tensor<1, 3> N_l = nodal_normals.at(face.dofs[j * dim]);
            const Tensor<1, 3> T_1 = reference_tangent(N_l);
            const Tensor<1, 3> T_2 = cross_product_3d(N_l, T_1);
            const Tensor<1, 3> t_1 = turn(T_1, N_l, N);
            const Tensor<1, 3> t_2 = turn(T_2, N_l, N);
            point.nodal_rotations[l][0][0] = e_1 * t_1;
            point.nodal_rotations[l][0][1] = e_1 * t_2;
            point.nodal_rotations[l][1][0] = e_2 * t_1;
            point.nodal_rotations[l][1][1] = e_2 * t_2;
          }
      }
    else
      (void)nodal_normals;
  }



  template <int dim>
  std::array<Tensor<1, dim>, dim - 1>
  ContactPair<dim>::slave_tangents(
    const std::vector<Tensor<1, dim>> &node_positions,
    const unsigned int                 quadrature_index) const
  {
    std::array<Tensor<1, dim>, dim - 1> a;
    const auto &gradient = table.displacement[quadrature_index].gradient;
    for (unsigned int j = 0; j < node_positions.size(); ++j)
      for (unsigned int d = 0; d < dim - 1; ++d)
        a[d] += gradient[j][d] * node_positions[j];
    return a;
  }



  template <int dim>
  bool
  ContactPair<dim>::update_patch(const LA::Vector &u, const bool force)
  {
    const auto read_all = [&u](const auto &faces, auto &all_positions) {
      all_positions.resize(faces.size());
      for (unsigned int f = 0; f < faces.size(); ++f)
        read_positions(faces[f], faces[f].n_nodes, u, all_positions[f]);
    };
    std::vector<SurfaceFace<dim>> slaves;
    for (const auto &slave : slave_faces)
      slaves.push_back(slave.face);
    std::vector<std::vector<Tensor<1, dim>>> slave_now, master_now;
    read_all(slaves, slave_now);
    read_all(patch->owned_faces(), master_now);

    double     motion  = force ? 2. * margin : 0.;
    const auto compare = [&motion](const auto &now, const auto &before) {
      for (unsigned int f = 0; f < before.size(); ++f)
        for (unsigned int j = 0; j < before[f].size(); ++j)
          motion = std::max(motion, (now[f][j] - before[f][j]).norm());
    };
    compare(slave_now, positions_at_fetch);
    compare(master_now, master_positions_at_fetch);
    if (Utilities::MPI::max(motion, communicator) <= 0.5 * margin)
      return false;

    std::vector<BoundingBox<dim>> boxes;
    for (const auto &face_nodes : slave_now)
      {
        const std::vector<Point<dim>> corners(face_nodes.begin(),
                                              face_nodes.end());
        boxes.emplace_back(corners);
      }
    patch->fetch(boxes, u, margin);
    for (auto &point : points)
      patch->relocate(point.frame);
    positions_at_fetch        = slave_now;
    master_positions_at_fetch = master_now;
    return true;
  }



  template <int dim>
  void
  ContactPair<dim>::update_configuration(const LA::Vector &u,
                                         const LA::Vector &u_old,
                                         const double      time)
  {
    for (auto &point : points)
      point.gap_offset =
        gap_offset.value(Point<dim>(point.reference_position), time);
    for (unsigned int f = 0; f < slave_faces.size(); ++f)
      {
        const SurfaceFace<dim> &face = slave_faces[f].face;
        read_positions(face, face.n_nodes, u, positions[f]);
        read_positions(face, face.n_nodes, u_old, old_positions[f]);
      }
    patch->update(u, u_old);
  }



  template <int dim>
  ContactFrame<dim>
  ContactPair<dim>::find_frame(const ContactPoint<dim> &point) const
  {
    const auto    &nodes = positions[point.slave_face];
    Tensor<1, dim> outward =
      -slave_faces[point.slave_face].face.orientation *
      surface_normal<dim>(slave_tangents(nodes, point.quadrature_index));
    outward /= outward.norm();
    const SlavePosition<dim> slave = slave_position(point);
    ContactFrame<dim>        frame = patch->find(slave.x, outward, point.frame);
    if (frame.paired)
      frame.tau = tangent_basis<dim>(frame.n, slave.direction);
    return frame;
  }



  template <int dim>
  SlavePosition<dim>
  ContactPair<dim>::slave_position(const ContactPoint<dim> &point) const
  {
    SlavePosition<dim> slave;
    const auto        &value = table.displacement[point.quadrature_index].value;
    const auto        &now   = positions[point.slave_face];
    const auto        &old   = old_positions[point.slave_face];
    for (unsigned int j = 0; j < now.size(); ++j)
      {
        slave.x += value[j] * now[j];
        slave.x_old += value[j] * old[j];
        slave.direction += point.direction_gradients[j] * now[j];
      }
    slave.gap_offset = point.gap_offset;
    return slave;
  }



  template <int dim>
  double
  ContactPair<dim>::area_ratio(const ContactPoint<dim> &point) const
  {
    const auto &reference =
      slave_faces[point.slave_face].face.reference_positions;
    std::vector<Tensor<1, dim>> nodes(reference.begin(), reference.end());
    const unsigned int          q = point.quadrature_index;
    return surface_normal<dim>(slave_tangents(positions[point.slave_face], q))
             .norm() /
           surface_normal<dim>(slave_tangents(nodes, q)).norm();
  }

  template class ContactPair<2>;
  template class ContactPair<3>;
} // namespace stickslip
