// Faces of tetrahedra: shape functions against those of the cells, quadrature,
// weighting functions beside an excluded vertex, and the projection of a point.

#include "print.h"

#include <stickslip/base/user_error.h>

#include <stickslip/contact/point/contact_kinematics.h>
#include <stickslip/contact/surface/contact_quadrature.h>
#include <stickslip/contact/surface/normal_projection.h>
#include <stickslip/contact/surface/weighting_functions.h>

#include <deal.II/base/quadrature_lib.h>

#include <deal.II/fe/fe_simplex_p.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

using namespace stickslip;

namespace
{
  FaceShape<3>
  triangle(const unsigned int degree)
  {
    return FaceShape<3>(degree, ReferenceCells::Triangle);
  }



  void
  test_shape_functions(const unsigned int degree)
  {
    const FaceShape<3>   shape = triangle(degree);
    const FE_SimplexP<2> fe(degree);
    const Point<2>       xi(0.3, 0.5);
    FaceShapeValues<3>   at;
    std::vector<double>  values;
    shape.evaluate(xi, at);
    shape.evaluate_values(xi, values);
    double error = std::abs(1. * shape.n_nodes() - fe.n_dofs_per_cell());
    for (unsigned int j = 0; j < shape.n_nodes(); ++j)
      error = std::max({error,
                        shape.node(j).distance(fe.unit_support_point(j)),
                        std::abs(values[j] - fe.shape_value(j, xi)),
                        std::abs(at.value[j] - fe.shape_value(j, xi)),
                        (at.gradient[j] - fe.shape_grad(j, xi)).norm(),
                        (at.hessian[j] - fe.shape_grad_grad(j, xi)).norm()});
    print("degree " + std::to_string(degree) + " as FE_SimplexP",
          error < 1e-13);
  }



  void
  test_quadrature()
  {
    for (const auto &[rule, order] :
         std::vector<std::pair<ContactRule, unsigned int>>{
           {ContactRule::nodal, 2},
           {ContactRule::Gauss, 1},
           {ContactRule::Gauss, 4},
           {ContactRule::Gauss, 5},
           {ContactRule::Simpson, 2}})
      try
        {
          const auto points =
            contact_quadrature(rule, order, triangle(1), "Contact/pair");
          double sum = 0., moment = 0.; // of 1 and xi_1
          for (unsigned int q = 0; q < points.size(); ++q)
            {
              sum += points.weight(q);
              moment += points.weight(q) * points.point(q)[0];
            }
          print(name_of(rule, all_contact_rules()) + " " +
                  std::to_string(order) + ": " + std::to_string(points.size()) +
                  " points",
                std::abs(sum - 0.5) < 1e-14 &&
                  std::abs(moment - 1. / 6.) < 1e-14);
          check_multipliers_are_determined(points, triangle(1), "Contact/pair");
        }
      catch (const UserError &error)
        {
          print(error.what());
        }
  }



  /// The neighbours of an excluded vertex share its part, whichever it is.
  void
  test_weighting()
  {
    const QGaussSimplex<2> quadrature(3);
    for (const auto kind :
         {WeightingFunctions::standard, WeightingFunctions::dual})
      {
        bool is_shared = true;
        for (unsigned int m = 0; m < 3; ++m)
          {
            std::vector<bool> excluded(3, false);
            excluded[m]          = true;
            const auto         W = weighting_functions<3>(kind,
                                                  triangle(1),
                                                  {excluded, {}},
                                                  quadrature,
                                                  quadrature.get_weights());
            const unsigned int a = (m + 1) % 3, b = (m + 2) % 3;
            is_shared = is_shared && std::abs(W(a, m) - 0.5) < 1e-12 &&
                        std::abs(W(b, m) - 0.5) < 1e-12 &&
                        std::abs(W(a, a) + W(b, a) - 1.) < 1e-12 &&
                        std::abs(W(m, a)) + std::abs(W(m, m)) < 1e-12;
          }
        print(name_of(kind, all_weighting_functions()) +
                ": neighbours share what is excluded",
              is_shared);
      }
  }



  /// D xi of a point above the slanting edge against differences of the
  /// projection, when the point and the nodes move.
  void
  test_derivative(const SurfaceFace<3>         &face,
                  const MasterConfiguration<3> &configuration,
                  const FaceShape<3>           &shape,
                  const Tensor<1, 3>           &x)
  {
    using G              = GeneralizedCoordinates<3>;
    const auto projected = [&](const double h) {
      MasterConfiguration<3> moved = configuration;
      for (unsigned int j = 0; j < moved.positions.size(); ++j)
        for (unsigned int c = 0; c < 3; ++c)
          moved.positions[j][c] += h * std::sin(2. * j + 3. * c);
      const Tensor<1, 3> x_moved = x + h * Tensor<1, 3>({0.5, -0.3, 0.8});
      return project_on_boundary_of_face(face, moved, shape, x_moved);
    };
    const auto     p = projected(0.);
    MasterPoint<3> master;
    evaluate_master_point(face, configuration, shape, p.xi, master);
    Pairing<3> frame;
    frame.xi   = p.xi;
    frame.free = p.free;
    frame.n    = master.n;
    SlavePosition<3> slave;
    slave.x = slave.x_old = x;
    slave.direction       = master.a[0];
    frame.tau             = tangent_basis<3>(frame.n, slave.direction);
    ContactKinematics<3> kinematics;
    evaluate_contact_kinematics(
      frame, master, master, slave, false, true, true, kinematics);

    std::array<double, G::n> motion{};
    for (unsigned int c = 0; c < 3; ++c)
      {
        motion[G::W + c] = Tensor<1, 3>({0.5, -0.3, 0.8})[c];
        for (unsigned int j = 0; j < shape.n_nodes(); ++j)
          {
            const double of_node = std::sin(2. * j + 3. * c);
            motion[G::W + c] -= master.shape.value[j] * of_node;
            for (unsigned int d = 0; d < 2; ++d)
              motion[G::C + d * 3 + c] += master.shape.gradient[j][d] * of_node;
          }
      }
    const double       h     = 1e-5;
    const Tensor<1, 2> slope = (projected(h).xi - projected(-h).xi) / (2. * h);
    bool               is_right = p.free == EdgeMotion<3>{{-1, 1}};
    for (unsigned int d = 0; d < 2; ++d)
      {
        double D_xi = 0.;
        for (unsigned int c = 0; c < G::n; ++c)
          D_xi += kinematics.D_xi[d][c] * motion[c];
        is_right = is_right && std::abs(D_xi - slope[d]) < 1e-7;
      }
    print("  derivative on the slanting edge", is_right);
  }



  void
  test_projection(const unsigned int degree)
  {
    const FaceShape<3>     shape = triangle(degree);
    SurfaceFace<3>         face;
    MasterConfiguration<3> configuration;
    MasterPoint<3>         master;
    for (unsigned int j = 0; j < shape.n_nodes(); ++j)
      {
        const double x = shape.node(j)[0], y = shape.node(j)[1];
        face.reference_positions.emplace_back(
          x + 0.2 * y, y, 0.3 * x + 0.2 * x * y + 0.1 * y * y);
        configuration.positions.emplace_back(face.reference_positions.back());
        face.n_nodes = j + 1;
      }
    const auto above = [&](const Point<2> &xi) {
      evaluate_master_point(face, configuration, shape, xi, master);
      return Tensor<1, 3>(master.x + 0.1 * master.n);
    };

    bool inside = true;
    for (const auto &xi :
         {Point<2>(0.1, 0.1), Point<2>(0.7, 0.2), Point<2>(0.2, 0.75)})
      {
        const auto p =
          project_on_face(face, configuration, shape, above(xi), 1e-10);
        inside = inside && p.found && (p.xi - xi).norm() < 1e-12 &&
                 p.free == everywhere<3>();
      }
    print("degree " + std::to_string(degree) + ": inside found", inside);

    bool outside = true, edges = true;
    for (const auto &xi :
         {Point<2>(0.55, 0.55), Point<2>(-0.1, 0.5), Point<2>(0.4, -0.2)})
      {
        const Tensor<1, 3> x = above(xi);
        outside              = outside &&
                  !project_on_face(face, configuration, shape, x, 0.01).found;

        // closest point of the edges by trying
        const auto p =
          project_on_boundary_of_face(face, configuration, shape, x);
        double closest = std::numeric_limits<double>::max();
        for (unsigned int i = 0; i <= 400; ++i)
          for (const auto &place : {Point<2>(i / 400., 0.),
                                    Point<2>(0., i / 400.),
                                    Point<2>(1. - i / 400., i / 400.)})
            {
              evaluate_master_point(face, configuration, shape, place, master);
              closest = std::min(closest, (x - master.x).norm());
            }
        evaluate_master_point(face, configuration, shape, p.xi, master);
        // the difference is orthogonal to the edge along which xi may move
        Tensor<1, 3> along;
        for (unsigned int d = 0; d < 2; ++d)
          along += p.free[d] * master.a[d];
        edges = edges && p.found && p.free != everywhere<3>() &&
                along.norm() > 0. && std::abs((x - master.x) * along) < 1e-12 &&
                p.distance < closest + 1e-12 && p.distance > closest - 1e-4;
      }
    print("  outside not found", outside);
    print("  edges", edges);
    test_derivative(face, configuration, shape, above(Point<2>(0.55, 0.55)));
  }
} // namespace



int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const unsigned int degree : {1, 2})
    test_shape_functions(degree);
  test_quadrature();
  test_weighting();
  for (const unsigned int degree : {1, 2})
    test_projection(degree);
}
