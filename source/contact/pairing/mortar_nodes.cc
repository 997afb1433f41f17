#include <stickslip/contact/pairing/mortar_nodes.h>

#include <algorithm>
#include <map>
#include <utility>

namespace stickslip
{
  namespace
  {
    /// A slave face at a multiplier node, with the numbers that it has there.
    struct Corner
    {
      unsigned int slave, multiplier, displacement;
    };



    /// Who is the first of the faces around a node, the same wherever it or one
    /// of its images is looked at.
    template <int dim>
    std::pair<FaceId, unsigned int>
    rank_of(const Corner &corner, const std::vector<CollectedFace<dim>> &slaves)
    {
      return {slaves[corner.slave].face.id.original(), corner.displacement};
    }
  } // namespace



  template <int dim>
  void
  collect_mortar_nodes(const FaceShape<dim> &displacement_shape,
                       const FaceShape<dim> &multiplier_shape,
                       const std::vector<CollectedFace<dim>>   &slaves,
                       const std::set<types::global_dof_index> &excluded,
                       const HangingNodes                      &hanging,
                       const std::vector<SlaveFace<dim>>       &owned_faces,
                       std::vector<ContactPoint<dim>>          &points,
                       std::vector<MortarFace<dim>>            &faces,
                       std::vector<MortarNode<dim>>            &nodes)
  {
    std::map<NodeName, std::vector<Corner>>           corners;
    std::vector<std::vector<types::global_dof_index>> keys(slaves.size());
    for (unsigned int s = 0; s < slaves.size(); ++s)
      for (unsigned int l = 0; l < multiplier_shape.n_nodes(); ++l)
        {
          const unsigned int j =
            displacement_node(displacement_shape, multiplier_shape, l);
          keys[s].push_back(slaves[s].face.dofs[j * dim]);
          corners[slaves[s].face.name(j)].push_back({s, l, j});
        }

    for (auto &[name, around] : corners)
      std::stable_sort(around.begin(),
                       around.end(),
                       [&](const Corner &a, const Corner &b) {
                         return rank_of(a, slaves) < rank_of(b, slaves);
                       });

    std::map<unsigned int, unsigned int> face_numbers;
    const auto                           number_of = [&](const unsigned int s) {
      const auto [entry, is_new] = face_numbers.emplace(s, faces.size());
      if (is_new)
        {
          faces.emplace_back();
          faces.back().face    = slaves[s].face;
          faces.back().missing = missing_nodes(
            keys[s], excluded, hanging, node_shared_with_parent(slaves[s]));
        }
      return entry->second;
    };
    const auto make_node = [&](const std::vector<Corner> &around) {
      MortarNode<dim>                  node;
      std::map<NodeName, unsigned int> stencil;
      for (const Corner &corner : around)
        {
          const SurfaceFace<dim> &face = slaves[corner.slave].face;
          node.faces.push_back({number_of(corner.slave),
                                corner.multiplier,
                                corner.displacement,
                                {}});
          for (unsigned int k = 0; k < face.n_nodes; ++k)
            {
              const auto [entry, is_new] =
                stencil.emplace(face.name(k), stencil.size());
              if (is_new)
                node.append(face, k);
              node.faces.back().stencil.push_back(entry->second);
            }
        }
      return node;
    };

    std::vector<ContactPoint<dim>> kept;
    for (const ContactPoint<dim> &point : points)
      {
        const SurfaceFace<dim> &own =
          owned_faces[point.geometry.slave_face].face;
        const unsigned int j =
          displacement_node(displacement_shape,
                            multiplier_shape,
                            point.geometry.quadrature_index);
        const auto &around = corners.at(own.name(j));
        // the first of the faces carries the point
        if (rank_of(around.front(), slaves) != std::make_pair(own.id, j))
          continue;
        kept.push_back(point);
        kept.back().geometry.mortar_node = nodes.size();
        nodes.push_back(make_node(around));
        MortarNode<dim> &node = nodes.back();
        node.direction.assign(node.n_stencil_nodes(), 0.);
        for (unsigned int k = 0; k < own.n_nodes; ++k)
          node.direction[node.faces.front().stencil[k]] =
            point.geometry.direction_gradients[k];
      }
    points.swap(kept);
  }

  template void
  collect_mortar_nodes(const FaceShape<2> &,
                       const FaceShape<2> &,
                       const std::vector<CollectedFace<2>> &,
                       const std::set<types::global_dof_index> &,
                       const HangingNodes &,
                       const std::vector<SlaveFace<2>> &,
                       std::vector<ContactPoint<2>> &,
                       std::vector<MortarFace<2>> &,
                       std::vector<MortarNode<2>> &);
  template void
  collect_mortar_nodes(const FaceShape<3> &,
                       const FaceShape<3> &,
                       const std::vector<CollectedFace<3>> &,
                       const std::set<types::global_dof_index> &,
                       const HangingNodes &,
                       const std::vector<SlaveFace<3>> &,
                       std::vector<ContactPoint<3>> &,
                       std::vector<MortarFace<3>> &,
                       std::vector<MortarNode<3>> &);
} // namespace stickslip
