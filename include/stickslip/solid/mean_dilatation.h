#ifndef stickslip_solid_mean_dilatation_h
#define stickslip_solid_mean_dilatation_h

#include <deal.II/base/tensor.h>

namespace stickslip
{
  using namespace dealii;

  /**
   * Elements that do not lock where the volume hardly changes: the dilatation
   * at a point is replaced by its mean over the cell, so that incompressible
   * flow is one constraint per cell instead of one per quadrature point.
   *
   * Large strains (F-bar; de Souza Neto et al., IJSS 33, 1996, with the mean of
   * J in place of its value at the centre): the law sees
   *
   *   F_bar = r F,  r = (J_mean / J)^(1/n),  J_mean = int J dV / V,
   *
   * and the Cauchy stress of F_bar acts in the deformed cell, which means
   * P = r^(1 - n) P(F_bar). The tangent is not symmetric.
   *
   * Small strains (B-bar; Hughes, IJNME 15, 1980): with theta = div u the law
   * sees F + (theta_mean - theta) I / n, and so do the virtual strains. The
   * tangent is symmetric.
   *
   * Here n is the number of directions that change: 3, but in plane strain the
   * two in the plane.
   * Everything here is at a point; the sums over nodes are in ElementArrays.
   */
  template <int dim>
  class MeanDilatation
  {
  public:
    explicit MeanDilatation(const bool         small_strains,
                            const unsigned int n_directions = dim);

    /// det F > 0; always true for small strains.
    bool
    has_volume(const Tensor<2, 3> &F) const
    {
      return small_strains || determinant(F) > 0.;
    }

    /// J, or theta.
    double
    dilatation(const Tensor<2, 3> &F) const;

    /// Its derivative with respect to F; zero in the directions that stay.
    Tensor<2, 3>
    derivative(const Tensor<2, 3> &F) const;

    /// What the law sees.
    Tensor<2, 3>
    modified(const Tensor<2, 3> &F, const double mean) const;

    /**
     * What the answer of the law means for the cell. With the virtual mean
     * dilatation m, which is ln J_mean or theta_mean, and its increment M:
     *
     *   virtual work            P : dF + p m
     *   its increment           dF : A : DF + (column : dF) M
     *                           + m (row : DF) + square m M.
     */
    struct Response
    {
      Tensor<2, 3> P;
      double       p = 0.;
      Tensor<4, 3> A;
      Tensor<2, 3> column, row;
      double       square = 0.;
    };

    /// @p P and, unless null, @p A are those of the law at @p modified(F).
    Response
    response(const Tensor<2, 3> &F,
             const double        mean,
             const Tensor<2, 3> &P,
             const Tensor<4, 3> *A) const;

    /// First Piola-Kirchhoff stress in the cell, if @p P is the law's answer to
    /// modified(F).
    Tensor<2, 3>
    nominal_stress(const Tensor<2, 3> &F,
                   const double        mean,
                   const Tensor<2, 3> &P) const
    {
      return small_strains ? P : response(F, mean, P, nullptr).P;
    }

    /// Not const, so that objects can be assigned.
    bool         small_strains;
    unsigned int n; ///< directions

  private:
    Response
    small_response(const Tensor<2, 3> &P, const Tensor<4, 3> *A) const;

    Response
    large_response(const Tensor<2, 3> &F,
                   const double        mean,
                   const Tensor<2, 3> &P,
                   const Tensor<4, 3> *A) const;
  };
} // namespace stickslip

#endif
