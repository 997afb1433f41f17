// Shape functions and quadrature on contact faces, and the projection of a
// point on one face.

#include "print.h"

#include <stickslip/base/user_error.h>

#include <stickslip/contact/surface/contact_quadrature.h>
#include <stickslip/contact/surface/normal_projection.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

using namespace stickslip;

namespace
{
  template <int dim>
  Point<dim - 1>
  face_point(const double first, const double second)
  {
    Point<dim - 1> xi;
    xi[0] = first;
    if (dim == 3)
      xi[dim - 2] = second;
    return xi;
  }



  // -------------------------------------------------------- shape functions



  template <int dim>
  void
  test_shape_functions(const unsigned int degree)
  {
    const FaceShape<dim> shape(degree);
    FaceShapeValues<dim> at, right, left;
    std::vector<double>  values;
    const double         h = 1e-5;
    double unity = 0., at_nodes = 0., gradients = 0., hessians = 0., same = 0.;
    for (const auto &xi : {face_point<dim>(0.3, 0.8), face_point<dim>(1., 0.)})
      {
        shape.evaluate(xi, at);
        shape.evaluate_values(xi, values);
        double             sum = -1.;
        Tensor<1, dim - 1> gradient_sum;
        for (unsigned int j = 0; j < shape.n_nodes(); ++j)
          {
            sum += at.value[j];
            gradient_sum += at.gradient[j];
            same = std::max(same, std::abs(at.value[j] - values[j]));
          }
        unity = std::max({unity, std::abs(sum), gradient_sum.norm()});
        for (unsigned int d = 0; d < dim - 1; ++d)
          {
            Point<dim - 1> step;
            step[d] = h;
            shape.evaluate(xi + step, right);
            shape.evaluate(Point<dim - 1>(xi - step), left);
            for (unsigned int j = 0; j < shape.n_nodes(); ++j)
              {
                const double slope =
                  (right.value[j] - left.value[j]) / (2. * h);
                gradients =
                  std::max(gradients, std::abs(slope - at.gradient[j][d]));
                const Tensor<1, dim - 1> second =
                  (right.gradient[j] - left.gradient[j]) / (2. * h);
                for (unsigned int e = 0; e < dim - 1; ++e)
                  hessians =
                    std::max(hessians,
                             std::abs(second[e] - at.hessian[j][e][d]));
              }
          }
      }
    for (unsigned int i = 0; i < shape.n_nodes(); ++i)
      {
        shape.evaluate_values(shape.node(i), values);
        for (unsigned int j = 0; j < shape.n_nodes(); ++j)
          at_nodes = std::max(at_nodes, std::abs(values[j] - (i == j)));
      }
    print(std::to_string(dim) + "D face shapes of degree " +
            std::to_string(degree) + ", " + std::to_string(shape.n_nodes()) +
            " nodes",
          unity < 1e-13 && same < 1e-14 && at_nodes < 1e-13 &&
            gradients < 1e-8 && hessians < 1e-8);
  }



  // -------------------------------------------------------------- quadrature



  /// Number of points, sign of the weights and highest exact degree.
  void
  print_rule(const ContactRule  rule,
             const unsigned int order,
             const unsigned int multiplier_degree)
  {
    const auto line        = contact_quadrature(rule,
                                         order,
                                         FaceShape<2>(multiplier_degree),
                                         "Contact/pair");
    const auto square      = contact_quadrature(rule,
                                           order,
                                           FaceShape<3>(multiplier_degree),
                                           "Contact/pair");
    bool       is_positive = true;
    unsigned   exact       = 0;
    for (unsigned int k = 0; k < 40; ++k, ++exact)
      {
        double moment = 0.;
        for (unsigned int q = 0; q < line.size(); ++q)
          {
            moment += line.weight(q) * std::pow(line.point(q)[0], k);
            is_positive = is_positive && line.weight(q) > 0.;
          }
        if (std::abs(moment * (k + 1) - 1.) > 1e-11)
          break;
      }
    double moment = 0., sum = 0.;
    for (unsigned int q = 0; q < square.size(); ++q)
      {
        sum += square.weight(q);
        moment += square.weight(q) *
                  std::pow(square.point(q)[0] * square.point(q)[1], exact - 1);
      }
    const bool is_product = square.size() == line.size() * line.size() &&
                            std::abs(sum - 1.) < 1e-13 &&
                            std::abs(moment * exact * exact - 1.) < 1e-10;
    print(name_of(rule, all_contact_rules()) + " " + std::to_string(order) +
          ", multipliers of degree " + std::to_string(multiplier_degree) +
          ": " + std::to_string(line.size()) + " points, exact to degree " +
          std::to_string(exact - 1) + (is_positive ? "" : ", NOT POSITIVE") +
          (is_product ? "" : ", NO TENSOR PRODUCT"));
  }



  void
  test_quadrature()
  {
    for (unsigned int degree = 1; degree <= 3; ++degree)
      print_rule(ContactRule::nodal, 2, degree);
    for (const unsigned int order : {1, 2, 3, 8, 20})
      print_rule(ContactRule::Gauss, order, 1);
    for (const unsigned int order : {1, 2, 20})
      print_rule(ContactRule::Simpson, order, 1);
    for (const unsigned int order : {1, 2, 3, 4, 5, 6, 7, 9})
      print_rule(ContactRule::Newton_Cotes, order, 2);
    const std::vector<std::pair<ContactRule, unsigned int>> wrong = {
      {ContactRule::Gauss, 0},
      {ContactRule::Gauss, 21},
      {ContactRule::Simpson, 0},
      {ContactRule::Newton_Cotes, 0},
      {ContactRule::Newton_Cotes, 8},
      {ContactRule::Newton_Cotes, 10}};
    for (const auto &[rule, order] : wrong)
      try
        {
          contact_quadrature(rule, order, FaceShape<3>(1), "Contact/pair");
          print(name_of(rule, all_contact_rules()) + ": no error");
        }
      catch (const UserError &error)
        {
          print(error.what());
        }
  }



  // -------------------------------------------------------------- projection



  /// A face over the unit square (segment) of height @p height, the body below.
  template <int dim, typename Height>
  SurfaceFace<dim>
  make_face(const FaceShape<dim> &shape, const Height &height)
  {
    SurfaceFace<dim> face;
    face.n_nodes     = shape.n_nodes();
    face.orientation = -1.;
    face.diameter    = std::sqrt(dim - 1.);
    for (unsigned int j = 0; j < face.n_nodes; ++j)
      {
        Point<dim> x;
        for (unsigned int d = 0; d < dim - 1; ++d)
          x[d] = shape.node(j)[d];
        x[dim - 1] = height(x);
        face.reference_positions.push_back(x);
      }
    return face;
  }



  template <int dim, typename Height>
  void
  test_projection(const std::string &name,
                  const unsigned int degree,
                  const bool         smoothed,
                  const Height      &height)
  {
    const FaceShape<dim>     shape(degree);
    const SurfaceFace<dim>   face = make_face<dim>(shape, height);
    MasterConfiguration<dim> configuration;
    MasterPoint<dim>         master;
    for (const auto &x : face.reference_positions)
      configuration.positions.emplace_back(x);
    if (smoothed)
      for (unsigned int j = 0; j < face.n_nodes; ++j)
        {
          Tensor<1, dim> n;
          n[0]       = 0.1 * std::sin(2. * j);
          n[dim - 1] = -1.;
          configuration.nodal_normals.push_back(n / n.norm());
        }
    const auto above = [&](const Point<dim - 1> &xi, const double gap) {
      evaluate_master_point(face, configuration, shape, xi, master);
      return Tensor<1, dim>(master.x + gap * master.n);
    };

    // 1e5 times its size away from the origin
    Tensor<1, dim>           offset;
    MasterConfiguration<dim> far_away = configuration;
    for (unsigned int d = 0; d < dim; ++d)
      offset[d] = 1e5;
    for (auto &x : far_away.positions)
      x += offset;

    bool inside = true, outside = true, overlap = true, edges = true,
         everywhere = true;
    for (const double gap : {-0.2, 0., 0.1})
      {
        for (const double first : {0., 0.1, 0.5, 0.97})
          {
            const auto xi = face_point<dim>(first, 0.7);
            const auto p  = project_on_face(
              face, configuration, shape, above(xi, gap), 1e-10);
            inside = inside && p.found && (p.xi - xi).norm() < 1e-12 &&
                     std::abs(p.distance - std::abs(gap)) < 1e-12 &&
                     p.free[0] && p.free[dim - 2] && p.overshoot == 0.;
            const auto q = project_on_face(
              face, far_away, shape, above(xi, gap) + offset, 1e-8);
            everywhere = everywhere && q.found && (q.xi - xi).norm() < 1e-9;
          }
        const auto near = above(face_point<dim>(1.005, 0.4), gap);
        const auto far  = above(face_point<dim>(-0.02, 0.4), gap);
        outside =
          outside &&
          !project_on_face(face, configuration, shape, near, 1e-10).found &&
          !project_on_face(face, configuration, shape, far, 0.01).found;
        const auto p = project_on_face(face, configuration, shape, near, 0.01);
        overlap      = overlap && p.found && std::abs(p.xi[0] - 1.005) < 1e-12;

        // closest point of the edges by trying
        for (const auto &xi : {face_point<dim>(1.2, 0.4),
                               face_point<dim>(-0.3, 1.2),
                               face_point<dim>(0.4, -0.1)})
          {
            const Tensor<1, dim> x = above(xi, gap);
            const auto           boundary =
              project_on_boundary_of_face(face, configuration, shape, x);
            double       closest = std::numeric_limits<double>::max();
            const double n       = dim == 3 ? 400. : 1.;
            for (unsigned int i = 0; i <= n; ++i)
              for (const double side : {0., 1.})
                for (unsigned int d = 0; d < dim - 1; ++d)
                  {
                    Point<dim - 1> try_xi;
                    try_xi[d] = side;
                    if (dim == 3)
                      try_xi[dim - 2 - d] = i / n;
                    evaluate_master_point(
                      face, configuration, shape, try_xi, master);
                    closest = std::min(closest, (x - master.x).norm());
                  }
            evaluate_master_point(
              face, configuration, shape, boundary.xi, master);
            edges =
              edges && boundary.found &&
              std::abs((x - master.x).norm() - boundary.distance) < 1e-13 &&
              boundary.distance < closest + 1e-12 &&
              boundary.distance > closest - 1e-4;
            // along a free edge the difference is orthogonal
            for (unsigned int d = 0; d < dim - 1; ++d)
              if (boundary.free[d])
                edges = edges && std::abs((x - master.x) * master.a[d]) < 1e-12;
          }
      }
    print(std::to_string(dim) + "D " + name + ": inside found", inside);
    print("  outside not found", outside);
    print("  found within the overlap", overlap);
    print("  edges and corners", edges);
    print("  inside found far from the origin", everywhere);
  }



  template <int dim>
  void
  test_projections()
  {
    const auto flat  = [](const Point<dim> &x) { return 0.3 * x[0]; };
    const auto bumpy = [](const Point<dim> &x) {
      return 0.2 * x[0] * x[0] + (dim == 3 ? 0.3 * x[0] * x[1] : 0.);
    };
    test_projection<dim>("flat", 1, false, flat);
    test_projection<dim>(dim == 3 ? "warped" : "inclined", 1, false, bumpy);
    test_projection<dim>("quadratic", 2, false, bumpy);
    test_projection<dim>("quadratic with smoothed normals", 2, true, bumpy);
    test_projection<dim>("linear with smoothed normals", 1, true, bumpy);
  }



  template <int dim>
  void
  test_all()
  {
    for (unsigned int degree = 1; degree <= 3; ++degree)
      test_shape_functions<dim>(degree);
    test_projections<dim>();
  }
} // namespace



int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_quadrature();
  test_all<2>();
  test_all<3>();
}
