#ifndef stickslip_mesh_refinement_parameters_h
#define stickslip_mesh_refinement_parameters_h

#include <stickslip/base/choice.h>
#include <stickslip/mesh/named_surface.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/point.h>

#include <functional>
#include <string>
#include <vector>

namespace stickslip
{
  using namespace dealii;

  /// Which cells a rule refines.
  enum class RefinementType
  {
    box,       ///< between two corners
    sphere,    ///< around a centre
    condition, ///< where an expression holds
    boundary,  ///< near boundaries of a body
    contact    ///< near the other surface of a contact pair
  };

  const Choices<RefinementType> &
  all_refinement_types();

  /**
   * Section `Refinement/<rule>`: cells that are refined before the first step,
   * in undeformed coordinates [length]. Rules add up: each cell gets the most
   * levels that one of them wants.
   */
  struct RefinementParameters
  {
    RefinementType           type   = RefinementType::box;
    unsigned int             levels = 1; ///< beyond the global refinements
    std::vector<std::string> bodies;     ///< empty: all
    std::vector<double>      first_corner;
    std::vector<double>      second_corner;
    std::vector<double>      centre;
    double                   radius = 0.;
    std::string              condition;
    std::vector<std::string> boundary; ///< ids or names
    std::string              contact_pair;
    double                   distance      = 0.;
    unsigned int             buffer_layers = 0; ///< of cells, at each level

    void
    add_parameters(ParameterHandler &prm);

    /// Throws UserError for what is wrong in @p dim dimensions; @p path is the
    /// subsection.
    void
    check(const std::string &path, const unsigned int dim) const;
  };

  /// A rule, and the surfaces of the pair that it names.
  struct RefinementRequest
  {
    std::string          path;
    RefinementParameters parameters;
    NamedSurface         slave;
    NamedSurface         master;

    /// Of an undeformed place from the master, infinity where the surface has
    /// ended [length]. Empty: the master is no rigid tool, which has no faces.
    std::function<double(const Point<3> &)> distance_from_tool = {};
  };
} // namespace stickslip

#endif
