#include <stickslip/contact/pairing/mortar_nodes.h>

#include <map>

namespace stickslip
{
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
    struct Corner
    {
      unsigned int slave, multiplier, displacement;
    };
    std::map<types::global_dof_index, std::vector<Corner>> corners;
    std::vector<std::vector<types::global_dof_index>>      keys(slaves.size());
    for (unsigned int s = 0; s < slaves.size(); ++s)
      for (unsigned int l = 0; l < multiplier_shape.n_nodes(); ++l)
        {
          const unsigned int j =
            displacement_node(displacement_shape, multiplier_shape, l);
          keys[s].push_back(slaves[s].face.dofs[j * dim]);
          corners[keys[s].back()].push_back({s, l, j});
        }

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
      MortarNode<dim>                                 node;
      std::map<types::global_dof_index, unsigned int> stencil;
      for (const Corner &corner : around)
        {
          const SurfaceFace<dim> &face = slaves[corner.slave].face;
          node.faces.push_back({number_of(corner.slave),
                                corner.multiplier,
                                corner.displacement,
                                {}});
          for (unsigned int k = 0; k < face.n_nodes; ++k)
            {
              const auto first = face.dofs.begin() + k * dim;
              const auto [entry, is_new] =
                stencil.emplace(*first, stencil.size());
              if (is_new)
                node.dofs.insert(node.dofs.end(), first, first + dim);
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
        const auto &around = corners.at(own.dofs[j * dim]);
        // the first of the faces, which are sorted, carries the point
        if (!(slaves[around.front().slave].face.id == own.id))
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
