#ifndef stickslip_tests_unit_law_at_a_point_h
#define stickslip_tests_unit_law_at_a_point_h

// A constitutive law and the history of one point of it.

#include <stickslip/base/user_error.h>

#include <stickslip/solid/constitutive_law.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

namespace law_test
{
  using namespace stickslip;

  /// Numbers in [-1, 1], the same everywhere.
  inline double
  next_number()
  {
    static unsigned long state = 12345;
    state                      = (1103515245 * state + 12345) % 2147483648UL;
    return 2. * double(state) / 2147483648. - 1.;
  }

  /// I + @p size times random numbers in the leading dim x dim block
  inline Tensor<2, 3>
  random_deformation_gradient(const unsigned int dim, const double size)
  {
    Tensor<2, 3> F;
    for (unsigned int i = 0; i < 3; ++i)
      F[i][i] = 1.;
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int j = 0; j < dim; ++j)
        F[i][j] += size * next_number();
    return F;
  }

  inline Tensor<2, 3>
  diagonal(const double x, const double y, const double z)
  {
    Tensor<2, 3> F;
    F[0][0] = x;
    F[1][1] = y;
    F[2][2] = z;
    return F;
  }

  inline void
  print(const std::string &what, const bool holds)
  {
    std::cout << what << ": " << (holds ? "yes" : "NO") << std::endl;
  }

  /// One point: evaluate() at will, accept() keeps the last history.
  class MaterialPoint
  {
  public:
    explicit MaterialPoint(std::shared_ptr<const ConstitutiveLaw> law)
      : law(law)
      , old_history(law->n_history_variables())
      , new_history(old_history)
    {
      law->initialize_history(
        ArrayView<double>(old_history.data(), old_history.size()));
    }

    bool
    evaluate(const Tensor<2, 3> &F, const bool with_tangent = true)
    {
      return law->evaluate(
        F,
        ArrayView<const double>(old_history.data(), old_history.size()),
        ArrayView<double>(new_history.data(), new_history.size()),
        P,
        with_tangent ? &A : nullptr);
    }

    void
    accept()
    {
      old_history = new_history;
    }

    /// P_ii = 0 in the given directions; F_ii is changed. 100 if not found.
    double
    relax(Tensor<2, 3> &F, const std::vector<unsigned int> &free)
    {
      for (unsigned int iteration = 0; iteration < 50; ++iteration)
        {
          if (!evaluate(F))
            return 100.;
          double residual = 0.;
          for (const unsigned int i : free)
            residual = std::max(residual, std::abs(P[i][i]));
          if (residual < 1e-14 * law->longitudinal_modulus())
            return 0.;
          // the free directions are equivalent
          double slope = 0.;
          for (const unsigned int j : free)
            slope += A[free[0]][free[0]][j][j];
          const double step = -P[free[0]][free[0]] / slope;
          for (const unsigned int i : free)
            F[i][i] += std::clamp(step, -0.3 * F[i][i], 0.3 * F[i][i]);
        }
      return std::abs(P[free[0]][free[0]]) < 1e-12 * law->longitudinal_modulus()
               ? 0.
               : 100.;
    }

    std::shared_ptr<const ConstitutiveLaw> law;
    std::vector<double>                    old_history, new_history;
    Tensor<2, 3>                           P;
    Tensor<4, 3>                           A;
  };

  /// Worst difference between tangent and central differences at @p F, in
  /// units of the modulus; 1e10 without an answer.
  inline double
  tangent_error(MaterialPoint      &point,
                const Tensor<2, 3> &F,
                const unsigned int  dim)
  {
    const double h     = 1e-6;
    double       worst = 0.;
    if (!point.evaluate(F))
      return 1e10;
    const Tensor<4, 3> A = point.A;
    for (unsigned int k = 0; k < dim; ++k)
      for (unsigned int l = 0; l < dim; ++l)
        {
          Tensor<2, 3> F_plus = F, F_minus = F;
          F_plus[k][l] += h;
          F_minus[k][l] -= h;
          if (!point.evaluate(F_plus, false))
            return 1e10;
          Tensor<2, 3> difference = point.P;
          if (!point.evaluate(F_minus, false))
            return 1e10;
          difference -= point.P;
          difference /= 2. * h;
          for (unsigned int i = 0; i < dim; ++i)
            for (unsigned int j = 0; j < dim; ++j)
              worst =
                std::max(worst, std::abs(A[i][j][k][l] - difference[i][j]));
        }
    return worst / point.law->longitudinal_modulus();
  }
} // namespace law_test

#endif
