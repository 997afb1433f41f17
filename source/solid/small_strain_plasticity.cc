#include <stickslip/solid/small_strain_plasticity.h>

#include <stickslip/base/user_error.h>

#include <stickslip/solid/history_tensor.h>
#include <stickslip/solid/radial_return.h>
#include <stickslip/solid/tangent_terms.h>

#include <cmath>
#include <sstream>

namespace stickslip
{
  namespace
  {
    const Choices<KinematicModulusType> &
    all_kinematic_modulus_types()
    {
      static const Choices<KinematicModulusType> choices = {
        {"slope", KinematicModulusType::slope},
        {"Prager constant", KinematicModulusType::prager_constant}};
      return choices;
    }



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
    prm.add_parameter("Kinematic modulus",
                      kinematic_modulus,
                      "Of Prager's linear kinematic hardening, force per area. "
                      "'Kinematic modulus is' says which slope it is.",
                      Patterns::Double());
    add_choice(prm,
               "Kinematic modulus is",
               kinematic_modulus_type,
               all_kinematic_modulus_types(),
               "slope: of the uniaxial back stress over the plastic "
               "strain. Prager constant: C of the back stress tensor "
               "X = C e_p, which has the uniaxial slope 3/2 C.");
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
  SmallStrainPlasticity::check(const std::string &path) const
  {
    constants.check(path);
    if (!(kinematic_modulus >= 0.))
      {
        std::ostringstream text;
        text << path << "/Kinematic modulus is " << kinematic_modulus
             << ", but has to be at least 0.";
        throw UserError(text.str());
      }
    hardening.check(path, constants, kinematic_slope());
  }



  double
  SmallStrainPlasticity::kinematic_slope() const
  {
    return kinematic_modulus_type == KinematicModulusType::slope
             ? kinematic_modulus
             : 1.5 * kinematic_modulus;
  }



  std::vector<std::string>
  SmallStrainPlasticity::history_names() const
  {
    std::vector<std::string> names = {equivalent_plastic_strain_name};
    append_tensor_names("plastic_strain", names);
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
    const double                H_kin   = kinematic_slope();
    const SymmetricTensor<2, 3> eps     = strain(F);
    const SymmetricTensor<2, 3> plastic = read_tensor(old_history, 1);

    // Trial stress less the back stress X = 2/3 H_kin e_p.
    const SymmetricTensor<2, 3> relative =
      2. * mu * (deviator(eps) - plastic) - (2. / 3. * H_kin) * plastic;
    const double norm = relative.norm();
    RadialReturn flow;
    if (!radial_return(std::sqrt(1.5) * norm,
                       mu,
                       H_kin,
                       old_history[0],
                       hardening,
                       constants,
                       flow))
      return false;

    SymmetricTensor<2, 3> direction;
    if (flow.is_plastic)
      direction = relative / norm;
    const SymmetricTensor<2, 3> new_plastic =
      plastic + (std::sqrt(1.5) * flow.dp) * direction;
    new_history[0] = old_history[0] + flow.dp;
    write_tensor(new_plastic, new_history, 1);

    const Tensor<2, 3> S = K * trace(eps) * unit_symmetric_tensor<3, double>() +
                           2. * mu * (deviator(eps) - new_plastic);
    P = is_small ? S : F * S;

    if (dP_dF != nullptr)
      {
        // dS/dE = l I x I + m (sym) - reduction N x N, pulled to P(F) by
        // E = sym(F^T dF)
        const double       m  = 2. * mu * flow.scale;
        const double       l  = K - m / 3.;
        const Tensor<2, 3> N  = direction;
        const Tensor<2, 3> I  = unit_symmetric_tensor<3, double>();
        const Tensor<2, 3> R  = is_small ? I : F;
        const Tensor<2, 3> RN = R * N;
        Tensor<4, 3>      &A  = *dP_dF;
        A                     = 0.;
        TangentTerms::add_product(A, l, R, R);
        TangentTerms::add_crossed_product(A, 0.5 * m, R, R);
        TangentTerms::add_spatial(A, 0.5 * m * (R * transpose(R)));
        if (flow.is_plastic)
          TangentTerms::add_product(A, -flow.reduction, RN, RN);
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
