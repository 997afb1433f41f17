#ifndef stickslip_mesh_periodicity_h
#define stickslip_mesh_periodicity_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>
#include <deal.II/base/types.h>

#include <deal.II/grid/tria.h>

#include <string>
#include <vector>

namespace stickslip
{
  using namespace dealii;

  /// The wish that two opposite boundaries of a body be identified.
  struct PeriodicRequest
  {
    std::string  parameter_path; ///< for messages
    std::string  body;
    std::string  first; ///< ids or names
    std::string  second;
    unsigned int direction = 0;     ///< the faces differ by a shift in x, y, z
    bool         is_cyclic = false; ///< they differ by a rotation instead ...
    Tensor<1, 3> axis;              ///< ... about it (unit length)
    Point<3>     centre;            ///< a point on it
  };

  /**
   * A rigid motion of the whole space, x -> Q x + c: what brings one of two
   * periodic boundaries onto the other. Plane models are in z = 0.
   */
  struct PeriodicMotion
  {
    Tensor<2, 3> Q = unit_symmetric_tensor<3>();
    Tensor<1, 3> c;

    /// That about the axis through @p centre by @p angle [radian].
    static PeriodicMotion
    rotation(const Tensor<1, 3> &axis,
             const Point<3>     &centre,
             const double        angle);

    template <int dim>
    Tensor<2, dim>
    rotation_matrix() const;

    template <int dim>
    Tensor<1, dim>
    operator()(const Tensor<1, dim> &x) const;

    /// This one after @p first.
    PeriodicMotion
    after(const PeriodicMotion &first) const;

    PeriodicMotion
    inverse() const;
  };

  /// Two boundaries of a body that are one, with the triangulation's ids.
  struct PeriodicBoundary
  {
    std::string        parameter_path;
    unsigned int       body;
    types::boundary_id first;
    types::boundary_id second;
    /// A coordinate along which the second boundary has no faces behind each
    /// other: of a shift its direction.
    unsigned int   direction;
    PeriodicMotion motion;    ///< of the first onto the second
    double         distance;  ///< of the middles of both [length]
    unsigned int   order = 0; ///< of a rotation: so many make a full turn
    Tensor<1, 3>   axis;      ///< of a rotation
    Point<3>       centre;    ///< a point on it

    bool
    is_cyclic() const
    {
      return order > 0;
    }
  };

  /**
   * The motion between the boundaries of @p request, which have the ids
   * @p first and @p second, from where they are on the coarse mesh. Throws
   * UserError if no whole number of such sectors makes a full turn.
   */
  template <int dim>
  PeriodicBoundary
  find_periodic_boundary(const PeriodicRequest    &request,
                         const Triangulation<dim> &coarse_mesh,
                         const unsigned int        body,
                         const types::boundary_id  first,
                         const types::boundary_id  second);

  /// Throws UserError where motions are of different symmetries of a model.
  void
  check_compatible(const std::vector<PeriodicBoundary> &boundaries);

  /// Tells the coarse mesh which of its faces are one. Throws what deal.II
  /// throws if they do not match.
  template <int dim>
  void
  add_periodicity(const std::vector<PeriodicBoundary> &boundaries,
                  Triangulation<dim>                  &coarse_mesh);
} // namespace stickslip

#endif
