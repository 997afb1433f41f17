#include <stickslip/solid/prescribed_displacement.h>

#include <stickslip/mesh/by_kind.h>
#include <stickslip/mesh/reference_cells.h>

#include <deal.II/base/mpi.h>

#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <sstream>
#include <utility>

namespace stickslip
{
  namespace
  {
    /// Collects the held nodes cell by cell.
    template <int dim>
    class HeldNodeCollector
    {
    public:
      HeldNodeCollector(
        const hp::MappingCollection<dim>               &mapping,
        const DoFHandler<dim>                          &dof_handler,
        const Bodies                                   &bodies,
        const std::vector<PrescribedDisplacement<dim>> &conditions,
        const double                                    time)
        : dof_handler(dof_handler)
        , bodies(bodies)
        , conditions(conditions)
        , time(time)
        , node_values(
            dof_handler.get_fe_collection(),
            [&](const FiniteElement<dim> &fe, const unsigned int kind) {
              return std::make_unique<FEValues<dim>>(
                mapping[kind],
                fe.base_element(0),
                Quadrature<dim>(fe.base_element(0).get_unit_support_points()),
                update_quadrature_points);
            })
        , face_values(
            dof_handler.get_fe_collection(),
            [&](const FiniteElement<dim> &fe, const unsigned int kind) {
              return std::make_unique<FEFaceValues<dim>>(
                mapping[kind],
                fe.base_element(0),
                gauss_quadrature<dim - 1>(faces_of<dim>(fe.reference_cell()),
                                          2),
                update_normal_vectors);
            })
      {}

      void
      collect();

      std::map<types::global_dof_index, HeldNode<dim>> nodes;
      std::string                                      error;

    private:
      using CellIterator = typename DoFHandler<dim>::active_cell_iterator;

      void
      prepare(const CellIterator &cell);

      void
      collect_body(const CellIterator &cell, const unsigned int condition);

      void
      collect_face(const CellIterator &cell,
                   const unsigned int  face,
                   const unsigned int  condition);

      /// Does the node of the prepared cell belong to this rank?
      bool
      is_of_this_rank(const unsigned int node) const
      {
        return dof_handler.locally_owned_dofs().is_element(
          dof_indices[prepared_cell->get_fe().component_to_system_index(0,
                                                                        node)]);
      }

      /// Of a face that has to be plane.
      Tensor<1, dim>
      face_normal(const CellIterator &cell,
                  const unsigned int  face,
                  const unsigned int  condition);

      /// @p normal is null unless the condition is a symmetry.
      void
      hold_node(const CellIterator   &cell,
                const unsigned int    node,
                const unsigned int    condition,
                const Tensor<1, dim> *normal);

      void
      add_normal_row(HeldNode<dim>        &node,
                     const unsigned int    condition,
                     const Tensor<1, dim> &normal);

      void
      add_component_rows(HeldNode<dim> &node, const unsigned int condition);

      void
      report(const unsigned int condition,
             const Point<dim>  &position,
             const std::string &problem);

      const DoFHandler<dim>                          &dof_handler;
      const Bodies                                   &bodies;
      const std::vector<PrescribedDisplacement<dim>> &conditions;
      const double                                    time;
      ByKind<FEValues<dim>>                           node_values;
      ByKind<FEFaceValues<dim>>                       face_values;
      std::vector<types::global_dof_index>            dof_indices;
      CellIterator                                    prepared_cell;
    };



    template <int dim>
    void
    HeldNodeCollector<dim>::collect()
    {
      for (const auto &cell : dof_handler.active_cell_iterators())
        if (!cell->is_artificial())
          for (unsigned int c = 0; c < conditions.size(); ++c)
            if (bodies.body_of(cell->material_id()) == conditions[c].body &&
                conditions[c].active.contains(time))
              {
                if (conditions[c].boundary_ids.empty())
                  collect_body(cell, c);
                else if (cell->at_boundary())
                  for (const unsigned int face : cell->face_indices())
                    if (cell->face(face)->at_boundary() &&
                        conditions[c].boundary_ids.count(
                          cell->face(face)->boundary_id()) > 0)
                      collect_face(cell, face, c);
              }
      for (auto &node : nodes)
        std::stable_sort(node.second.rows.begin(),
                         node.second.rows.end(),
                         [](const auto &a, const auto &b) {
                           return a.condition < b.condition;
                         });
    }



    template <int dim>
    void
    HeldNodeCollector<dim>::prepare(const CellIterator &cell)
    {
      if (prepared_cell.state() == IteratorState::valid &&
          prepared_cell == cell)
        return;
      prepared_cell = cell;
      node_values[cell].reinit(
        typename Triangulation<dim>::active_cell_iterator(cell));
      dof_indices.resize(cell->get_fe().n_dofs_per_cell());
      cell->get_dof_indices(dof_indices);
    }



    template <int dim>
    void
    HeldNodeCollector<dim>::collect_body(const CellIterator &cell,
                                         const unsigned int  condition)
    {
      prepare(cell);
      const unsigned int n_nodes = dof_indices.size() / dim;
      for (unsigned int a = 0; a < n_nodes; ++a)
        hold_node(cell, a, condition, nullptr);
    }



    template <int dim>
    void
    HeldNodeCollector<dim>::collect_face(const CellIterator &cell,
                                         const unsigned int  face,
                                         const unsigned int  condition)
    {
      prepare(cell);
      const FiniteElement<dim> &scalar_fe = cell->get_fe().base_element(0);
      std::vector<unsigned int> nodes_of_rank;
      for (unsigned int a = 0; a < scalar_fe.n_dofs_per_cell(); ++a)
        if (has_node_on_face(scalar_fe, a, face) && is_of_this_rank(a))
          nodes_of_rank.push_back(a);
      if (nodes_of_rank.empty()) // of a ghost cell
        return;
      const bool is_symmetry =
        conditions[condition].type == BoundaryConditionType::symmetry;
      const Tensor<1, dim> normal =
        is_symmetry ? face_normal(cell, face, condition) : Tensor<1, dim>();
      for (const unsigned int a : nodes_of_rank)
        hold_node(cell, a, condition, is_symmetry ? &normal : nullptr);
    }



    template <int dim>
    Tensor<1, dim>
    HeldNodeCollector<dim>::face_normal(const CellIterator &cell,
                                        const unsigned int  face,
                                        const unsigned int  condition)
    {
      FEFaceValues<dim> &values = face_values[cell];
      values.reinit(typename Triangulation<dim>::active_cell_iterator(cell),
                    face);
      Tensor<1, dim> normal = values.normal_vector(0);
      for (const unsigned int q : values.quadrature_point_indices())
        if ((values.normal_vector(q) - normal).norm() > 1e-4)
          report(condition,
                 cell->face(face)->center(),
                 "its boundary is not plane");

      // Boundaries along the axes hold exactly one component.
      for (unsigned int d = 0; d < dim; ++d)
        if (std::abs(normal[d]) < 1e-10)
          normal[d] = 0.;
      return normal / normal.norm();
    }



    template <int dim>
    void
    HeldNodeCollector<dim>::hold_node(const CellIterator   &cell,
                                      const unsigned int    node,
                                      const unsigned int    condition,
                                      const Tensor<1, dim> *normal)
    {
      if (!is_of_this_rank(node))
        return;
      const FiniteElement<dim>     &fe = cell->get_fe();
      const types::global_dof_index first_dof =
        dof_indices[fe.component_to_system_index(0, node)];
      const Point<dim> &position = node_values[cell].quadrature_point(node);
      if (conditions[condition].where &&
          conditions[condition].where->value(position, time) == 0.)
        return;

      const auto     known = nodes.find(first_dof);
      HeldNode<dim> &held =
        (known != nodes.end() ? known->second : nodes[first_dof]);
      if (known == nodes.end())
        {
          for (unsigned int d = 0; d < dim; ++d)
            held.dofs[d] = dof_indices[fe.component_to_system_index(d, node)];
          held.position      = position;
          held.body          = conditions[condition].body;
          held.cell_diameter = cell->diameter();
        }

      if (normal != nullptr)
        add_normal_row(held, condition, *normal);
      else
        add_component_rows(held, condition);
    }



    template <int dim>
    void
    HeldNodeCollector<dim>::add_normal_row(HeldNode<dim>        &node,
                                           const unsigned int    condition,
                                           const Tensor<1, dim> &normal)
    {
      for (const auto &row : node.rows)
        if (row.condition == condition)
          {
            const double cosine = std::abs(row.direction * normal);
            if (cosine > 1. - 1e-8)
              return; // another face of the same plane
            if (cosine > 0.87)
              report(condition, node.position, "its boundary is not plane");
          }
      node.rows.push_back({normal, 0., condition});
    }



    template <int dim>
    void
    HeldNodeCollector<dim>::add_component_rows(HeldNode<dim>     &node,
                                               const unsigned int condition)
    {
      for (const auto &row : node.rows)
        if (row.condition == condition)
          return; // seen from a neighbouring cell

      const PrescribedDisplacement<dim> &prescribed = conditions[condition];
      if (prescribed.is_coupling())
        {
          if (node.is_coupled() && node.coupling != condition)
            report(condition,
                   node.position,
                   "Boundary conditions/" + conditions[node.coupling].name +
                     " couples the same node with another point");
          node.coupling = condition;
          return;
        }
      const bool is_rigid_motion =
        prescribed.type == BoundaryConditionType::rigid_motion;
      const Tensor<1, dim> displacement =
        is_rigid_motion ? prescribed.motion.displacement(node.position, time)
                        : prescribed.value->vector(node.position, time);
      if (!std::isfinite(displacement.norm()))
        report(condition, node.position, "its value is not a number");
      for (unsigned int d = 0; d < dim; ++d)
        if (is_rigid_motion || !prescribed.value->is_free(d))
          {
            const Tensor<1, dim> direction =
              prescribed.frame ? prescribed.frame->direction(node.position, d)
                               : Point<dim>::unit_vector(d);
            if (direction.norm() == 0.)
              report(condition,
                     node.position,
                     "the axis of its cylindrical components runs through the "
                     "node");
            node.rows.push_back({direction, displacement[d], condition});
          }
    }



    template <int dim>
    void
    HeldNodeCollector<dim>::report(const unsigned int condition,
                                   const Point<dim>  &position,
                                   const std::string &problem)
    {
      if (!error.empty())
        return;
      std::ostringstream text;
      text << "Boundary conditions/" << conditions[condition].name << ": "
           << problem << " at (" << position << "), time " << time << '.';
      error = text.str();
    }
  } // namespace



  template <int dim>
  std::map<types::global_dof_index, HeldNode<dim>>
  find_held_nodes(const hp::MappingCollection<dim>               &mapping,
                  const DoFHandler<dim>                          &dof_handler,
                  const Bodies                                   &bodies,
                  const std::vector<PrescribedDisplacement<dim>> &conditions,
                  const double                                    time,
                  std::string                                    &error)
  {
    HeldNodeCollector<dim> collector(
      mapping, dof_handler, bodies, conditions, time);
    collector.collect();
    error += collector.error;
    return std::move(collector.nodes);
  }



  template std::map<types::global_dof_index, HeldNode<2>>
  find_held_nodes(const hp::MappingCollection<2> &,
                  const DoFHandler<2> &,
                  const Bodies &,
                  const std::vector<PrescribedDisplacement<2>> &,
                  const double,
                  std::string &);
  template std::map<types::global_dof_index, HeldNode<3>>
  find_held_nodes(const hp::MappingCollection<3> &,
                  const DoFHandler<3> &,
                  const Bodies &,
                  const std::vector<PrescribedDisplacement<3>> &,
                  const double,
                  std::string &);
} // namespace stickslip
