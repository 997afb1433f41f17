#include <stickslip/contact/pairing/contact_pair.h>

#include <stickslip/base/user_error.h>
#include <stickslip/mesh/reference_cells.h>

#include <stickslip/contact/pairing/pair_faces.h>
#include <stickslip/contact/pairing/partner_search.h>
#include <stickslip/contact/point/contact_points.h>
#include <stickslip/contact/point/handed_over_points.h>
#include <stickslip/contact/point/multiplier_shape.h>
#include <stickslip/contact/surface/contact_quadrature.h>
#include <stickslip/contact/surface/excluded_nodes.h>

#include <deal.II/base/mpi.h>

#include <algorithm>

namespace stickslip
{
  template <int dim>
  ContactPair<dim>::ContactPair(
    const std::string                                     &name,
    const ContactPairParameters                           &parameters,
    const PairSurfaces                                    &surfaces,
    const hp::MappingCollection<dim>                      &mapping,
    const DoFHandler<dim>                                 &dof_handler,
    const Constraints                                     &supports,
    const std::function<double(const types::material_id)> &modulus,
    const ToolMaster<dim>                                 &tool,
    const std::shared_ptr<const PeriodicImages<dim>>      &images,
    const MPI_Comm                                        &communicator)
    : parameters(parameters)
    , name(name)
    , surfaces(surfaces)
    , displacement_shape(dof_handler.get_fe().degree,
                         faces_of<dim>(surfaces.slave_cells))
    , multiplier_shape(make_multiplier_shape(parameters,
                                             displacement_shape,
                                             path(),
                                             surfaces.cross_section))
    , images(images)
    , gap_offsets(parameters, path())
    , communicator(communicator)
  {
    if (meets_itself())
      parameters.check_self_contact(path());
    const FaceShape<dim>   master_shape(displacement_shape.degree(),
                                      faces_of<dim>(surfaces.master_cells));
    PairFaceCollector<dim> collector{
      mapping, dof_handler, supports, modulus, surfaces.cross_section, *images};
    collector.has_curved_facets = parameters.has_curved_facets();
    auto slaves                 = collector.collect(surfaces.slave,
                                    surfaces.slave_body,
                                    displacement_shape,
                                    communicator);
    images->check_slave(path(),
                        surfaces.master_number,
                        surfaces.slave_number,
                        slaves);
    collector.has_curved_facets &= !tool.tool;
    auto masters = collector.collect(surfaces.master,
                                     surfaces.master_body,
                                     master_shape,
                                     communicator);
    set_rises_of_convex_pairs(
      master_shape, masters, displacement_shape, *images, communicator, slaves);
    if (parameters.has_smoothed_normals() && !tool.tool)
      add_nodal_normals(masters,
                        master_shape,
                        parameters.smoothing_angle * numbers::PI / 180.);
    std::vector<SurfaceFace<dim>> owned_masters = tool.owned_frame;
    for (const auto &face : masters)
      if (!tool.tool && face.is_owned())
        owned_masters.push_back(face.face);

    for (const auto &slave : slaves)
      if (slave.is_owned())
        {
          slave_faces.push_back({slave.face, {}});
          largest_slave_diameter =
            std::max(largest_slave_diameter, slave.face.diameter);
        }
    largest_slave_diameter =
      Utilities::MPI::max(largest_slave_diameter, communicator);
    softest_modulus =
      Utilities::MPI::min(std::min(softest_modulus_of(slaves, modulus),
                                   softest_modulus_of(masters, modulus)),
                          communicator);
    margin = 0.5 * largest_slave_diameter;
    const PairingTolerances tolerances{parameters.search_distance > 0.
                                         ? parameters.search_distance
                                         : 4. * largest_slave_diameter,
                                       parameters.projection_tolerance,
                                       parameters.facet_overlap,
                                       parameters.end_overlap,
                                       parameters.least_cosine,
                                       meets_itself()};
    const MasterImages<dim> repeated{images,
                                     images->images_of(surfaces.master_number,
                                                       masters)};
    patch = std::make_unique<MasterPatch<dim>>(owned_masters,
                                               master_shape,
                                               tolerances,
                                               communicator,
                                               tool.tool,
                                               repeated);

    excluded = excluded_slave_nodes(slaves,
                                    surfaces.excluded,
                                    parameters.excluded_points,
                                    path() + "/Excluded points",
                                    *images,
                                    mapping,
                                    dof_handler,
                                    communicator);
    excluded.merge(std::set(surfaces.excluded_nodes));
    hanging =
      HangingNodes::find(dof_handler, multiplier_shape.degree(), slaves);
    const Quadrature<dim - 1> quadrature =
      contact_quadrature(parameters.quadrature,
                         parameters.quadrature_order,
                         multiplier_shape,
                         path());
    check_multipliers_are_determined(quadrature, multiplier_shape, path());
    table =
      SlaveShapeTable<dim>(displacement_shape, multiplier_shape, quadrature);
    points = make_contact_points(quadrature,
                                 displacement_shape,
                                 multiplier_shape,
                                 table,
                                 slave_faces,
                                 slaves,
                                 excluded,
                                 surfaces.cross_section);
    hand_over_points(hanging,
                     dof_handler,
                     multiplier_keys(),
                     multiplier_shape.n_nodes(),
                     parameters,
                     path(),
                     points);
    if (parameters.has_segments())
      mortar = std::make_unique<MortarSurface<dim>>(displacement_shape,
                                                    master_shape,
                                                    multiplier_shape,
                                                    parameters,
                                                    slaves,
                                                    slave_faces,
                                                    excluded,
                                                    hanging,
                                                    surfaces.cross_section,
                                                    meets_itself(),
                                                    points);
  }



  template <int dim>
  std::vector<types::global_dof_index>
  ContactPair<dim>::multiplier_keys() const
  {
    std::vector<types::global_dof_index> keys;
    for (const auto &slave : slave_faces)
      for (unsigned int l = 0; l < multiplier_shape.n_nodes(); ++l)
        keys.push_back(
          slave.face.dofs[dim * displacement_node(
                                  displacement_shape, multiplier_shape, l)]);
    return keys;
  }



  template <int dim>
  void
  ContactPair<dim>::set_multiplier_dofs(const MultiplierNumbering &numbering,
                                        const unsigned int         pair_index)
  {
    const auto         keys = multiplier_keys();
    const unsigned int n    = multiplier_shape.n_nodes();
    for (unsigned int f = 0; f < slave_faces.size(); ++f)
      for (unsigned int j = 0; j < n; ++j)
        {
          const auto first = numbering.first_dof(pair_index, keys[f * n + j]);
          for (unsigned int c = 0; c < n_multiplier_components(); ++c)
            slave_faces[f].multiplier_dofs.push_back(first + c);
        }
  }



  template <int dim>
  bool
  ContactPair<dim>::update_patch(const LA::Vector &u, const bool force)
  {
    if (mortar && mortar->keeps_partners())
      return false;
    slave_nodes.read(searching_faces(), u);
    std::vector<const SurfaceFace<dim> *> masters;
    for (const auto &face : patch->owned_faces())
      masters.push_back(&face);
    master_nodes.read(masters, u);
    const double motion =
      std::max(slave_nodes.largest_motion(), master_nodes.largest_motion());
    if (!force && Utilities::MPI::max(motion, communicator) <= 0.5 * margin)
      return false;

    slave_nodes.remember();
    master_nodes.remember();
    const bool changed = patch->fetch(slave_nodes.boxes(), u, margin);
    if (!changed && !force)
      return false;
    // after a restart the points know their faces by name only
    for (auto &point : points)
      point.hysteresis.relocate(
        [this](Pairing<dim> &pairing) { patch->relocate(pairing); });
    if (mortar)
      mortar->relocate(*patch);
    return changed;
  }



  template <int dim>
  std::vector<const SurfaceFace<dim> *>
  ContactPair<dim>::searching_faces() const
  {
    std::vector<const SurfaceFace<dim> *> faces;
    if (mortar)
      for (const auto &slave : mortar->mortar_faces())
        faces.push_back(&slave.face);
    else
      for (const auto &slave : slave_faces)
        faces.push_back(&slave.face);
    return faces;
  }



  template <int dim>
  void
  ContactPair<dim>::update_configuration(const LA::Vector &u,
                                         const LA::Vector &u_old)
  {
    slave_configuration.update(slave_faces, u, u_old);
    patch->update(u, u_old);
    if (mortar)
      mortar->update_configuration(u, u_old);
  }



  template <int dim>
  Pairing<dim>
  ContactPair<dim>::find_pairing(const ContactPoint<dim> &point) const
  {
    const SlavePosition<dim>  slave = slave_position(point);
    const unsigned int        f     = point.geometry.slave_face;
    const SearchingPoint<dim> searching{slave.x,
                                        slave.x_old,
                                        slave_configuration.normal(slave_faces,
                                                                   table,
                                                                   point),
                                        slave_faces[f].face.thickness,
                                        &slave_positions(f)};
    Pairing<dim>              pairing = find_partner(*patch,
                                        searching,
                                        point.hysteresis.last(),
                                        point.hysteresis.retention());
    if (pairing.paired)
      pairing.tau = tangent_basis<dim>(pairing.n, slave.direction);
    return pairing;
  }



  template <int dim>
  Pairing<dim>
  ContactPair<dim>::last_pairing(const ContactPoint<dim> &point) const
  {
    Pairing<dim> pairing = point.hysteresis.last();
    pairing.paired       = pairing.paired && patch->contains(pairing);
    return pairing;
  }



  template <int dim>
  FoundPairings<dim>
  ContactPair<dim>::find_pairings() const
  {
    FoundPairings<dim> found;
    if (mortar)
      found.segments = mortar->find(*patch);
    else
      for (const auto &point : points)
        found.points.push_back(find_pairing(point));
    return found;
  }



  template <int dim>
  FoundPairings<dim>
  ContactPair<dim>::last_pairings() const
  {
    FoundPairings<dim> found;
    if (mortar)
      found.segments = mortar->last();
    else
      for (const auto &point : points)
        found.points.push_back(last_pairing(point));
    return found;
  }



  template <int dim>
  void
  ContactPair<dim>::use_pairings(const FoundPairings<dim> &pairings)
  {
    if (mortar)
      mortar->use(pairings.segments, *patch);
    for (unsigned int i = 0; i < points.size(); ++i)
      points[i].pairing = mortar
                            ? mortar->pairing_of(points[i].geometry.mortar_node)
                            : pairings.points[i];
  }



  template <int dim>
  void
  ContactPair<dim>::accept_iterate(const bool find_again)
  {
    if (mortar)
      mortar->accept_iterate();
    else
      for (auto &point : points)
        if (point.hysteresis.accept_iterate(point.pairing) && find_again)
          point.pairing = find_pairing(point);
  }



  template <int dim>
  void
  ContactPair<dim>::accept_step()
  {
    if (mortar)
      mortar->accept_step();
    else
      for (auto &point : points)
        point.hysteresis.accept_step(point.pairing);
  }



  template <int dim>
  void
  ContactPair<dim>::restore()
  {
    if (mortar)
      mortar->restore();
    else
      for (auto &point : points)
        point.hysteresis.restore();
    use_pairings(last_pairings());
  }



  template <int dim>
  bool
  ContactPair<dim>::choose_sides()
  {
    const bool changed =
      mortar->choose_sides(*patch, patch->owned_faces(), communicator);
    for (auto &slave : slave_faces)
      slave.side = mortar->side_of(slave.face.id);
    return changed;
  }



  template <int dim>
  void
  ContactPair<dim>::share_sides()
  {
    std::vector<SidedFace> owned;
    for (const auto &slave : slave_faces)
      owned.push_back(sided(slave.face, slave.side));
    mortar->resume_sides(owned, communicator);
  }



  template class ContactPair<2>;
  template class ContactPair<3>;
} // namespace stickslip
