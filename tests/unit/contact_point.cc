// One contact point at the level of nodal coordinates: residual and tangent for
// all states, parameters, thresholds and live/frozen combinations.

#include "contact_point_problem.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <map>
#include <string>

using namespace contact_test;

namespace
{
  /// Largest values of what has to be small, printed in alphabetic order.
  class Checks
  {
  public:
    void
    add(const std::string &what, const double value)
    {
      double &worst = values[what];
      worst         = std::isnan(value) ? 1e300 : std::max(worst, value);
    }

    void
    print(const std::string &what, const double tolerance) const
    {
      const double value = values.at(what);
      std::cout << what << " below " << tolerance << ": "
                << (value < tolerance ? "yes" : "NO, " + std::to_string(value))
                << std::endl;
    }

  private:
    std::map<std::string, double> values;
  };



  /// Largest difference in each block of rows over the largest entry there.
  double
  relative_difference(const FullMatrix<double>        &a,
                      const FullMatrix<double>        &b,
                      const std::vector<unsigned int> &first_rows)
  {
    double largest = 0., worst = 0.;
    for (unsigned int i = 0; i < a.m(); ++i)
      for (unsigned int j = 0; j < a.n(); ++j)
        largest = std::max(largest, std::abs(b(i, j)));
    for (unsigned int block = 0; block + 1 < first_rows.size(); ++block)
      {
        double in_block = 1e-3 * largest, difference = 0.;
        for (unsigned int i = first_rows[block]; i < first_rows[block + 1]; ++i)
          for (unsigned int j = 0; j < a.n(); ++j)
            {
              in_block   = std::max(in_block, std::abs(b(i, j)));
              difference = std::max(difference, std::abs(a(i, j) - b(i, j)));
            }
        worst = std::max(worst, difference / in_block);
      }
    return worst;
  }



  double
  asymmetry(const FullMatrix<double> &a)
  {
    double largest = 0., worst = 0.;
    for (unsigned int i = 0; i < a.m(); ++i)
      for (unsigned int j = 0; j < a.n(); ++j)
        {
          largest = std::max(largest, std::abs(a(i, j)));
          worst   = std::max(worst, std::abs(a(i, j) - a(j, i)));
        }
    return worst / largest;
  }



  template <int dim>
  FullMatrix<double>
  differences(PointProblem<dim> &problem, const Setting &setting)
  {
    const double       h = 2e-6;
    const unsigned int n = problem.residual(problem.q, setting).size();
    FullMatrix<double> result(n, n);
    for (unsigned int j = 0; j < n; ++j)
      {
        std::vector<double> left = problem.q, right = problem.q;
        left[problem.unknown(j, setting)] -= h;
        right[problem.unknown(j, setting)] += h;
        Vector<double> column = problem.residual(right, setting);
        column -= problem.residual(left, setting);
        for (unsigned int i = 0; i < n; ++i)
          result(i, j) = column(i) / (2. * h);
      }
    return result;
  }



  template <int dim>
  double
  gradient_error(PointProblem<dim> &problem, const Setting &setting)
  {
    const double         h     = 1e-5;
    const Vector<double> R     = problem.residual(problem.q, setting);
    double               worst = 0.;
    for (unsigned int i = 0; i < R.size(); ++i)
      {
        std::vector<double> left = problem.q, right = problem.q;
        left[problem.unknown(i, setting)] -= h;
        right[problem.unknown(i, setting)] += h;
        const double slope = (problem.potential(right, setting) -
                              problem.potential(left, setting)) /
                             (2. * h);
        worst = std::max(worst, std::abs(slope - R(i)));
      }
    return worst / R.linfty_norm();
  }



  template <int dim>
  double
  force_imbalance(const PointProblem<dim> &problem, const Vector<double> &R)
  {
    Tensor<1, dim> sum;
    for (unsigned int i = 0; i < problem.first_multiplier; ++i)
      sum[i % dim] += R(i);
    return sum.norm() / std::max(R.linfty_norm(), 1e-3);
  }



  template <int dim>
  void
  check_symmetry(PointProblem<dim> &problem,
                 const bool         smoothed,
                 const bool         one,
                 Checks            &checks)
  {
    const Setting fpm{{false, false, true},
                      ThresholdKind::augmented,
                      true,
                      false};
    const double  a = asymmetry(problem.tangent(fpm));
    if (one || !problem.state.status.closed || problem.state.status.stick)
      checks.add("asymmetry of the FPM tangent", a);
    else if (dim == 3)
      checks.add("symmetry of the FPM tangent in slip with r_t^A != r_t^C",
                 a > 1e-4 ? 0. : 1.);
    if (one)
      checks.add("residual minus gradient of the potential, frozen",
                 gradient_error(problem, fpm));

    const Setting frictionless{{}, ThresholdKind::none, false, false};
    if (problem.place != Place::interior || smoothed)
      return;
    checks.add("asymmetry of the frictionless live tangent, facet normals",
               asymmetry(problem.tangent(frictionless)));
    if (one)
      checks.add("residual minus gradient of the potential, frictionless live",
                 gradient_error(problem, frictionless));
  }



  template <int dim>
  void
  check_tangents(PointProblem<dim>  &problem,
                 const ThresholdKind threshold,
                 Checks             &checks)
  {
    const unsigned int m = problem.first_multiplier;
    const unsigned int s = dim * problem.shape.n_nodes();
    const bool         closed =
      (problem.residual(problem.q, {{}, threshold, true, false}),
       problem.state.status.closed);
    // geometry, threshold, status; a frozen status may be the wrong one
    for (unsigned int combination = 0; combination < 12; ++combination)
      {
        Setting setting;
        setting.live.geometry     = combination % 2 == 0;
        setting.live.threshold    = (combination / 2) % 2 == 0;
        setting.live.status       = combination / 4 == 0;
        setting.threshold         = threshold;
        setting.closed            = combination / 4 == 1 ? closed : !closed;
        const auto         K      = problem.tangent(setting);
        const auto         D      = differences(problem, setting);
        const unsigned int n_dofs = K.m();
        const auto         name   = [](const bool live) {
          return live ? std::string("live") : std::string("frozen");
        };
        checks.add("tangent: geometry " + name(setting.live.geometry) +
                     ", threshold " + name(setting.live.threshold) +
                     ", status " + name(setting.live.status),
                   relative_difference(K, D, {0, s, m, n_dofs}));
        checks.add("sum of the contact forces",
                   force_imbalance(problem,
                                   problem.residual(problem.q, setting)));
      }
    // rounded corners, from nearly sharp to wide
    for (const double width : {0.05, 1., 20.})
      {
        Setting setting;
        setting.threshold      = threshold;
        setting.rounding       = {2. * width, width};
        const auto         K   = problem.tangent(setting);
        const unsigned int end = K.m();
        checks.add("tangent: rounded corners",
                   relative_difference(K,
                                       differences(problem, setting),
                                       {0, s, m, end}));
      }
    // the multiplier rows by themselves, and without friction
    const Setting      frictionless{{}, ThresholdKind::none, false, false};
    const auto         K      = problem.tangent(frictionless);
    const unsigned int n_dofs = K.m();
    checks.add("tangent: frictionless, live",
               relative_difference(K,
                                   differences(problem, frictionless),
                                   {0, s, m, n_dofs}));
  }



  /// A point that constraints restrain in one or all tangential directions: the
  /// row of Lambda along them is s / r (Lambda_restrained - Lambda), and the
  /// tangent is the derivative (with a frozen geometry: the restrained
  /// directions are constants).
  template <int dim>
  void
  check_restrained(PointProblem<dim> &problem, Checks &checks)
  {
    const ContactPoint<dim> before   = problem.point;
    auto                   &point    = problem.point;
    const Tensor<1, dim>    t_1      = point.pairing.tau[0];
    point.restrained.Lambda[0]       = 0.15;
    point.restrained.Lambda[dim - 2] = 0.25;

    std::vector<std::vector<Tensor<1, dim>>> all = {{t_1}};
    if (dim == 3)
      all.push_back({t_1, point.pairing.tau[dim - 2]});
    for (const auto &directions : all)
      {
        point.restrained.directions = directions;
        for (const bool threshold_is_live : {true, false})
          {
            Setting setting;
            setting.live                     = {false, threshold_is_live, true};
            setting.closed                   = true;
            const FullMatrix<double> tangent = problem.tangent(setting);
            const auto              &state   = problem.state;
            if (state.status.closed)
              {
                const Tensor<1, dim - 1> expected =
                  state.response.threshold / point.regularization.r_t_law *
                  (point.restrained.Lambda - state.multipliers.Lambda);
                double error =
                  std::abs(state.response.row_Lambda[0] - expected[0]);
                if (directions.size() == dim - 1)
                  error += (state.response.row_Lambda - expected).norm();
                checks.add("restrained: error of the row of Lambda", error);
                checks.add("restrained: slip that is left",
                           std::abs(state.kinematics.d_t * t_1));
              }
            const unsigned int n = tangent.m();
            checks.add("restrained: tangent",
                       relative_difference(tangent,
                                           differences(problem, setting),
                                           {0, problem.first_multiplier, n}));
          }
      }
    problem.point = before;
  }



  template <int dim>
  void
  check_all(const unsigned int degree, const bool smoothed, Checks &checks)
  {
    Regularization six, one;
    six.r_n_status       = 11.;
    six.r_n_augmentation = 7.;
    six.r_n_law          = 5.;
    six.r_t_status       = 31.;
    six.r_t_augmentation = 23.;
    six.r_t_law          = 17.;
    one.r_n_status = one.r_n_augmentation = one.r_n_law = 7.;
    one.r_t_status = one.r_t_augmentation = one.r_t_law = 23.;
    Tensor<1, dim - 1> Lambda;
    Lambda[0]                             = 0.2;
    Lambda[dim - 2]                       = -0.3;
    const std::vector<Wanted<dim>> states = {
      {"open", -0.12, 0.01, 0.3, false, false, Lambda},
      {"stick", 0.04, 0.003, -2., true, true, Lambda},
      {"slip", 0.05, 0.16, -1.5, true, false, Lambda},
      {"closed_slip", -0.02, 0.12, -3., true, false, Lambda}};

    unsigned int n_wrong = 0;
    for (const Place place : {Place::interior, Place::edge, Place::corner})
      for (const auto &wanted : states)
        for (const bool is_six : {true, false})
          {
            if (dim == 2 && place == Place::edge)
              continue; // an edge of a segment is a point
            PointProblem<dim> problem(degree, smoothed, place);
            problem.point.regularization  = is_six ? six : one;
            problem.point.scales.open_row = 1.3;
            problem.set_state(wanted);
            problem.residual(problem.q, Setting());
            const auto &status = problem.state.status;
            const auto &frame  = problem.point.pairing;
            if (!frame.paired || status.closed != wanted.closed ||
                status.stick != wanted.stick ||
                frame.is_interior() != (place == Place::interior) ||
                (place == Place::edge && frame.free[0] == frame.free[dim - 2]))
              ++n_wrong;
            // the large case with one form of the threshold only
            for (const ThresholdKind threshold :
                 {ThresholdKind::augmented, ThresholdKind::plain})
              if (degree == 1 ||
                  (threshold == ThresholdKind::augmented) == is_six)
                check_tangents(problem, threshold, checks);
            check_symmetry(problem, smoothed, !is_six, checks);
            check_restrained(problem, checks);
          }
    std::cout << dim << "D, degree " << degree << ", "
              << (smoothed ? "smoothed" : "facet")
              << " normals: points that are not in the wanted state: "
              << n_wrong << std::endl;
  }



  // ---------------------------------------------------- rotation and sliding



  /// The proper rotation by 90 degrees about @p axis (2D: in the plane).
  template <int dim>
  Tensor<1, dim>
  turned(const Tensor<1, dim> &x, const unsigned int axis)
  {
    const unsigned int a = dim == 2 ? 0 : (axis + 1) % 3;
    const unsigned int b = dim == 2 ? 1 : (axis + 2) % 3;
    Tensor<1, dim>     y = x;
    y[a]                 = -x[b];
    y[b]                 = x[a];
    return y;
  }



  /// A stuck closed pair that turns by 90 degrees in one step.
  template <int dim>
  void
  check_rotation(const unsigned int degree, const bool smoothed, Checks &checks)
  {
    for (unsigned int axis = (dim == 2 ? 2 : 0); axis < 3; ++axis)
      {
        PointProblem<dim>  problem(degree, smoothed, Place::interior);
        Tensor<1, dim - 1> Lambda;
        Lambda[0]                               = 0.3;
        problem.point.regularization.r_t_status = 10.;
        problem.set_state({"stick", 0., 0., -2., true, true, Lambda});
        // starts from rest
        problem.old_master.positions = problem.master_now;
        for (unsigned int j = 0; j < problem.shape.n_nodes(); ++j)
          for (unsigned int c = 0; c < dim; ++c)
            problem.slave_old[j][c] = problem.q[j * dim + c];
        const Vector<double> R_0   = problem.residual(problem.q, Setting());
        const auto           rest  = problem.state;
        std::vector<double>  after = problem.q;
        const auto           turn_nodes = [&](const auto &in, auto &out) {
          for (unsigned int i = 0; i < problem.first_multiplier; i += dim)
            {
              Tensor<1, dim> x;
              for (unsigned int c = 0; c < dim; ++c)
                x[c] = in[i + c];
              x = turned(x, axis);
              for (unsigned int c = 0; c < dim; ++c)
                out[i + c] = x[c];
            }
        };
        turn_nodes(problem.q, after);
        Vector<double>       expected(R_0);
        const Vector<double> R = problem.residual(after, Setting());
        turn_nodes(R_0, expected);
        expected -= R;
        const auto &now = problem.state;
        checks.add("rotation: slip of a stuck closed point",
                   now.kinematics.d_t.norm() + rest.kinematics.d_t.norm());
        checks.add("rotation: change of the gap",
                   std::abs(now.kinematics.d_n - rest.kinematics.d_n));
        checks.add("rotation: change of lambda_n and Lambda",
                   std::abs(now.multipliers.lambda_n -
                            rest.multipliers.lambda_n) +
                     (now.multipliers.Lambda - rest.multipliers.Lambda).norm());
        checks.add("rotation: forces that do not turn along",
                   expected.linfty_norm());
        checks.add("rotation: points that no longer stick",
                   rest.status.stick && now.status.stick ? 0. : 1.);
      }
  }



  /// Slides over the border of two facets whose nodes are numbered in opposite
  /// directions, while the master moves, too: the slip is the relative motion.
  template <int dim>
  void
  check_sliding(Checks &checks)
  {
    const FaceShape<dim>        shape(1);
    const SurfaceFace<dim>      left  = make_master<dim>(shape, false);
    const SurfaceFace<dim>      right = make_master<dim>(shape, false, true);
    Tensor<1, dim>              master_motion, slip, slope, e;
    std::vector<Tensor<1, dim>> old_left, now_left, old_right, now_right;
    master_motion[0]       = 0.3;
    master_motion[dim - 1] = -0.2;
    e[0]                   = 1.;
    e[dim - 1]             = -0.4;
    if (dim == 3)
      e[1] = 0.5;
    // the plane z = x / 2
    const auto inclined = [](Tensor<1, dim> x) {
      x[dim - 1] += 0.5 * x[0];
      return x;
    };
    slip[0] = 0.7;
    if (dim == 3)
      slip[1] = 0.2;
    slip = inclined(slip);
    Tensor<1, dim> shift;
    shift[0] = 1.;
    for (unsigned int j = 0; j < shape.n_nodes(); ++j)
      {
        old_left.push_back(
          inclined(Tensor<1, dim>(left.reference_positions[j])));
        old_right.push_back(
          inclined(Tensor<1, dim>(right.reference_positions[j]) + shift));
        now_left.push_back(old_left[j] + master_motion);
        now_right.push_back(old_right[j] + master_motion);
      }
    Tensor<1, dim> start = old_left[0];
    start[0] += 0.8;
    if (dim == 3)
      start[1] += 0.4;
    start[dim - 1] += 0.5 * 0.8;

    std::array<Tensor<1, dim>, dim - 1> tau_before;
    for (const double t : {0.1, 0.2, 0.5, 1.}) // the border is at 0.29
      {
        SlavePosition<dim> slave;
        slave.x_old     = start;
        slave.x         = start + t * slip + master_motion;
        slave.direction = e;
        const bool                     on_left = 0.8 + 0.7 * t < 1.;
        const SurfaceFace<dim>        &face    = on_left ? left : right;
        const MasterConfiguration<dim> now{on_left ? now_left : now_right, {}};
        const MasterConfiguration<dim> old{on_left ? old_left : old_right, {}};
        const auto projection = project_on_face(face, now, shape, slave.x, 0.);
        checks.add("sliding: projections that fail",
                   projection.found ? 0. : 1.);
        MasterPoint<dim> master, master_old;
        Pairing<dim>     frame;
        frame.xi   = projection.xi;
        frame.free = projection.free;
        evaluate_master_point(face, now, shape, frame.xi, master);
        evaluate_master_point(face, old, shape, frame.xi, master_old);
        frame.n   = master.n;
        frame.tau = tangent_basis<dim>(frame.n, e);
        ContactKinematics<dim> kinematics;
        evaluate_contact_kinematics(
          frame, master, master_old, slave, false, true, false, kinematics);
        checks.add("sliding: error of the slip",
                   (kinematics.d_t - t * slip).norm());
        checks.add("sliding: error of the gap", std::abs(kinematics.d_n));
        if (t > 0.1)
          for (unsigned int d = 0; d < dim - 1; ++d)
            checks.add("sliding: change of the tangent basis",
                       (frame.tau[d] - tau_before[d]).norm());
        tau_before = frame.tau;
      }
  }



  /// What the law does where its formulas have nothing to work with.
  void
  check_limits(Checks &checks)
  {
    ContactKinematics<3> kinematics;
    Multipliers<3>       multipliers;
    ContactResponse<3>   response;
    kinematics.n   = Tensor<1, 3>({0., 0., 1.});
    kinematics.tau = tangent_basis<3>(kinematics.n, Tensor<1, 3>({1., 0., 0.}));
    kinematics.D_d_n.fill(0.);
    for (unsigned int i = 0; i < 3; ++i)
      {
        kinematics.D_n[i].fill(0.);
        kinematics.D_d_t[i].fill(0.);
        for (unsigned int d = 0; d < 2; ++d)
          kinematics.D_tau[d][i].fill(0.);
      }
    multipliers.Lambda = Tensor<1, 2>({0.3, 0.4});
    // closed without pressure: the Lambda row must not be empty
    PointLaw law;
    law.threshold.kind                 = ThresholdKind::augmented;
    law.threshold.friction_coefficient = 0.4;
    evaluate_contact_law(
      law, kinematics, multipliers, {true, true}, true, response);
    using G = GeneralizedCoordinates<3>;
    checks.add("no pressure: deviation from the open Lambda row",
               (response.row_Lambda + multipliers.Lambda).norm() +
                 std::abs(response.D_row_Lambda[0][G::Lambda] + 1.) +
                 std::abs(response.D_row_Lambda[1][G::Lambda + 1] + 1.));
    checks.add("no pressure: traction", response.traction.norm());

    // no direction of slip
    multipliers.Lambda  = Tensor<1, 2>();
    law.threshold.kind  = ThresholdKind::given;
    law.threshold.given = 2.;
    evaluate_contact_law(
      law, kinematics, multipliers, {true, false}, true, response);
    double sum = response.traction.norm() + response.row_Lambda.norm();
    for (unsigned int i = 0; i < 3; ++i)
      for (const double entry : response.D_traction[i])
        sum += std::abs(entry);
    checks.add("slip without direction: not finite",
               std::isfinite(sum) ? 0. : 1.);
  }
} // namespace



int
main()
{
  Checks checks;
  for (const bool smoothed : {false, true})
    {
      check_all<2>(1, smoothed, checks);
      check_all<2>(2, smoothed, checks);
      check_all<3>(1, smoothed, checks);
      check_all<3>(2, smoothed, checks);
    }
  for (const bool smoothed : {false, true})
    for (const unsigned int degree : {1, 2})
      {
        check_rotation<2>(degree, smoothed, checks);
        check_rotation<3>(degree, smoothed, checks);
      }
  check_sliding<2>(checks);
  check_sliding<3>(checks);
  check_limits(checks);

  for (const std::string geometry : {"live", "frozen"})
    for (const std::string threshold : {"live", "frozen"})
      for (const std::string status : {"live", "frozen"})
        checks.print("tangent: geometry " + geometry + ", threshold " +
                       threshold + ", status " + status,
                     1e-7);
  checks.print("tangent: frictionless, live", 1e-7);
  checks.print("tangent: rounded corners", 1e-7);
  checks.print("asymmetry of the FPM tangent", 1e-12);
  checks.print("asymmetry of the frictionless live tangent, facet normals",
               1e-12);
  // the paper's six parameters are not for symmetric solvers
  checks.print("symmetry of the FPM tangent in slip with r_t^A != r_t^C", 0.5);
  checks.print("residual minus gradient of the potential, frozen", 1e-7);
  checks.print("residual minus gradient of the potential, frictionless live",
               1e-7);
  checks.print("sum of the contact forces", 1e-13);
  checks.print("restrained: error of the row of Lambda", 1e-13);
  checks.print("restrained: slip that is left", 1e-13);
  checks.print("restrained: tangent", 1e-7);
  for (const std::string what : {"slip of a stuck closed point",
                                 "change of the gap",
                                 "change of lambda_n and Lambda",
                                 "forces that do not turn along",
                                 "points that no longer stick"})
    checks.print("rotation: " + what, 1e-12);
  for (const std::string what : {"projections that fail",
                                 "error of the slip",
                                 "error of the gap",
                                 "change of the tangent basis"})
    checks.print("sliding: " + what, 1e-13);
  checks.print("no pressure: deviation from the open Lambda row", 1e-14);
  checks.print("no pressure: traction", 1e-14);
  checks.print("slip without direction: not finite", 0.5);
}
