#include <stickslip/solid/material_parameters.h>

#include <stickslip/base/user_error.h>

#include <stickslip/solid/plane_stress.h>


namespace stickslip
{
  namespace
  {
    const Choices<ElementType> &
    all_element_types()
    {
      static const Choices<ElementType> choices = {
        {"standard", ElementType::standard},
        {"F-bar", ElementType::f_bar},
        {"B-bar", ElementType::b_bar}};
      return choices;
    }
  } // namespace



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
    add_choice(
      prm,
      "Element",
      element,
      all_element_types(),
      "standard: the law sees the deformation of each quadrature point; with "
      "Degree 1 this locks in plastic flow and for Poisson's ratios close to "
      "0.5. F-bar: it sees the mean change of volume of the cell, for laws of "
      "large strains. B-bar: the same for laws of small strains. Both are for "
      "Degree 1; Degree 2 hardly locks.");
    law_object->add_parameters(prm);
  }



  void
  MaterialParameters::read_files(const std::string &path,
                                 const std::string &directory,
                                 const MPI_Comm     communicator)
  {
    Assert(law_object, ExcMessage("choose_law() goes first."));
    law_object->read_files(path, directory, communicator);
  }



  void
  MaterialParameters::check(const std::string &path,
                            const unsigned int dim,
                            const unsigned int degree) const
  {
    Assert(law_object, ExcMessage("choose_law() goes first."));
    if (plane_stress && dim != 2)
      throw UserError(path + "/Plane stress is true, but Dimension is " +
                      std::to_string(dim) + ": plane stress is for 2.");
    law_object->check(path);
    check_element(path, degree);
  }



  void
  MaterialParameters::check_element(const std::string &path,
                                    const unsigned int degree) const
  {
    if (element == ElementType::standard)
      return;
    const std::string found =
      path + "/Element is " + name_of(element, all_element_types()) + ", but ";
    if (degree != 1)
      throw UserError(found + "Degree is " + std::to_string(degree) +
                      ": this element is for 1. Take standard.");
    if (plane_stress)
      throw UserError(found +
                      "Plane stress is true: there the thickness "
                      "follows and nothing locks. Take standard.");
    const bool        is_linear = law_object->is_geometrically_linear();
    const ElementType fitting =
      is_linear ? ElementType::b_bar : ElementType::f_bar;
    if (element != fitting)
      throw UserError(found + "the law '" + law + "' is one of " +
                      (is_linear ? "small" : "large") + " strains. Take " +
                      name_of(fitting, all_element_types()) + ".");
  }



  std::shared_ptr<const ConstitutiveLaw>
  MaterialParameters::constitutive_law() const
  {
    Assert(law_object, ExcMessage("choose_law() goes first."));
    if (plane_stress)
      return std::make_shared<PlaneStress>(law_object);
    return law_object;
  }



  namespace
  {
    /// The material of a region, or a null pointer for rigid bodies without.
    const MaterialParameters *
    material_of(const Region                        &region,
                const NamedList<MaterialParameters> &materials,
                const Bodies                        &bodies)
    {
      const Body &body = bodies.bodies[region.body];
      if (body.is_rigid && region.material.empty())
        return nullptr;
      std::string known;
      for (const auto &[name, material] : materials)
        {
          if (name == region.material)
            return &material;
          known += (known.empty() ? "'" : ", '") + name + "'";
        }
      throw UserError("Bodies/" + body.name + "/Material: '" + region.material +
                      "' is not in the section Materials. Known there: " +
                      (known.empty() ? "none" : known) + ".");
    }
  } // namespace



  std::vector<std::shared_ptr<const ConstitutiveLaw>>
  laws_of_regions(const NamedList<MaterialParameters> &materials,
                  const Bodies                        &bodies)
  {
    std::vector<std::shared_ptr<const ConstitutiveLaw>> laws;
    for (const Region &region : bodies.regions)
      {
        const MaterialParameters *material =
          material_of(region, materials, bodies);
        laws.push_back(material ? material->constitutive_law() : nullptr);
      }
    return laws;
  }



  std::vector<bool>
  mean_dilatation_of_regions(const NamedList<MaterialParameters> &materials,
                             const Bodies                        &bodies)
  {
    std::vector<bool> result;
    for (const Region &region : bodies.regions)
      {
        const MaterialParameters *material =
          material_of(region, materials, bodies);
        result.push_back(material &&
                         material->element != ElementType::standard);
      }
    return result;
  }
} // namespace stickslip
