#include <stickslip/solid/rigid_coupling.h>

#include <stickslip/base/user_error.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace stickslip
{
  namespace
  {
    /// Distances between nodes and where a rigid body would have them, relative
    /// to the largest displacement, that are roundoff.
    constexpr double roundoff_of_displacements = 1e-12;

    /// Masters stay while they are this independent, relative to the best.
    constexpr double good_independence = 0.3;

    /// Of a displacement or a rotation, for central differences.
    constexpr double difference_step = 1e-5;

    /// In place of a weight that is zero: AffineConstraints forgets those, and
    /// the sparsity would lack what a rotation makes of them.
    constexpr double no_weight = 1e-200;



    /// In 2D the component along z.
    template <int n_rotations>
    Tensor<1, n_rotations>
    rotational(const Tensor<1, 3> &v)
    {
      Tensor<1, n_rotations> result;
      for (unsigned int k = 0; k < n_rotations; ++k)
        result[k] = v[n_rotations == 1 ? 2 : k];
      return result;
    }



  } // namespace



  template <int dim>
  RigidCoupling<dim>::RigidCoupling(
    const PrescribedDisplacement<dim> &condition,
    const std::vector<HeldNode<dim>>  &held_nodes,
    const Constraints                 &geometric,
    const MPI_Comm                     communicator)
    : prescribed(condition)
    , communicator(communicator)
  {
    const RigidMotion<dim> &motion = prescribed.motion;
    for (unsigned int c = 0; c < motion.n_components; ++c)
      if (motion.is_free(c))
        free_components.push_back(c);
    std::vector<MasterCandidate<dim>> may_be_masters;
    for (const HeldNode<dim> &node : held_nodes)
      {
        nodes.push_back({node.dofs, node.position - motion.reference_point()});
        if (node.rows.empty() && !geometric.is_constrained(node.dofs[0]))
          may_be_masters.push_back({node.dofs, nodes.back().arm});
      }
    closest = ClosestRigidState<dim>(nodes, communicator);
    if (motion.has_free_rotation() && !closest.determines_rotation())
      throw UserError("Boundary conditions/" + prescribed.name +
                      "/Rotation angle is 'free', but its nodes do not "
                      "determine a rotation: they are " +
                      (dim == 2 ? "at a point." : "on a line."));
    candidates = outermost_nodes(may_be_masters, communicator);
  }



  template <int dim>
  RigidState<dim>
  RigidCoupling<dim>::state_of(const double time, const LA::Vector &u) const
  {
    if (prescribed.motion.has_free_rotation())
      return closest.state_of(u, nodes, nullptr);
    RigidState<dim> state;
    prescribed.motion.prescribe(time, state);
    return closest.state_of(u, nodes, &state.rotation);
  }



  template <int dim>
  Tensor<1, dim>
  RigidCoupling<dim>::motion_of_arm(const unsigned int    component,
                                    const Tensor<1, dim> &arm) const
  {
    Tensor<1, dim> result;
    if (component < dim)
      {
        result[component] = 1.;
        return result;
      }
    const Tensor<1, 3> moved =
      cross_product_3d(prescribed.motion.spin(component, target),
                       target.current_arm(arm));
    for (unsigned int d = 0; d < dim; ++d)
      result[d] = moved[d];
    return result;
  }



  template <int dim>
  FullMatrix<double>
  RigidCoupling<dim>::map_of_candidates(const double length) const
  {
    FullMatrix<double> map(candidates.size() * dim, free_components.size());
    for (unsigned int i = 0; i < candidates.size(); ++i)
      for (unsigned int k = 0; k < free_components.size(); ++k)
        {
          const unsigned int   c = free_components[k];
          const Tensor<1, dim> u = motion_of_arm(c, candidates[i].arm);
          for (unsigned int d = 0; d < dim; ++d)
            map(i * dim + d, k) = c < dim ? u[d] : u[d] / length;
        }
    return map;
  }



  template <int dim>
  bool
  RigidCoupling<dim>::update(const double      time,
                             const LA::Vector &u,
                             const bool        may_change_masters)
  {
    target = state_of(time, u);
    prescribed.motion.prescribe(time, target);
    prescribed.motion.check_forces(time);

    // one node may be at the point
    const double length = closest.length() > 0. ? closest.length() : 1.;
    const FullMatrix<double> map    = map_of_candidates(length);
    bool                     is_new = false;
    if (master_rows.empty() || may_change_masters)
      {
        const auto best = independent_rows(map);
        if (best.size() < free_components.size())
          throw UserError("Boundary conditions/" + prescribed.name +
                          ": its nodes do not determine the components that "
                          "are 'free'.");
        if (independence_of(master_rows, map) <
            good_independence * independence_of(best, map))
          {
            master_rows = best;
            is_new      = true;
          }
      }
    const unsigned int n = free_components.size();
    master_dofs.clear();
    FullMatrix<double> of_masters(n, n);
    for (unsigned int i = 0; i < n; ++i)
      {
        const unsigned int row = master_rows[i];
        master_dofs.push_back(candidates[row / dim].dofs[row % dim]);
        for (unsigned int k = 0; k < n; ++k)
          of_masters(i, k) =
            map(row, k) * (free_components[k] < dim ? 1. : length);
      }
    inverse_map.reinit(n, n);
    inverse_map.invert(of_masters);
    return is_new;
  }



  template <int dim>
  Vector<double>
  RigidCoupling<dim>::missing_at_masters(const LA::Vector &u) const
  {
    Vector<double> missing(master_dofs.size());
    for (unsigned int i = 0; i < master_dofs.size(); ++i)
      if (u.in_local_range(master_dofs[i]))
        missing(i) =
          target.displacement(
            candidates[master_rows[i] / dim].arm)[master_rows[i] % dim] -
          u(master_dofs[i]);
    Utilities::MPI::sum(missing, communicator, missing);
    return missing;
  }



  template <int dim>
  std::vector<ConstraintLine>
  RigidCoupling<dim>::lines(const LA::Vector &u) const
  {
    const unsigned int          n         = free_components.size();
    const Vector<double>        of_master = missing_at_masters(u);
    std::vector<ConstraintLine> result;
    double                      largest = of_master.linfty_norm();
    Vector<double>              motion(n), weights(n);
    for (const auto &node : nodes)
      {
        const Tensor<1, dim> missing =
          target.displacement(node.arm) - node.values(u);
        largest = std::max(largest, missing.norm());
        std::vector<Tensor<1, dim>> motions;
        for (const unsigned int c : free_components)
          motions.push_back(motion_of_arm(c, node.arm));
        for (unsigned int d = 0; d < dim; ++d)
          {
            if (std::count(master_dofs.begin(),
                           master_dofs.end(),
                           node.dofs[d]) > 0)
              continue;
            for (unsigned int k = 0; k < n; ++k)
              motion(k) = motions[k][d];
            inverse_map.Tvmult(weights, motion);
            ConstraintLine line{node.dofs[d],
                                {},
                                missing[d] - weights * of_master};
            for (unsigned int k = 0; k < n; ++k)
              line.entries.emplace_back(master_dofs[k],
                                        weights(k) == 0. ? no_weight
                                                         : weights(k));
            result.push_back(line);
          }
      }
    if (Utilities::MPI::max(largest, communicator) <=
        roundoff_of_displacements * u.linfty_norm())
      for (ConstraintLine &line : result)
        line.inhomogeneity = 0.;
    return result;
  }



  template <int dim>
  void
  RigidCoupling<dim>::add_driving_forces(const double time,
                                         const bool   with_springs,
                                         LA::Vector  &forces) const
  {
    const unsigned int n = free_components.size();
    Vector<double>     of_components(n), of_masters(n);
    for (unsigned int k = 0; k < n; ++k)
      {
        const unsigned int c = free_components[k];
        of_components(k)     = prescribed.motion.driving_force(c, time, target);
        if (with_springs)
          of_components(k) += prescribed.motion.spring_force(c, target);
      }
    inverse_map.Tvmult(of_masters, of_components);
    for (unsigned int i = 0; i < n; ++i)
      if (forces.in_local_range(master_dofs[i]))
        forces(master_dofs[i]) += of_masters(i);
  }



  template <int dim>
  void
  RigidCoupling<dim>::add_tangent(const double      time,
                                  const LA::Vector &unbalanced,
                                  LA::SparseMatrix &matrix) const
  {
    const RigidMotion<dim> &motion = prescribed.motion;
    const unsigned int      n      = free_components.size();
    Tensor<2, 3>            arms_and_forces;
    for (const auto &node : nodes)
      {
        const Tensor<1, 3> arm   = target.current_arm(node.arm);
        const auto         force = node.values(unbalanced);
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int d = 0; d < dim; ++d)
            arms_and_forces[i][d] += arm[i] * force[d];
      }
    arms_and_forces = Utilities::MPI::sum(arms_and_forces, communicator);

    Tensor<1, 3> moment;
    for (unsigned int i = 0; i < 3; ++i)
      moment[i] = arms_and_forces[(i + 1) % 3][(i + 2) % 3] -
                  arms_and_forces[(i + 2) % 3][(i + 1) % 3];
    const auto imbalance = [&](const unsigned int     c,
                               const RigidState<dim> &state) {
      return (c < dim ? 0. : moment * motion.spin(c, state)) -
             motion.driving_force(c, time, state) -
             motion.spring_force(c, state);
    };
    FullMatrix<double> of_components(n, n), of_masters(n, n);
    for (unsigned int l = 0; l < n; ++l)
      {
        const unsigned int c_l   = free_components[l];
        const auto         plus  = motion.moved(c_l, difference_step, target);
        const auto         minus = motion.moved(c_l, -difference_step, target);
        const Tensor<1, 3> w =
          c_l < dim ? Tensor<1, 3>() : motion.spin(c_l, target);
        for (unsigned int k = 0; k < n; ++k)
          {
            const unsigned int c = free_components[k];
            // what the components of the forces change...
            of_components(k, l) = (imbalance(c, plus) - imbalance(c, minus)) /
                                  (2. * difference_step);
            // ... and the arms: (w x r) x f = r (w . f) - w (r . f)
            if (c >= dim)
              of_components(k, l) +=
                motion.spin(c, target) *
                (arms_and_forces * w - trace(arms_and_forces) * w);
          }
      }
    of_masters.triple_product(of_components, inverse_map, inverse_map, true);
    for (unsigned int i = 0; i < n; ++i)
      if (unbalanced.in_local_range(master_dofs[i]))
        for (unsigned int j = 0; j < n; ++j)
          matrix.add(master_dofs[i], master_dofs[j], of_masters(i, j));
  }



  template <int dim>
  void
  RigidCoupling<dim>::place_at(const RigidState<dim> &state,
                               LA::Vector            &u) const
  {
    for (const auto &node : nodes)
      {
        const Tensor<1, dim> u_node = state.displacement(node.arm);
        for (unsigned int d = 0; d < dim; ++d)
          u(node.dofs[d]) = u_node[d];
      }
    u.compress(VectorOperation::insert);
  }



  template <int dim>
  void
  RigidCoupling<dim>::make_rigid(LA::Vector &u) const
  {
    // the time is that of prescribed rotations only
    if (prescribed.motion.has_free_rotation())
      place_at(state_of(0., u), u);
  }



  template <int dim>
  void
  RigidCoupling<dim>::place(const double time, LA::Vector &u) const
  {
    RigidState<dim> state = state_of(time, u);
    prescribed.motion.prescribe(time, state);
    place_at(state, u);
  }



  template <int dim>
  RigidReaction<dim>
  RigidCoupling<dim>::reaction(const double      time,
                               const LA::Vector &u,
                               const LA::Vector &unbalanced) const
  {
    const RigidState<dim> state = state_of(time, u);
    Tensor<1, 3>          moment;
    for (const auto &node : nodes)
      {
        Tensor<1, 3> force;
        for (unsigned int d = 0; d < dim; ++d)
          force[d] = unbalanced(node.dofs[d]);
        moment += cross_product_3d(state.current_arm(node.arm), force);
      }
    constexpr unsigned int n_rotations = RigidMotion<dim>::n_rotations;
    return {rotational<n_rotations>(Utilities::MPI::sum(moment, communicator)),
            state.translation,
            rotational<n_rotations>(180. / numbers::PI *
                                    state.rotation.vector())};
  }



  template class RigidCoupling<2>;
  template class RigidCoupling<3>;
} // namespace stickslip
