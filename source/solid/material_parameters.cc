#include <stickslip/base/user_error.h>

#include <stickslip/solid/material_parameters.h>
#include <stickslip/solid/plane_stress.h>

#include <algorithm>

namespace stickslip
{
  void
  MaterialParameters::choose_law(const std::string &name,
                                 const std::string &path)
  {
    law_object = create_constitutive_law(name, path + "/Law");
    law        = name;
  }



  void
  MaterialParameters::add_parameters(ParameterHandler &prm)
  {
    if (!law_object)
      law_object = create_constitutive_law(law, "Law");

    std::string names;
    for (const std::string &name : constitutive_law_names())
      names += (names.empty() ? "" : "|") + name;
    prm.add_parameter("Law",
                      law,
                      "The constitutive law. " +
                        constitutive_law_descriptions(),
                      Patterns::Selection(names));
    prm.add_parameter("Plane stress",
                      plane_stress,
                      "In 2D: no stress normal to the plane, instead of no "
                      "strain.",
                      Patterns::Bool());
    law_object->add_parameters(prm);
  }



  void
  MaterialParameters::check(const std::string &path,
                            const unsigned int dim) const
  {
    Assert(law_object, ExcMessage("choose_law() goes first."));
    if (plane_stress && dim != 2)
      throw UserError(path + "/Plane stress is true, but Dimension is " +
                      std::to_string(dim) + ": plane stress is for 2.");
    law_object->check(path);
  }



  std::shared_ptr<const ConstitutiveLaw>
  MaterialParameters::constitutive_law() const
  {
    Assert(law_object, ExcMessage("choose_law() goes first."));
    if (plane_stress)
      return std::make_shared<PlaneStress>(law_object);
    return law_object;
  }



  std::vector<std::shared_ptr<const ConstitutiveLaw>>
  laws_of_regions(const NamedList<MaterialParameters> &materials,
                  const Bodies                        &bodies)
  {
    std::string known;
    for (const auto &material : materials)
      known += (known.empty() ? "'" : ", '") + material.first + "'";

    std::vector<std::shared_ptr<const ConstitutiveLaw>> laws;
    for (const Region &region : bodies.regions)
      {
        const Body &body = bodies.bodies[region.body];
        if (body.is_rigid && region.material.empty())
          {
            laws.push_back(nullptr);
            continue;
          }

        const auto material =
          std::find_if(materials.begin(),
                       materials.end(),
                       [&region](const auto &named) {
                         return named.first == region.material;
                       });
        if (material == materials.end())
          throw UserError("Bodies/" + body.name + "/Material: '" +
                          region.material +
                          "' is not in the section Materials. Known there: " +
                          (known.empty() ? "none" : known) + ".");
        laws.push_back(material->second.constitutive_law());
      }
    return laws;
  }
} // namespace stickslip
