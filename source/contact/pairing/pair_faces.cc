#include <stickslip/contact/pairing/pair_faces.h>

#include <stickslip/contact/pairing/local_thickness.h>
#include <stickslip/contact/pairing/symmetry_planes.h>
#include <stickslip/contact/surface/facet_rise.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>
#include <deal.II/base/symmetric_tensor.h>

#include <algorithm>
#include <cmath>

namespace stickslip
{
  namespace
  {
    /// Angle between the facets of a curved surface at most [radian]: 42
    /// degrees, so that chamfers of 45 degrees have edges, and nine facets
    /// make a circle.
    constexpr double sharpest_turn = 42. / 180. * numbers::PI;

    /// Curvatures are the same up to this fraction, ...
    constexpr double same_curvature = 0.3;

    /// ... a surface is round where they are on all but this part of its area,
    /// ...
    constexpr double part_of_others = 0.3;

    /// ... and no more than that part is flat, ...
    constexpr double flat_part = 0.02;

    /// ... and a cylinder if it is that much more curved than along its axis,
    /// which is the same up to this fraction.
    constexpr double straight = 0.05;

    /// A master that turns by less than the first over an edge of the slave
    /// [radian] is as curved beyond it; one that turns by the second may end.
    constexpr double small_turn = 0.8, large_turn = 1.6;



    double
    curvature_of_arc(const double rise, const double chord)
    {
      return rise == 0. ? 0. : 8. * rise / (chord * chord + 4. * rise * rise);
    }



    double
    rise_of_arc(const double curvature, const double chord)
    {
      const double half_angle =
        std::asin(std::clamp(0.5 * curvature * chord, -1., 1.));
      return 0.5 * chord * std::tan(0.5 * half_angle);
    }



    /// A surface with one curvature: everywhere in a plane and on a sphere; but
    /// not along the axis of a cylinder.
    template <int dim>
    struct RoundSurface
    {
      double         curvature = 0.; ///< 0: it is none
      Tensor<1, dim> axis;           ///< of a cylinder; 0

      /// What a surface that is parallel to it between the ends of @p edge rises
      /// by, the other way round.
      double
      rise_over(const Tensor<1, dim> &edge) const
      {
        const double chord = edge.norm();
        if (chord == 0.)
          return 0.;
        const double along = axis * edge / chord;
        const double here  = curvature * (1. - along * along);
        const double turn  = here * chord;
        return -rise_of_arc(here, chord) *
               std::clamp((large_turn - turn) / (large_turn - small_turn),
                          0.,
                          1.);
      }
    };



    /// How curved the smooth surface behind a facet is, in its middle.
    template <int dim>
    struct PrincipalCurvatures
    {
      double         most = 0., least = 0.; ///< least: 3D
      Tensor<1, dim> direction;             ///< of the least
      double         area = 0.;
    };



    template <int dim>
    PrincipalCurvatures<dim>
    principal_curvatures(const FaceShape<dim>   &shape,
                         const SurfaceFace<dim> &face)
    {
      const auto x = face.undeformed_nodes();
      const auto a = surface_tangents<dim>(shape.at_centre().gradient, x);
      PrincipalCurvatures<dim> found;
      found.area       = outward_normal(face, a).norm();
      const auto &rise = face.rise;
      if constexpr (dim == 2)
        {
          if (!rise.empty())
            found.most = curvature_of_arc(rise[0], a[0].norm());
          return found;
        }
      else
        {
          if (rise.empty())
            return found;
          // the square of c_alpha a_alpha times the curvature along it
          Tensor<2, 2> form, metric;
          const auto   along = [](const double r, const Tensor<1, dim> &edge) {
            return curvature_of_arc(r, edge.norm()) * edge.norm_square();
          };
          if (shape.is_triangle())
            {
              form[0][0] = along(rise[0], a[0]);
              form[1][1] = along(rise[2], a[1]);
              form[0][1] =
                0.5 * (form[0][0] + form[1][1] - along(rise[1], a[1] - a[0]));
            }
          else
            {
              form[0][0]             = along(0.5 * (rise[2] + rise[3]), a[0]);
              form[1][1]             = along(0.5 * (rise[0] + rise[1]), a[1]);
              const Tensor<1, dim> n = outward_normal(face, a);
              form[0][1] = (x[1] + x[2] - x[0] - x[3]) * n / n.norm();
            }
          form[1][0] = form[0][1];
          for (unsigned int d = 0; d < 2; ++d)
            for (unsigned int e = 0; e < 2; ++e)
              metric[d][e] = a[d] * a[e];
          const Tensor<2, 2> mixed = invert(metric) * form;
          const double       mean  = 0.5 * trace(mixed);
          const double       half =
            std::sqrt(std::max(0., mean * mean - determinant(mixed)));
          found.most  = mean + half;
          found.least = mean - half;
          // (mixed - most) maps everything on the direction of the least
          Tensor<2, 2> onto = mixed;
          onto[0][0] -= found.most;
          onto[1][1] -= found.most;
          for (unsigned int e = 0; e < 2; ++e)
            {
              const Tensor<1, dim> d = onto[0][e] * a[0] + onto[1][e] * a[1];
              if (d.norm() > found.direction.norm())
                found.direction = d;
            }
          if (found.direction.norm() > 0.)
            found.direction /= found.direction.norm();
          return found;
        }
    }



    /// A cylinder or a sphere; curvature 0: neither.
    template <int dim>
    RoundSurface<dim>
    round_surface(const FaceShape<dim>                  &shape,
                  const std::vector<CollectedFace<dim>> &faces,
                  const MPI_Comm                        &communicator)
    {
      std::vector<PrincipalCurvatures<dim>> owned;
      for (const auto &face : faces)
        if (face.is_owned())
          owned.push_back(principal_curvatures(shape, face.face));
      const auto total = [&](const auto &of_face) {
        double sum = 0.;
        for (const auto &one : owned)
          sum += one.area * of_face(one);
        return Utilities::MPI::sum(sum, communicator);
      };
      using Curvatures = PrincipalCurvatures<dim>;
      // flat ones do not count
      const double sum = total([](const Curvatures &c) { return c.most; });
      const double sum_of_squares =
        total([](const Curvatures &c) { return c.most * c.most; });
      if (sum <= 0.)
        return {};
      const double mean  = sum_of_squares / sum;
      const auto   alike = [&](const double curvature) {
        return std::abs(curvature - mean) < same_curvature * mean;
      };
      const double area = total([](const Curvatures &) { return 1.; });
      if (total([&](const Curvatures &c) { return c.most < straight * mean; }) >
          flat_part * area)
        return {};
      if (total([&](const Curvatures &c) { return !alike(c.most); }) >
          part_of_others * area)
        return {};
      if (dim == 2 || total([&](const Curvatures &c) {
                        return !alike(c.least);
                      }) < part_of_others * area)
        return {mean, {}};
      const double            straight_part = total([&](const Curvatures &c) {
        return std::abs(c.least) < straight * mean;
      });
      SymmetricTensor<2, dim> directions;
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = i; j < dim; ++j)
          directions[i][j] = total([&](const Curvatures &c) {
            return c.direction[i] * c.direction[j] / area;
          });
      const auto [value, axis] = eigenvectors(directions)[0];
      const bool is_cylinder   = straight_part > (1. - part_of_others) * area &&
                               value > (1. - straight) * trace(directions);
      return is_cylinder ? RoundSurface<dim>{mean, axis} : RoundSurface<dim>{};
    }



    /// Edges of a face of degree 1, in the order of SurfaceFace::rise.
    template <int dim>
    std::vector<Tensor<1, dim>>
    edges_of(const FaceShape<dim> &shape, const SurfaceFace<dim> &face)
    {
      const auto x = face.undeformed_nodes();
      if (dim == 2)
        return {x[1] - x[0]};
      if (shape.is_triangle())
        return {x[1] - x[0], x[2] - x[1], x[0] - x[2]};
      return {x[2] - x[0], x[3] - x[1], x[1] - x[0], x[3] - x[2]};
    }
  } // namespace



  template <int dim>
  std::vector<CollectedFace<dim>>
  PairFaceCollector<dim>::collect(
    const std::set<types::boundary_id> &boundary,
    const std::set<types::boundary_id> &boundary_of_body,
    const FaceShape<dim>               &shape,
    const MPI_Comm                     &communicator) const
  {
    auto faces = collect_faces(mapping, dof_handler, boundary, modulus, true);
    drop_faces_on_axis(cross_section, faces);
    measure_thickness(dof_handler, boundary_of_body, communicator, faces);
    images.name_nodes(faces);
    if (has_curved_facets)
      find_rises<dim>(
        shape,
        sharpest_turn,
        [this](const SurfaceFace<dim> &face, const unsigned int j) {
          return held_directions<dim>(face.dofs[j * dim],
                                      face.rotation(j),
                                      supports);
        },
        communicator,
        faces);
    return faces;
  }



  template <int dim>
  void
  set_rises_of_convex_pairs(const FaceShape<dim>                  &master_shape,
                            const std::vector<CollectedFace<dim>> &masters,
                            const FaceShape<dim>                  &slave_shape,
                            const PeriodicImages<dim>             &images,
                            const MPI_Comm                        &communicator,
                            std::vector<CollectedFace<dim>>       &slaves)
  {
    if (is_partly_concave(slaves, communicator) ||
        is_partly_concave(masters, communicator))
      return;
    RoundSurface<dim> master;
    if (slave_shape.degree() == 1)
      master = round_surface(master_shape, masters, communicator);
    for (auto &slave : slaves)
      {
        slave.face.rise.clear();
        if (master.curvature > 0.)
          {
            // of an image that of the face itself, wherever the axis is
            const Tensor<2, dim> Q = images.motion(slave.face.id.image)
                                       .template rotation_matrix<dim>();
            for (const auto &edge : edges_of(slave_shape, slave.face))
              slave.face.rise.push_back(master.rise_over(edge * Q));
          }
      }
  }



  template void
  set_rises_of_convex_pairs(const FaceShape<2> &,
                            const std::vector<CollectedFace<2>> &,
                            const FaceShape<2> &,
                            const PeriodicImages<2> &,
                            const MPI_Comm &,
                            std::vector<CollectedFace<2>> &);
  template void
  set_rises_of_convex_pairs(const FaceShape<3> &,
                            const std::vector<CollectedFace<3>> &,
                            const FaceShape<3> &,
                            const PeriodicImages<3> &,
                            const MPI_Comm &,
                            std::vector<CollectedFace<3>> &);
  template struct PairFaceCollector<2>;
  template struct PairFaceCollector<3>;
} // namespace stickslip
