#include <stickslip/problem/problem_sparsity.h>

#include <deal.II/base/mpi.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparsity_tools.h>

#include <algorithm>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

namespace stickslip
{
  namespace
  {
    /// A mortar node, or a slave face, and a master face that it couples with.
    using PlaceAndMaster = std::pair<unsigned int, FaceId>;

    using Coupling = std::tuple<unsigned int, unsigned int, FaceId>;



    bool
    is_coupling_of(const Coupling    &coupling,
                   const unsigned int pair,
                   const unsigned int place)
    {
      const auto &[p, other_place, id] = coupling;
      return p == pair && other_place == place;
    }



    template <int dim>
    std::vector<PlaceAndMaster>
    couplings_of(const ContactPair<dim> &pair, const ContactPoint<dim> &point)
    {
      if (!pair.mortar)
        return {
          {point.geometry.slave_face, pair.patch->face(point.pairing.face).id}};
      std::vector<PlaceAndMaster> couplings;
      const unsigned int          i = point.geometry.mortar_node;
      for (const unsigned int m : pair.mortar->masters_of(i))
        couplings.emplace_back(i, pair.patch->face(m).id);
      return couplings;
    }



    /// The faces of a patch, by the nodes that they share.
    template <int dim>
    class Neighbours
    {
    public:
      explicit Neighbours(const MasterPatch<dim> &patch)
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
    const SurfaceFace<dim> &
    master_of(const Coupling &coupling, const ContactPair<dim> &pair)
    {
      const auto &[p, place, id] = coupling;
      return pair.patch->face(pair.patch->index_of(id));
    }



    /// Displacements and multipliers of a mortar node (point i is node i) or a
    /// slave face.
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
      return dofs;
    }



    /// @p displacements and those that @p constraints relate them to: nodes
    /// that hanging nodes of distant master faces hang on.
    IndexSet
    with_what_they_hang_on(IndexSet           displacements,
                           const Constraints &constraints)
    {
      std::vector<types::global_dof_index> others;
      for (const auto &line : constraints.get_lines())
        if (line.index < displacements.size())
          for (const auto &[other, weight] : line.entries)
            others.push_back(other);
      std::sort(others.begin(), others.end());
      displacements.add_indices(others.begin(), others.end());
      displacements.compress();
      return displacements;
    }
  } // namespace



  template <int dim>
  ProblemSparsity<dim>::ProblemSparsity(const DofLayout<dim>        &dofs,
                                        const ContactAssembler<dim> &contact,
                                        const MPI_Comm &communicator)
    : dofs(dofs)
    , contact(contact)
    , communicator(communicator)
  {}



  template <int dim>
  bool
  ProblemSparsity<dim>::couplings_are_known()
  {
    unsigned int n_new = 0;
    const auto  &pairs = contact.contact_pairs();
    for (unsigned int p = 0; p < pairs.size(); ++p)
      for (const auto &point : pairs[p]->points)
        if (point.pairing.paired)
          for (const auto &[place, master] : couplings_of(*pairs[p], point))
            n_new += known_couplings.emplace(p, place, master).second;
    return Utilities::MPI::sum(n_new, communicator) == 0;
  }



  template <int dim>
  void
  ProblemSparsity<dim>::drop_distant_couplings()
  {
    const auto &pairs = contact.contact_pairs();
    for (auto coupling = known_couplings.begin();
         coupling != known_couplings.end();)
      {
        const auto [p, place, master] = *coupling;
        const MasterPatch<dim> &patch = *pairs[p]->patch;
        if (patch.index_of(master) < patch.n_faces())
          ++coupling;
        else
          coupling = known_couplings.erase(coupling);
      }
  }



  template <int dim>
  void
  ProblemSparsity<dim>::add_couplings_nearby()
  {
    const auto &pairs = contact.contact_pairs();
    for (unsigned int p = 0; p < pairs.size(); ++p)
      {
        const MasterPatch<dim> &patch = *pairs[p]->patch;
        const Neighbours<dim>   neighbours(patch);
        for (const auto &point : pairs[p]->points)
          if (point.pairing.paired)
            for (const auto &[place, master] : couplings_of(*pairs[p], point))
              neighbours.visit(
                patch.index_of(master), [&](const unsigned int f) {
                  known_couplings.emplace(p, place, patch.face(f).id);
                });
      }
  }



  template <int dim>
  bool
  ProblemSparsity<dim>::update(const Constraints     &constraints,
                               LA::BlockSparseMatrix &matrix)
  {
    // Couplings are only ever added while the patches stay the same, so a node
    // that hops between facets costs one rebuild, not one per hop. Where nodes
    // do hop, more of them will: there is room for the facets around then.
    const bool are_known = couplings_are_known();
    if (are_known && !is_outdated)
      return false;
    drop_distant_couplings();
    has_hopped = has_hopped || !(are_known || is_first);
    if (has_hopped)
      add_couplings_nearby();
    is_first    = false;
    is_outdated = false;
    matrix.clear(); // not two of them at a time
    const auto                 &multipliers = contact.multipliers();
    const std::vector<IndexSet> owned       = {dofs.owned,
                                               multipliers.locally_owned()};
    const std::vector<IndexSet> writable    = {
         with_what_they_hang_on(contact.needed_displacements(), constraints),
         multipliers.locally_relevant()};
    // Trilinos' own patterns take twice as long to fill.
    BlockDynamicSparsityPattern          pattern(writable);
    std::vector<types::global_dof_index> cell_dofs(dofs.fe.n_dofs_per_cell());
    for (const auto &cell : dofs.dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          cell->get_dof_indices(cell_dofs);
          constraints.add_entries_local_to_global(cell_dofs, pattern, false);
        }
    const types::global_dof_index n_u   = dofs.owned.size();
    const auto                   &pairs = contact.contact_pairs();
    // Each master face with the nodes of its slave face; all master faces of a
    // mortar node together.
    std::vector<types::global_dof_index> coupled;
    for (auto entry = known_couplings.begin(); entry != known_couplings.end();)
      {
        const auto [p, place, first] = *entry;
        const ContactPair<dim> &pair = *pairs[p];
        coupled                      = dofs_at(pair, place, n_u);
        bool is_same_place           = true;
        while (is_same_place)
          {
            const auto &master = master_of(*entry, pair).dofs;
            coupled.insert(coupled.end(), master.begin(), master.end());
            ++entry;
            is_same_place = pair.mortar && entry != known_couplings.end() &&
                            is_coupling_of(*entry, p, place);
          }
        // neighbouring master faces share nodes; each may be named once
        std::sort(coupled.begin(), coupled.end());
        coupled.erase(std::unique(coupled.begin(), coupled.end()),
                      coupled.end());
        constraints.add_entries_local_to_global(coupled, pattern, false);
      }
    // open and unpaired points have rows of their own
    for (const auto &pair : pairs)
      {
        const unsigned int n_places =
          pair->mortar ? pair->points.size() : pair->slave_faces.size();
        for (unsigned int place = 0; place < n_places; ++place)
          constraints.add_entries_local_to_global(dofs_at(*pair, place, n_u),
                                                  pattern,
                                                  false);
      }
    for (const auto i : multipliers.locally_owned())
      pattern.block(1, 1).add(i, i);
    for (unsigned int b = 0; b < owned.size(); ++b)
      for (unsigned int c = 0; c < owned.size() && owned[b].size() > 0; ++c)
        SparsityTools::distribute_sparsity_pattern(pattern.block(b, c),
                                                   owned[b],
                                                   communicator,
                                                   writable[b]);
    matrix.reinit(owned, pattern, communicator);
    return true;
  }

  template class ProblemSparsity<2>;
  template class ProblemSparsity<3>;
} // namespace stickslip
