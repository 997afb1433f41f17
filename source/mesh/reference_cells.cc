#include <stickslip/mesh/reference_cells.h>

#include <stickslip/base/over_ranks.h>
#include <stickslip/base/user_error.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/quadrature_lib.h>

#include <deal.II/fe/fe_dgq.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_simplex_p.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/mapping_fe.h>
#include <deal.II/fe/mapping_q.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

namespace stickslip
{
  template <int dim>
  ReferenceCell
  reference_cell_of(const Triangulation<dim> &triangulation)
  {
    const auto &cells = triangulation.get_reference_cells();
    AssertDimension(cells.size(), 1);
    return cells.front();
  }



  template <int dim>
  std::vector<ReferenceCell>
  kinds_of_cells(const Triangulation<dim> &triangulation)
  {
    bool has_simplices = false, has_others = false;
    // not get_reference_cells(): in deal.II 9.4 ranks of a fully distributed
    // triangulation may miss a kind that they have
    for (const auto &cell : triangulation.active_cell_iterators())
      (cell->reference_cell().is_simplex() ? has_simplices : has_others) = true;
    const MPI_Comm             communicator = triangulation.get_communicator();
    std::vector<ReferenceCell> kinds;
    if (any_rank(has_others, communicator))
      kinds.push_back(ReferenceCells::get_hypercube<dim>());
    if (any_rank(has_simplices, communicator))
      kinds.push_back(ReferenceCells::get_simplex<dim>());
    return kinds;
  }



  template <int dim>
  ReferenceCell
  faces_of(const ReferenceCell &cell)
  {
    return cell.is_simplex() ? ReferenceCells::get_simplex<dim - 1>()
                             : ReferenceCells::get_hypercube<dim - 1>();
  }



  std::string
  plural(const ReferenceCell &cell)
  {
    return cell == ReferenceCells::Triangle      ? "triangles"
           : cell == ReferenceCells::Tetrahedron ? "tetrahedra"
           : cell == ReferenceCells::Hexahedron  ? "hexahedra"
                                                 : "quadrilaterals";
  }



  template <int dim>
  std::unique_ptr<FiniteElement<dim>>
  make_element(const ReferenceCell &cell, const unsigned int degree)
  {
    constexpr unsigned int highest_of_simplices = 2; // in deal.II
    if (!cell.is_simplex())
      return std::make_unique<FE_Q<dim>>(degree);
    if (degree > highest_of_simplices)
      throw UserError("Degree is " + std::to_string(degree) +
                      ", but there are bodies of " + plural(cell) +
                      ": these have degree 1 or 2.");
    return std::make_unique<FE_SimplexP<dim>>(degree);
  }



  template <int dim>
  hp::FECollection<dim>
  make_vector_elements(const std::vector<ReferenceCell> &kinds,
                       const unsigned int                degree)
  {
    hp::FECollection<dim> elements;
    for (const ReferenceCell &kind : kinds)
      elements.push_back(FESystem<dim>(*make_element<dim>(kind, degree), dim));
    return elements;
  }



  namespace
  {
    /// Within edges and faces deal.II numbers component after component, which
    /// are nodes after nodes only if there is one of them (up to degree 2).
    template <int dim>
    void
    number_by_nodes(DoFHandler<dim> &dof_handler)
    {
      if (dof_handler.get_fe_collection().max_degree() < 3)
        return;
      const IndexSet &owned = dof_handler.locally_owned_dofs();
      // the dofs of a node by the smallest one
      std::map<types::global_dof_index, std::vector<types::global_dof_index>>
                                           nodes;
      std::vector<types::global_dof_index> dofs;
      for (const auto &cell : dof_handler.active_cell_iterators())
        {
          if (!cell->is_locally_owned())
            continue;
          const FiniteElement<dim> &fe = cell->get_fe();
          dofs.resize(fe.n_dofs_per_cell());
          cell->get_dof_indices(dofs);
          for (unsigned int a = 0; a < fe.base_element(0).n_dofs_per_cell();
               ++a)
            {
              std::vector<types::global_dof_index> node;
              for (unsigned int c = 0; c < fe.n_components(); ++c)
                node.push_back(dofs[fe.component_to_system_index(c, a)]);
              if (owned.is_element(node.front()))
                nodes[*std::min_element(node.begin(), node.end())] = node;
            }
        }
      std::vector<types::global_dof_index> new_numbers(owned.n_elements());
      unsigned int                         next = 0;
      for (const auto &[smallest, node] : nodes)
        for (const auto dof : node)
          new_numbers[owned.index_within_set(dof)] =
            owned.nth_index_in_set(next++);
      dof_handler.renumber_dofs(new_numbers);
    }
  } // namespace



  template <int dim>
  void
  distribute_dofs(const hp::FECollection<dim> &elements,
                  DoFHandler<dim>             &dof_handler)
  {
    if (elements.size() > 1)
      for (const auto &cell : dof_handler.active_cell_iterators())
        if (cell->is_locally_owned())
          for (unsigned int kind = 0; kind < elements.size(); ++kind)
            if (elements[kind].reference_cell() == cell->reference_cell())
              cell->set_active_fe_index(kind);
    dof_handler.distribute_dofs(elements);
    number_by_nodes(dof_handler);
  }



  template <int dim>
  std::unique_ptr<FiniteElement<dim>>
  make_discontinuous_element(const ReferenceCell &cell)
  {
    if (cell.is_simplex())
      return std::make_unique<FE_SimplexDGP<dim>>(1);
    return std::make_unique<FE_DGQ<dim>>(1);
  }



  template <int dim>
  std::unique_ptr<Mapping<dim>>
  make_mapping(const ReferenceCell &cell, const unsigned int degree)
  {
    if (cell.is_simplex())
      return std::make_unique<MappingFE<dim>>(FE_SimplexP<dim>(1));
    return std::make_unique<MappingQ<dim>>(degree);
  }



  template <int dim>
  Quadrature<dim>
  gauss_quadrature(const ReferenceCell &cell, const unsigned int n)
  {
    if constexpr (dim > 1)
      if (cell.is_simplex())
        {
          // In Release mode deal.II returns an empty rule.
          AssertThrow(n >= 1 && n <= most_simplex_points<dim>,
                      ExcNotImplemented());
          return QWitherdenVincentSimplex<dim>(n);
        }
    return QGauss<dim>(n);
  }



  template <int dim>
  Quadrature<dim>
  cell_quadrature(const ReferenceCell &cell, const unsigned int degree)
  {
    return gauss_quadrature<dim>(cell, cell.is_simplex() ? degree : degree + 1);
  }



  namespace
  {
    /// Of @p p in the unit simplex, for its vertex @p v.
    template <int dim>
    double
    barycentric_coordinate(const Point<dim> &p, const unsigned int v)
    {
      double coordinate = 1.;
      for (unsigned int d = 0; d < dim; ++d)
        coordinate -= p[d];
      return v == 0 ? coordinate : p[v - 1];
    }
  } // namespace



  template <int dim>
  bool
  has_node_on_face(const FiniteElement<dim> &fe,
                   const unsigned int        i,
                   const unsigned int        face)
  {
    const ReferenceCell cell = fe.reference_cell();
    if (!cell.is_simplex())
      return fe.has_support_on_face(i, face);
    unsigned int opposite = dim * (dim + 1) / 2; // the sum of all vertices
    for (unsigned int v = 0; v < dim; ++v)
      opposite -= cell.face_to_cell_vertices(face, v, 1);
    return std::abs(barycentric_coordinate(fe.unit_support_point(i),
                                           opposite)) < 1e-12;
  }



  template <int dim>
  double
  distance_to_unit_cell(const ReferenceCell &cell, const Point<dim> &p)
  {
    if (!cell.is_simplex())
      return GeometryInfo<dim>::distance_to_unit_cell(p);
    double smallest = 0.;
    for (unsigned int v = 0; v <= dim; ++v)
      smallest = std::min(smallest, barycentric_coordinate(p, v));
    return -smallest;
  }



  template <int dim>
  Point<dim>
  project_to_unit_cell(const ReferenceCell &cell, const Point<dim> &p)
  {
    if (!cell.is_simplex())
      return GeometryInfo<dim>::project_to_unit_cell(p);
    Point<dim> inside;
    double     sum = 0.;
    for (unsigned int d = 0; d < dim; ++d)
      {
        inside[d] = std::max(p[d], 0.);
        sum += inside[d];
      }
    return sum > 1. ? Point<dim>(inside / sum) : inside;
  }

#define INSTANTIATE(dim)                                                        \
  template ReferenceCell reference_cell_of(const Triangulation<dim> &);         \
  template std::vector<ReferenceCell> kinds_of_cells(                           \
    const Triangulation<dim> &);                                                \
  template hp::FECollection<dim> make_vector_elements(                          \
    const std::vector<ReferenceCell> &, const unsigned int);                    \
  template void          distribute_dofs(const hp::FECollection<dim> &,         \
                                         DoFHandler<dim> &);                    \
  template ReferenceCell faces_of<dim>(const ReferenceCell &);                  \
  template std::unique_ptr<FiniteElement<dim>> make_element(                    \
    const ReferenceCell &, const unsigned int);                                 \
  template std::unique_ptr<FiniteElement<dim>> make_discontinuous_element(      \
    const ReferenceCell &);                                                     \
  template std::unique_ptr<Mapping<dim>> make_mapping(const ReferenceCell &,    \
                                                      const unsigned int);      \
  template Quadrature<dim>               cell_quadrature(const ReferenceCell &, \
                                                         const unsigned int);   \
  template bool       has_node_on_face(const FiniteElement<dim> &,              \
                                       const unsigned int,                      \
                                       const unsigned int);                     \
  template double     distance_to_unit_cell(const ReferenceCell &,              \
                                            const Point<dim> &);                \
  template Point<dim> project_to_unit_cell(const ReferenceCell &,               \
                                           const Point<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
  template Quadrature<1>
  gauss_quadrature(const ReferenceCell &, const unsigned int);
  template Quadrature<2>
  gauss_quadrature(const ReferenceCell &, const unsigned int);
  template Quadrature<3>
  gauss_quadrature(const ReferenceCell &, const unsigned int);
} // namespace stickslip
