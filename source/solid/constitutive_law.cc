#include <stickslip/solid/constitutive_law.h>

#include <stickslip/base/registry.h>

#include <stickslip/solid/hencky.h>
#include <stickslip/solid/hyperelastic.h>
#include <stickslip/solid/linear_elastic.h>
#include <stickslip/solid/neo_hookean.h>
#include <stickslip/solid/saint_venant_kirchhoff.h>
#include <stickslip/solid/simo_miehe.h>
#include <stickslip/solid/small_strain_plasticity.h>

namespace stickslip
{
  namespace
  {
    // The list of laws: a new law is one more entry here. (Those of other
    // programs come by register_constitutive_law().)
    Registry<ConstitutiveLaw> &
    constitutive_laws()
    {
      static Registry<ConstitutiveLaw> registry(
        "constitutive law",
        {{"linear elastic",
          "isotropic linear elasticity at small strains",
          [] { return std::make_unique<LinearElastic>(); }},
         {"St Venant-Kirchhoff",
          "linear between Green-Lagrange strain and second Piola-Kirchhoff "
          "stress, for large rotations and moderate strains (in compression "
          "it softens below a stretch of 0.577)",
          [] { return std::make_unique<SaintVenantKirchhoff>(); }},
         {"neo-Hookean",
          "compressible, P = mu (F - F^-T) + lambda ln J F^-T, for large "
          "strains",
          [] { return std::make_unique<NeoHookean>(); }},
         {"hyperelastic",
          "rubber with C10, C01, C20 and K/2 (J - 1)^2 (Mooney-Rivlin; "
          "neo-Hookean with C10 alone), for large strains",
          [] { return std::make_unique<Hyperelastic>(); }},
         {"Hencky",
          "linear between logarithmic strain and Kirchhoff stress, for large "
          "strains",
          [] { return std::make_unique<Hencky>(); }},
         {"Hencky plasticity",
          "von Mises with isotropic hardening, F = F^e F^p and logarithmic "
          "elastic strains, for large strains",
          [] { return std::make_unique<HenckyPlasticity>(); }},
         {"Simo-Miehe plasticity",
          "von Mises with isotropic hardening, F = F^e F^p and neo-Hookean "
          "elastic response, for large strains",
          [] { return std::make_unique<SimoMiehe>(); }},
         {"small-strain plasticity",
          "von Mises with isotropic and kinematic hardening, small strains; "
          "large rotations with 'Strain measure = Green-Lagrange'",
          [] { return std::make_unique<SmallStrainPlasticity>(); }}});
      return registry;
    }
  } // namespace



  void
  ConstitutiveLaw::initialize_history(const ArrayView<double> &history) const
  {
    for (double &variable : history)
      variable = 0.;
  }



  Tensor<2, 3>
  ConstitutiveLaw::full_deformation_gradient(
    const Tensor<2, 3> &F,
    const ArrayView<const double> &) const
  {
    return F;
  }



  SymmetricTensor<2, 3>
  ConstitutiveLaw::cauchy_stress(const Tensor<2, 3> &F,
                                 const Tensor<2, 3> &P) const
  {
    return symmetrize(P * transpose(F)) / determinant(F);
  }



  SymmetricTensor<2, 3>
  ConstitutiveLaw::strain(const Tensor<2, 3> &F) const
  {
    return 0.5 *
           (symmetrize(transpose(F) * F) - unit_symmetric_tensor<3, double>());
  }



  std::unique_ptr<ConstitutiveLaw>
  create_constitutive_law(const std::string &name,
                          const std::string &parameter_path)
  {
    return constitutive_laws().create(name, parameter_path);
  }



  void
  register_constitutive_law(
    const std::string                                       &name,
    const std::string                                       &description,
    const std::function<std::unique_ptr<ConstitutiveLaw>()> &create)
  {
    if (!constitutive_laws().add({name, description, create}))
      throw UserError("There is a constitutive law '" + name +
                      "' already; the other needs another name.");
  }



  std::vector<std::string>
  constitutive_law_names()
  {
    return constitutive_laws().names();
  }



  std::string
  constitutive_law_descriptions()
  {
    return constitutive_laws().descriptions();
  }
} // namespace stickslip
