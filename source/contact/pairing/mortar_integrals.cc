#include <stickslip/contact/pairing/mortar_integrals.h>

#include <stickslip/contact/pairing/corner_normals.h>
#include <stickslip/contact/pairing/corner_tangents.h>
#include <stickslip/contact/surface/facet_rise.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace stickslip
{
  namespace
  {
    /// A node with less of its area opposite a master has no partner.
    constexpr double least_share = 0.01;

    /// Nor has one whose average may exceed the values that it is an average of
    /// by more than this factor. Where little of a face has a master opposite,
    /// dual functions (and standard ones of degree 2) extrapolate to nodes far
    /// from it. Whole faces: 1.7 per direction with degree 1, 2.2 with
    /// degree 2.
    constexpr double largest_amplification = 20.;



    /// An integral of psi_l N_k that is less than this fraction of that of
    /// |psi_l| is roundoff of zero, as it is for other nodes where psi_l is
    /// dual. write_rows() spares the rows of zeros.
    constexpr double roundoff = 1e-14;



    /// The weighting functions on the part of a face that has a master.
    template <int dim>
    FullMatrix<double>
    weighting_on(const MortarFace<dim>                &slave,
                 const FaceShape<dim>                 &multiplier_shape,
                 const std::vector<SegmentPoint<dim>> &points)
    {
      std::vector<Point<dim - 1>> places;
      std::vector<double>         areas;
      for (const auto &point : points)
        {
          places.push_back(point.xi);
          areas.push_back(point.weight);
        }
      return weighting_functions<dim>(slave.weighting_kind,
                                      multiplier_shape,
                                      slave.missing,
                                      Quadrature<dim - 1>(places),
                                      areas);
    }



    /// The gap that @p slave is to keep where its shape functions are @p N.
    template <int dim>
    double
    kept_gap(const MortarFace<dim> &slave, const std::vector<double> &N)
    {
      return slave.gap_offsets.empty()
               ? 0.
               : std::inner_product(N.begin(),
                                    N.end(),
                                    slave.gap_offsets.begin(),
                                    0.);
    }



    /// The weighting functions of a face. Few points of it may be opposite a
    /// tool: they are not made dual there.
    template <int dim>
    FullMatrix<double>
    weighting_of(const MortarFace<dim>   &slave,
                 const FaceSegments<dim> &segments,
                 const FaceShape<dim>    &multiplier_shape)
    {
      return segments.is_partial ? slave.extended
             : segments.ends.empty()
               ? slave.weighting
               : weighting_on(slave, multiplier_shape, segments.points);
    }
  } // namespace


  /// psi_l from the values @p L of the multipliers' shape functions.
  double
  combination(const FullMatrix<double>  &weighting,
              const unsigned int         l,
              const std::vector<double> &L)
  {
    double psi = 0.;
    for (unsigned int m = 0; m < L.size(); ++m)
      psi += weighting(l, m) * L[m];
    return psi;
  }



  template <int dim>
  MortarIntegrals<dim>::MortarIntegrals(
    const FaceShape<dim> &displacement_shape,
    const FaceShape<dim> &multiplier_shape)
    : displacement_shape(displacement_shape)
    , multiplier_shape(multiplier_shape)
  {}



  template <int dim>
  MortarFrame<dim>
  MortarIntegrals<dim>::frame_at(const MortarNode<dim>                &node,
                                 const std::vector<MortarFace<dim>>   &faces,
                                 const std::vector<FaceSegments<dim>> &segments,
                                 const MasterPatch<dim> &patch) const
  {
    MortarFrame<dim> frame;
    const auto       find_normal_of_corner = [&] {
      return patch.tool() != nullptr
                     ? find_tool_normal(node, faces, segments, patch, frame)
                     : find_corner_normal(
                   displacement_shape, node, faces, segments, patch, frame);
    };
    if (!node.is_corner || !find_normal_of_corner())
      average_normals(node, faces, frame);
    frame.tau = tangent_basis<dim>(frame.n, tangent_direction(node, faces));
    return frame;
  }



  template <int dim>
  bool
  MortarIntegrals<dim>::find_tool_normal(
    const MortarNode<dim>                &node,
    const std::vector<MortarFace<dim>>   &faces,
    const std::vector<FaceSegments<dim>> &segments,
    const MasterPatch<dim>               &patch,
    MortarFrame<dim>                     &frame) const
  {
    Tensor<1, dim>      sum;
    std::vector<double> L;
    MasterPoint<dim>    on_tool;
    for (const auto &around : node.faces)
      for (const auto &point : segments[around.face].points)
        {
          multiplier_shape.evaluate_values(point.xi, L);
          patch.tool()->evaluate(patch.configuration(0).positions,
                                 point.chart,
                                 point.eta,
                                 on_tool);
          sum += point.weight *
                 combination(weighting_of(faces[around.face],
                                          segments[around.face],
                                          multiplier_shape),
                             around.multiplier,
                             L) *
                 on_tool.n;
        }
    sum                 = node.projection * sum;
    const double length = sum.norm();
    if (length < least_share * node.area)
      return false;
    frame.n            = sum / length;
    frame.length       = length;
    frame.is_of_corner = true;
    return true;
  }



  template <int dim>
  void
  MortarIntegrals<dim>::average_normals(
    const MortarNode<dim>              &node,
    const std::vector<MortarFace<dim>> &faces,
    MortarFrame<dim>                   &frame) const
  {
    const bool all_are_masters = // and the frame is of no use
      std::none_of(node.faces.begin(), node.faces.end(), [&](const auto &a) {
        return faces[a.face].counts_for_normals();
      });
    for (const auto &around : node.faces)
      {
        const MortarFace<dim> &slave = faces[around.face];
        if (!slave.counts_for_normals() && !all_are_masters)
          continue;
        const Tensor<1, dim> v =
          -slave.face.orientation *
          surface_normal<dim>(surface_tangents<dim>(
            displacement_shape.at_node(around.displacement).gradient,
            slave.positions));
        frame.n += v / v.norm();
      }
    frame.n      = node.projection * frame.n;
    frame.length = frame.n.norm();
    frame.n /= frame.length;
  }



  template <int dim>
  FaceIntegrals<dim>
  MortarIntegrals<dim>::integrate(const MortarFace<dim>   &slave,
                                  const FaceSegments<dim> &segments,
                                  const MasterPatch<dim>  &patch) const
  {
    const unsigned int n_multipliers = multiplier_shape.n_nodes();
    const unsigned int n_nodes       = displacement_shape.n_nodes();
    const unsigned int n_master      = patch.n_face_nodes();
    FaceIntegrals<dim> integrals;
    integrals.area.assign(n_multipliers, 0.);
    integrals.variation.assign(n_multipliers, 0.);
    integrals.rise.assign(n_multipliers, 0.);
    integrals.depth.assign(n_multipliers, 0.);
    integrals.D.reinit(n_multipliers, n_nodes);
    integrals.M.assign(segments.masters.size(),
                       FullMatrix<double>(n_multipliers, n_master));
    integrals.weighting = weighting_of(slave, segments, multiplier_shape);
    const Tensor<1, dim> outward = outward_normal(
      slave.face,
      surface_tangents<dim>(displacement_shape.at_centre().gradient,
                            slave.positions));
    const Tensor<1, dim> normal = outward / outward.norm();
    std::vector<double>  L, N, N_master;
    for (const auto &point : segments.points)
      {
        multiplier_shape.evaluate_values(point.xi, L);
        displacement_shape.evaluate_values(point.xi, N);
        patch.evaluate_values(point.chart, point.eta, N_master);
        const unsigned int m = segments.masters[point.master];
        const double       rise =
          rise_between(slave.face, point.xi, patch.face(m), point.eta);
        const double depth =
          normal *
            (interpolate<dim>(N, slave.positions) -
             interpolate<dim>(N_master, patch.configuration(m).positions)) +
          rise - kept_gap(slave, N);
        integrals.deepest = std::max(integrals.deepest, depth);
        for (unsigned int l = 0; l < n_multipliers; ++l)
          {
            const double psi =
              point.weight * combination(integrals.weighting, l, L);
            if (psi == 0.)
              continue;
            integrals.area[l] += psi;
            integrals.variation[l] += std::abs(psi);
            integrals.rise[l] += psi * rise;
            integrals.depth[l] += psi * depth;
            for (unsigned int k = 0; k < n_nodes; ++k)
              integrals.D(l, k) += psi * N[k];
            for (unsigned int k = 0; k < n_master; ++k)
              integrals.M[point.master](l, k) += psi * N_master[k];
          }
      }
    return integrals;
  }



  template <int dim>
  MortarAverage<dim>
  MortarIntegrals<dim>::average(
    const MortarNode<dim>                 &node,
    const bool                             reached,
    const std::vector<MortarFace<dim>>    &faces,
    const std::vector<FaceSegments<dim>>  &segments,
    const std::vector<FaceIntegrals<dim>> &integrals,
    const MasterPatch<dim>                &patch) const
  {
    MortarAverage<dim> average;
    average.D.assign(node.n_stencil_nodes(), 0.);
    double variation = 0.;
    for (const auto &around : node.faces)
      {
        average.area += integrals[around.face].area[around.multiplier];
        variation += integrals[around.face].variation[around.multiplier];
      }
    average.paired = reached && average.area > least_share * node.area &&
                     variation < largest_amplification * average.area;
    if (!average.paired)
      return average;

    average.slave_positions.resize(node.n_stencil_nodes());
    average.slave_motions.resize(node.n_stencil_nodes());
    average.slave_gap_offsets.assign(node.n_stencil_nodes(), node.gap_offset);
    std::map<NodeName, unsigned int> numbers;
    std::map<unsigned int, double>   shares; // of master faces
    for (const auto &around : node.faces)
      {
        const MortarFace<dim>    &slave    = faces[around.face];
        const FaceIntegrals<dim> &integral = integrals[around.face];
        average.rise += integral.rise[around.multiplier];
        for (unsigned int k = 0; k < slave.face.n_nodes; ++k)
          {
            const double D = integral.D(around.multiplier, k);
            average.D[around.stencil[k]] += D;
            average.slave_positions[around.stencil[k]] = slave.positions[k];
            average.slave_motions[around.stencil[k]] =
              slave.positions[k] - slave.old_positions[k];
            if (!slave.gap_offsets.empty())
              average.slave_gap_offsets[around.stencil[k]] =
                node.gap_offset + slave.gap_offsets[k];
            average.x += D * slave.positions[k];
            average.w += D * (slave.positions[k] - slave.old_positions[k]);
            if (!slave.gap_offsets.empty())
              average.gap_offset += D * slave.gap_offsets[k];
          }
        for (unsigned int i = 0; i < integral.M.size(); ++i)
          {
            const unsigned int      m      = segments[around.face].masters[i];
            const SurfaceFace<dim> &master = patch.face(m);
            for (unsigned int k = 0; k < master.n_nodes; ++k)
              {
                const double M = integral.M[i](around.multiplier, k);
                shares[m] += M;
                const auto [position, is_new] =
                  numbers.emplace(master.name(k), numbers.size());
                if (is_new)
                  {
                    average.masters.append(master, k);
                    const auto &now = patch.configuration(m).positions[k];
                    average.M.push_back(0.);
                    average.master_positions.push_back(now);
                    average.master_motions.push_back(
                      now - patch.old_configuration(m).positions[k]);
                  }
                average.M[position->second] += M;
              }
          }
      }
    for (double &D : average.D)
      if (std::abs(D) < roundoff * variation)
        D = 0.;
    average.r = average.x;
    for (unsigned int l = 0; l < average.n_master_nodes(); ++l)
      {
        average.r -= average.M[l] * average.master_positions[l];
        average.w -= average.M[l] * average.master_motions[l];
      }
    average.x /= average.area;
    average.r /= average.area;
    average.w /= average.area;
    average.rise /= average.area;
    average.gap_offset =
      average.gap_offset / average.area + node.gap_offset - average.rise;
    average.main_master =
      std::max_element(shares.begin(), shares.end(), [](auto &a, auto &b) {
        return a.second < b.second;
      })->first;
    return average;
  }

  template struct FaceIntegrals<2>;
  template struct FaceIntegrals<3>;
  template class MortarIntegrals<2>;
  template class MortarIntegrals<3>;
} // namespace stickslip
