// One contact point on the surface of a rigid tool that moves with the nodes of
// a frame: tangent with all unknowns against differences, resultant and moment
// on the frame, turned shafts, work around a closed path.

#include "print.h"

#include <stickslip/contact/point/contact_element.h>
#include <stickslip/contact/surface/tool_frame.h>

#include <deal.II/base/numbers.h>
#include <deal.II/physics/transformations.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

using namespace stickslip;

namespace
{
  using numbers::PI;

  constexpr double mu = 0.4;

  template <int dim>
  Tensor<2, dim>
  rotation(const double angle)
  {
    if constexpr (dim == 2)
      return Physics::Transformations::Rotations::rotation_matrix_2d(angle);
    else
      return Physics::Transformations::Rotations::rotation_matrix_3d(
        Point<3>(1., 2., 2.) / 3., angle);
  }



  /// Moment of a force at x about the origin; 2D: its only component.
  template <int dim>
  Tensor<1, 3>
  moment(const Tensor<1, dim> &x, const Tensor<1, dim> &force)
  {
    Tensor<1, 3> x_3, force_3;
    for (unsigned int c = 0; c < dim; ++c)
      {
        x_3[c]     = x[c];
        force_3[c] = force[c];
      }
    return cross_product_3d(x_3, force_3);
  }



  /// A tool, two slave nodes with a contact point between them, and a
  /// multiplier node. The unknowns q are those of the local vector.
  template <int dim>
  class ToolContact
  {
  public:
    explicit ToolContact(const ToolSurface<dim> &surface)
      : surface(surface)
      , frame(corners())
    {
      point.geometry.weight              = 0.37;
      point.geometry.direction_gradients = {-1., 1.};
      Tensor<2, dim - 1> identity;
      for (unsigned int d = 0; d < dim - 1; ++d)
        identity[d][d] = 1.;
      point.nodal_rotations    = {identity};
      point.regularization     = {11., 7., 5., 9., 6., 5.};
      face.n_nodes             = ToolFrame<dim>::n_nodes;
      face.reference_positions = corners();
      old_positions            = moved(0., {});
    }

    static std::vector<Point<dim>>
    corners()
    {
      std::vector<Point<dim>> nodes(dim + 1);
      for (unsigned int d = 0; d < dim; ++d)
        {
          nodes[d + 1][d] = 2.;
          nodes[d][(d + 1) % dim] += 0.3;
        }
      return nodes;
    }

    /// The frame turned by @p angle about the origin, then shifted.
    static std::vector<Tensor<1, dim>>
    moved(const double angle, const Tensor<1, dim> &shift)
    {
      std::vector<Tensor<1, dim>> positions;
      for (const auto &corner : corners())
        positions.push_back(shift + rotation<dim>(angle) * corner);
      return positions;
    }

    /// Unknowns with the slave point at @p x.
    std::vector<double>
    unknowns(const Tensor<1, dim>              &x,
             const std::vector<Tensor<1, dim>> &positions,
             const double                       lambda_n,
             const double                       Lambda) const
    {
      Tensor<1, dim> half; // of the edge between the slave nodes
      half[0]       = 0.3;
      half[dim - 1] = 0.2;
      std::vector<double> q;
      for (unsigned int c = 0; c < dim; ++c)
        q.push_back(x[c] - slave_shape[1] * half[c]);
      for (unsigned int c = 0; c < dim; ++c)
        q.push_back(x[c] + slave_shape[0] * half[c]);
      for (const auto &position : positions)
        for (unsigned int c = 0; c < dim; ++c)
          q.push_back(position[c]);
      q.push_back(lambda_n);
      for (unsigned int d = 0; d < dim - 1; ++d)
        q.push_back(d == 0 ? Lambda : -0.5 * Lambda);
      return q;
    }

    Tensor<1, dim>
    slave_point(const std::vector<double> &q) const
    {
      Tensor<1, dim> x;
      for (unsigned int c = 0; c < dim; ++c)
        x[c] = slave_shape[0] * q[c] + slave_shape[1] * q[dim + c];
      return x;
    }

    std::vector<Tensor<1, dim>>
    frame_positions(const std::vector<double> &q) const
    {
      std::vector<Tensor<1, dim>> positions(face.n_nodes);
      for (unsigned int j = 0; j < face.n_nodes; ++j)
        for (unsigned int c = 0; c < dim; ++c)
          positions[j][c] = q[(2 + j) * dim + c];
      return positions;
    }

    Vector<double>
    residual(const std::vector<double> &q, const bool with_friction = true)
    {
      const auto     element = evaluate(q, false, with_friction);
      Vector<double> local(element.n_dofs());
      local_residual(element, state, local);
      return local;
    }

    FullMatrix<double>
    tangent(const std::vector<double> &q)
    {
      const auto         element = evaluate(q, true, true);
      FullMatrix<double> local(element.n_dofs(), element.n_dofs());
      local_tangent(element, state, false, local);
      return local;
    }

    const ToolSurface<dim>      surface;
    const ToolFrame<dim>        frame;
    SurfaceFace<dim>            face;
    const std::vector<double>   slave_shape{0.4, 0.6};
    const std::vector<double>   multiplier_shape{1.};
    ContactPoint<dim>           point;
    std::vector<Tensor<1, dim>> old_positions;
    Tensor<1, dim>              x_old;
    ContactEvaluation<dim>      state;
    bool                        found = false;

  private:
    MasterConfiguration<dim> configuration;

    ContactElement<dim>
    evaluate(const std::vector<double> &q,
             const bool                 differentiate,
             const bool                 with_friction)
    {
      SlavePosition<dim> slave;
      slave.x     = slave_point(q);
      slave.x_old = x_old;
      for (unsigned int c = 0; c < dim; ++c)
        slave.direction[c] = q[dim + c] - q[c];
      configuration.positions = frame_positions(q);
      const auto foot =
        project_on_tool(surface, frame, configuration.positions, slave.x);
      found = foot.found;
      MasterPoint<dim> old;
      evaluate_tool_point(surface,
                          frame,
                          configuration.positions,
                          foot.chart,
                          foot.xi,
                          state.master);
      evaluate_tool_point(
        surface, frame, old_positions, foot.chart, foot.xi, old);
      Pairing<dim> pairing;
      pairing.paired = true;
      pairing.xi     = foot.xi;
      pairing.free   = everywhere<dim>();
      pairing.n      = state.master.n;
      pairing.tau    = tangent_basis<dim>(pairing.n, slave.direction);
      evaluate_contact_kinematics(pairing,
                                  state.master,
                                  old,
                                  slave,
                                  false,
                                  true,
                                  differentiate,
                                  state.kinematics);
      ContactElement<dim> element{
        point, slave_shape, multiplier_shape, dim, &face, &configuration};
      state.multipliers =
        interpolate_multipliers(element,
                                std::vector<double>(q.end() - dim, q.end()));
      state.status.closed = is_closed(state.multipliers.lambda_n,
                                      state.kinematics.d_n,
                                      point.regularization);
      state.status.stick =
        state.status.closed &&
        is_stick(tangential_vector<dim>(state.multipliers.Lambda,
                                        state.kinematics.tau),
                 state.kinematics.d_t,
                 point.regularization);
      PointLaw law;
      law.r = point.regularization;
      law.threshold.kind =
        with_friction ? ThresholdKind::augmented : ThresholdKind::none;
      law.threshold.friction_coefficient = mu;
      evaluate_contact_law(law,
                           state.kinematics,
                           state.multipliers,
                           state.status,
                           differentiate,
                           state.response);
      return element;
    }
  };



  template <int dim>
  Tensor<1, dim>
  shift_of_tool()
  {
    Tensor<1, dim> shift;
    shift[0]       = 0.2;
    shift[dim - 1] = -0.3;
    return shift;
  }



  /// Stick and slip near the point @p X of the undisplaced tool, which has
  /// turned by two radians, and whose frame is not quite rigid.
  template <int dim>
  void
  test_tangent(const std::string      &name,
               const ToolSurface<dim> &surface,
               const Point<dim>       &X)
  {
    print(name);
    for (const bool stick : {true, false})
      {
        ToolContact<dim> contact(surface);
        auto             positions = contact.moved(2., shift_of_tool<dim>());
        for (unsigned int j = 0; j < positions.size(); ++j)
          for (unsigned int c = 0; c < dim; ++c)
            positions[j][c] += 0.01 * std::sin(1. + 3. * j + 5. * c);
        contact.old_positions = contact.moved(1.6, {});
        const auto       foot = surface.closest(X);
        MasterPoint<dim> now, old;
        evaluate_tool_point(
          surface, contact.frame, positions, foot.chart, foot.xi, now);
        evaluate_tool_point(surface,
                            contact.frame,
                            contact.old_positions,
                            foot.chart,
                            foot.xi,
                            old);
        const Tensor<1, dim> x = now.x + 0.03 * now.n;
        contact.x_old          = x - (now.x - old.x) - 0.013 * now.n -
                        (stick ? 0.01 : 0.4) * now.a[0] / now.a[0].norm();
        const auto q    = contact.unknowns(x, positions, -1.3, 0.3);
        const auto K    = contact.tangent(q);
        bool       same = contact.found && contact.state.status.closed &&
                    contact.state.status.stick == stick;
        double       worst = 0.;
        const double h     = 1e-6;
        for (unsigned int k = 0; k < q.size(); ++k)
          {
            auto displaced = q;
            displaced[k] += h;
            Vector<double> difference = contact.residual(displaced);
            displaced[k] -= 2. * h;
            difference -= contact.residual(displaced);
            same = same && contact.found && contact.state.status.stick == stick;
            for (unsigned int i = 0; i < q.size(); ++i)
              worst =
                std::max(worst, std::abs(difference[i] / (2. * h) - K(i, k)));
          }
        print(std::string("  ") + (stick ? "sticks" : "slips"), same);
        print("  tangent within 1e-7 of differences",
              worst < 1e-7 * K.linfty_norm());

        const Vector<double> forces = contact.residual(q);
        Tensor<1, dim>       sum;
        Tensor<1, 3>         sum_of_moments;
        const auto           force_at = [&](const unsigned int node) {
          Tensor<1, dim> force;
          for (unsigned int c = 0; c < dim; ++c)
            force[c] = forces[node * dim + c];
          return force;
        };
        for (unsigned int j = 0; j < positions.size(); ++j)
          {
            sum += force_at(2 + j);
            sum_of_moments += moment<dim>(positions[j], force_at(2 + j));
          }
        const Tensor<1, dim> on_slave = force_at(0) + force_at(1);
        print("  forces balance", (sum + on_slave).norm() < 1e-13);
        print("  moment on the frame is that of the force",
              (sum_of_moments + moment<dim>(contact.state.master.x, on_slave))
                  .norm() < 1e-13);
      }
  }



  /// Where a rigid tool is does not matter: rotations of any size.
  template <int dim>
  void
  test_rotations(const std::string      &name,
                 const ToolSurface<dim> &surface,
                 const Point<dim>       &X)
  {
    const ToolContact<dim> contact(surface);
    const auto             at_rest = surface.closest(X);
    double                 worst   = 0.;
    bool                   same    = at_rest.found;
    for (unsigned int i = 1; i < 20; ++i)
      {
        const Tensor<1, dim> shift = shift_of_tool<dim>() * i;
        const Tensor<2, dim> turn  = rotation<dim>(0.7 * i);
        const auto           foot  = project_on_tool(surface,
                                          contact.frame,
                                          contact.moved(0.7 * i, shift),
                                          shift + turn * X);
        same  = same && foot.found && foot.chart == at_rest.chart;
        worst = std::max(worst, foot.xi.distance(at_rest.xi));
      }
    print(name + ": turned tool has the same places", same && worst < 1e-12);
  }



  /// A shaft in a bush that it presses against on one side: what the slave
  /// points of the bush exert on it while it is turned.
  void
  test_shaft()
  {
    print("Turned shaft");
    const double   radius = 0.8, r_n = 7.;
    const Point<2> centre(0.1, -0.2);
    ToolContact<2> contact(
      ToolSurface<2>(ToolProfile::circle(centre, radius, false)));
    double       worst_moment = 0., worst_force = 0., worst_friction = 0.;
    Tensor<1, 2> at_first;
    for (unsigned int turn = 0; turn < 25; ++turn)
      {
        const double       angle     = 0.37 * turn;
        const Tensor<1, 2> shift     = centre - rotation<2>(angle) * centre;
        const auto         positions = contact.moved(angle, shift);
        const Tensor<1, 2> before = centre - rotation<2>(angle - 0.37) * centre;
        contact.old_positions     = contact.moved(angle - 0.37, before);
        for (const bool with_friction : {false, true})
          {
            Tensor<1, 2> force, sum;
            double       torque = 0., normal_forces = 0.;
            for (unsigned int i = 0; i < 40; ++i)
              {
                const double       at = 2. * PI * i / 40.;
                const Tensor<1, 2> out({std::cos(at), std::sin(at)});
                const double       gap = 0.02 * (0.3 + std::cos(at));
                const Tensor<1, 2> x   = centre + (radius - gap) * out;
                contact.x_old          = x;
                const auto q =
                  contact.unknowns(x, positions, 0., with_friction ? 1. : 0.);
                const auto f = contact.residual(q, with_friction);
                for (unsigned int j = 0; j < positions.size(); ++j)
                  {
                    for (unsigned int c = 0; c < 2; ++c)
                      force[c] = f[(2 + j) * 2 + c];
                    sum += force;
                    torque +=
                      moment<2>(positions[j] - Tensor<1, 2>(centre), force)[2];
                  }
                normal_forces +=
                  contact.point.geometry.weight * r_n * std::max(gap, 0.);
              }
            if (with_friction)
              worst_friction =
                std::max(worst_friction,
                         std::abs(std::abs(torque) / normal_forces -
                                  mu * radius));
            else
              {
                worst_moment = std::max(worst_moment, std::abs(torque));
                if (turn == 0)
                  at_first = sum;
                worst_force = std::max(worst_force, (sum - at_first).norm());
              }
          }
      }
    print("  without friction there is no moment", worst_moment < 1e-13);
    print("  and the force is always the same",
          at_first.norm() > 0.1 && worst_force < 1e-13);
    print("  with friction the moment is mu N R", worst_friction < 1e-12);
  }



  /// The work of all forces while slave point and tool go around, frictionless.
  template <int dim>
  void
  test_work(const std::string      &name,
            const ToolSurface<dim> &surface,
            const Point<dim>       &X)
  {
    ToolContact<dim>   contact(surface);
    const unsigned int n    = 400;
    double             work = 0., largest = 0.;
    bool               closed = true;
    const auto         at     = [&](const double t) {
      const double   angle = 1. + 0.5 * std::sin(t);
      Tensor<1, dim> shift =
        (0.3 + 0.1 * std::cos(2. * t)) * shift_of_tool<dim>();
      Point<dim> place = X;
      place[0] += 0.03 * std::cos(t);
      place[1] += 0.02 * std::sin(t + 0.4);
      return contact.unknowns(shift + rotation<dim>(angle) * place,
                              contact.moved(angle, shift),
                              0.,
                              0.);
    };
    const double h = 1e-3;
    for (unsigned int i = 0; i < n; ++i)
      {
        const double t     = 2. * PI * i / n;
        const auto   force = contact.residual(at(t), false);
        closed = closed && contact.found && contact.state.status.closed;
        // of fourth order, h^4 / 30 of the fifth derivatives
        const auto a = at(t - 2. * h), b = at(t - h), c = at(t + h),
                   d = at(t + 2. * h);
        double power = 0.;
        for (unsigned int k = 0; k + dim < a.size(); ++k)
          power += force[k] * (a[k] - 8. * b[k] + 8. * c[k] - d[k]) / (12. * h);
        work += power * 2. * PI / n;
        largest = std::max(largest, std::abs(power));
      }
    print(name + ": in contact all the way", closed);
    print("  with power", largest > 1e-4);
    print("  work around the path is zero", std::abs(work) < 1e-10);
  }
} // namespace



int
main(int argc, char *argv[])
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const ToolSurface<2> circle(ToolProfile::circle({0.2, 0.1}, 0.9, false));
  const ToolSurface<2> bush(ToolProfile::circle({0.2, 0.1}, 0.9, true));
  const ToolSurface<2> rounded(ToolProfile::polyline(
    {{{-1., 0.}}, {{1., 0.}, 0.4}, {{1., 2.}}}, false, "rounded"));
  test_tangent<2>("2D circle", circle, {0.9, 0.6});
  test_tangent<2>("2D bush", bush, {-0.5, -0.3});
  test_tangent<2>("2D line", rounded, {0.1, 0.05});
  test_tangent<2>("2D fillet", rounded, {0.95, 0.1});

  const ToolSurface<3> ball(ToolProfile::half_circle({0., 0.}, 1.1, false),
                            {},
                            "ball");
  const ToolSurface<3> ring(ToolProfile::circle({1.4, 0.2}, 0.5, true),
                            {},
                            "ring");
  const ToolSurface<3> cone(ToolProfile::polyline({{{0., 0.}, 0.3}, {{1., 2.}}},
                                                  false,
                                                  "cone"),
                            {},
                            "cone");
  ToolSweep            along;
  along.kind = ToolSweep::Kind::extruded;
  along.axis = Tensor<1, 3>({0., 1., 0.});
  const ToolSurface<3> bar(ToolProfile::polyline({{{-1., -1.}, 0.4},
                                                  {{1., -1.}, 0.4},
                                                  {{1., 1.}, 0.4},
                                                  {{-1., 1.}, 0.4}},
                                                 true,
                                                 "bar"),
                           along,
                           "bar");
  test_tangent<3>("3D ball, side", ball, {0.9, 0.5, 0.2});
  test_tangent<3>("3D ball, pole", ball, {0.1, -0.2, 1.});
  test_tangent<3>("3D ball, other pole", ball, {0., 0., -1.});
  test_tangent<3>("3D ring, hollow", ring, {0.8, 0.9, 0.5});
  test_tangent<3>("3D cone", cone, {0.5, -0.3, 1.2});
  test_tangent<3>("3D cone, tip", cone, {0.02, 0.01, 0.3});
  test_tangent<3>("3D bar, fillet", bar, {0.95, 0.3, 0.9});
  test_tangent<3>("3D bar, side", bar, {0.9, 0.3, 0.2});

  test_rotations<2>("2D fillet", rounded, {0.95, 0.1});
  test_rotations<3>("3D ball", ball, {0.1, -0.2, 1.});
  test_rotations<3>("3D cone", cone, {0.5, -0.3, 1.2});
  test_rotations<3>("3D bar", bar, {0.95, 0.3, 0.9});
  test_shaft();
  test_work<2>("2D circle", circle, {0.9, 0.5});
  test_work<3>("3D ball", ball, {0.5, 0.2, 0.8});
  test_work<3>("3D ring, hollow", ring, {1.0, 0.9, 0.75});
}
