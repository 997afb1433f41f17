#include <stickslip/solid/symmetry_cuts.h>

#include <stickslip/mesh/by_kind.h>
#include <stickslip/mesh/reference_cells.h>

#include <deal.II/base/mpi.h>

#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <vector>

namespace stickslip
{
  namespace
  {
    /// Calls @p action with the cells and numbers of all boundary faces with an
    /// id of @p boundary that this rank sees.
    template <int dim, typename Action>
    void
    for_each_face(const DoFHandler<dim>              &dof_handler,
                  const std::set<types::boundary_id> &boundary,
                  const Action                       &action)
    {
      for (const auto &cell : dof_handler.active_cell_iterators())
        if (!cell->is_artificial() && cell->at_boundary())
          for (const unsigned int f : cell->face_indices())
            if (cell->face(f)->at_boundary() &&
                boundary.count(cell->face(f)->boundary_id()) > 0)
              action(cell, f);
    }



    /// Vertices of the faces with the boundary id @p id.
    template <int dim>
    std::set<unsigned int>
    vertices_of(const DoFHandler<dim> &dof_handler, const types::boundary_id id)
    {
      std::set<unsigned int> vertices;
      for_each_face(dof_handler, {id}, [&](const auto &cell, const auto f) {
        for (const unsigned int v : cell->face(f)->vertex_indices())
          vertices.insert(cell->face(f)->vertex_index(v));
      });
      return vertices;
    }



    /// True if one of this rank's faces of @p boundary has an edge (2D: a
    /// vertex) in common with the faces that have the boundary id @p id.
    template <int dim>
    bool
    meets(const DoFHandler<dim>              &dof_handler,
          const std::set<types::boundary_id> &boundary,
          const types::boundary_id            id)
    {
      const std::set<unsigned int> vertices = vertices_of(dof_handler, id);
      bool                         found    = false;
      for_each_face(dof_handler, boundary, [&](const auto &cell, const auto f) {
        const auto  &face     = cell->face(f);
        unsigned int n_common = 0;
        for (const unsigned int v : face->vertex_indices())
          n_common += vertices.count(face->vertex_index(v));
        found = found || n_common >= dim - 1;
      });
      return found;
    }



    /// Mean outward normal of this rank's faces, times their area.
    template <int dim>
    Tensor<1, dim>
    area_vector(const hp::MappingCollection<dim> &mapping,
                const DoFHandler<dim>            &dof_handler,
                const types::boundary_id          id)
    {
      const ByKind<FEFaceValues<dim>> values_of(
        dof_handler.get_fe_collection(),
        [&](const FiniteElement<dim> &fe, const unsigned int kind) {
          return std::make_unique<FEFaceValues<dim>>(
            mapping[kind],
            fe,
            gauss_quadrature<dim - 1>(faces_of<dim>(fe.reference_cell()), 1),
            update_normal_vectors | update_JxW_values);
        });
      Tensor<1, dim> sum;
      for_each_face(dof_handler, {id}, [&](const auto &cell, const auto f) {
        if (!cell->is_locally_owned())
          return;
        FEFaceValues<dim> &values = values_of[cell];
        values.reinit(cell, f);
        for (const unsigned int q : values.quadrature_point_indices())
          sum += values.JxW(q) * values.normal_vector(q);
      });
      return sum;
    }
  } // namespace



  template <int dim>
  std::vector<Tensor<1, dim>>
  normals_of_symmetry_cuts(
    const hp::MappingCollection<dim>               &mapping,
    const DoFHandler<dim>                          &dof_handler,
    const std::set<types::boundary_id>             &boundary,
    const std::vector<PrescribedDisplacement<dim>> &conditions)
  {
    constexpr double             parallel     = 1. - 1e-8;
    const MPI_Comm               communicator = dof_handler.get_communicator();
    std::set<types::boundary_id> planes;
    for (const auto &condition : conditions)
      if (condition.type == BoundaryConditionType::symmetry &&
          condition.active.is_always())
        planes.insert(condition.boundary_ids.begin(),
                      condition.boundary_ids.end());

    std::vector<Tensor<1, dim>> normals;
    for (const types::boundary_id id : planes)
      {
        if (Utilities::MPI::max<unsigned int>(meets(dof_handler, boundary, id),
                                              communicator) == 0)
          continue;
        Tensor<1, dim> n =
          Utilities::MPI::sum(area_vector(mapping, dof_handler, id),
                              communicator);
        n /= n.norm();
        if (std::none_of(normals.begin(), normals.end(), [&](const auto &m) {
              return std::abs(n * m) > parallel;
            }))
          normals.push_back(n);
      }
    return normals;
  }

#define INSTANTIATE(dim)                                         \
  template std::vector<Tensor<1, dim>> normals_of_symmetry_cuts( \
    const hp::MappingCollection<dim> &,                          \
    const DoFHandler<dim> &,                                     \
    const std::set<types::boundary_id> &,                        \
    const std::vector<PrescribedDisplacement<dim>> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
