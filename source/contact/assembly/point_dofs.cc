#include <stickslip/contact/assembly/point_dofs.h>

#include <map>

namespace stickslip
{
  namespace
  {
    /// Slave nodes and master stencil of a point; nullptr: it has no partner.
    template <int dim>
    struct PointNodes
    {
      const StencilNodes<dim> *slave;
      const StencilNodes<dim> *master;
    };



    template <int dim>
    PointNodes<dim>
    nodes_of(const ContactPair<dim> &pair, const ContactPoint<dim> &point)
    {
      if (pair.mortar)
        {
          const unsigned int i = point.geometry.mortar_node;
          return {&pair.mortar->node(i), &pair.mortar->average(i).masters};
        }
      return {&pair.slave_faces[point.geometry.slave_face].face,
              point.pairing.paired ? &pair.patch->face(point.pairing.face)
                                   : nullptr};
    }



    template <int dim, typename Local>
    void
    turn_back(const PointNodes<dim> &nodes, Local &local)
    {
      nodes.slave->turn_back(0, local);
      if (nodes.master != nullptr)
        nodes.master->turn_back(nodes.slave->dofs.size(), local);
    }
  } // namespace



  template <int dim>
  std::vector<types::global_dof_index>
  point_dofs(const ContactPair<dim>       &pair,
             const ContactPoint<dim>      &point,
             const types::global_dof_index n_displacements)
  {
    const PointNodes<dim> nodes = nodes_of(pair, point);
    auto                  dofs  = nodes.slave->dofs;
    if (nodes.master != nullptr)
      dofs.insert(dofs.end(),
                  nodes.master->dofs.begin(),
                  nodes.master->dofs.end());
    const auto &all =
      pair.slave_faces[point.geometry.slave_face].multiplier_dofs;
    auto first = all.begin(), last = all.end();
    if (pair.mortar)
      {
        const unsigned int n = pair.n_multiplier_components();
        first += point.geometry.quadrature_index * n;
        last = first + n;
      }
    for (auto dof = first; dof != last; ++dof)
      dofs.push_back(n_displacements + *dof);
    return dofs;
  }



  template <int dim>
  void
  turn_images_back(const ContactPair<dim>  &pair,
                   const ContactPoint<dim> &point,
                   Vector<double>          &local)
  {
    turn_back(nodes_of(pair, point), local);
  }



  template <int dim>
  void
  turn_images_back(const ContactPair<dim>  &pair,
                   const ContactPoint<dim> &point,
                   FullMatrix<double>      &local)
  {
    turn_back(nodes_of(pair, point), local);
  }



  template <int dim>
  void
  merge_images(const ContactPair<dim>               &pair,
               const ContactPoint<dim>              &point,
               std::vector<types::global_dof_index> &dofs,
               Vector<double>                       &local,
               FullMatrix<double>                   &local_matrix)
  {
    const PointNodes<dim> nodes = nodes_of(pair, point);
    if (nodes.slave->images.empty() &&
        (nodes.master == nullptr || nodes.master->images.empty()))
      return;
    std::map<types::global_dof_index, unsigned int> numbers;
    std::vector<unsigned int>                       number;
    std::vector<types::global_dof_index>            once;
    for (const auto dof : dofs)
      {
        const auto [entry, is_new] = numbers.emplace(dof, once.size());
        if (is_new)
          once.push_back(dof);
        number.push_back(entry->second);
      }
    if (once.size() == dofs.size())
      return;
    Vector<double>     sum(once.size());
    FullMatrix<double> sums(once.size(), once.size());
    for (unsigned int i = 0; i < dofs.size(); ++i)
      {
        sum[number[i]] += local[i];
        for (unsigned int k = 0; k < dofs.size(); ++k)
          sums(number[i], number[k]) += local_matrix(i, k);
      }
    dofs.swap(once);
    local        = sum;
    local_matrix = sums;
  }

#define INSTANTIATE(dim)                                             \
  template std::vector<types::global_dof_index> point_dofs(          \
    const ContactPair<dim> &,                                        \
    const ContactPoint<dim> &,                                       \
    const types::global_dof_index);                                  \
  template void turn_images_back(const ContactPair<dim> &,           \
                                 const ContactPoint<dim> &,          \
                                 Vector<double> &);                  \
  template void turn_images_back(const ContactPair<dim> &,           \
                                 const ContactPoint<dim> &,          \
                                 FullMatrix<double> &);              \
  template void merge_images(const ContactPair<dim> &,               \
                             const ContactPoint<dim> &,              \
                             std::vector<types::global_dof_index> &, \
                             Vector<double> &,                       \
                             FullMatrix<double> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
