#ifndef stickslip_mesh_body_parameters_h
#define stickslip_mesh_body_parameters_h

#include <stickslip/mesh/mesh_format.h>

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace stickslip
{
  using namespace dealii;

  /**
   * How one body is made: from a generator or a mesh file, then reshaped
   * (`Coordinates`), refined, scaled, rotated and translated, in this order.
   * After that the conditions of `Boundary ids` and `Material regions` see the
   * final coordinates. Lengths are in the user's unit.
   */
  struct BodyParameters
  {
    std::string generator;
    std::string arguments;
    std::string mesh_file;
    std::vector<std::string>
                 mesh_groups; ///< names or numbers; empty: all cells
    MeshFormat   mesh_format = MeshFormat::automatic;
    std::string  coordinates; ///< expressions "fx; fy; fz"
    unsigned int refinements = 0;
    bool         simplices   = false;

    std::vector<double> scale           = {1.};
    std::vector<double> rotation_axis   = {0., 0., 1.};
    double              rotation_angle  = 0.; ///< degrees
    std::vector<double> rotation_centre = {0., 0., 0.};
    std::vector<double> translation     = {0., 0., 0.};

    std::string boundary_ids;     ///< "id or name: condition; ..."
    std::string material;         ///< name of a section of Materials
    std::string material_regions; ///< "name: condition; name: condition"
    bool        is_rigid = false;

    /// A rigid body without facets, known by its shape (tool_generators.h).
    bool
    is_tool() const;

    /// It moves as a whole, or not at all.
    bool
    moves_as_a_whole() const
    {
      return is_rigid || is_tool();
    }

    void
    add_parameters(ParameterHandler &prm);

    /// Throws UserError for what is wrong in any dimension; @p path is the
    /// body's subsection, e.g. "Bodies/punch".
    void
    check(const std::string &path) const;
  };
} // namespace stickslip

#endif
