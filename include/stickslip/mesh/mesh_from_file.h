#ifndef stickslip_mesh_mesh_from_file_h
#define stickslip_mesh_mesh_from_file_h

#include <stickslip/mesh/file/mesh_file.h>
#include <stickslip/mesh/labelled_ids.h>
#include <stickslip/mesh/quadratic_cells.h>

#include <deal.II/grid/tria.h>

#include <memory>
#include <string>
#include <vector>

namespace stickslip
{
  /**
   * Makes the mesh of one body from the cells of a file: those of the @p groups
   * (names or numbers), or all. Boundary and material ids are those of
   * @p boundaries and @p materials. A node set marks the boundary faces whose
   * vertices are all in it, unless all vertices of the body are.
   *
   * The cells of the triangulation have the vertices of the file. Returns the
   * geometry of cells of the second order if any of them is curved (see
   * curved_cells()), no pointer otherwise.
   *
   * The same on each rank. Throws UserError that begins with @p where (file
   * and parameter) for unknown groups, cells that cannot be used, cells that
   * overlap, a 2D mesh that is not plane. @p path is the body's subsection.
   */
  template <int dim>
  std::shared_ptr<QuadraticCells<dim>>
  make_triangulation(const MeshFile                 &file,
                     const std::vector<std::string> &groups,
                     const std::string              &where,
                     const std::string              &path,
                     Triangulation<dim>             &triangulation,
                     LabelledIds                    &boundaries,
                     LabelledIds                    &materials);
} // namespace stickslip

#endif
