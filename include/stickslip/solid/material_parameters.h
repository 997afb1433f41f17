#ifndef stickslip_solid_material_parameters_h
#define stickslip_solid_material_parameters_h

#include <stickslip/base/choice.h>
#include <stickslip/base/parameter_file.h>

#include <stickslip/mesh/body.h>

#include <stickslip/solid/constitutive_law.h>

#include <deal.II/base/mpi.h>

#include <memory>
#include <string>
#include <vector>

namespace stickslip
{
  /// The deformation that the law sees at a quadrature point.
  enum class ElementType
  {
    standard, ///< of the point
    f_bar,    ///< with the cell's mean change of volume, large strains
    b_bar     ///< the same for small strains
  };

  /**
   * The parameters of one material: the name of the law and that law's own
   * parameters, and no others. Because the set of parameters depends on the
   * law, choose_law() goes before add_parameters().
   */
  struct MaterialParameters
  {
    std::string law          = "linear elastic";
    bool        plane_stress = false;
    ElementType element      = ElementType::standard;

    /// Takes the law of that name; throws UserError naming @p path ("Materials/
    /// steel") and the known names.
    void
    choose_law(const std::string &name, const std::string &path);

    /// Declares "Law", "Plane stress", "Element" and the parameters of the
    /// chosen law.
    void
    add_parameters(ParameterHandler &prm);

    /// As ConstitutiveLaw::read_files(). Collective.
    void
    read_files(const std::string &path,
               const std::string &directory,
               const MPI_Comm     communicator);

    /// Throws UserError for impossible values; @p degree is that of the
    /// displacements.
    void
    check(const std::string &path,
          const unsigned int dim,
          const unsigned int degree) const;

    /// The law, within PlaneStress if that was asked for.
    std::shared_ptr<const ConstitutiveLaw>
    constitutive_law() const;

  private:
    /// Throws UserError if the element does not fit to law and degree.
    void
    check_element(const std::string &path, const unsigned int degree) const;

    std::shared_ptr<ConstitutiveLaw> law_object;
  };

  /**
   * The law of each region, indexed by material id. Regions of rigid bodies
   * need no material: an empty name there gives a null pointer. Throws
   * UserError listing the materials if a region names an unknown one.
   */
  std::vector<std::shared_ptr<const ConstitutiveLaw>>
  laws_of_regions(const NamedList<MaterialParameters> &materials,
                  const Bodies                        &bodies);

  /// Whether a region has F-bar or B-bar elements, indexed by material id.
  std::vector<bool>
  mean_dilatation_of_regions(const NamedList<MaterialParameters> &materials,
                             const Bodies                        &bodies);
} // namespace stickslip

#endif
