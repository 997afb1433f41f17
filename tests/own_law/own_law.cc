// A program with a law of its own: the foam of Blatz and Ko beside all that
// stickslip has. The manual explains it (doc/developers.md).

#include <stickslip/base/user_error.h>

#include <stickslip/simulation/program.h>

#include <stickslip/solid/constitutive_law.h>

#include <deal.II/base/patterns.h>

#include <memory>
#include <string>

namespace
{
  using namespace dealii;

  // [law]
  /// W = mu/2 (tr C^-1 + 2 J - 5): a foam with Poisson's ratio 1/4.
  class BlatzKo : public stickslip::ConstitutiveLaw
  {
  public:
    void
    add_parameters(ParameterHandler &prm) override
    {
      prm.add_parameter("Shear modulus",
                        mu,
                        "Force per area; greater than zero.",
                        Patterns::Double());
    }

    void
    check(const std::string &path) const override
    {
      if (!(mu > 0.))
        throw stickslip::UserError("'" + path + "/Shear modulus' is " +
                                   std::to_string(mu) +
                                   ". Allowed: greater than zero.");
    }

    bool
    evaluate(const Tensor<2, 3> &F,
             const ArrayView<const double> & /*old_history*/,
             const ArrayView<double> & /*new_history*/,
             Tensor<2, 3> &P,
             Tensor<4, 3> *dP_dF) const override
    {
      const double J = determinant(F);
      if (!(J > 0.))
        return false;
      const Tensor<2, 3> G = transpose(invert(F));
      const Tensor<2, 3> H = G * transpose(G) * G;
      P                    = mu * (J * G - H);
      if (dP_dF != nullptr)
        tangent(G, H, J, *dP_dF);
      return true;
    }

    double
    longitudinal_modulus() const override
    {
      return 3. * mu;
    }
    // [end of law]

  private:
    /// With dG_iJ = -G_iL G_kJ dF_kL and dJ = J G_kL dF_kL.
    void
    tangent(const Tensor<2, 3> &G,
            const Tensor<2, 3> &H,
            const double        J,
            Tensor<4, 3>       &A) const
    {
      const Tensor<2, 3> left  = G * transpose(G);
      const Tensor<2, 3> right = transpose(G) * G;
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          for (unsigned int k = 0; k < 3; ++k)
            for (unsigned int l = 0; l < 3; ++l)
              A[i][j][k][l] =
                mu * (J * (G[k][l] * G[i][j] - G[i][l] * G[k][j]) +
                      G[i][l] * H[k][j] + left[i][k] * right[j][l] +
                      H[i][l] * G[k][j]);
    }

    double mu = 1.;
  };
} // namespace



// [main]
int
main(int argc, char **argv)
{
  stickslip::register_constitutive_law(
    "Blatz-Ko", "rubber foam, P = mu (J F^-T - F^-T F^-1 F^-T)", [] {
      return std::make_unique<BlatzKo>();
    });
  return stickslip::run_program(argc, argv);
}
// [end of main]
