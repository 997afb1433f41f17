#include <stickslip/solid/history_tensor.h>
#include <stickslip/solid/radial_return.h>
#include <stickslip/solid/simo_miehe.h>
#include <stickslip/solid/tangent_terms.h>

#include <cmath>

namespace stickslip
{
  namespace
  {
    using namespace TangentTerms;

    /// The x with det(d + x I) = 1, d traceless, from a start above it:
    /// x^3 - (d:d/2) x + det d = 1 is convex there, so that Newton's
    /// iterates come down to it.
    bool
    spherical_part(const Tensor<2, 3> &d, double &x)
    {
      const double j2 = 0.5 * d.norm_square();
      const double j3 = determinant(d);
      for (unsigned int iteration = 0; iteration < 50; ++iteration)
        {
          const double value = x * (x * x - j2) + j3 - 1.;
          const double slope = 3. * x * x - j2;
          if (!(slope > 0.))
            return false;
          x -= value / slope;
          if (std::abs(value / slope) <= 1e-15 * x)
            return true;
        }
      return false;
    }
  } // namespace



  void
  SimoMiehe::add_parameters(ParameterHandler &prm)
  {
    constants.add_parameters(prm);
    hardening.add_parameters(prm);
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

    const double       K  = constants.bulk_modulus();
    const double       mu = constants.shear_modulus();
    const Tensor<2, 3> G  = transpose(invert(F));

    // Trial state: b = J^(-2/3) F Q F^T = H F^T, d its deviator.
    const SymmetricTensor<2, 3> Q     = read_tensor(old_history, 1);
    const Tensor<2, 3>          Qs    = Q / std::cbrt(J * J);
    const Tensor<2, 3>          H     = F * Qs;
    Tensor<2, 3>                d     = H * transpose(F);
    const double                third = trace(d) / 3.;
    for (unsigned int i = 0; i < 3; ++i)
      d[i][i] -= third;
    const double q = std::sqrt(1.5) * mu * d.norm();

    RadialReturn flow;
    if (!radial_return(
          q, mu * third, 0., old_history[0], hardening, constants, flow))
      return false;

    // tau F^-T
    const double g = 0.5 * K * (J * J - 1.) - flow.scale * mu * third;
    P              = g * G + flow.scale * mu * H;

    new_history[0] = old_history[0] + flow.dp;
    write_tensor(Q, new_history, 1);
    if (flow.is_plastic)
      {
        double spherical = third;
        if (!spherical_part(flow.scale * d, spherical))
          return false;
        write_tensor(flow.scale * Q + std::cbrt(J * J) *
                                        (spherical - flow.scale * third) *
                                        symmetrize(transpose(G) * G),
                     new_history,
                     1);
      }

    if (dP_dF != nullptr)
      {
        Tensor<4, 3>      &A       = *dP_dF;
        const Tensor<2, 3> d_third = 2. / 3. * (H - third * G);
        Tensor<2, 3>       dg = K * J * J * G - (flow.scale * mu) * d_third;
        A                     = 0.;
        if (flow.is_plastic)
          {
            // dq, then d(dp) of q - 3 mu third dp = R, then that of the scale
            const double       c = 1.5 * mu * mu / q;
            const Tensor<2, 3> dq =
              2. * c * (d * H - (d.norm_square() / 3.) * G);
            const double       stiffness = 3. * mu * third + flow.slope;
            const Tensor<2, 3> d_dp =
              (dq - (3. * flow.dp * mu) * d_third) / stiffness;
            const Tensor<2, 3> d_scale =
              (flow.slope * d_dp - flow.scale * dq) / q;
            dg -= (mu * third) * d_scale;
            add_product(A, mu, H, d_scale);
          }
        add_product(A, 1., G, dg);
        add_crossed_product(A, -g, G, G);
        add_material(A, (flow.scale * mu) * Qs);
        add_product(A, -2. / 3. * flow.scale * mu, H, G);
      }
    return true;
  }



  double
  SimoMiehe::longitudinal_modulus() const
  {
    return constants.lame_lambda() + 2. * constants.shear_modulus();
  }
} // namespace stickslip
