#include <stickslip/problem/overlaps_at_start.h>

#include <stickslip/contact/pairing/segment_depth.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <vector>

namespace stickslip
{
  namespace
  {
    /// A surface whose mean normal is longer is taken for flat (a sector of 28
    /// degrees has this one).
    constexpr double flat = 0.99;

    /// Surfaces conform whose distance changes from face to face by no more
    /// than this times what it does within faces.
    constexpr double conforming = 3.;

    /// Of a round surface; with few of them that distance says nothing.
    constexpr unsigned int fewest_faces = 6;



    /// How far each of @p faces, undeformed, may be from the curve that it
    /// follows: the rise of an arc over a chord with their angles to each
    /// other.
    template <int dim>
    std::vector<double>
    rises_over(const FaceShape<dim>                        &shape,
               const std::vector<const SurfaceFace<dim> *> &faces)
    {
      std::vector<Tensor<1, dim>>                   centres, normals;
      std::map<NodeName, std::vector<unsigned int>> faces_at;
      for (unsigned int f = 0; f < faces.size(); ++f)
        {
          const auto nodes = faces[f]->undeformed_nodes();
          centres.push_back(interpolate<dim>(shape.at_centre().value, nodes));
          const Tensor<1, dim> n =
            outward_normal(*faces[f],
                           surface_tangents<dim>(shape.at_centre().gradient,
                                                 nodes));
          normals.push_back(n / n.norm());
          for (unsigned int j = 0; j < faces[f]->n_nodes; ++j)
            faces_at[faces[f]->name(j)].push_back(f);
        }
      std::vector<double> rises(faces.size(), 0.);
      for (const auto &[node, around] : faces_at)
        for (const unsigned int f : around)
          for (const unsigned int g : around)
            rises[f] = std::max(rises[f],
                                std::abs((centres[g] - centres[f]) *
                                         (normals[g] - normals[f])) /
                                  8.);
      return rises;
    }



    /// Sums over slave faces that tell how facets change the overlap of round
    /// surfaces.
    template <int dim>
    struct FacetSums
    {
      double n_faces = 0., area = 0., overlap = 0.;
      double squares_of_means = 0., variation = 0.;
      double rise = 0.; ///< of both surfaces

      Tensor<1, dim> normal;

      void
      add_point(const double          weight,
                const double          depth,
                const Tensor<1, dim> &n)
      {
        area_of_face += weight;
        overlap_of_face += weight * depth;
        square_of_face += weight * depth * depth;
        normal += weight * n;
      }

      /// @p rise_of_face: of it and of what is opposite.
      void
      finish_face(const double rise_of_face)
      {
        if (area_of_face > 0.)
          {
            const double square_of_mean =
              overlap_of_face * overlap_of_face / area_of_face;
            n_faces += 1.;
            area += area_of_face;
            overlap += overlap_of_face;
            squares_of_means += square_of_mean;
            rise += area_of_face * rise_of_face;
            variation += std::max(0., square_of_face - square_of_mean);
          }
        area_of_face = overlap_of_face = square_of_face = 0.;
      }

      void
      put_into(ContactAtStart<dim> &start, const MPI_Comm &communicator)
      {
        for (double *sum :
             {&n_faces, &area, &overlap, &squares_of_means, &variation, &rise})
          *sum = Utilities::MPI::sum(*sum, communicator);
        normal = Utilities::MPI::sum(normal, communicator);
        if (n_faces < fewest_faces || normal.norm() > flat * area)
          return;
        const double mean    = overlap / area;
        const double ripple  = std::sqrt(variation / area);
        const double between = squares_of_means / area - mean * mean; // square
        // more than facets can make is the shape of the gap: of a roller in a
        // tube, the larger its faces the more
        if (between > Utilities::fixed_power<2>(conforming * ripple) ||
            ripple > rise / area)
          return;
        start.mean_overlap = mean;
        start.facet_ripple = ripple;
        start.face_size    = std::pow(area / n_faces, 1. / (dim - 1));
      }

    private:
      double area_of_face = 0., overlap_of_face = 0., square_of_face = 0.;
    };



    /// Whether facets change what the pair is at the start: not those of a
    /// smooth tool, nor gaps and overlaps that cause no stress.
    template <int dim>
    bool
    facets_count(const ContactPair<dim> &pair)
    {
      const InitialGaps &gaps = pair.parameters.initial_gaps;
      return pair.patch->tool() == nullptr &&
             gaps.treatment == InitialGapTreatment::as_meshed &&
             (!pair.parameters.is_bilateral() || gaps.ramp_time > 0.);
    }
  } // namespace



  template <int dim>
  Extremes<dim>
  look_at_segments(const ContactPair<dim> &pair,
                   const MPI_Comm         &communicator,
                   ContactAtStart<dim>    &start)
  {
    const MortarSurface<dim> &surface = *pair.mortar;
    const MasterPatch<dim>   &patch   = *pair.patch;
    std::set<FaceId>          owned; // the others are those of other ranks
    for (const auto &slave : pair.slave_faces)
      owned.insert(slave.face.id);
    std::vector<const SurfaceFace<dim> *> slaves, masters;
    for (const MortarFace<dim> &slave : surface.mortar_faces())
      slaves.push_back(&slave.face);
    if (patch.tool() == nullptr)
      for (unsigned int m = 0; m < patch.n_faces(); ++m)
        masters.push_back(&patch.face(m));
    const auto     slave_rises  = rises_over(surface.slave_shape(), slaves);
    const auto     master_rises = rises_over(patch.face_shape(), masters);
    Extremes<dim>  extremes;
    FacetSums<dim> sums;
    for (unsigned int f = 0; f < surface.mortar_faces().size(); ++f)
      {
        const MortarFace<dim>   &slave    = surface.mortar_faces()[f];
        const FaceSegments<dim> &segments = surface.segments(f);
        if (owned.count(slave.face.id) == 0)
          continue;
        double rise_opposite = 0.;
        for (const auto &point : segments.points)
          {
            if (patch.tool() == nullptr)
              rise_opposite =
                std::max(rise_opposite,
                         master_rises[segments.masters[point.master]]);
            const SegmentDepth<dim> there = segment_depth(
              surface.slave_shape(), slave, segments, point, patch);
            extremes.add(there.depth, Point<dim>(there.x));
            sums.add_point(point.weight, there.depth, there.n);
          }
        sums.finish_face(slave_rises[f] + rise_opposite);
      }
    if (facets_count(pair))
      sums.put_into(start, communicator);
    return extremes;
  }

#define INSTANTIATE(dim)                                            \
  template Extremes<dim> look_at_segments(const ContactPair<dim> &, \
                                          const MPI_Comm &,         \
                                          ContactAtStart<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
