#include <stickslip/contact/pairing/surface_sides.h>

#include <stickslip/base/over_ranks.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <utility>

namespace stickslip
{
  namespace
  {
    std::vector<SidedFace>
    merged(const std::vector<std::vector<SidedFace>> &of_ranks)
    {
      std::map<FaceId, SidedFace> faces;
      for (const auto &of_rank : of_ranks)
        for (const auto &face : of_rank)
          {
            SidedFace &known    = faces.emplace(face.id, face).first->second;
            known.may_be_slave  = known.may_be_slave || face.may_be_slave;
            known.may_be_master = known.may_be_master || face.may_be_master;
          }
      std::vector<SidedFace> result;
      for (const auto &entry : faces)
        result.push_back(entry.second);
      return result;
    }



    /// Each pair of faces once, with the smaller of its distances.
    std::vector<OppositeFaces>
    merged(const std::vector<std::vector<OppositeFaces>> &of_ranks)
    {
      std::map<std::pair<FaceId, FaceId>, double> distances;
      for (const auto &of_rank : of_ranks)
        for (const auto &both : of_rank)
          {
            const auto [entry, is_new] =
              distances.emplace(both.a < both.b
                                  ? std::make_pair(both.a, both.b)
                                  : std::make_pair(both.b, both.a),
                                both.distance);
            entry->second = std::min(entry->second, both.distance);
          }
      std::vector<OppositeFaces> result;
      for (const auto &[both, distance] : distances)
        result.push_back({both.first, both.second, distance});
      return result;
    }



    std::vector<SidedFace>
    with_side(const std::vector<SidedFace> &faces)
    {
      std::vector<SidedFace> result;
      for (const auto &face : faces)
        if (face.side != Side::neither)
          result.push_back(face);
      return result;
    }
  } // namespace



  bool
  SurfaceSides::choose(const std::vector<SidedFace>     &faces,
                       const std::vector<OppositeFaces> &opposite,
                       const MPI_Comm                   &communicator)
  {
    if (!any_rank(!opposite.empty(), communicator))
      return set({});
    auto       all = merged(Utilities::MPI::gather(communicator, faces));
    const auto all_opposite =
      merged(Utilities::MPI::gather(communicator, opposite));
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      {
        for (auto &face : all)
          face.side = side_of(face.id);
        choose_sides(all, all_opposite);
        all = with_side(all);
      }
    return set(Utilities::MPI::broadcast(communicator, all));
  }



  void
  SurfaceSides::resume(const std::vector<SidedFace> &owned,
                       const MPI_Comm               &communicator)
  {
    set(merged(Utilities::MPI::all_gather(communicator, with_side(owned))));
  }



  bool
  SurfaceSides::set(const std::vector<SidedFace> &faces)
  {
    const auto                        before = std::exchange(sides, {});
    std::set<types::global_dof_index> of_slaves;
    for (const auto &face : faces)
      {
        sides[face.id] = face.side;
        if (face.side == Side::slave)
          of_slaves.insert(face.nodes.begin(), face.nodes.end());
      }
    border.clear();
    for (const auto &face : faces)
      if (face.side == Side::master)
        for (const auto node : face.nodes)
          if (of_slaves.count(node) > 0)
            border.insert(node);
    return sides != before;
  }
} // namespace stickslip
