#include <stickslip/solid/simo_miehe.h>

#include <stickslip/solid/history_tensor.h>
#include <stickslip/solid/principal_axes.h>
#include <stickslip/solid/radial_return.h>
#include <stickslip/solid/tangent_terms.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace stickslip
{
  namespace
  {
    using PrincipalMatrix = std::array<std::array<double, 3>, 3>;

    /// Deviatoric stress of a deviatoric logarithmic elastic strain e,
    /// s = mu dev(exp(2 e)), its derivative and its von Mises norm.
    struct PrincipalStress
    {
      PrincipalStress(const double mu, const Tensor<1, 3> &e)
      {
        // x - 1 keeps the digits of small elastic strains
        Tensor<1, 3> x_1;
        for (unsigned int a = 0; a < 3; ++a)
          x_1[a] = std::expm1(2. * e[a]);
        const double third = (x_1[0] + x_1[1] + x_1[2]) / 3.;
        for (unsigned int a = 0; a < 3; ++a)
          {
            s[a] = mu * (x_1[a] - third);
            for (unsigned int b = 0; b < 3; ++b)
              ds_de[a][b] = mu * ((a == b ? 2. : 0.) - 2. / 3.) * (1. + x_1[b]);
          }
        q = std::sqrt(1.5) * s.norm();
      }

      Tensor<1, 3> s;
      Tensor<2, 3> ds_de;
      double       q;
    };



    /// The plastic end state for the deviatoric trial strain, both as
    /// deviatoric logarithmic elastic strains in the same principal axes.
    struct PlasticFlow
    {
      Tensor<1, 3> e;
      double       dp;
      Tensor<2, 3> de_dtrial;
    };



    /**
     * Solves e + 3/2 dp s(e)/q(e) = e_trial, q(e) = R(p_old + dp) by Newton's
     * method from the solution for small elastic strains; steps that lead away
     * are halved.
     */
    bool
    solve_flow(const Tensor<1, 3>       &e_trial,
               const double              p_old,
               const IsotropicHardening &hardening,
               const ElasticConstants   &elastic,
               PlasticFlow              &flow)
    {
      const double mu = elastic.shear_modulus();
      // the answer for small elastic strains
      RadialReturn start;
      if (!radial_return(std::sqrt(6.) * mu * e_trial.norm(),
                         mu,
                         p_old,
                         hardening,
                         elastic,
                         start))
        return false;
      flow.e  = start.scale * e_trial;
      flow.dp = start.dp;
      Tensor<1, 3> step_e;
      double       step_dp     = 0.;
      double       last_merit  = std::numeric_limits<double>::max();
      double       first_merit = 0.;
      for (unsigned int iteration = 0; iteration < 100; ++iteration)
        {
          const PrincipalStress stress(mu, flow.e);
          const auto            yield  = hardening.at(p_old + flow.dp, elastic);
          const double          factor = 1.5 / stress.q;
          const Tensor<1, 3> r = flow.e - e_trial + factor * flow.dp * stress.s;
          const double       r_yield = stress.q - yield.value;
          const double       merit = std::max(r.norm(), std::abs(r_yield) / mu);
          if (!std::isfinite(merit))
            return false;
          first_merit = std::max(first_merit, merit);
          if (merit > 2. * last_merit && merit > 1e-12)
            {
              step_e *= 0.5;
              step_dp *= 0.5;
              flow.e -= step_e;
              flow.dp -= step_dp;
              continue;
            }

          // M de + m d(dp) = -r, g de - R' d(dp) = -r_yield
          const Tensor<1, 3> g = factor * (stress.s * stress.ds_de);
          const Tensor<1, 3> m = factor * stress.s;
          Tensor<2, 3>       M =
            (factor * flow.dp) *
            (stress.ds_de - outer_product(stress.s, g) / stress.q);
          for (unsigned int a = 0; a < 3; ++a)
            M[a][a] += 1.;
          const Tensor<2, 3> M_inverse   = invert(M);
          const Tensor<1, 3> g_M         = g * M_inverse;
          const double       denominator = yield.slope + g_M * m;

          const bool is_exact = r.norm() <= 1e-15 * e_trial.norm() &&
                                std::abs(r_yield) <= 1e-14 * yield.value;
          // down to roundoff, which the strains set
          const bool has_stagnated = merit >= last_merit &&
                                     r.norm() <= 1e-13 * (1. + first_merit) &&
                                     std::abs(r_yield) <= 1e-11 * yield.value;
          if (is_exact || has_stagnated)
            {
              flow.de_dtrial =
                M_inverse - outer_product(M_inverse * m, g_M) / denominator;
              return true;
            }
          last_merit = merit;
          step_dp    = (r_yield - g_M * r) / denominator;
          step_e     = -(M_inverse * (r + step_dp * m));
          flow.e += step_e;
          flow.dp += step_dp;
        }
      return false;
    }



    /// Derivatives of the principal Kirchhoff stresses, in the form that
    /// nominal_tangent() takes.
    void
    plastic_moduli(const ElasticConstants &elastic,
                   const double            J,
                   const PrincipalAxes    &principal,
                   const PlasticFlow      &flow,
                   PrincipalMatrix        &moduli,
                   PrincipalMatrix        &shear_factors)
    {
      const double          mu = elastic.shear_modulus();
      const PrincipalStress stress(mu, flow.e);
      const Tensor<2, 3>    ds = stress.ds_de * flow.de_dtrial;
      for (unsigned int a = 0; a < 3; ++a)
        {
          const double mean = (ds[a][0] + ds[a][1] + ds[a][2]) / 3.;
          for (unsigned int b = 0; b < 3; ++b)
            {
              moduli[a][b] = elastic.bulk_modulus() * J * J + ds[a][b] - mean;
              const double slope =
                2. * mu * divided_exponential(2. * flow.e[a], 2. * flow.e[b]);
              shear_factors[a][b] =
                b < a ? shear_factors[b][a]
                      : 0.5 * slope / (1. + 1.5 * flow.dp / stress.q * slope) *
                          principal.divided_log(a, b);
            }
        }
    }
  } // namespace



  void
  SimoMiehe::add_parameters(ParameterHandler &prm)
  {
    constants.add_parameters(prm);
    hardening.add_parameters(prm);
  }



  void
  SimoMiehe::read_files(const std::string &path,
                        const std::string &directory,
                        const MPI_Comm     communicator)
  {
    hardening.read_table_file(path, directory, communicator);
  }



  void
  SimoMiehe::check(const std::string &path) const
  {
    constants.check(path);
    hardening.check(path, constants);
  }



  std::vector<std::string>
  SimoMiehe::history_names() const
  {
    std::vector<std::string> names = {equivalent_plastic_strain_name};
    append_tensor_names("inverse_plastic_metric", names);
    return names;
  }



  void
  SimoMiehe::initialize_history(const ArrayView<double> &history) const
  {
    history[0] = 0.;
    write_tensor(unit_symmetric_tensor<3, double>(), history, 1);
  }



  bool
  SimoMiehe::evaluate(const Tensor<2, 3>            &F,
                      const ArrayView<const double> &old_history,
                      const ArrayView<double>       &new_history,
                      Tensor<2, 3>                  &P,
                      Tensor<4, 3>                  *dP_dF) const
  {
    const double J = determinant(F);
    if (!(J > 0.))
      return false;

    // Trial state: b = J^(-2/3) F Q F^T = H F^T, d its deviator.
    const double                mu    = constants.shear_modulus();
    const SymmetricTensor<2, 3> Q     = read_tensor(old_history, 1);
    const Tensor<2, 3>          Qs    = Q / std::cbrt(J * J);
    const Tensor<2, 3>          H     = F * Qs;
    Tensor<2, 3>                d     = H * transpose(F);
    const double                third = trace(d) / 3.;
    for (unsigned int i = 0; i < 3; ++i)
      d[i][i] -= third;
    const double q = std::sqrt(1.5) * mu * d.norm();
    if (!std::isfinite(q))
      return false;
    // Roundoff of a state on the yield surface is no plastic flow.
    if (q > hardening.at(old_history[0], constants).value * (1. + 1e-13))
      return evaluate_plastic(F, J, old_history, new_history, P, dP_dF);

    new_history[0] = old_history[0];
    write_tensor(Q, new_history, 1);
    const double       K = constants.bulk_modulus();
    const Tensor<2, 3> G = transpose(invert(F));
    const double       g = 0.5 * K * (J * J - 1.) - mu * third;
    P                    = g * G + mu * H;
    if (dP_dF != nullptr)
      {
        Tensor<4, 3> &A = *dP_dF;
        A               = 0.;
        TangentTerms::add_product(
          A, 1., G, (K * J * J + 2. / 3. * mu * third) * G - 2. / 3. * mu * H);
        TangentTerms::add_crossed_product(A, -g, G, G);
        TangentTerms::add_material(A, mu * Qs);
        TangentTerms::add_product(A, -2. / 3. * mu, H, G);
      }
    return true;
  }



  bool
  SimoMiehe::evaluate_plastic(const Tensor<2, 3>            &F,
                              const double                   J,
                              const ArrayView<const double> &old_history,
                              const ArrayView<double>       &new_history,
                              Tensor<2, 3>                  &P,
                              Tensor<4, 3>                  *dP_dF) const
  {
    const Tensor<2, 3>  Q = read_tensor(old_history, 1);
    const PrincipalAxes principal(symmetrize(F * Q * transpose(F)));
    if (!principal.is_positive())
      return false;
    const std::array<double, 3> strains = principal.logarithmic_strains();
    const double mean = (strains[0] + strains[1] + strains[2]) / 3.;
    Tensor<1, 3> e_trial;
    for (unsigned int a = 0; a < 3; ++a)
      e_trial[a] = strains[a] - mean;

    PlasticFlow flow;
    if (!solve_flow(e_trial, old_history[0], hardening, constants, flow))
      return false;

    const PrincipalStress stress(constants.shear_modulus(), flow.e);
    const double pressure = 0.5 * constants.bulk_modulus() * (J * J - 1.);
    std::array<double, 3> tau, elastic;
    for (unsigned int a = 0; a < 3; ++a)
      {
        tau[a]     = pressure + stress.s[a];
        elastic[a] = std::exp(2. * (mean + flow.e[a]));
      }
    const Tensor<2, 3> inverse_F = invert(F);
    P = Tensor<2, 3>(principal.tensor(tau)) * transpose(inverse_F);

    // Q = F^-1 b^e F^-T
    const Tensor<2, 3> b = principal.tensor(elastic);
    new_history[0]       = old_history[0] + flow.dp;
    write_tensor(symmetrize(inverse_F * b * transpose(inverse_F)),
                 new_history,
                 1);

    if (dP_dF != nullptr)
      {
        PrincipalMatrix moduli, shear_factors;
        plastic_moduli(constants, J, principal, flow, moduli, shear_factors);
        *dP_dF =
          nominal_tangent(principal, inverse_F, tau, moduli, shear_factors);
      }
    return true;
  }



  double
  SimoMiehe::longitudinal_modulus() const
  {
    return constants.lame_lambda() + 2. * constants.shear_modulus();
  }
} // namespace stickslip
