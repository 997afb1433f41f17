#include <stickslip/mesh/periodicity.h>

#include <stickslip/base/in_space.h>
#include <stickslip/base/short_number.h>
#include <stickslip/base/user_error.h>

#include <deal.II/base/numbers.h>

#include <deal.II/grid/grid_tools.h>

#include <deal.II/lac/full_matrix.h>

#include <deal.II/physics/transformations.h>

#include <cmath>
#include <string>

namespace stickslip
{
  namespace
  {
    /// Of the angle of a sector, in parts of itself: mesh files have rounded
    /// numbers.
    constexpr double angle_tolerance = 1e-5;

    /// Axes that differ by less, in radians or parts of the distance of the
    /// sides, are the same.
    constexpr double same_axis = 1e-6;

    /// Sectors that reach closer to the axis, as a part of the distance of
    /// their middle, reach it.
    constexpr double at_axis = 1e-8;



    Tensor<1, 3>
    away_from_axis(const PeriodicRequest &request, const Tensor<1, 3> &x)
    {
      const Tensor<1, 3> r = x - request.centre;
      return r - (r * request.axis) * request.axis;
    }



    /// What lies on the axis would have to follow itself.
    template <int dim>
    void
    check_keeps_off_axis(const PeriodicRequest    &request,
                         const Triangulation<dim> &coarse_mesh,
                         const types::boundary_id  boundary,
                         const double              distance)
    {
      for (const auto &face : coarse_mesh.active_face_iterators())
        if (face->at_boundary() && face->boundary_id() == boundary)
          for (const unsigned int v : face->vertex_indices())
            if (away_from_axis(request, in_space<dim>(face->vertex(v))).norm() <
                at_axis * distance)
              throw UserError(request.parameter_path + ": body '" +
                              request.body +
                              "' reaches the axis of its cyclic symmetry. A "
                              "sector has to keep off it: leave a small hole.");
    }



    /// From a boundary into the body behind it.
    template <int dim>
    Tensor<1, 3>
    way_inside(const Triangulation<dim> &coarse_mesh,
               const types::boundary_id  boundary)
    {
      Tensor<1, 3> sum;
      for (const auto &cell : coarse_mesh.active_cell_iterators())
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary() && face->boundary_id() == boundary)
            sum += in_space<dim>(cell->center() - face->center());
      return sum;
    }



    /// Where the faces of a boundary are: the mean of their centres.
    template <int dim>
    Point<dim>
    mean_of_faces(const Triangulation<dim> &coarse_mesh,
                  const types::boundary_id  boundary)
    {
      Point<dim>   sum;
      unsigned int n = 0;
      for (const auto &face : coarse_mesh.active_face_iterators())
        if (face->at_boundary() && face->boundary_id() == boundary)
          {
            sum += face->center();
            ++n;
          }
      return n == 0 ? sum : sum / static_cast<double>(n);
    }



    /// Faces of coarse cells that are one.
    template <int dim>
    using FacePairs = std::vector<
      GridTools::PeriodicFacePair<typename Triangulation<dim>::cell_iterator>>;



    template <int dim>
    FacePairs<dim>
    face_pairs(const PeriodicBoundary   &boundary,
               const Triangulation<dim> &coarse_mesh)
    {
      FacePairs<dim> pairs;
      if (!boundary.is_cyclic())
        {
          // the shift is what deal.II finds, whatever the mean of the faces
          // says
          GridTools::collect_periodic_faces(coarse_mesh,
                                            boundary.first,
                                            boundary.second,
                                            boundary.direction,
                                            pairs);
          return pairs;
        }
      const Tensor<2, dim> Q = boundary.motion.rotation_matrix<dim>();
      FullMatrix<double>   matrix(dim, dim);
      Tensor<1, dim>       offset;
      for (unsigned int i = 0; i < dim; ++i)
        {
          offset[i] = boundary.motion.c[i];
          for (unsigned int j = 0; j < dim; ++j)
            matrix(i, j) = Q[i][j];
        }
      GridTools::collect_periodic_faces(coarse_mesh,
                                        boundary.first,
                                        boundary.second,
                                        boundary.direction,
                                        pairs,
                                        offset,
                                        matrix);
      return pairs;
    }
  } // namespace



  PeriodicMotion
  PeriodicMotion::rotation(const Tensor<1, 3> &axis,
                           const Point<3>     &centre,
                           const double        angle)
  {
    PeriodicMotion motion;
    motion.Q =
      Physics::Transformations::Rotations::rotation_matrix_3d(Point<3>(axis),
                                                              angle);
    motion.c = centre - motion.Q * Tensor<1, 3>(centre);
    return motion;
  }



  template <int dim>
  Tensor<2, dim>
  PeriodicMotion::rotation_matrix() const
  {
    Tensor<2, dim> result;
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int j = 0; j < dim; ++j)
        result[i][j] = Q[i][j];
    return result;
  }



  template <int dim>
  Tensor<1, dim>
  PeriodicMotion::operator()(const Tensor<1, dim> &x) const
  {
    Tensor<1, dim> result = rotation_matrix<dim>() * x;
    for (unsigned int d = 0; d < dim; ++d)
      result[d] += c[d];
    return result;
  }



  PeriodicMotion
  PeriodicMotion::after(const PeriodicMotion &first) const
  {
    return {Q * first.Q, Q * first.c + c};
  }



  PeriodicMotion
  PeriodicMotion::inverse() const
  {
    return {transpose(Q), -1. * (transpose(Q) * c)};
  }



  template <int dim>
  PeriodicBoundary
  find_periodic_boundary(const PeriodicRequest    &request,
                         const Triangulation<dim> &coarse_mesh,
                         const unsigned int        body,
                         const types::boundary_id  first,
                         const types::boundary_id  second)
  {
    PeriodicBoundary   result{request.parameter_path,
                            body,
                            first,
                            second,
                            request.direction,
                            {},
                            0.,
                            0,
                            request.axis,
                            request.centre};
    const Tensor<1, 3> a = in_space<dim>(mean_of_faces(coarse_mesh, first));
    const Tensor<1, 3> b = in_space<dim>(mean_of_faces(coarse_mesh, second));
    result.distance      = (b - a).norm();
    if (!request.is_cyclic)
      {
        result.motion.c[request.direction] =
          b[request.direction] - a[request.direction];
        return result;
      }

    const Tensor<1, 3> r_a = away_from_axis(request, a);
    const Tensor<1, 3> r_b = away_from_axis(request, b);
    check_keeps_off_axis(request, coarse_mesh, first, r_a.norm());
    check_keeps_off_axis(request, coarse_mesh, second, r_b.norm());
    const double angle =
      std::atan2(cross_product_3d(r_a, r_b) * request.axis, r_a * r_b);
    const double n = std::round(2. * numbers::PI / std::abs(angle));
    // N - 1 sectors have their sides where one has them, on the other side
    const bool is_rest = n > 2.5 && (cross_product_3d(request.axis, r_a) *
                                     way_inside(coarse_mesh, first)) *
                                        angle <
                                      0.;
    if (is_rest || !(n >= 2. && n < 1e4) ||
        std::abs(std::abs(angle) * n - 2. * numbers::PI) >
          angle_tolerance * 2. * numbers::PI)
      throw UserError(request.parameter_path + ": boundaries " + request.first +
                      " and " + request.second + " of body '" + request.body +
                      "' are " +
                      short_number((is_rest ? 2. * numbers::PI - std::abs(angle)
                                            : std::abs(angle)) *
                                   180. / numbers::PI) +
                      " degrees apart about the axis, but a sector of cyclic "
                      "symmetry is 180, 120, 90, 72, ... degrees wide: a whole "
                      "number of them makes a full turn.");
    result.order = static_cast<unsigned int>(n);
    result.motion =
      PeriodicMotion::rotation(request.axis,
                               request.centre,
                               std::copysign(2. * numbers::PI / n, angle));
    // across the second boundary
    const Tensor<1, 3> across = cross_product_3d(request.axis, r_b);
    result.direction          = 0;
    for (unsigned int d = 1; d < dim; ++d)
      if (std::abs(across[d]) > std::abs(across[result.direction]))
        result.direction = d;
    return result;
  }



  void
  check_compatible(const std::vector<PeriodicBoundary> &boundaries)
  {
    const auto refuse = [](const PeriodicBoundary &a,
                           const PeriodicBoundary &b,
                           const std::string      &why) {
      throw UserError(a.parameter_path + " and " + b.parameter_path + ": " +
                      why);
    };
    for (const PeriodicBoundary &a : boundaries)
      for (const PeriodicBoundary &b : boundaries)
        if (a.is_cyclic() && b.is_cyclic())
          {
            const Tensor<1, 3> between = b.centre - a.centre;
            if (a.order != b.order)
              refuse(a,
                     b,
                     "one sector is 1/" + std::to_string(a.order) +
                       " of a full turn, the other one 1/" +
                       std::to_string(b.order) +
                       ". A model has one cyclic symmetry.");
            if (cross_product_3d(a.axis, b.axis).norm() > same_axis ||
                cross_product_3d(a.axis, between).norm() >
                  same_axis * a.distance)
              refuse(a, b, "their axes differ. A model has one axis.");
          }
        else if (a.is_cyclic() &&
                 std::abs(std::abs(a.axis[b.direction]) - 1.) > same_axis)
          refuse(a,
                 b,
                 "beside cyclic symmetry periodic boundaries can only be "
                 "along its axis.");
  }



  template <int dim>
  void
  add_periodicity(const std::vector<PeriodicBoundary> &boundaries,
                  Triangulation<dim>                  &coarse_mesh)
  {
    FacePairs<dim> pairs;
    for (const PeriodicBoundary &boundary : boundaries)
      for (const auto &pair : face_pairs(boundary, coarse_mesh))
        pairs.push_back(pair);
    if (!pairs.empty())
      coarse_mesh.add_periodicity(pairs);
  }

#define INSTANTIATE(dim)                                                       \
  template Tensor<2, dim> PeriodicMotion::rotation_matrix() const;             \
  template Tensor<1, dim> PeriodicMotion::operator()(const Tensor<1, dim> &)   \
    const;                                                                     \
  template PeriodicBoundary find_periodic_boundary(const PeriodicRequest &,    \
                                                   const Triangulation<dim> &, \
                                                   const unsigned int,         \
                                                   const types::boundary_id,   \
                                                   const types::boundary_id);  \
  template void add_periodicity(const std::vector<PeriodicBoundary> &,         \
                                Triangulation<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
