#ifndef stickslip_output_field_output_h
#define stickslip_output_field_output_h

#include <stickslip/base/types.h>
#include <stickslip/mesh/body.h>
#include <stickslip/output/material_fields.h>
#include <stickslip/output/output_parameters.h>
#include <stickslip/output/output_series.h>

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/hp/mapping_collection.h>

#include <deal.II/lac/vector.h>

#include <string>
#include <utility>
#include <vector>

namespace stickslip
{
  /// Numbers of cells by name, by active_cell_index.
  using NamedCellValues = std::vector<std::pair<std::string, Vector<float>>>;



  /**
   * The fields of the bodies as files for ParaView: displacement, Cauchy
   * stress, von Mises stress, strain, history variables of the laws (such as
   * the equivalent plastic strain) by their names, body, material region, rank,
   * and what else is known of each cell.
   *
   * Stress, strain and history are projected cell by cell (L2) to discontinuous
   * (bi-, tri-)linears and never averaged over cells, so that jumps between
   * cells, which tell about the discretization error, stay visible. In 2D the
   * out-of-plane components are fields of their own ("cauchy_stress_zz").
   *
   * The grid is the undeformed one, to be warped by "displacement", unless
   * Output/Deformed is set.
   */
  template <int dim>
  class FieldOutput
  {
  public:
    /// VTU files have pieces of at most @p cells_of_piece cells: their patches
    /// take 3 kB each (those of quadratic tetrahedra three times as much), and
    /// are in memory at the same time.
    FieldOutput(const OutputParameters &parameters,
                const Bodies           &bodies,
                const MPI_Comm          communicator,
                const unsigned int      cells_of_piece = 8192);

    /// Continues the series of an earlier run after @p time. Collective.
    void
    resume(const double time);

    /**
     * Writes one step. @p displacement is ghosted; @p material may be empty.
     * Collective; throws UserError on all ranks if writing fails.
     */
    void
    write(const unsigned int                step,
          const double                      time,
          const hp::MappingCollection<dim> &mapping,
          const DoFHandler<dim>            &dof_handler,
          const LA::Vector                 &displacement,
          const MaterialFields<dim>        &material,
          const NamedCellValues            &of_cells = {});

  private:
    const unsigned int cells_of_piece;
    const bool         deformed;
    const bool         is_vtu;
    const Bodies      &bodies;

    OutputSeries series;

    /// The owned cells of deformable bodies and rigid ones with a mesh.
    std::vector<typename Triangulation<dim>::cell_iterator>
    cells_to_write(const Triangulation<dim> &triangulation) const;
  };
} // namespace stickslip

#endif
