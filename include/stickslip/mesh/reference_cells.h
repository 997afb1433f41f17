#ifndef stickslip_mesh_reference_cells_h
#define stickslip_mesh_reference_cells_h

#include <deal.II/base/point.h>
#include <deal.II/base/quadrature.h>

#include <deal.II/fe/fe.h>
#include <deal.II/fe/mapping.h>

#include <deal.II/grid/reference_cell.h>
#include <deal.II/grid/tria.h>

#include <memory>
#include <string>

/**
 * What depends on the kind of the cells: quadrilaterals and hexahedra, or
 * triangles and tetrahedra (simplices). All cells of a model are of one kind,
 * so that it is asked for once, and nothing else has to know it. Nothing here
 * is collective.
 */
namespace stickslip
{
  using namespace dealii;

  /// The cells that @p triangulation is made of. All must be of one kind.
  template <int dim>
  ReferenceCell
  reference_cell_of(const Triangulation<dim> &triangulation);

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
