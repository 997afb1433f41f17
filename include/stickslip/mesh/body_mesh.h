#ifndef stickslip_mesh_body_mesh_h
#define stickslip_mesh_body_mesh_h

#include <stickslip/mesh/body_parameters.h>
#include <stickslip/mesh/labelled_ids.h>
#include <stickslip/mesh/mesh_parameters.h>
#include <stickslip/mesh/mesh_reader.h>
#include <stickslip/mesh/mesh_size.h>
#include <stickslip/mesh/quadratic_cells.h>
#include <stickslip/mesh/transformed_manifold.h>

#include <deal.II/grid/manifold.h>
#include <deal.II/grid/tria.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace stickslip
{
  /**
   * The serial mesh of one body in its final place, before it is joined with
   * the others. Boundary ids are those of `boundaries`, cell->material_id() is
   * an index into `materials`. `manifolds` holds the manifolds of the final
   * place for the ids that are still in use (the triangulation's own may be
   * outdated). `curved_cells` is the geometry of cells of the second order and
   * of those that 'Coordinates' bends, no pointer if the body has none; it is a
   * manifold like others afterwards.
   */
  template <int dim>
  struct BodyMesh
  {
    Triangulation<dim>                   triangulation;
    std::shared_ptr<QuadraticCells<dim>> curved_cells;
    /// in the mesh file, and not where straight cells have them
    bool                     has_nodes_between_vertices = false;
    LabelledIds              boundaries;
    std::vector<std::string> materials;
    std::vector<std::string> warnings; ///< for the user
    std::map<types::manifold_id, std::unique_ptr<Manifold<dim, dim>>> manifolds;
  };

  /// Where a body is put after its generation: scaled, rotated, translated.
  /// Throws UserError that blames parameters below @p path.
  template <int dim>
  AffineMap<dim>
  body_motion(const BodyParameters &parameters, const std::string &path);

  /**
   * Generates or reads, shapes, refines, moves and marks one body. Collective
   * (mesh files). @p path is the body's subsection. @p size refuses
   * what does not fit before it is made. Throws UserError on all ranks.
   */
  template <int dim>
  std::unique_ptr<BodyMesh<dim>>
  make_body_mesh(const BodyParameters &parameters,
                 const std::string    &path,
                 const MeshParameters &mesh,
                 MeshFiles            &files,
                 const MeshSize       &size);
} // namespace stickslip

#endif
