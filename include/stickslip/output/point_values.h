#ifndef stickslip_output_point_values_h
#define stickslip_output_point_values_h

#include <stickslip/base/types.h>
#include <stickslip/mesh/body.h>
#include <stickslip/output/material_fields.h>
#include <stickslip/output/output_parameters.h>
#include <stickslip/output/statistics_table.h>
#include <stickslip/output/surface_values.h>

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/hp/mapping_collection.h>

#include <string>
#include <vector>

namespace stickslip
{
  /**
   * The displacement at named points of the bodies over the steps, written
   * into points.csv with the columns step, time, NAME_x, NAME_y(, NAME_z), and
   * for points with "Material state" NAME.cauchy_stress_xx and so on, for those
   * with "Contact pair" NAME.pressure, NAME.gap and NAME.tangential_traction_x.
   *
   * A point belongs to a cell of its body (of the undeformed mesh): among the
   * cells that contain it the one with the smallest CellId, which does not
   * depend on the number of ranks.
   */
  template <int dim>
  class PointValues
  {
  public:
    PointValues(const OutputParameters &parameters,
                const Bodies           &bodies,
                const MPI_Comm          communicator);

    /**
     * Finds the cells of the points; to be called again when the mesh or its
     * distribution changes. Points outside of the body, but closer than 5 %
     * of the cell size (on a curved boundary), take the nearest place of the
     * cell. Collective; throws UserError on all ranks if a point is not in
     * its body or has not `dim` coordinates.
     */
    void
    locate(const hp::MappingCollection<dim> &mapping,
           const DoFHandler<dim>            &dof_handler);

    /**
     * The displacements at the points, in the order of Output/Points, on all
     * ranks. @p displacement is ghosted. Collective.
     */
    std::vector<Tensor<1, dim>>
    evaluate(const LA::Vector &displacement) const;

    /// A result at a point. Results of one family have one unit.
    struct NamedValue
    {
      std::string family, name;
      double      value;
    };

    /**
     * Displacements, material states and contact under their names, in this
     * order, on all ranks. @p faces: the locally owned slave faces. Collective.
     */
    std::vector<NamedValue>
    named_values(const LA::Vector                          &displacement,
                 const MaterialFields<dim>                 &material,
                 const std::vector<ContactFaceResult<dim>> &faces) const;

    /// Continues points.csv of an earlier run after @p time. Collective.
    void
    resume(const double time);

    /// Evaluates and appends a row to points.csv. Collective.
    void
    write(const unsigned int                         step,
          const double                               time,
          const LA::Vector                          &displacement,
          const MaterialFields<dim>                 &material = {},
          const std::vector<ContactFaceResult<dim>> &faces    = {});

    const StatisticsTable &
    values_of_steps() const
    {
      return table;
    }

  private:
    struct NamedPoint
    {
      std::string  name;
      unsigned int body;
      Point<dim>   position;
      bool         material_state;
    };

    /// Place of a point in a locally owned cell.
    struct Location
    {
      typename DoFHandler<dim>::active_cell_iterator cell;
      Point<dim>                                     unit_point;
      /// Distance from the cell in units of its reference cell, 0 inside.
      double distance;
    };

    Location
    locate_locally(const NamedPoint                 &point,
                   const hp::MappingCollection<dim> &mapping,
                   const DoFHandler<dim>            &dof_handler) const;

    /// Adds the stress and the history of a point. Collective.
    void
    add_material_state(const unsigned int         point,
                       const MaterialFields<dim> &material,
                       std::vector<NamedValue>   &values) const;

    const Bodies  &bodies;
    const MPI_Comm communicator;

    /// Adds pressure, gap and traction of the points on slave surfaces.
    /// Collective.
    void
    add_contact(const std::vector<ContactFaceResult<dim>> &faces,
                std::vector<NamedValue>                   &values) const;

    std::vector<NamedPoint>        points;
    std::vector<SurfacePoint<dim>> surface_points; ///< some of them
    std::vector<std::string>       names_of_surface_points;
    /// Per point; the cell is valid on the one rank that owns it.
    std::vector<Location> locations;

    StatisticsTable table;
  };
} // namespace stickslip

#endif
