#ifndef stickslip_adaptivity_linear_moduli_h
#define stickslip_adaptivity_linear_moduli_h

#include <stickslip/problem/contact_problem.h>

#include <deal.II/base/symmetric_tensor.h>

#include <vector>

namespace stickslip
{
  /// The elastic constants of a material where nothing is deformed, taken for
  /// isotropic: what errors are measured with.
  struct LinearModuli
  {
    double shear          = 0.; ///< mu [stress]
    double poissons_ratio = 0.;

    /// sigma : C^-1 : sigma, twice the complementary energy [stress].
    double
    square(const SymmetricTensor<2, 3> &stress) const;
  };

  /// From the tangent of @p law at F = I.
  LinearModuli
  linear_moduli(const ConstitutiveLaw &law);



  /// Those of the regions of a problem.
  template <int dim>
  class LinearModuliOf
  {
  public:
    explicit LinearModuliOf(ContactProblem<dim> &problem);

    /// False for cells of rigid bodies, which have no error.
    template <typename CellIterator>
    bool
    is_deformable(const CellIterator &cell) const
    {
      return deformable[cell->material_id()];
    }

    template <typename CellIterator>
    const LinearModuli &
    of(const CellIterator &cell) const
    {
      return moduli[cell->material_id()];
    }

  private:
    std::vector<bool>         deformable; ///< by material id
    std::vector<LinearModuli> moduli;     ///< likewise
  };
} // namespace stickslip

#endif
