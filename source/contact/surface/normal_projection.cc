#include <stickslip/contact/surface/normal_projection.h>

#include <algorithm>
#include <cmath>
#include <limits>

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
    is_outside(const Point<dim> &xi, const double margin)
    {
      for (unsigned int d = 0; d < dim; ++d)
        if (xi[d] < -margin || xi[d] > 1. + margin)
          return true;
      return false;
    }



    /// The coordinate along an edge, free to move between its ends only.
    template <int dim>
    void
    set_along(const double       xi,
              const unsigned int along,
              Projection<dim>   &projection)
    {
      projection.xi[along]   = std::clamp(xi, 0., 1.);
      projection.free[along] = xi > 0. && xi < 1.;
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



    /// Coordinate @p along of the point closest to @p x_s on a bent edge of a
    /// face in 3D, whose other coordinate is that of @p xi.
    double
    closest_on_edge(const SurfaceFace<3>         &face,
                    const MasterConfiguration<3> &configuration,
                    const FaceShape<3>           &shape,
                    const Tensor<1, 3>           &x_s,
                    Point<2>                      xi,
                    const unsigned int            along)
    {
      MasterPoint<3> point;
      xi[along] = 0.5;
      for (unsigned int iteration = 0; iteration < 30; ++iteration)
        {
          evaluate_master_point(face, configuration, shape, xi, point);
          const Tensor<1, 3> r = x_s - point.x;
          double             slope =
            point.a[along] * point.a[along] - r * point.x_ab[along][along];
          if (slope <= 0.)
            slope = point.a[along] * point.a[along];
          const double step = (point.a[along] * r) / slope;
          xi[along]         = std::clamp(xi[along] + step, -0.5, 1.5);
          if (std::abs(step) < no_step)
            break;
        }
      return xi[along];
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
    for (unsigned int d = 0; d < dim - 1; ++d)
      projection.xi[d] = 0.5;
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
            is_outside(projection.xi, overlap + settled_step))
          return projection;
        converged = largest < no_step + roundoff ||
                    (iteration > usual_iterations &&
                     largest < idle_step + 10. * roundoff);
      }
    if (!converged)
      return projection;
    if (is_outside(projection.xi, overlap))
      return projection;
    evaluate_master_point(face, configuration, shape, projection.xi, point);
    projection.found = true;
    projection.free.fill(true);
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

    for (unsigned int fixed = 0; fixed < dim - 1; ++fixed)
      for (const unsigned int side : {0, 1})
        {
          Projection<dim> candidate;
          candidate.xi[fixed] = side;
          if constexpr (dim == 2)
            offer(candidate, configuration.positions[side * shape.degree()]);
          else if (shape.degree() == 1)
            {
              const unsigned int   along = 1 - fixed;
              const unsigned int   first = side << fixed;
              const Tensor<1, dim> begin = configuration.positions[first];
              const Tensor<1, dim> edge =
                configuration.positions[first + (1 << along)] - begin;
              set_along(((x_s - begin) * edge) / edge.norm_square(),
                        along,
                        candidate);
              offer(candidate, begin + candidate.xi[along] * edge);
            }
          else
            {
              const unsigned int along = 1 - fixed;
              candidate.xi[along]      = closest_on_edge(
                face, configuration, shape, x_s, candidate.xi, along);
              set_along(candidate.xi[along], along, candidate);
              evaluate_master_point(
                face, configuration, shape, candidate.xi, point);
              offer(candidate, point.x);
            }
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
