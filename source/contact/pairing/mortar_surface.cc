#include <stickslip/contact/pairing/mortar_surface.h>

#include <stickslip/contact/pairing/corner_cone.h>
#include <stickslip/contact/pairing/mortar_nodes.h>
#include <stickslip/contact/pairing/slave_configuration.h>
#include <stickslip/contact/pairing/symmetry_planes.h>

#include <stickslip/mesh/reference_cells.h>

#include <algorithm>
#include <set>

namespace stickslip
{
  template <int dim>
  MortarSurface<dim>::MortarSurface(
    const FaceShape<dim>                    &displacement_shape,
    const FaceShape<dim>                    &master_shape,
    const FaceShape<dim>                    &multiplier_shape,
    const ContactPairParameters             &parameters,
    const std::vector<CollectedFace<dim>>   &slaves,
    const std::vector<SlaveFace<dim>>       &owned_faces,
    const std::set<types::global_dof_index> &excluded,
    const HangingNodes                      &hanging,
    const CrossSection                      &cross_section,
    const bool                               meets_itself,
    std::vector<ContactPoint<dim>>          &points)
    : displacement_shape(displacement_shape)
    , multiplier_shape(multiplier_shape)
    , rule(displacement_shape,
           master_shape,
           parameters.quadrature_order,
           cross_section)
    , tool_rule(displacement_shape,
                multiplier_shape,
                parameters.quadrature_order,
                cross_section)
    , integrals(displacement_shape, multiplier_shape)
    , derivatives(displacement_shape, multiplier_shape)
    , cross_section(cross_section)
    , meets_itself(meets_itself)
    , may_part(!parameters.is_bilateral())
    , shares(displacement_shape, multiplier_shape)
  {
    collect_mortar_nodes(displacement_shape,
                         multiplier_shape,
                         slaves,
                         excluded,
                         hanging,
                         owned_faces,
                         points,
                         faces,
                         nodes);
    for (MortarFace<dim> &slave : faces)
      {
        slave.weighting_kind = parameters.weighting;
        slave.always_missing = slave.missing;
        slave.side           = meets_itself ? Side::neither : Side::slave;
        slave.positions      = slave.face.undeformed_nodes();
      }
    const auto weights = set_weightings();
    for (auto &node : nodes)
      for (const auto &around : node.faces)
        node.area += weights[around.face][around.multiplier];
    // what is bonded is not pressed against anything
    if (!parameters.is_bilateral())
      {
        find_corners(displacement_shape, faces, nodes);
        choose_tangent_directions(displacement_shape, faces, nodes, points);
      }
    for (auto &point : points)
      point.geometry.weight = nodes[point.geometry.mortar_node].area;
    averages.resize(nodes.size());
    shares.expect(nodes);
    current = remembered = accepted = empty_pairing();
  }



  template <int dim>
  std::vector<std::vector<double>>
  MortarSurface<dim>::set_weightings()
  {
    const auto quadrature =
      gauss_quadrature<dim - 1>(displacement_shape.reference_cell(),
                                multiplier_shape.degree() +
                                  displacement_shape.degree() + 1);
    std::vector<std::vector<double>> weights; // [face][l]
    for (MortarFace<dim> &slave : faces)
      weights.push_back(stickslip::set_weightings(displacement_shape,
                                                  multiplier_shape,
                                                  quadrature,
                                                  cross_section,
                                                  slave));
    return weights;
  }



  template <int dim>
  bool
  MortarSurface<dim>::choose_sides(const MasterPatch<dim>              &patch,
                                   const std::vector<SurfaceFace<dim>> &masters,
                                   const MPI_Comm &communicator)
  {
    std::vector<SidedFace>     known;
    std::vector<OppositeFaces> opposite;
    for (const MortarFace<dim> &slave : faces)
      {
        known.push_back(sided(slave.face, slave.side));
        known.back().may_be_slave = true;
        for (const auto &both : find_opposite(slave, rule, patch))
          opposite.push_back(both);
      }
    for (const SurfaceFace<dim> &master : masters)
      {
        known.push_back(sided(master, sides.side_of(master.id)));
        known.back().may_be_master = true;
      }
    const bool changed = sides.choose(known, opposite, communicator);
    if (changed)
      take_sides();
    return changed;
  }



  template <int dim>
  void
  MortarSurface<dim>::resume_sides(const std::vector<SidedFace> &owned,
                                   const MPI_Comm               &communicator)
  {
    sides.resume(owned, communicator);
    take_sides();
  }



  template <int dim>
  void
  MortarSurface<dim>::take_sides()
  {
    for (MortarFace<dim> &slave : faces)
      {
        slave.side    = sides.side_of(slave.face.id);
        slave.missing = slave.always_missing;
        for (unsigned int l = 0; l < multiplier_shape.n_nodes(); ++l)
          if (sides.is_on_border(
                slave.face.dofs[dim * displacement_node(displacement_shape,
                                                        multiplier_shape,
                                                        l)]))
            slave.missing.is_missing[l] = true;
      }
    set_weightings();
  }



  template <int dim>
  void
  MortarSurface<dim>::find_symmetry_planes(
    const Constraints              &supports,
    std::vector<ContactPoint<dim>> &points)
  {
    for (unsigned int i = 0; i < nodes.size(); ++i)
      {
        MortarNode<dim>        &node = nodes[i];
        std::vector<Point<dim>> positions(node.n_stencil_nodes());
        for (const auto &around : node.faces)
          for (unsigned int k = 0; k < around.stencil.size(); ++k)
            positions[around.stencil[k]] =
              faces[around.face].face.reference_positions[k];
        const unsigned int own =
          node.faces.front().stencil[node.faces.front().displacement];
        node.projection = symmetry_projection(
          positions, own, node.dofs[own * dim], node.rotation(own), supports);
        restrict_to_symmetry_planes(displacement_shape, faces, node);
        align_with_symmetry_plane(displacement_shape, faces, node, points[i]);
      }
  }



  template <int dim>
  typename MortarSurface<dim>::PairingPointer
  MortarSurface<dim>::empty_pairing() const
  {
    const auto pairing = std::make_shared<MortarPairing<dim>>();
    pairing->segments  = std::make_shared<Segments>(faces.size());
    pairing->frames.resize(nodes.size());
    return pairing;
  }



  template <int dim>
  void
  MortarSurface<dim>::update_gap_offsets(
    const std::function<double(const Point<dim> &)> &offset)
  {
    for (MortarFace<dim> &slave : faces)
      {
        slave.gap_offsets.clear();
        for (unsigned int k = 0; k < slave.face.n_nodes; ++k)
          slave.gap_offsets.push_back(
            offset(slave.face.reference_positions[k]));
      }
  }



  template <int dim>
  void
  MortarSurface<dim>::keep_partners(const bool tied)
  {
    kept = current->segments;
    for (unsigned int i = 0; i < nodes.size(); ++i)
      {
        const Tensor<1, dim> &r = averages[i].r;
        Tensor<1, dim>        along;
        along[0] = current->frames[i].n * r + averages[i].rise;
        for (unsigned int b = 0; b < dim - 1; ++b)
          along[1 + b] = current->frames[i].tau[b] * r;
        kept_positions.push_back(along);
        if (tied)
          nodes[i].tie_offset.emplace();
      }
    set_kept_share(1.);
  }



  template <int dim>
  void
  MortarSurface<dim>::set_kept_share(const double share)
  {
    for (unsigned int i = 0; i < nodes.size(); ++i)
      {
        nodes[i].gap_offset = share * kept_positions[i][0];
        if (nodes[i].tie_offset)
          for (unsigned int b = 0; b < dim - 1; ++b)
            (*nodes[i].tie_offset)[b] = share * kept_positions[i][1 + b];
      }
  }



  template <int dim>
  void
  MortarSurface<dim>::update_configuration(const LA::Vector &u,
                                           const LA::Vector &u_old)
  {
    for (MortarFace<dim> &slave : faces)
      {
        const SurfaceFace<dim> &face = slave.face;
        read_positions(face, face.n_nodes, u, slave.positions);
        read_positions(face, face.n_nodes, u_old, slave.old_positions);
      }
  }



  template <int dim>
  typename MortarSurface<dim>::SegmentsPointer
  MortarSurface<dim>::find_all_segments(const MasterPatch<dim> &patch) const
  {
    const auto segments  = std::make_shared<Segments>();
    const auto is_master = [this](const FaceId &face) {
      return sides.side_of(face) != Side::slave;
    };
    for (const MortarFace<dim> &slave : faces)
      if (patch.tool() != nullptr)
        segments->push_back(tool_rule.find_segments(slave, patch));
      else if (!meets_itself)
        segments->push_back(find_segments(slave, rule, patch));
      else if (slave.side == Side::slave)
        segments->push_back(find_segments(slave, rule, patch, is_master));
      else
        segments->emplace_back();
    return segments;
  }



  template <int dim>
  typename MortarSurface<dim>::PairingPointer
  MortarSurface<dim>::find(const MasterPatch<dim> &patch) const
  {
    const auto pairing = std::make_shared<MortarPairing<dim>>();
    pairing->segments  = kept ? kept : find_all_segments(patch);
    for (const auto &node : nodes)
      pairing->frames.push_back(
        integrals.frame_at(node, faces, *pairing->segments, patch));
    return pairing;
  }



  template <int dim>
  void
  MortarSurface<dim>::use(const PairingPointer   &pairing,
                          const MasterPatch<dim> &patch)
  {
    current              = pairing;
    const auto &segments = *current->segments;
    shares.clear();
    if (integrated != current->segments)
      {
        // Functions of the segments alone: frozen ones keep them, and which
        // nodes were far from their masters where they were found.
        integrated = current->segments;
        over_faces.clear();
        for (unsigned int f = 0; f < faces.size(); ++f)
          over_faces.push_back(
            integrals.integrate(faces[f], segments[f], patch));
        if (may_part)
          far_nodes.find(
            displacement_shape, nodes, faces, segments, over_faces, patch);
      }
    for (unsigned int i = 0; i < nodes.size(); ++i)
      averages[i] = integrals.average(
        nodes[i], !far_nodes.contain(i), faces, segments, over_faces, patch);
  }



  template <int dim>
  double
  MortarSurface<dim>::area_ratio(const unsigned int i) const
  {
    const bool paired = averages[i].paired;
    double     now = 0., undeformed = 0.;
    for (const auto &around : nodes[i].faces)
      {
        const MortarFace<dim> &slave = faces[around.face];
        const double           area =
          paired ? over_faces[around.face].area[around.multiplier] : slave.area;
        undeformed += area;
        now +=
          area *
          stickslip::area_ratio(displacement_shape.at_node(around.displacement),
                                slave.face,
                                slave.positions,
                                cross_section);
      }
    return now / undeformed;
  }



  template <int dim>
  Pairing<dim>
  MortarSurface<dim>::pairing_of(const unsigned int i) const
  {
    Pairing<dim> pairing;
    pairing.paired = averages[i].paired;
    pairing.is_far = far_nodes.contain(i);
    if (!pairing.paired)
      return pairing;
    pairing.face = averages[i].main_master;
    pairing.n    = current->frames[i].n;
    pairing.tau  = current->frames[i].tau;
    pairing.free = everywhere<dim>();
    return pairing;
  }



  template <int dim>
  void
  MortarSurface<dim>::differentiate(const unsigned int      i,
                                    const MasterPatch<dim> &patch,
                                    MortarDerivative<dim>  &derivative)
  {
    derivatives.differentiate(nodes[i],
                              averages[i],
                              current->frames[i],
                              faces,
                              *current->segments,
                              over_faces,
                              patch,
                              !keeps_partners(),
                              shares,
                              derivative);
    shares.finish_node(i);
  }



  template <int dim>
  void
  MortarSurface<dim>::relocate(const MasterPatch<dim> &patch)
  {
    remembered = relocated(*remembered, patch);
    accepted   = relocated(*accepted, patch);
  }

  template class MortarSurface<2>;
  template class MortarSurface<3>;
} // namespace stickslip
