#include <stickslip/solid/volumetric_locking.h>

#include <stickslip/mesh/reference_cells.h>

#include <algorithm>

namespace stickslip
{
  namespace
  {
    constexpr double largest_poisson_ratio = 0.4;



    /// At rest: lambda / (2 lambda + 2 mu).
    double
    poisson_ratio(const ConstitutiveLaw &law)
    {
      std::vector<double> history(law.n_history_variables()), new_history;
      law.initialize_history(ArrayView<double>(history.data(), history.size()));
      new_history = history;
      const Tensor<2, 3> rest(unit_symmetric_tensor<3>());
      Tensor<2, 3>       P;
      Tensor<4, 3>       tangent;
      law.evaluate(rest,
                   ArrayView<const double>(history.data(), history.size()),
                   ArrayView<double>(new_history.data(), new_history.size()),
                   P,
                   &tangent);
      const double lambda = tangent[0][0][1][1], mu = tangent[0][1][0][1];
      return lambda / (2. * (lambda + mu));
    }



    /// Why the material locks; empty if it does not.
    std::string
    reason_to_lock(const MaterialParameters &material)
    {
      const auto law = material.constitutive_law();
      if (material.plane_stress)
        return "";
      if (law->n_history_variables() > 0)
        return "is plastic";
      return poisson_ratio(*law) > largest_poisson_ratio
               ? "has a Poisson's ratio above 0.4"
               : "";
    }
  } // namespace



  std::vector<std::string>
  warnings_about_locking(const NamedList<MaterialParameters> &materials,
                         const Bodies                        &bodies,
                         const unsigned int                   degree)
  {
    std::vector<std::string> warnings;
    if (degree > 1)
      return warnings;
    for (const auto &[name, material] : materials)
      {
        const auto region =
          std::find_if(bodies.regions.begin(),
                       bodies.regions.end(),
                       [&, &wanted = name](const Region &region) {
                         return region.material == wanted &&
                                bodies.bodies[region.body].cells.is_simplex();
                       });
        const bool        is_used = region != bodies.regions.end();
        const std::string reason  = is_used ? reason_to_lock(material) : "";
        if (!reason.empty())
          warnings.push_back("Materials/" + name + " " + reason + ": " +
                             plural(bodies.bodies[region->body].cells) +
                             " of degree 1 lock, they are far too stiff, also "
                             "with F-bar and B-bar. Set 'Degree = 2'.");
      }
    return warnings;
  }
} // namespace stickslip
