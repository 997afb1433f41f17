#ifndef stickslip_solid_finite_rotation_h
#define stickslip_solid_finite_rotation_h

#include <deal.II/base/numbers.h>
#include <deal.II/base/tensor.h>

#include <vector>

namespace stickslip
{
  using namespace dealii;

  /**
   * A rotation R in space, stored as a unit quaternion: small rotations keep
   * all their digits, which a matrix close to the unit matrix has lost.
   */
  class FiniteRotation
  {
  public:
    /// None.
    FiniteRotation() = default;

    /// About @p rotation_vector, by its length in radians.
    static FiniteRotation
    from_vector(const Tensor<1, 3> &rotation_vector);

    /// Of the plane: about z by @p angle in radians.
    static FiniteRotation
    about_z(const double angle);

    /**
     * The rotation that takes points closest, in the mean square, from
     * reference to current positions. @p displacements is the sum of u r^T over
     * the points, with u minus its mean, @p positions that of r r^T, with the
     * arms r from the mean reference position. The points must not be on a
     * line. Exact where they have moved as a rigid body; small rotations have
     * the relative accuracy of the displacements.
     */
    static FiniteRotation
    closest(const Tensor<2, 3> &displacements, const Tensor<2, 3> &positions);

    /// The rotation vector whose length is at most pi.
    Tensor<1, 3>
    vector() const;

    /// (R - I) r.
    Tensor<1, 3>
    displacement(const Tensor<1, 3> &r) const;

    /// R r.
    Tensor<1, 3>
    rotate(const Tensor<1, 3> &r) const
    {
      return r + displacement(r);
    }

    /// First @p first, then this one.
    FiniteRotation
    after(const FiniteRotation &first) const;

  private:
    double       scalar = 1.;
    Tensor<1, 3> axial;

    static FiniteRotation
    from_matrix(const Tensor<2, 3> &R);

    /// R - I.
    Tensor<2, 3>
    minus_identity() const;
  };

  /**
   * T of the spin w = T d theta, with which d R = [w x] R if R is the rotation
   * about theta. Singular at a full turn.
   */
  Tensor<2, 3>
  spin_of_rotation_vector(const Tensor<1, 3> &theta);

  /// The vector of the same rotation as @p theta, of those that differ by full
  /// turns, that is closest to having the components @p values along @p axes.
  Tensor<1, 3>
  nearest_branch(const Tensor<1, 3>              &theta,
                 const std::vector<Tensor<1, 3>> &axes,
                 const std::vector<double>       &values);
} // namespace stickslip

#endif
