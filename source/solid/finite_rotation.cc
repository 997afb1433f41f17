#include <stickslip/solid/finite_rotation.h>

#include <deal.II/base/symmetric_tensor.h>

#include <cmath>
#include <limits>
#include <vector>

namespace stickslip
{
  namespace
  {
    /// Below this angle sin(x)/x is one up to roundoff.
    constexpr double tiny_angle = 1e-8;

    constexpr unsigned int most_iterations = 30;



    /// The matrix of r -> v x r.
    Tensor<2, 3>
    skew(const Tensor<1, 3> &v)
    {
      Tensor<2, 3> W;
      W[0][1] = -v[2];
      W[0][2] = v[1];
      W[1][0] = v[2];
      W[1][2] = -v[0];
      W[2][0] = -v[1];
      W[2][1] = v[0];
      return W;
    }



    /// Sum of r x e, where @p M is that of e r^T.
    Tensor<1, 3>
    moment(const Tensor<2, 3> &M)
    {
      Tensor<1, 3> m;
      m[0] = M[2][1] - M[1][2];
      m[1] = M[0][2] - M[2][0];
      m[2] = M[1][0] - M[0][1];
      return m;
    }



    /// Of its rows' cross products; deal.II's needs an inverse, which points in
    /// a plane do not have.
    Tensor<2, 3>
    cofactors(const Tensor<2, 3> &A)
    {
      Tensor<2, 3> result;
      for (unsigned int i = 0; i < 3; ++i)
        result[i] = cross_product_3d(A[(i + 1) % 3], A[(i + 2) % 3]);
      return result;
    }



    /// The orthogonal factor of a matrix with positive determinant, by
    /// Newton's method (Higham 1986).
    Tensor<2, 3>
    polar_rotation(Tensor<2, 3> R)
    {
      for (unsigned int i = 0; i < most_iterations; ++i)
        {
          const Tensor<2, 3> inverse = transpose(invert(R));
          const double       scale   = std::sqrt(inverse.norm() / R.norm());
          const Tensor<2, 3> next = 0.5 * (scale * R + (1. / scale) * inverse);
          const double       change = (next - R).norm();
          R                         = next;
          if (change < 1e-14)
            break;
        }
      return R;
    }
  } // namespace



  FiniteRotation
  FiniteRotation::from_vector(const Tensor<1, 3> &rotation_vector)
  {
    const double   angle = rotation_vector.norm();
    FiniteRotation result;
    result.scalar = std::cos(0.5 * angle);
    result.axial  = (angle < tiny_angle ? 0.5 : std::sin(0.5 * angle) / angle) *
                   rotation_vector;
    return result;
  }



  FiniteRotation
  FiniteRotation::about_z(const double angle)
  {
    Tensor<1, 3> vector;
    vector[2] = angle;
    return from_vector(vector);
  }



  FiniteRotation
  FiniteRotation::from_matrix(const Tensor<2, 3> &R)
  {
    // the largest of the four components is the safe one to divide by
    // (Shepperd 1978)
    FiniteRotation result;
    const double   t = trace(R);
    unsigned int   i = 0;
    for (unsigned int d = 1; d < 3; ++d)
      if (R[d][d] > R[i][i])
        i = d;
    if (t >= R[i][i])
      {
        result.scalar = 0.5 * std::sqrt(1. + t);
        result.axial  = moment(R) / (4. * result.scalar);
        return result;
      }
    const unsigned int j = (i + 1) % 3, k = (i + 2) % 3;
    result.axial[i] = 0.5 * std::sqrt(1. + R[i][i] - R[j][j] - R[k][k]);
    result.axial[j] = (R[i][j] + R[j][i]) / (4. * result.axial[i]);
    result.axial[k] = (R[i][k] + R[k][i]) / (4. * result.axial[i]);
    result.scalar   = (R[k][j] - R[j][k]) / (4. * result.axial[i]);
    return result;
  }



  Tensor<2, 3>
  FiniteRotation::minus_identity() const
  {
    const Tensor<2, 3> W = skew(axial);
    return 2. * (scalar * W + W * W);
  }



  FiniteRotation
  FiniteRotation::closest(const Tensor<2, 3> &displacements,
                          const Tensor<2, 3> &positions)
  {
    const Tensor<2, 3> H = positions + displacements;
    // The cofactor gives points in a plane a thickness that turns with them.
    FiniteRotation rotation =
      from_matrix(polar_rotation(H + (1. / trace(positions)) * cofactors(H)));
    // Newton's method for the largest R : H, with the moments of the
    // displacements that are left.
    for (unsigned int i = 0; i < most_iterations; ++i)
      {
        const Tensor<2, 3> R_I = rotation.minus_identity();
        const Tensor<2, 3> R   = R_I + unit_symmetric_tensor<3>();
        const Tensor<2, 3> Q   = H * transpose(R);
        const Tensor<2, 3> left =
          (displacements - R_I * positions) * transpose(R);
        const Tensor<2, 3> hessian =
          trace(Q) * Tensor<2, 3>(unit_symmetric_tensor<3>()) -
          0.5 * (Q + transpose(Q));
        const Tensor<1, 3> spin = invert(hessian) * moment(left);
        rotation                = from_vector(spin).after(rotation);
        if (spin.norm() <= 1e-15 * rotation.axial.norm())
          break;
      }
    return rotation;
  }



  Tensor<1, 3>
  FiniteRotation::vector() const
  {
    const double sine = axial.norm();
    const double sign = scalar < 0. ? -1. : 1.;
    return sign *
           (sine < tiny_angle ? 2.
                              : 2. * std::atan2(sine, sign * scalar) / sine) *
           axial;
  }



  Tensor<1, 3>
  FiniteRotation::displacement(const Tensor<1, 3> &r) const
  {
    const Tensor<1, 3> v_x_r = cross_product_3d(axial, r);
    return 2. * (scalar * v_x_r + cross_product_3d(axial, v_x_r));
  }



  FiniteRotation
  FiniteRotation::after(const FiniteRotation &first) const
  {
    FiniteRotation result;
    result.scalar = scalar * first.scalar - axial * first.axial;
    result.axial  = scalar * first.axial + first.scalar * axial +
                   cross_product_3d(axial, first.axial);
    const double norm =
      std::sqrt(result.scalar * result.scalar + result.axial.norm_square());
    result.scalar /= norm;
    result.axial /= norm;
    return result;
  }



  Tensor<2, 3>
  spin_of_rotation_vector(const Tensor<1, 3> &theta)
  {
    const double       angle = theta.norm();
    const Tensor<2, 3> W     = skew(theta);
    // series where the differences lose their digits
    const double a =
      angle < 1e-4 ? 0.5 : (1. - std::cos(angle)) / (angle * angle);
    const double b = angle < 1e-4
                       ? 1. / 6.
                       : (angle - std::sin(angle)) / (angle * angle * angle);
    return Tensor<2, 3>(unit_symmetric_tensor<3>()) + a * W + b * W * W;
  }



  Tensor<1, 3>
  nearest_branch(const Tensor<1, 3>              &theta,
                 const std::vector<Tensor<1, 3>> &axes,
                 const std::vector<double>       &values)
  {
    const double angle    = theta.norm();
    Tensor<1, 3> best     = theta;
    double       distance = std::numeric_limits<double>::max();
    for (const int turns : {0, 1, -1, 2, -2})
      {
        const Tensor<1, 3> other =
          angle > 0. ? (1. + turns * 2. * numbers::PI / angle) * theta : theta;
        double square = 0.;
        for (unsigned int k = 0; k < axes.size(); ++k)
          square += std::pow(other * axes[k] - values[k], 2);
        if (square < (1. - 1e-10) * distance)
          {
            distance = square;
            best     = other;
          }
      }
    return best;
  }
} // namespace stickslip
