#include <stickslip/contact/normal_projection.h>

#include <algorithm>
#include <cmath>

namespace stickslip
{
  namespace
  {
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
    double d_n       = 0.;
    bool   converged = false;
    for (unsigned int iteration = 0; iteration < 30 && !converged; ++iteration)
      {
        evaluate_master_point(face, configuration, shape, projection.xi, point);
        if (iteration == 0)
          d_n = (x_s - point.x) * point.n;
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
        converged = largest < 1e-14;
        // roundoff of far away faces: no more progress to be had
        if (iteration > 6 && largest < 1e-12)
          converged = true;
      }
    if (!converged)
      return projection;
    for (unsigned int d = 0; d < dim - 1; ++d)
      if (projection.xi[d] < -overlap || projection.xi[d] > 1. + overlap)
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
    const auto       offer = [&](Projection<dim> candidate) {
      evaluate_master_point(face, configuration, shape, candidate.xi, point);
      finish_projection(point, x_s, candidate);
      candidate.found = true;
      if (!best.found || candidate.distance < best.distance * (1. - 1e-12))
        best = candidate;
    };

    for (unsigned int fixed = 0; fixed < dim - 1; ++fixed)
      for (const double side : {0., 1.})
        {
          Projection<dim> candidate;
          candidate.xi[fixed] = side;
          if constexpr (dim == 3)
            {
              const unsigned int along = 1 - fixed;
              candidate.xi[along]      = 0.5;
              bool inside              = true;
              for (unsigned int iteration = 0; iteration < 30; ++iteration)
                {
                  evaluate_master_point(
                    face, configuration, shape, candidate.xi, point);
                  const Tensor<1, dim> r     = x_s - point.x;
                  double               slope = point.a[along] * point.a[along] -
                                 r * point.x_ab[along][along];
                  if (slope <= 0.)
                    slope = point.a[along] * point.a[along];
                  const double step = (point.a[along] * r) / slope;
                  candidate.xi[along] =
                    std::clamp(candidate.xi[along] + step, -0.5, 1.5);
                  if (std::abs(step) < 1e-14)
                    break;
                }
              inside = candidate.xi[along] > 0. && candidate.xi[along] < 1.;
              candidate.xi[along]   = std::clamp(candidate.xi[along], 0., 1.);
              candidate.free[along] = inside;
            }
          offer(candidate);
        }
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
