#ifndef stickslip_contact_surface_face_shape_h
#define stickslip_contact_surface_face_shape_h

#include <stickslip/base/types.h>

#include <deal.II/base/point.h>
#include <deal.II/base/polynomial.h>
#include <deal.II/base/tensor.h>

#include <deal.II/grid/reference_cell.h>

#include <vector>

namespace stickslip
{
  /// Values and derivatives of the face shape functions at one point.
  template <int dim>
  struct FaceShapeValues
  {
    std::vector<double>             value;
    std::vector<Tensor<1, dim - 1>> gradient; ///< with respect to xi
    std::vector<Tensor<2, dim - 1>> hessian;
  };

  /// A cell between neighbouring nodes of a face, with straight edges.
  template <int dim>
  struct NodeCell
  {
    std::vector<unsigned int> corners; ///< nodes, along its border
    Point<dim - 1>            centre;  ///< parametric
  };



  /**
   * Lagrange shape functions of a face. They describe positions, displacements
   * and multipliers on slave and master faces alike (paper, eqs. 14 and 15).
   *
   * - Of a FE_Q(degree) cell: tensor products on [0,1]^(dim-1) with
   *   Gauss-Lobatto nodes in lexicographic order.
   * - Of a tetrahedron, degree 1 or 2: on the triangle xi_1, xi_2 >= 0,
   *   xi_1 + xi_2 <= 1; its vertices, then the middles of its edges.
   */
  template <int dim>
  class FaceShape
  {
  public:
    /// @p face is what the faces are: lines in 2D.
    explicit FaceShape(
      const unsigned int   degree,
      const ReferenceCell &face = ReferenceCells::get_hypercube<dim - 1>());

    unsigned int
    degree() const;

    unsigned int
    n_nodes() const;

    const ReferenceCell &
    reference_cell() const
    {
      return face;
    }

    bool
    is_triangle() const
    {
      return dim == 3 && face.is_simplex();
    }

    const Point<dim - 1> &
    node(const unsigned int j) const;

    /// The cells that the nodes cut the face into: one for degree 1.
    const std::vector<NodeCell<dim>> &
    cells() const
    {
      return node_cells;
    }

    /// Between two nodes of a face with edges of length 1.
    double
    distance(const unsigned int j, const unsigned int k) const;

    /// Only the values.
    void
    evaluate_values(const Point<dim - 1> &xi, std::vector<double> &value) const;

    /// Values and gradients; the Hessians of @p shape stay as they are.
    void
    evaluate_gradients(const Point<dim - 1> &xi,
                       FaceShapeValues<dim> &shape) const;

    /// Values, gradients and Hessians.
    void
    evaluate(const Point<dim - 1> &xi, FaceShapeValues<dim> &shape) const;

    const Point<dim - 1> &
    centre() const
    {
      return middle;
    }

    /// evaluate() in the middle of the face.
    const FaceShapeValues<dim> &
    at_centre() const
    {
      return centre_values;
    }

    /// evaluate() at node @p j.
    const FaceShapeValues<dim> &
    at_node(const unsigned int j) const
    {
      return node_values[j];
    }

  private:
    void
    evaluate_product(const Point<dim - 1> &xi,
                     const bool            with_hessians,
                     FaceShapeValues<dim> &shape) const;

    ReferenceCell                                face;
    unsigned int                                 n_1d;
    std::vector<Polynomials::Polynomial<double>> basis;
    std::vector<Point<dim - 1>>                  nodes;
    std::vector<NodeCell<dim>>                   node_cells;
    Point<dim - 1>                               middle;
    FaceShapeValues<dim>                         centre_values;
    std::vector<FaceShapeValues<dim>>            node_values;
  };



  /// sum_j N_j x_j over the nodes that @p N has values for.
  template <int dim>
  Tensor<1, dim>
  interpolate(const std::vector<double>         &N,
              const std::vector<Tensor<1, dim>> &nodes)
  {
    Tensor<1, dim> x;
    for (unsigned int j = 0; j < N.size(); ++j)
      x += N[j] * nodes[j];
    return x;
  }
} // namespace stickslip

#endif
