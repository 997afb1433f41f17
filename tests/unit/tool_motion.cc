// How the partner of a point of a slave face moves over a rigid tool, and how
// the tool's normal there turns, when the nodes of the face and those of the
// tool's frame move: against central differences of the projection.

#include "print.h"

#include <stickslip/contact/pairing/tool_motion.h>
#include <stickslip/contact/surface/tool_shapes.h>

#include <deal.II/base/index_set.h>
#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

using namespace stickslip;

namespace
{
  constexpr double step = 1e-6;

  /// A tool whose frame is a master face, and a slave face before it.
  template <int dim>
  class Scene
  {
  public:
    Scene(const ToolSurface<dim> &surface, const Point<dim> &near)
      : shape(1)
      , layout(complete_index_set((dim + 1) * dim))
    {
      for (unsigned int j = 0; j < dim + 1; ++j)
        {
          Point<dim> node;
          if (j > 0)
            node[j - 1] = 2.;
          nodes.push_back(node);
        }
      SurfaceFace<dim> frame;
      frame.n_nodes             = dim + 1;
      frame.reference_positions = nodes;
      for (unsigned int i = 0; i < (dim + 1) * dim; ++i)
        frame.dofs.push_back(i);
      PairingTolerances tolerances{10., 0., 0., 0.};
      patch = std::make_unique<MasterPatch<dim>>(
        std::vector<SurfaceFace<dim>>{frame},
        shape,
        tolerances,
        MPI_COMM_SELF,
        std::make_shared<RigidTool<dim>>(
          RigidTool<dim>{surface, ToolFrame<dim>(nodes)}));
      u.reinit(layout, MPI_COMM_SELF);
      for (unsigned int k = 0; k < shape.n_nodes(); ++k)
        {
          Tensor<1, dim> x = near;
          for (unsigned int d = 0; d < dim - 1; ++d)
            x[d] += 0.4 * (shape.node(k)[d] - 0.5);
          x[dim - 1] += 0.05 * k;
          slave.positions.push_back(x);
        }
      for (unsigned int d = 0; d < dim - 1; ++d)
        point.xi[d] = 0.3 + 0.2 * d;
      patch->fetch({BoundingBox<dim>(std::make_pair(near, near))}, u, 1.);
    }

    /// xi and normal of the partner, with column @p k moved by @p distance.
    std::vector<double>
    partner(const unsigned int k, const double distance)
    {
      const unsigned int n     = shape.n_nodes();
      const auto         saved = slave.positions;
      for (unsigned int i = 0; i < u.size(); ++i)
        u(i) = k >= n * dim && i == k - n * dim ? distance : 0.;
      if (k < n * dim)
        slave.positions[k / dim][k % dim] += distance;
      patch->update(u, u);
      std::vector<double> N;
      shape.evaluate_values(point.xi, N);
      const auto      &positions = patch->configuration(0).positions;
      const auto       foot      = project_on_tool(patch->tool()->surface,
                                        patch->tool()->frame,
                                        positions,
                                        interpolate<dim>(N, slave.positions));
      MasterPoint<dim> at;
      patch->tool()->evaluate(positions, foot.chart, foot.xi, at);
      slave.positions = saved;
      point.chart     = foot.chart;
      point.eta       = foot.xi;
      std::vector<double> result;
      for (unsigned int d = 0; d < dim - 1; ++d)
        result.push_back(foot.xi[d]);
      for (unsigned int d = 0; d < dim; ++d)
        result.push_back(at.n[d]);
      return result;
    }

    /// Largest difference of the derivatives from central differences.
    double
    largest_error()
    {
      const unsigned int n_columns =
        (shape.n_nodes() + ToolFrame<dim>::n_nodes) * dim;
      std::vector<std::vector<double>> differences;
      for (unsigned int k = 0; k < n_columns; ++k)
        {
          auto       plus  = partner(k, step);
          const auto minus = partner(k, -step);
          for (unsigned int i = 0; i < plus.size(); ++i)
            plus[i] = (plus[i] - minus[i]) / (2. * step);
          differences.push_back(plus);
        }
      partner(0, 0.);
      ToolMotion<dim> motion;
      motion.evaluate(shape, slave, point, *patch, true);
      double error = 0.;
      for (unsigned int k = 0; k < n_columns; ++k)
        {
          for (unsigned int d = 0; d < dim - 1; ++d)
            error =
              std::max(error, std::abs(motion.D_xi[d][k] - differences[k][d]));
          for (unsigned int d = 0; d < dim; ++d)
            error = std::max(error,
                             std::abs(motion.D_n[k][d] -
                                      differences[k][dim - 1 + d]));
        }
      return error;
    }

  private:
    const FaceShape<dim>              shape;
    const IndexSet                    layout;
    std::vector<Point<dim>>           nodes;
    std::unique_ptr<MasterPatch<dim>> patch;
    LA::Vector                        u;
    MortarFace<dim>                   slave;
    SegmentPoint<dim>                 point;
  };



  template <int dim>
  void
  test(const std::string      &name,
       const ToolSurface<dim> &surface,
       const Point<dim>       &near)
  {
    const double error = Scene<dim>(surface, near).largest_error();
    std::cout << name << ": as differences within 1e-7: "
              << (error < 1e-7 ? "yes" : "NO, " + std::to_string(error))
              << '\n';
  }
} // namespace



int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const Tensor<1, 3>               axis({0.1, 1., 0.3});
  test<2>("plane",
          make_plane<2>(Point<2>(0., 1.), Tensor<1, 2>({0.2, -1.}), 9., "t"),
          Point<2>(0.2, 0.8));
  test<2>("circle",
          make_circle(Point<2>(0.3, 3.), 2., ToolSide::inside, "t"),
          Point<2>(0.8, 0.9));
  test<2>("bore",
          make_circle(Point<2>(0.3, 0.), 2., ToolSide::around, "t"),
          Point<2>(0.8, 1.7));
  test<3>(
    "cylinder",
    make_cylinder(Point<3>(0., 0., 3.), axis, 2., 9., ToolSide::inside, "t"),
    Point<3>(0.4, 0.3, 0.9));
  test<3>("sphere",
          make_sphere(Point<3>(0.2, 0.1, 3.), 2., ToolSide::inside, "t"),
          Point<3>(0.6, 0.4, 0.9));
  test<3>("torus",
          make_torus(Point<3>(0., 0., 2.),
                     Tensor<1, 3>({0., 0.2, 1.}),
                     2.,
                     0.7,
                     ToolSide::inside,
                     "t"),
          Point<3>(1.6, 0.7, 1.1));
}
