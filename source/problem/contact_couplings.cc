#include <stickslip/problem/contact_couplings.h>

#include <algorithm>
#include <unordered_map>
#include <utility>

namespace stickslip
{
  /// The faces of a patch, by the nodes that they share.
  template <int dim>
  class PatchNeighbours
  {
  public:
    explicit PatchNeighbours(const MasterPatch<dim> &patch)
      : patch(patch)
    {
      for (unsigned int f = 0; f < patch.n_faces(); ++f)
        visit_nodes(f, [&](const auto node) { faces_at[node].push_back(f); });
    }

    /// Visits the faces that share a node with face @p f, some more than
    /// once.
    template <typename Visitor>
    void
    visit(const unsigned int f, const Visitor &visitor) const
    {
      visit_nodes(f, [&](const auto node) {
        for (const unsigned int neighbour : faces_at.at(node))
          visitor(neighbour);
      });
    }

  private:
    const MasterPatch<dim> &patch;
    /// by the first displacement of a node
    std::unordered_map<types::global_dof_index, std::vector<unsigned int>>
      faces_at;

    template <typename Visitor>
    void
    visit_nodes(const unsigned int f, const Visitor &visitor) const
    {
      const SurfaceFace<dim> &face = patch.face(f);
      for (unsigned int i = 0; i < face.n_nodes; ++i)
        visitor(face.dofs[i * dim]);
    }
  };



  template <int dim>
  std::vector<types::global_dof_index>
  dofs_at(const ContactPair<dim>       &pair,
          const unsigned int            place,
          const types::global_dof_index n_displacements)
  {
    const SlaveFace<dim> &slave =
      pair.slave_faces[pair.mortar ? pair.points[place].geometry.slave_face
                                   : place];
    std::vector<types::global_dof_index> dofs =
      pair.mortar ? pair.mortar->node(place).dofs : slave.face.dofs;
    for (const auto dof : slave.multiplier_dofs)
      dofs.push_back(n_displacements + dof);
    // several images of one node have the same
    std::sort(dofs.begin(), dofs.end());
    dofs.erase(std::unique(dofs.begin(), dofs.end()), dofs.end());
    return dofs;
  }



  template <int dim>
  ContactCouplings<dim>::ContactCouplings(const ContactAssembler<dim> &contact)
    : contact(contact)
    , has_hopped(contact.contact_pairs().size(), false)
  {}



  template <int dim>
  bool
  ContactCouplings<dim>::is_coupled(const unsigned int pair,
                                    const unsigned int place) const
  {
    const auto first = last_met.lower_bound({pair, place, FaceId()});
    return first != last_met.end() && std::get<0>(first->first) == pair &&
           std::get<1>(first->first) == place;
  }



  template <int dim>
  template <typename Visitor>
  void
  ContactCouplings<dim>::visit_present(const unsigned int p,
                                       const Visitor     &visit) const
  {
    const ContactPair<dim> &pair = *contact.contact_pairs()[p];
    for (const auto &point : pair.points)
      {
        if (!point.pairing.paired)
          continue;
        if (!pair.mortar)
          {
            visit(point.geometry.slave_face, point.pairing.face);
            continue;
          }
        const unsigned int node = point.geometry.mortar_node;
        for (const unsigned int master : pair.mortar->masters_of(node))
          visit(node, master);
      }
  }



  template <int dim>
  bool
  ContactCouplings<dim>::add_present()
  {
    std::vector<Coupling> added;
    for (unsigned int p = 0; p < has_hopped.size(); ++p)
      visit_present(p, [&](const auto place, const auto master) {
        const Coupling coupling(
          p, place, contact.contact_pairs()[p]->patch->face(master).id);
        const auto known = last_met.find(coupling);
        if (known == last_met.end())
          added.push_back(coupling);
        else
          known->second = n_patterns;
      });
    for (const auto &[p, place, id] : added)
      has_hopped[p] = has_hopped[p] || is_coupled(p, place);
    for (const Coupling &coupling : added)
      last_met[coupling] = n_patterns;
    return added.empty();
  }



  template <int dim>
  void
  ContactCouplings<dim>::begin_pattern()
  {
    drop_old();
    ++n_patterns;
    make_room();
  }



  template <int dim>
  void
  ContactCouplings<dim>::drop_old()
  {
    for (auto entry = last_met.begin(); entry != last_met.end();)
      {
        const auto &[p, place, master] = entry->first;
        const MasterPatch<dim> &patch  = *contact.contact_pairs()[p]->patch;
        if (entry->second == n_patterns &&
            patch.index_of(master) < patch.n_faces())
          ++entry;
        else
          entry = last_met.erase(entry);
      }
  }



  template <int dim>
  void
  ContactCouplings<dim>::make_room()
  {
    for (unsigned int p = 0; p < has_hopped.size(); ++p)
      if (has_hopped[p])
        {
          const MasterPatch<dim>    &patch = *contact.contact_pairs()[p]->patch;
          const PatchNeighbours<dim> neighbours(patch);
          visit_present(p, [&](const auto place, const auto master) {
            neighbours.visit(master, [&](const unsigned int f) {
              last_met.try_emplace({p, place, patch.face(f).id},
                                   n_patterns - 1);
            });
          });
        }
  }



  template <int dim>
  std::vector<std::vector<types::global_dof_index>>
  ContactCouplings<dim>::coupled_dofs(
    const types::global_dof_index n_displacements) const
  {
    std::vector<std::vector<types::global_dof_index>> result;
    for (auto entry = last_met.begin(); entry != last_met.end();)
      {
        const auto [p, place, first] = entry->first;
        const ContactPair<dim> &pair = *contact.contact_pairs()[p];
        auto                    dofs = dofs_at(pair, place, n_displacements);
        bool                    is_same_place = true;
        while (is_same_place)
          {
            const auto &id = std::get<2>(entry->first);
            const auto &master =
              pair.patch->face(pair.patch->index_of(id)).dofs;
            dofs.insert(dofs.end(), master.begin(), master.end());
            ++entry;
            is_same_place = pair.mortar && entry != last_met.end() &&
                            std::get<0>(entry->first) == p &&
                            std::get<1>(entry->first) == place;
          }
        // neighbouring master faces share nodes; each may be named once
        std::sort(dofs.begin(), dofs.end());
        dofs.erase(std::unique(dofs.begin(), dofs.end()), dofs.end());
        result.push_back(std::move(dofs));
      }
    return result;
  }



#define INSTANTIATE(dim)                                 \
  template class ContactCouplings<dim>;                  \
  template std::vector<types::global_dof_index> dofs_at( \
    const ContactPair<dim> &,                            \
    const unsigned int,                                  \
    const types::global_dof_index);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
