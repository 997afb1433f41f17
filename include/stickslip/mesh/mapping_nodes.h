#ifndef stickslip_mesh_mapping_nodes_h
#define stickslip_mesh_mapping_nodes_h

#include <deal.II/fe/mapping_q.h>

namespace stickslip
{
  using namespace dealii;

  /// Shows where MappingQ has its nodes, in the order of FE_Q.
  template <int dim>
  class MappingNodes : public MappingQ<dim>
  {
  public:
    using MappingQ<dim>::MappingQ;
    using MappingQ<dim>::compute_mapping_support_points;
  };
} // namespace stickslip

#endif
