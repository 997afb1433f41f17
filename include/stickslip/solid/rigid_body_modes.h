#ifndef stickslip_solid_rigid_body_modes_h
#define stickslip_solid_rigid_body_modes_h

#include <stickslip/base/types.h>

#include <stickslip/mesh/body.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <deal.II/grid/tria.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <string>
#include <utility>
#include <vector>

namespace stickslip
{
  /**
   * The infinitesimal rigid motions of one body: dim translations and the
   * rotations about its centre (1 in 2D, 3 in 3D), and which of them are held.
   */
  template <int dim>
  class RigidBodyModes
  {
  public:
    static constexpr unsigned int n_rotations = (dim == 2 ? 1 : 3);
    static constexpr unsigned int n_modes     = dim + n_rotations;

    /// For a body with the given bounding box.
    RigidBodyModes(const Point<dim> &lower, const Point<dim> &upper);

    /// Displacements along @p direction at @p position are prevented.
    void
    hold(const Point<dim> &position, const Tensor<1, dim> &direction);

    /// Rotations about @p axis are prevented, wherever it is.
    void
    hold_rotation(const Tensor<1, 3> &axis);

    /// Displacements at the image of a place, wherever that is, are those at
    /// the place, turned.
    void
    tie(const PeriodicMotion &motion);

    /// Sums over the ranks what they hold. Collective.
    void
    sum_over_ranks(const MPI_Comm communicator);

    /// A basis of the motions that nothing holds: of each the factors of
    /// rigid_mode() about middle().
    std::vector<Vector<double>>
    unheld() const;

    /// "translation along x", "rotation about z", ...
    std::string
    motion_name(const Vector<double> &motion) const;

    const Point<dim> &
    middle() const
    {
      return centre;
    }

  private:
    void
    add_row(const Vector<double> &row);

    Point<dim>         centre;
    double             length;
    FullMatrix<double> gram; ///< sum of row row^T over everything that holds
  };

  /**
   * Displacement of an infinitesimal rigid motion at @p offset from the centre:
   * the translations along the axes, then the rotations by one radian (about z
   * in 2D; about x, y, z in 3D).
   */
  template <int dim>
  Tensor<1, dim>
  rigid_mode(const unsigned int mode, const Tensor<1, dim> &offset);

  /**
   * Lower and upper corner of the box around each body's vertices.
   * Collective.
   */
  template <int dim>
  std::vector<std::pair<Point<dim>, Point<dim>>>
  body_boxes(const Triangulation<dim> &triangulation, const Bodies &bodies);
} // namespace stickslip

#endif
