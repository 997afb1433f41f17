#include <stickslip/contact/pairing/master_candidates.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace stickslip
{
  namespace
  {
    /// Projections of two master faces that share less than this fraction of
    /// the slave face do not lie behind each other.
    constexpr double no_overlap = 1e-6;



    /// A point of a surface that meets itself has come in if it is not deeper
    /// than this fraction of the faces and of the thickness of the body.
    constexpr double come_in = 0.25;

    /// The back of a body is not farther away than this times its thickness.
    constexpr double thick = 1.5;



    /// Shape functions of the slave and of the master face, their means over
    /// the segments of a candidate.
    struct MeanShape
    {
      std::vector<double> slave;
      std::vector<double> master;
    };



    template <int dim>
    MeanShape
    mean_shape(const std::vector<SegmentPoint<dim>> &points,
               const FaceShape<dim>                 &slave_shape,
               const FaceShape<dim>                 &master_shape)
    {
      MeanShape           mean{std::vector<double>(slave_shape.n_nodes()),
                     std::vector<double>(master_shape.n_nodes())};
      std::vector<double> N;
      double              area = 0.;
      const auto          add  = [&](const FaceShape<dim> &shape,
                           const Point<dim - 1> &xi,
                           const double          weight,
                           std::vector<double>  &sum) {
        shape.evaluate_values(xi, N);
        for (unsigned int j = 0; j < N.size(); ++j)
          sum[j] += weight * N[j];
      };
      for (const auto &point : points)
        {
          area += point.weight;
          add(slave_shape, point.xi, point.weight, mean.slave);
          add(master_shape, point.eta, point.weight, mean.master);
        }
      for (auto *values : {&mean.slave, &mean.master})
        for (double &value : *values)
          value /= area;
      return mean;
    }



    /// Where the segments of a candidate are, were and are without deformation:
    /// the means over them.
    template <int dim>
    void
    measure_candidate(const MortarFace<dim>  &slave,
                      const FaceShape<dim>   &slave_shape,
                      const Tensor<1, dim>   &n,
                      const Tensor<1, dim>   &old_n,
                      const MasterPatch<dim> &patch,
                      FaceCandidate<dim>     &candidate)
    {
      const MeanShape mean =
        mean_shape(candidate.points, slave_shape, patch.face_shape());
      auto &middle  = candidate.middle;
      auto &partner = candidate.partner;
      for (const auto &point : candidate.points)
        candidate.area += point.weight;
      middle.x = interpolate<dim>(mean.slave, slave.positions);
      partner.x =
        interpolate<dim>(mean.master,
                         patch.configuration(candidate.master).positions);
      candidate.distance = std::abs((partner.x - middle.x) * n);
      middle.normal      = n;
      middle.thickness   = slave.face.thickness;
      middle.face_nodes  = &slave.positions;
      partner.face       = candidate.master;
      partner.n          = n;
      if (patch.tolerances.is_own_master)
        candidate.through =
          interpolate<dim>(mean.master,
                           patch.face(candidate.master).undeformed_nodes()) -
          interpolate<dim>(mean.slave, slave.face.undeformed_nodes());
      else if (is_level(middle, partner, patch))
        return;
      middle.x_old = interpolate<dim>(mean.slave, slave.old_positions);
      partner.x_old =
        interpolate<dim>(mean.master,
                         patch.old_configuration(candidate.master).positions);
      partner.n_old = old_n;
    }



    /// Of faces of one body: depth up to which one has come in at the other.
    template <int dim>
    double
    deepest(const MortarFace<dim> &slave, const SurfaceFace<dim> &master)
    {
      return come_in * std::min({slave.face.diameter,
                                 master.diameter,
                                 slave.face.thickness,
                                 master.thickness});
    }



    /// True if the segments of @p candidate are on the back of the body, seen
    /// from the slave face, which no deformation brings to its front.
    template <int dim>
    bool
    is_back(const MortarFace<dim>    &slave,
            const FaceCandidate<dim> &candidate,
            const MasterPatch<dim>   &patch)
    {
      const SurfaceFace<dim> &master  = patch.face(candidate.master);
      const Tensor<1, dim>   &through = candidate.through;
      const Tensor<1, dim>    n       = projection_plane(slave.face,
                                                patch.face_shape(),
                                                slave.face.undeformed_nodes())
                                 .n;
      return through * n < -deepest(slave, master) &&
             through.norm() <=
               thick * std::min(slave.face.thickness, master.thickness);
    }



    /// can_be_partners() for two faces of one body. A surface that has not met
    /// itself yet has no penetrations, and what lies far behind a face is its
    /// own body.
    template <int dim>
    bool
    can_meet(const MortarFace<dim>    &slave,
             const FaceCandidate<dim> &candidate,
             const MasterPatch<dim>   &patch)
    {
      const Depth depth = depth_of(candidate.middle, candidate.partner);
      return std::min(depth.now, depth.at_start) <=
               deepest(slave, patch.face(candidate.master)) &&
             !is_back(slave, candidate, patch);
    }



    /// True if, above the slave face, the projections @p a and @p b overlap.
    template <int dim>
    bool
    overlap(const ProjectedFace<dim> &slave,
            const ProjectedFace<dim> &a,
            const ProjectedFace<dim> &b)
    {
      double common = 0., whole = 0.;
      for (const auto &cell : slave.cells)
        {
          whole += measure<dim - 1>(cell);
          for (const auto &cell_a : a.cells)
            for (const auto &cell_b : b.cells)
              common += measure<dim - 1>(
                intersection<dim - 1>(intersection<dim - 1>(cell, cell_a),
                                      cell_b));
        }
      return common > no_overlap * whole;
    }



    /// True if candidates are farther from each other than a body is thick:
    /// they are not one surface.
    template <int dim>
    bool
    are_apart(const std::vector<FaceCandidate<dim>> &candidates,
              const MasterPatch<dim>                &patch)
    {
      if (candidates.empty())
        return false;
      const auto height = [&](const FaceCandidate<dim> &candidate) {
        return depth_of(candidate.middle, candidate.partner).now;
      };
      double low = height(candidates[0]), high = low,
             thickness = std::numeric_limits<double>::infinity();
      for (const auto &candidate : candidates)
        {
          low  = std::min(low, height(candidate));
          high = std::max(high, height(candidate));
          thickness =
            std::min(thickness, patch.face(candidate.master).thickness);
        }
      return high - low > thickness;
    }



    /// Of candidates that lie behind each other only the nearest is a partner,
    /// and none behind a body that the slave has come into.
    template <int dim>
    void
    drop_hidden(const ProjectedFace<dim>        &slave,
                const MasterPatch<dim>          &patch,
                std::vector<FaceCandidate<dim>> &candidates)
    {
      const std::vector<FaceCandidate<dim>> all = candidates;
      const auto is_hidden = [&](const FaceCandidate<dim> &candidate) {
        return std::any_of(all.begin(), all.end(), [&](const auto &entered) {
          return hides(entered.middle,
                       entered.partner,
                       candidate.partner,
                       patch) &&
                 overlap(slave, entered.projected, candidate.projected);
        });
      };
      candidates.erase(std::remove_if(candidates.begin(),
                                      candidates.end(),
                                      is_hidden),
                       candidates.end());
      std::stable_sort(candidates.begin(),
                       candidates.end(),
                       [](const auto &a, const auto &b) {
                         return a.distance < b.distance;
                       });
      std::vector<FaceCandidate<dim>> kept;
      for (const auto &candidate : candidates)
        if (std::none_of(kept.begin(), kept.end(), [&](const auto &nearer) {
              return overlap(slave, nearer.projected, candidate.projected);
            }))
          kept.push_back(candidate);
      std::sort(kept.begin(), kept.end(), [](const auto &a, const auto &b) {
        return a.master < b.master;
      });
      candidates.swap(kept);
    }
  } // namespace



  template <int dim>
  double
  covered_area(const std::vector<FaceCandidate<dim>> &candidates)
  {
    double area = 0.;
    for (const auto &candidate : candidates)
      area += candidate.area;
    return area;
  }



  template <int dim>
  SeenFrom<dim>
  look_from(const MortarFace<dim>  &slave,
            const SegmentRule<dim> &rule,
            const MasterPatch<dim> &patch)
  {
    const FaceShape<dim> &shape        = rule.slave_face_shape();
    const FaceShape<dim> &master_shape = rule.master_face_shape();
    SeenFrom<dim>         seen;
    auto                 &plane     = seen.plane;
    auto                 &projected = seen.projected;
    plane     = projection_plane(slave.face, shape, slave.positions);
    projected = project(shape, slave.positions, plane);
    const Tensor<1, dim> old_n =
      projection_plane(slave.face, shape, slave.old_positions).n;
    for (const unsigned int m : patch.faces_near(slave.positions))
      {
        const auto &nodes = patch.configuration(m).positions;
        // most faces near are beside the slave face
        if (!may_meet(projected, plane, nodes, master_shape.n_nodes()) ||
            -(projection_plane(patch.face(m), master_shape, nodes).n *
              plane.n) <= patch.tolerances.least_cosine)
          continue;
        FaceCandidate<dim> candidate;
        candidate.master    = m;
        candidate.projected = project(master_shape, nodes, plane);
        rule.add_points(plane,
                        {slave.positions, projected},
                        slave.face.reference_positions,
                        {nodes, candidate.projected},
                        0,
                        candidate.points);
        if (candidate.points.empty())
          continue;
        measure_candidate(
          slave, rule.slave_face_shape(), plane.n, old_n, patch, candidate);
        if (candidate.distance > patch.tolerances.search_distance ||
            !(patch.tolerances.is_own_master
                ? can_meet(slave, candidate, patch)
                : can_be_partners(candidate.middle, candidate.partner, patch)))
          continue;
        seen.candidates.push_back(std::move(candidate));
      }
    if (covered_area(seen.candidates) > (1. + no_overlap) * slave.area ||
        are_apart(seen.candidates, patch))
      drop_hidden(projected, patch, seen.candidates);
    return seen;
  }

#define INSTANTIATE(dim)                                                        \
  template double        covered_area(const std::vector<FaceCandidate<dim>> &); \
  template SeenFrom<dim> look_from(const MortarFace<dim> &,                     \
                                   const SegmentRule<dim> &,                    \
                                   const MasterPatch<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
