#include <stickslip/adaptivity/linear_moduli.h>

#include <deal.II/base/array_view.h>

#include <cmath>

namespace stickslip
{
  double
  LinearModuli::square(const SymmetricTensor<2, 3> &stress) const
  {
    const double sum = trace(stress);
    return (stress * stress -
            poissons_ratio / (1. + poissons_ratio) * sum * sum) /
           (2. * shear);
  }



  LinearModuli
  linear_moduli(const ConstitutiveLaw &law)
  {
    std::vector<double>     old_history(law.n_history_variables());
    std::vector<double>     new_history(law.n_history_variables());
    const ArrayView<double> virgin(old_history.data(), old_history.size());
    law.initialize_history(virgin);
    Tensor<2, 3> I, P;
    for (unsigned int d = 0; d < 3; ++d)
      I[d][d] = 1.;
    Tensor<4, 3> C;
    LinearModuli moduli;
    const bool   has_answer =
      law.evaluate(I,
                   ArrayView<const double>(old_history.data(),
                                           old_history.size()),
                   ArrayView<double>(new_history.data(), new_history.size()),
                   P,
                   &C);
    AssertThrow(has_answer, ExcInternalError());
    // the same for P and for a symmetric stress
    moduli.shear = 0.5 * (C[0][1][0][1] + C[0][1][1][0]);
    // plane stress has no modulus out of the plane: C_0011 / C_0000 is then
    // Poisson's ratio itself, else it is nu / (1 - nu)
    const double ratio    = C[0][0][1][1] / C[0][0][0][0];
    const bool   is_plane = std::abs(C[2][2][2][2]) < 1e-8 * C[0][0][0][0];
    moduli.poissons_ratio = is_plane ? ratio : ratio / (1. + ratio);
    return moduli;
  }



  template <int dim>
  LinearModuliOf<dim>::LinearModuliOf(ContactProblem<dim> &problem)
  {
    const Bodies &bodies = problem.bodies();
    for (unsigned int m = 0; m < bodies.regions.size(); ++m)
      {
        deformable.push_back(!bodies.bodies[bodies.body_of(m)].is_rigid);
        moduli.push_back(deformable[m] ? linear_moduli(problem.solid().law(m))
                                       : LinearModuli());
      }
  }

  template class LinearModuliOf<2>;
  template class LinearModuliOf<3>;
} // namespace stickslip
