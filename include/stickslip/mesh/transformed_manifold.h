#ifndef stickslip_mesh_transformed_manifold_h
#define stickslip_mesh_transformed_manifold_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <deal.II/grid/manifold.h>

#include <memory>
#include <vector>

namespace stickslip
{
  using namespace dealii;

  /// x -> linear x + shift.
  template <int dim>
  struct AffineMap
  {
    Tensor<2, dim> linear = unit_symmetric_tensor<dim>();
    Tensor<1, dim> shift;

    Point<dim>
    operator()(const Point<dim> &x) const
    {
      return Point<dim>(linear * x + shift);
    }

    bool
    is_identity() const
    {
      return (linear - Tensor<2, dim>(unit_symmetric_tensor<dim>())).norm() ==
               0. &&
             shift.norm() == 0.;
    }

    /// Scaling per direction, then rotation by @p angle (radians) about the
    /// @p axis (2D: z) through @p centre, then translation.
    static AffineMap<dim>
    from_motion(const Tensor<1, dim> &scale,
                const Tensor<1, 3>   &axis,
                const double          angle,
                const Tensor<1, dim> &centre,
                const Tensor<1, dim> &translation);
  };

  /**
   * The image of a manifold under an invertible affine map: the manifold of a
   * body that was scaled, rotated and translated after its generation. Points
   * are pulled back, handed to the original manifold and pushed forward.
   */
  template <int dim>
  class TransformedManifold : public Manifold<dim, dim>
  {
  public:
    TransformedManifold(std::unique_ptr<Manifold<dim, dim>> original,
                        const AffineMap<dim>               &map);

    std::unique_ptr<Manifold<dim, dim>>
    clone() const override;

    Point<dim>
    get_intermediate_point(const Point<dim> &p1,
                           const Point<dim> &p2,
                           const double      w) const override;

    Point<dim>
    get_new_point(const ArrayView<const Point<dim>> &surrounding_points,
                  const ArrayView<const double>     &weights) const override;

    void
    get_new_points(const ArrayView<const Point<dim>> &surrounding_points,
                   const Table<2, double>            &weights,
                   ArrayView<Point<dim>> new_points) const override;

    Point<dim>
    project_to_manifold(const ArrayView<const Point<dim>> &surrounding_points,
                        const Point<dim> &candidate) const override;

    Tensor<1, dim>
    get_tangent_vector(const Point<dim> &x1,
                       const Point<dim> &x2) const override;

  private:
    std::unique_ptr<Manifold<dim, dim>> original;
    AffineMap<dim>                      map;
    Tensor<2, dim>                      inverse;

    Point<dim>
    pull_back(const Point<dim> &x) const;

    std::vector<Point<dim>>
    pull_back(const ArrayView<const Point<dim>> &points) const;
  };
} // namespace stickslip

#endif
