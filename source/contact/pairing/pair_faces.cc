#include <stickslip/contact/pairing/pair_faces.h>

#include <stickslip/contact/pairing/local_thickness.h>
#include <stickslip/contact/pairing/symmetry_planes.h>
#include <stickslip/contact/surface/facet_rise.h>

#include <deal.II/base/numbers.h>

namespace stickslip
{
  namespace
  {
    /// Angle between the facets of a curved surface at most [radian]: 42
    /// degrees, so that chamfers of 45 degrees have edges, and nine facets
    /// make a circle.
    constexpr double sharpest_turn = 42. / 180. * numbers::PI;
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
    if (has_curved_facets)
      find_rises<dim>(
        shape,
        sharpest_turn,
        [this](const types::global_dof_index first) {
          return held_directions<dim>(first, supports);
        },
        communicator,
        faces);
    return faces;
  }

  template <int dim>
  void
  drop_rises_of_convex_pairs(const std::vector<CollectedFace<dim>> &masters,
                             const MPI_Comm                  &communicator,
                             std::vector<CollectedFace<dim>> &slaves)
  {
    if (!is_partly_concave(slaves, communicator) &&
        !is_partly_concave(masters, communicator))
      for (auto &slave : slaves)
        slave.face.rise.clear();
  }



  template void
  drop_rises_of_convex_pairs(const std::vector<CollectedFace<2>> &,
                             const MPI_Comm &,
                             std::vector<CollectedFace<2>> &);
  template void
  drop_rises_of_convex_pairs(const std::vector<CollectedFace<3>> &,
                             const MPI_Comm &,
                             std::vector<CollectedFace<3>> &);
  template struct PairFaceCollector<2>;
  template struct PairFaceCollector<3>;
} // namespace stickslip
