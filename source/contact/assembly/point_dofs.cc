#include <stickslip/contact/assembly/point_dofs.h>

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

#define INSTANTIATE(dim)                                    \
  template std::vector<types::global_dof_index> point_dofs( \
    const ContactPair<dim> &,                               \
    const ContactPoint<dim> &,                              \
    const types::global_dof_index);                         \
  template void turn_images_back(const ContactPair<dim> &,  \
                                 const ContactPoint<dim> &, \
                                 Vector<double> &);         \
  template void turn_images_back(const ContactPair<dim> &,  \
                                 const ContactPoint<dim> &, \
                                 FullMatrix<double> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
