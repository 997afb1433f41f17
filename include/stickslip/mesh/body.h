#ifndef stickslip_mesh_body_h
#define stickslip_mesh_body_h

#include <stickslip/base/types.h>
#include <stickslip/mesh/body_parameters.h>
#include <stickslip/mesh/cross_section.h>
#include <stickslip/mesh/labelled_ids.h>
#include <stickslip/mesh/periodicity.h>

#include <deal.II/base/types.h>

#include <deal.II/grid/reference_cell.h>

#include <set>
#include <string>
#include <vector>

namespace stickslip
{
  /// One deformable or rigid body. Its index is its place in the input file.
  struct Body
  {
    std::string name;
    bool        is_rigid = false; ///< moves as a whole, or not at all
    /// Of a body of revolution: it has nodes where the radius is zero.
    bool reaches_axis = false;
    /// The body's own ids, only those with faces.
    std::set<types::boundary_id> boundary_ids;
    /// What the user may call them.
    LabelledIds    boundaries = LabelledIds();
    BodyParameters parameters = {};              ///< how it was made
    ReferenceCell  cells      = ReferenceCell(); ///< all of one kind
  };

  /// Cells of one body with one material: what cell->material_id() points to.
  struct Region
  {
    unsigned int body;
    std::string  material; ///< may be empty for a rigid body
  };

  /**
   * The bodies of the joined triangulation and the meaning of its ids:
   * cell->material_id() is an index into `regions`, and face->boundary_id() is
   * a "global" id, unique over the bodies, so that body 'punch' and body
   * 'block' can both have a boundary 3. Identical on all ranks. No body has the
   * global id 0.
   */
  class Bodies
  {
  public:
    std::vector<Body>             bodies;
    std::vector<Region>           regions;
    CrossSection                  cross_section;
    std::vector<PeriodicBoundary> periodic_boundaries;

    /// Index of the body @p name. Throws UserError (with the known names) that
    /// blames the parameter @p parameter_path.
    unsigned int
    index_of(const std::string &name, const std::string &parameter_path) const;

    /// The triangulation's id of the boundary @p local of body @p body. The id
    /// must exist.
    types::boundary_id
    global_boundary_id(const unsigned int       body,
                       const types::boundary_id local) const;

    /// The triangulation's ids of several boundaries of a body given by name.
    /// @p labels are ids or names, or `all` for the whole boundary. Throws
    /// UserError (with what there is) if there is no such body, if @p labels is
    /// empty or if one marks no face.
    std::set<types::boundary_id>
    global_boundary_ids(const std::string              &body,
                        const std::vector<std::string> &labels,
                        const std::string              &parameter_path) const;

    /// The same for a label that has to stand for one id.
    types::boundary_id
    single_boundary_id(const std::string &body,
                       const std::string &label,
                       const std::string &parameter_path) const;

    /// All of the triangulation's ids of the boundaries of a body.
    std::set<types::boundary_id>
    all_boundary_ids(const unsigned int body) const;

    /// The body that owns the triangulation's boundary id @p global.
    unsigned int
    body_of_boundary(const types::boundary_id global) const;

    /// The user's id of the triangulation's boundary id @p global.
    types::boundary_id
    local_boundary_id(const types::boundary_id global) const;

    unsigned int
    body_of(const types::material_id material_id) const
    {
      return regions[material_id].body;
    }

    unsigned int
    n_bodies() const
    {
      return bodies.size();
    }
  };
} // namespace stickslip

#endif
