#include <stickslip/solid/hencky.h>

#include <stickslip/solid/history_tensor.h>
#include <stickslip/solid/multiplicative_return.h>
#include <stickslip/solid/principal_axes.h>
#include <stickslip/solid/radial_return.h>
#include <stickslip/solid/symmetric_maps.h>
#include <stickslip/solid/tangent_terms.h>

#include <array>
#include <cmath>

namespace stickslip
{
  namespace
  {
    using PrincipalValues = std::array<double, 3>;
    using PrincipalMatrix = std::array<std::array<double, 3>, 3>;

    /// K tr(e) + 2 mu scale dev(e), component by component.
    PrincipalValues
    principal_stress(const ElasticConstants &constants,
                     const PrincipalValues  &strains,
                     const double            scale)
    {
      const double    trace    = strains[0] + strains[1] + strains[2];
      const double    pressure = constants.bulk_modulus() * trace;
      const double    shear    = 2. * constants.shear_modulus() * scale;
      PrincipalValues tau;
      for (unsigned int a = 0; a < 3; ++a)
        tau[a] = pressure + shear * (strains[a] - trace / 3.);
      return tau;
    }



    /// The tangent of principal_stress() for b = F Q F^T with @p principal
    /// axes; @p direction is the unit deviator of the trial strains.
    Tensor<4, 3>
    tangent(const ElasticConstants &constants,
            const PrincipalAxes    &principal,
            const Tensor<2, 3>     &inverse_F,
            const PrincipalValues  &tau,
            const RadialReturn     &flow,
            const PrincipalValues  &direction)
    {
      const double    K     = constants.bulk_modulus();
      const double    shear = constants.shear_modulus() * flow.scale;
      PrincipalMatrix moduli, shear_factors;
      for (unsigned int a = 0; a < 3; ++a)
        for (unsigned int b = 0; b < 3; ++b)
          {
            moduli[a][b] = K + 2. * shear * ((a == b ? 1. : 0.) - 1. / 3.) -
                           flow.reduction * direction[a] * direction[b];
            shear_factors[a][b] =
              b < a ? shear_factors[b][a]
                    : (b == a ? 0. : shear * principal.divided_log(a, b));
          }
      return nominal_tangent(principal, inverse_F, tau, moduli, shear_factors);
    }



    /// The positive root of a tensor.
    SymmetricTensor<2, 3>
    root(const PrincipalAxes &principal)
    {
      return principal.tensor({{std::sqrt(principal.values[0]),
                                std::sqrt(principal.values[1]),
                                std::sqrt(principal.values[2])}});
    }



    /// The second Piola-Kirchhoff stress over the intermediate configuration,
    /// C^e^-1 times the Mandel stress, and its derivative over C^e.
    struct IntermediateStress
    {
      IntermediateStress(const ElasticConstants      &constants,
                         const SymmetricTensor<2, 3> &elastic_metric)
      {
        const PrincipalAxes   principal(elastic_metric);
        const PrincipalValues tau =
          principal_stress(constants, principal.logarithmic_strains(), 1.);
        PrincipalValues inverse, stress;
        for (unsigned int a = 0; a < 3; ++a)
          {
            inverse[a] = 1. / principal.values[a];
            stress[a]  = tau[a] * inverse[a];
          }
        // stress_a = (lambda tr(e) + mu ln x_a) / x_a, first at a fixed tr(e)
        PrincipalMatrix f;
        for (unsigned int a = 0; a < 3; ++a)
          for (unsigned int b = 0; b < 3; ++b)
            f[a][b] = inverse[a] *
                      (constants.shear_modulus() * principal.divided_log(a, b) -
                       stress[b]);
        const SymmetricTensor<2, 3> C_inverse = principal.tensor(inverse);
        value                                 = principal.tensor(stress);
        slope = principal.derivative(f) + 0.5 * constants.lame_lambda() *
                                            outer_product(C_inverse, C_inverse);
      }

      SymmetricTensor<2, 3> value;
      SymmetricTensor<4, 3> slope;
    };
  } // namespace



  void
  Hencky::add_parameters(ParameterHandler &prm)
  {
    constants.add_parameters(prm);
  }



  void
  Hencky::check(const std::string &path) const
  {
    constants.check(path);
  }



  bool
  Hencky::evaluate(const Tensor<2, 3> &F,
                   const ArrayView<const double> & /*old_history*/,
                   const ArrayView<double> & /*new_history*/,
                   Tensor<2, 3> &P,
                   Tensor<4, 3> *dP_dF) const
  {
    if (!(determinant(F) > 0.))
      return false;
    const PrincipalAxes principal(symmetrize(F * transpose(F)));
    if (!principal.is_positive())
      return false;
    const PrincipalValues tau =
      principal_stress(constants, principal.logarithmic_strains(), 1.);
    const Tensor<2, 3> inverse_F = invert(F);
    P = Tensor<2, 3>(principal.tensor(tau)) * transpose(inverse_F);
    if (dP_dF != nullptr)
      *dP_dF = tangent(
        constants, principal, inverse_F, tau, RadialReturn(), {{0., 0., 0.}});
    return true;
  }



  SymmetricTensor<2, 3>
  Hencky::strain(const Tensor<2, 3> &F) const
  {
    const PrincipalAxes principal(symmetrize(transpose(F) * F));
    return principal.tensor(principal.logarithmic_strains());
  }



  double
  Hencky::longitudinal_modulus() const
  {
    return constants.lame_lambda() + 2. * constants.shear_modulus();
  }



  void
  HenckyPlasticity::add_parameters(ParameterHandler &prm)
  {
    Hencky::add_parameters(prm);
    hardening.add_parameters(prm);
    kinematic.add_parameters(prm);
  }



  void
  HenckyPlasticity::read_files(const std::string &path,
                               const std::string &directory,
                               const MPI_Comm     communicator)
  {
    hardening.read_table_file(path, directory, communicator);
  }



  void
  HenckyPlasticity::check(const std::string &path) const
  {
    Hencky::check(path);
    kinematic.check(path);
    hardening.check(path, constants, kinematic);
  }



  std::vector<std::string>
  HenckyPlasticity::history_names() const
  {
    std::vector<std::string> names = {equivalent_plastic_strain_name};
    append_tensor_names("inverse_plastic_metric", names);
    kinematic.append_history_names(names);
    return names;
  }



  void
  HenckyPlasticity::initialize_history(const ArrayView<double> &history) const
  {
    ConstitutiveLaw::initialize_history(history);
    write_tensor(unit_symmetric_tensor<3, double>(), history, 1);
  }



  bool
  HenckyPlasticity::evaluate(const Tensor<2, 3>            &F,
                             const ArrayView<const double> &old_history,
                             const ArrayView<double>       &new_history,
                             Tensor<2, 3>                  &P,
                             Tensor<4, 3>                  *dP_dF) const
  {
    if (!(determinant(F) > 0.))
      return false;
    if (kinematic.is_active())
      return evaluate_mixed(F, old_history, new_history, P, dP_dF);
    const Tensor<2, 3>  Q = read_tensor(old_history, 1);
    const PrincipalAxes principal(symmetrize(F * Q * transpose(F)));
    if (!principal.is_positive())
      return false;

    const PrincipalValues strains = principal.logarithmic_strains();
    const double          mean    = (strains[0] + strains[1] + strains[2]) / 3.;
    PrincipalValues       direction;
    double                norm = 0.;
    for (unsigned int a = 0; a < 3; ++a)
      {
        direction[a] = strains[a] - mean;
        norm += direction[a] * direction[a];
      }
    norm            = std::sqrt(norm);
    const double mu = constants.shear_modulus();
    RadialReturn flow;
    if (!radial_return(std::sqrt(6.) * mu * norm,
                       mu,
                       old_history[0],
                       hardening,
                       constants,
                       flow))
      return false;

    const PrincipalValues tau =
      principal_stress(constants, strains, flow.scale);
    const Tensor<2, 3> inverse_F = invert(F);
    P = Tensor<2, 3>(principal.tensor(tau)) * transpose(inverse_F);

    new_history[0] = old_history[0] + flow.dp;
    write_tensor(read_tensor(old_history, 1), new_history, 1);
    if (flow.is_plastic)
      {
        // Q = F^-1 b^e F^-T with the elastic part of the strains
        PrincipalValues elastic;
        for (unsigned int a = 0; a < 3; ++a)
          elastic[a] = std::exp(2. * (mean + flow.scale * direction[a]));
        const Tensor<2, 3> b = principal.tensor(elastic);
        write_tensor(symmetrize(inverse_F * b * transpose(inverse_F)),
                     new_history,
                     1);
      }

    if (dP_dF != nullptr)
      {
        for (double &component : direction)
          component = flow.is_plastic ? component / norm : 0.;
        *dP_dF = tangent(constants, principal, inverse_F, tau, flow, direction);
      }
    return true;
  }



  bool
  HenckyPlasticity::evaluate_mixed(const Tensor<2, 3>            &F,
                                   const ArrayView<const double> &old_history,
                                   const ArrayView<double>       &new_history,
                                   Tensor<2, 3>                  &P,
                                   Tensor<4, 3>                  *dP_dF) const
  {
    // F^p = U = Q^(-1/2) at the beginning of the step, and its inverse W
    const SymmetricTensor<2, 3> Q = read_tensor(old_history, 1);
    const PrincipalAxes         principal(Q);
    if (!principal.is_positive())
      return false;
    const Tensor<2, 3>          W       = root(principal);
    const SymmetricTensor<2, 3> C_trial = symmetrize(W * transpose(F) * F * W);

    KinematicHardening::BackStrains back_strains;
    back_strains[0] = -principal.logarithmic_strain();
    kinematic.read_back_strains(old_history, 7, back_strains);
    MultiplicativeReturn flow;
    if (!multiplicative_return(C_trial,
                               old_history[0],
                               hardening,
                               kinematic,
                               constants,
                               back_strains,
                               flow))
      return false;

    const Tensor<2, 3>      &G_inverse = flow.inverse_G;
    const IntermediateStress stress(constants, flow.elastic_metric);
    const Tensor<2, 3>       S = G_inverse * stress.value * G_inverse;
    const Tensor<2, 3>       Y = F * W;
    P                          = Y * S * W;

    new_history[0] = old_history[0] + flow.dp;
    write_tensor(Q, new_history, 1);
    if (flow.dp > 0.)
      {
        // F^p = G U = R (new U): the back strains turn to the new U
        const Tensor<2, 3>          H     = G_inverse * W;
        const SymmetricTensor<2, 3> new_Q = symmetrize(transpose(H) * H);
        const Tensor<2, 3>          R =
          transpose(invert(H)) * root(PrincipalAxes(new_Q));
        for (unsigned int k = 1; k < kinematic.n_terms(); ++k)
          back_strains[k] = symmetrize(transpose(R) * back_strains[k] * R);
        write_tensor(new_Q, new_history, 1);
      }
    kinematic.write_back_stresses(back_strains, new_history, 7);

    if (dP_dF != nullptr)
      {
        using namespace SymmetricMaps;
        const SymmetricTensor<4, 3> dmetric =
          congruence(G_inverse) +
          symmetric_product(C_trial * G_inverse) * flow.dinverse_G;
        const SymmetricTensor<4, 3> dS =
          congruence(G_inverse) * (stress.slope * dmetric) +
          symmetric_product(stress.value * G_inverse) * flow.dinverse_G;
        *dP_dF = 0.;
        TangentTerms::add_material(*dP_dF, W * S * W);
        TangentTerms::add_metric_derivative(*dP_dF, Y, W, dS);
      }
    return true;
  }
} // namespace stickslip
