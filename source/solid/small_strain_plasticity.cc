#include <stickslip/solid/small_strain_plasticity.h>

#include <stickslip/solid/history_tensor.h>
#include <stickslip/solid/radial_return.h>
#include <stickslip/solid/tangent_terms.h>

namespace stickslip
{
  namespace
  {
    const Choices<StrainMeasure> &
    all_strain_measures()
    {
      static const Choices<StrainMeasure> choices = {
        {"small", StrainMeasure::small},
        {"Green-Lagrange", StrainMeasure::green_lagrange}};
      return choices;
    }
  } // namespace



  void
  SmallStrainPlasticity::add_parameters(ParameterHandler &prm)
  {
    constants.add_parameters(prm);
    hardening.add_parameters(prm);
    kinematic.add_parameters(prm);
    add_choice(prm,
               "Strain measure",
               strain_measure,
               all_strain_measures(),
               "small: small strains and small rotations. "
               "Green-Lagrange: small strains (some percent) and any "
               "rotations. For large strains take a law with a "
               "multiplicative split (Simo-Miehe, Hencky).");
  }



  void
  SmallStrainPlasticity::read_files(const std::string &path,
                                    const std::string &directory,
                                    const MPI_Comm     communicator)
  {
    hardening.read_table_file(path, directory, communicator);
  }



  void
  SmallStrainPlasticity::check(const std::string &path) const
  {
    constants.check(path);
    kinematic.check(path);
    hardening.check(path, constants, kinematic);
  }



  std::vector<std::string>
  SmallStrainPlasticity::history_names() const
  {
    std::vector<std::string> names = {equivalent_plastic_strain_name};
    append_tensor_names("plastic_strain", names);
    kinematic.append_history_names(names);
    return names;
  }



  bool
  SmallStrainPlasticity::evaluate(const Tensor<2, 3>            &F,
                                  const ArrayView<const double> &old_history,
                                  const ArrayView<double>       &new_history,
                                  Tensor<2, 3>                  &P,
                                  Tensor<4, 3>                  *dP_dF) const
  {
    const bool is_small = is_geometrically_linear();
    if (!is_small && !(determinant(F) > 0.))
      return false;

    const double                K       = constants.bulk_modulus();
    const double                mu      = constants.shear_modulus();
    const SymmetricTensor<2, 3> eps     = strain(F);
    const SymmetricTensor<2, 3> plastic = read_tensor(old_history, 1);

    KinematicHardening::BackStrains back_strains;
    back_strains[0] = plastic;
    kinematic.read_back_strains(old_history, 7, back_strains);
    MixedReturn flow;
    if (!mixed_return(2. * mu * (deviator(eps) - plastic),
                      old_history[0],
                      hardening,
                      kinematic,
                      constants,
                      back_strains,
                      flow))
      return false;

    const SymmetricTensor<2, 3> new_plastic = plastic + flow.flow;
    new_history[0]                          = old_history[0] + flow.dp;
    write_tensor(new_plastic, new_history, 1);
    kinematic.write_back_stresses(back_strains, new_history, 7);

    const Tensor<2, 3> S = K * trace(eps) * unit_symmetric_tensor<3, double>() +
                           2. * mu * (deviator(eps) - new_plastic);
    P = is_small ? S : F * S;

    if (dP_dF != nullptr)
      {
        // dS/dE = l I x I + m (sym) - V x N, pulled to P(F) by
        // E = sym(F^T dF)
        const double       m  = 2. * mu * flow.scale;
        const double       l  = K - m / 3.;
        const Tensor<2, 3> I  = unit_symmetric_tensor<3, double>();
        const Tensor<2, 3> R  = is_small ? I : F;
        const Tensor<2, 3> RN = R * Tensor<2, 3>(flow.N);
        const Tensor<2, 3> RV = R * Tensor<2, 3>(flow.V);
        Tensor<4, 3>      &A  = *dP_dF;
        A                     = 0.;
        TangentTerms::add_product(A, l, R, R);
        TangentTerms::add_crossed_product(A, 0.5 * m, R, R);
        TangentTerms::add_spatial(A, 0.5 * m * (R * transpose(R)));
        if (flow.is_plastic)
          TangentTerms::add_product(A, -1., RV, RN);
        if (!is_small)
          TangentTerms::add_material(A, S);
      }
    return true;
  }



  SymmetricTensor<2, 3>
  SmallStrainPlasticity::cauchy_stress(const Tensor<2, 3> &F,
                                       const Tensor<2, 3> &P) const
  {
    return is_geometrically_linear() ? symmetrize(P)
                                     : ConstitutiveLaw::cauchy_stress(F, P);
  }



  SymmetricTensor<2, 3>
  SmallStrainPlasticity::strain(const Tensor<2, 3> &F) const
  {
    return is_geometrically_linear()
             ? symmetrize(F) - unit_symmetric_tensor<3, double>()
             : ConstitutiveLaw::strain(F);
  }



  double
  SmallStrainPlasticity::longitudinal_modulus() const
  {
    return constants.lame_lambda() + 2. * constants.shear_modulus();
  }



  bool
  SmallStrainPlasticity::is_geometrically_linear() const
  {
    return strain_measure == StrainMeasure::small;
  }
} // namespace stickslip
