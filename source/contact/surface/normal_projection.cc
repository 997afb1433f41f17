#include <stickslip/contact/surface/normal_projection.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace stickslip
{
  namespace
  {
    /// A Newton step after which the coordinates move by less than itself:
    /// enough to turn away a face far from the projection.
    constexpr double settled_step = 0.05;

    /// Steps that do not change a coordinate.
    constexpr double no_step = 1e-14;

    /// Steps of this size after the usual iterations are roundoff, too.
    constexpr double       idle_step        = 1e-12;
    constexpr unsigned int usual_iterations = 6;



    template <int dim>
    bool
    is_outside(const FaceShape<dim> &shape,
               const Point<dim - 1> &xi,
               const double          margin)
    {
      for (unsigned int d = 0; d < dim - 1; ++d)
        if (xi[d] < -margin || xi[d] > 1. + margin)
          return true;
      return shape.is_triangle() && xi[0] + xi[dim - 2] > 1. + margin;
    }



    /// An edge of a face in 3D: begin + s direction with s from 0 to 1.
    struct Edge
    {
      Point<2>      begin;
      EdgeMotion<3> direction;

      Point<2>
      at(const double s) const
      {
        Point<2> xi = begin;
        for (unsigned int d = 0; d < 2; ++d)
          xi[d] += s * direction[d];
        return xi;
      }
    };



    const std::vector<Edge> &
    edges_of(const FaceShape<3> &shape)
    {
      static const std::vector<Edge> square   = {{Point<2>(0., 0.), {{0, 1}}},
                                                 {Point<2>(1., 0.), {{0, 1}}},
                                                 {Point<2>(0., 0.), {{1, 0}}},
                                                 {Point<2>(0., 1.), {{1, 0}}}};
      static const std::vector<Edge> triangle = {{Point<2>(0., 0.), {{1, 0}}},
                                                 {Point<2>(1., 0.), {{-1, 1}}},
                                                 {Point<2>(0., 0.), {{0, 1}}}};
      return shape.is_triangle() ? triangle : square;
    }



    /// The vertex at a corner of a linear face.
    unsigned int
    vertex_at(const Point<2> &corner)
    {
      return std::lround(corner[0] + 2. * corner[1]);
    }



    template <int dim>
    void
    finish_projection(const MasterPoint<dim> &point,
                      const Tensor<1, dim>   &x_s,
                      Projection<dim>        &projection)
    {
      const Tensor<1, dim> r = x_s - point.x;
      projection.distance    = r.norm();
      projection.overshoot   = (r - (r * point.n) * point.n).norm();
    }



    /// What the roundoff of the position of @p x_s, which may be far from the
    /// origin, makes of a coordinate in a (small) face.
    template <int dim>
    double
    coordinate_roundoff(const MasterPoint<dim> &point,
                        const Tensor<1, dim>   &x_s)
    {
      double size = point.a[0].norm();
      for (unsigned int d = 1; d < dim - 1; ++d)
        size = std::min(size, point.a[d].norm());
      return 4. * std::numeric_limits<double>::epsilon() * x_s.norm() / size;
    }



    /// The s of the point closest to @p x_s on a bent edge of a face in 3D.
    double
    closest_on_edge(const SurfaceFace<3>         &face,
                    const MasterConfiguration<3> &configuration,
                    const FaceShape<3>           &shape,
                    const Tensor<1, 3>           &x_s,
                    const Edge                   &edge)
    {
      MasterPoint<3> point;
      double         s = 0.5;
      for (unsigned int iteration = 0; iteration < 30; ++iteration)
        {
          evaluate_master_point(face, configuration, shape, edge.at(s), point);
          const Tensor<1, 3> r = x_s - point.x;
          Tensor<1, 3>       a, curvature;
          for (unsigned int d = 0; d < 2; ++d)
            {
              a += edge.direction[d] * point.a[d];
              for (unsigned int e = 0; e < 2; ++e)
                curvature +=
                  edge.direction[d] * edge.direction[e] * point.x_ab[d][e];
            }
          double slope = a * a - r * curvature;
          if (slope <= 0.)
            slope = a * a;
          const double step = (a * r) / slope;
          s                 = std::clamp(s + step, -0.5, 1.5);
          if (std::abs(step) < no_step)
            break;
        }
      return s;
    }



    /// The point closest to @p x_s on an edge of a face in 3D, and its position.
    std::pair<Projection<3>, Tensor<1, 3>>
    project_on_edge(const SurfaceFace<3>         &face,
                    const MasterConfiguration<3> &configuration,
                    const FaceShape<3>           &shape,
                    const Tensor<1, 3>           &x_s,
                    const Edge                   &edge)
    {
      Projection<3> projection;
      const auto    set_place = [&](const double s) {
        projection.xi = edge.at(std::clamp(s, 0., 1.));
        if (s > 0. && s < 1.)
          projection.free = edge.direction;
      };
      if (shape.degree() == 1)
        {
          const Tensor<1, 3> begin =
            configuration.positions[vertex_at(edge.begin)];
          const Tensor<1, 3> way =
            configuration.positions[vertex_at(edge.at(1.))] - begin;
          const double s = ((x_s - begin) * way) / way.norm_square();
          set_place(s);
          return {projection, begin + std::clamp(s, 0., 1.) * way};
        }
      set_place(closest_on_edge(face, configuration, shape, x_s, edge));
      MasterPoint<3> point;
      evaluate_master_point(face, configuration, shape, projection.xi, point);
      return {projection, point.x};
    }
  } // namespace



  template <int dim>
  Projection<dim>
  project_on_face(const SurfaceFace<dim>         &face,
                  const MasterConfiguration<dim> &configuration,
                  const FaceShape<dim>           &shape,
                  const Tensor<1, dim>           &x_s,
                  const double                    overlap)
  {
    Projection<dim>  projection;
    MasterPoint<dim> point;
    projection.xi = shape.centre();
    double d_n = 0., roundoff = 0.;
    bool   converged = false;
    for (unsigned int iteration = 0; iteration < 30 && !converged; ++iteration)
      {
        evaluate_master_point(face, configuration, shape, projection.xi, point);
        if (iteration == 0)
          {
            d_n      = (x_s - point.x) * point.n;
            roundoff = coordinate_roundoff(point, x_s);
          }
        const Tensor<1, dim> residual = x_s - point.x - d_n * point.n;
        Tensor<2, dim>       jacobian;
        for (unsigned int i = 0; i < dim; ++i)
          {
            for (unsigned int d = 0; d < dim - 1; ++d)
              jacobian[i][d] = point.a[d][i] + d_n * point.n_a[d][i];
            jacobian[i][dim - 1] = point.n[i];
          }
        if (std::abs(determinant(jacobian)) <
            1e-12 * std::pow(point.a[0].norm(), dim - 1))
          return projection;
        const Tensor<1, dim> step    = invert(jacobian) * residual;
        double               largest = 0.;
        for (unsigned int d = 0; d < dim - 1; ++d)
          {
            projection.xi[d] += step[d];
            largest = std::max(largest, std::abs(step[d]));
            if (!(std::abs(projection.xi[d]) < 20.))
              return projection;
          }
        d_n += step[dim - 1];
        if (largest < settled_step &&
            is_outside(shape, projection.xi, overlap + settled_step))
          return projection;
        converged = largest < no_step + roundoff ||
                    (iteration > usual_iterations &&
                     largest < idle_step + 10. * roundoff);
      }
    if (!converged)
      return projection;
    if (is_outside(shape, projection.xi, overlap))
      return projection;
    evaluate_master_point(face, configuration, shape, projection.xi, point);
    projection.found = true;
    projection.free  = everywhere<dim>();
    finish_projection(point, x_s, projection);
    projection.overshoot = 0.;
    return projection;
  }



  template <int dim>
  Projection<dim>
  project_on_boundary_of_face(const SurfaceFace<dim>         &face,
                              const MasterConfiguration<dim> &configuration,
                              const FaceShape<dim>           &shape,
                              const Tensor<1, dim>           &x_s)
  {
    Projection<dim>  best;
    MasterPoint<dim> point;
    const auto offer = [&](Projection<dim> candidate, const Tensor<1, dim> &x) {
      candidate.found    = true;
      candidate.distance = (x_s - x).norm();
      if (!best.found || candidate.distance < best.distance * (1. - 1e-12))
        best = candidate;
    };

    if constexpr (dim == 2)
      for (const unsigned int side : {0, 1})
        {
          Projection<dim> candidate;
          candidate.xi[0] = side;
          offer(candidate, configuration.positions[side * shape.degree()]);
        }
    else
      for (const Edge &edge : edges_of(shape))
        {
          const auto [candidate, position] =
            project_on_edge(face, configuration, shape, x_s, edge);
          offer(candidate, position);
        }
    evaluate_master_point(face, configuration, shape, best.xi, point);
    finish_projection(point, x_s, best);
    return best;
  }

#define INSTANTIATE(dim)                                                     \
  template Projection<dim> project_on_face(const SurfaceFace<dim> &,         \
                                           const MasterConfiguration<dim> &, \
                                           const FaceShape<dim> &,           \
                                           const Tensor<1, dim> &,           \
                                           const double);                    \
  template Projection<dim> project_on_boundary_of_face(                      \
    const SurfaceFace<dim> &,                                                \
    const MasterConfiguration<dim> &,                                        \
    const FaceShape<dim> &,                                                  \
    const Tensor<1, dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
