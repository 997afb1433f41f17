#ifndef stickslip_mesh_reference_cells_h
#define stickslip_mesh_reference_cells_h

#include <deal.II/base/point.h>
#include <deal.II/base/quadrature.h>

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/fe/fe.h>
#include <deal.II/fe/mapping.h>

#include <deal.II/grid/reference_cell.h>
#include <deal.II/grid/tria.h>

#include <deal.II/hp/fe_collection.h>

#include <memory>
#include <string>
#include <vector>

/**
 * What depends on the kind of the cells: quadrilaterals and hexahedra, or
 * triangles and tetrahedra (simplices). All cells of a body are of one kind,
 * those of a model of one or two. Bodies share no faces, so that the kinds do
 * not meet. Collections for the kinds of a model have the order of
 * kinds_of_cells(), which is also that of the active FE indices.
 */
namespace stickslip
{
  using namespace dealii;

  /// The cells that @p triangulation is made of. All must be of one kind.
  template <int dim>
  ReferenceCell
  reference_cell_of(const Triangulation<dim> &triangulation);

  /// The kinds of cells that @p triangulation is made of, on any rank, those
  /// that are no simplices first. Collective.
  template <int dim>
  std::vector<ReferenceCell>
  kinds_of_cells(const Triangulation<dim> &triangulation);

  /// The faces of @p cell: all are alike.
  template <int dim>
  ReferenceCell
  faces_of(const ReferenceCell &cell);

  /// "triangles".
  std::string
  plural(const ReferenceCell &cell);

  /// FE_Q or FE_SimplexP. Throws UserError about `Degree` if there is none.
  template <int dim>
  std::unique_ptr<FiniteElement<dim>>
  make_element(const ReferenceCell &cell, const unsigned int degree);

  /// Vectors of such functions, for each of @p kinds.
  template <int dim>
  hp::FECollection<dim>
  make_vector_elements(const std::vector<ReferenceCell> &kinds,
                       const unsigned int                degree);

  /// Numbers degrees of freedom, those of each cell with the one of
  /// @p elements that is for its kind; all components of a node one after the
  /// other. Collective.
  template <int dim>
  void
  distribute_dofs(const hp::FECollection<dim> &elements,
                  DoFHandler<dim>             &dof_handler);

  /// The same functions, discontinuous. Degree 1.
  template <int dim>
  std::unique_ptr<FiniteElement<dim>>
  make_discontinuous_element(const ReferenceCell &cell);

  /// Isoparametric; of simplices the one with straight sides, of degree 1.
  template <int dim>
  std::unique_ptr<Mapping<dim>>
  make_mapping(const ReferenceCell &cell, const unsigned int degree);

  /// The largest n of gauss_quadrature() on triangles and tetrahedra.
  template <int dim>
  constexpr unsigned int most_simplex_points = (dim == 2 ? 7 : 5);

  /// Gauss' rule, and that of Witherden and Vincent on a simplex, which does
  /// not depend on how vertices are numbered: exact for polynomials of degree
  /// 2 @p n - 1. Simplices: @p n <= most_simplex_points.
  template <int dim>
  Quadrature<dim>
  gauss_quadrature(const ReferenceCell &cell, const unsigned int n);

  /// The points at which the laws of displacements of @p degree are evaluated:
  /// the stiffness of undistorted cells is exact. On simplices, whose
  /// gradients have one degree less than the displacements in every
  /// direction, that takes fewer of them.
  template <int dim>
  Quadrature<dim>
  cell_quadrature(const ReferenceCell &cell, const unsigned int degree);

  /// True if the node of the shape function @p i lies on face @p face.
  /// (FE_SimplexP does not know.)
  template <int dim>
  bool
  has_node_on_face(const FiniteElement<dim> &fe,
                   const unsigned int        i,
                   const unsigned int        face);

  /// How far @p p is from the unit cell, along the axis in which it is farthest
  /// away, and the point in it that is near; @p p itself if it is inside.
  template <int dim>
  double
  distance_to_unit_cell(const ReferenceCell &cell, const Point<dim> &p);

  template <int dim>
  Point<dim>
  project_to_unit_cell(const ReferenceCell &cell, const Point<dim> &p);
} // namespace stickslip

#endif
