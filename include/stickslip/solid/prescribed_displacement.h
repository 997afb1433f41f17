#ifndef stickslip_solid_prescribed_displacement_h
#define stickslip_solid_prescribed_displacement_h

#include <stickslip/base/types.h>

#include <stickslip/mesh/body.h>

#include <stickslip/base/space_time_function.h>
#include <stickslip/solid/active_interval.h>
#include <stickslip/solid/boundary_condition_parameters.h>
#include <stickslip/solid/cylindrical_frame.h>
#include <stickslip/solid/rigid_motion.h>

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/hp/mapping_collection.h>

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace stickslip
{
  /**
   * One condition of the types displacement, symmetry and rigid motion.
   */
  template <int dim>
  struct PrescribedDisplacement
  {
    std::string                  name; ///< as in the parameter file
    BoundaryConditionType        type;
    unsigned int                 body;
    std::set<types::boundary_id> boundary_ids; ///< global; empty: whole body

    /// Of a displacement: the components' values.
    std::shared_ptr<const SpaceTimeFunction<dim>> value;

    /// Of a rigid motion.
    RigidMotion<dim> motion;

    /// If given: holds only at nodes where this function is not zero.
    std::shared_ptr<const SpaceTimeFunction<dim>> where;

    ActiveInterval active;

    /// Of the components of a displacement, if not Cartesian.
    std::optional<CylindricalFrame<dim>> frame;

    /// Not the user's: no radial displacement on the axis of a body of
    /// revolution. No force is needed for that.
    bool is_of_axis = false;

    /// A rigid motion some of whose components are free: its nodes follow a
    /// reference point (RigidCoupling).
    bool
    is_coupling() const
    {
      return motion.has_free_components();
    }
  };

  /// Where an image of a node is (mesh/periodic_nodes.h), and the rotation of
  /// the displacement of the node to that of the image.
  template <int dim>
  struct NodeImage
  {
    Point<dim>     position;
    Tensor<2, dim> Q;
  };

  /**
   * A node whose displacement is prescribed along one or more directions, or
   * that follows a reference point.
   */
  template <int dim>
  struct HeldNode
  {
    /// direction . u = value
    struct Row
    {
      Tensor<1, dim> direction; ///< of unit length
      double         value;
      unsigned int   condition; ///< index into the conditions

      /// Of what is prescribed there; these come behind the others.
      std::optional<NodeImage<dim>> image = {};

      /// Directions that differ by less are the same: mesh files have rounded
      /// numbers, and images are not quite where the motion has them.
      double
      same_direction() const
      {
        return image ? 1e-4 : 1e-6;
      }

      /// The part of a force along the unit vector @p d, which is held by this
      /// row, where the condition is.
      Tensor<1, dim>
      turned(const Tensor<1, dim> &d) const
      {
        return image ? image->Q * d : d;
      }
    };

    std::array<types::global_dof_index, dim> dofs;
    Point<dim>                               position; ///< reference
    unsigned int                             body;
    double                                   cell_diameter;
    std::vector<Row>                         rows;

    /// The condition whose reference point the node follows, or invalid.
    unsigned int coupling = numbers::invalid_unsigned_int;

    bool
    is_coupled() const
    {
      return coupling != numbers::invalid_unsigned_int;
    }
  };

  /**
   * All locally owned nodes that @p conditions hold at time @p time, by the
   * first of their degrees of freedom. They are complete, because every cell
   * at a locally owned node is locally owned or ghost. Not collective; an
   * error of the user (a symmetry boundary that is not plane) is added to
   * @p error for the caller to throw it on all ranks.
   */
  template <int dim>
  std::map<types::global_dof_index, HeldNode<dim>>
  find_held_nodes(const hp::MappingCollection<dim>               &mapping,
                  const DoFHandler<dim>                          &dof_handler,
                  const Bodies                                   &bodies,
                  const std::vector<PrescribedDisplacement<dim>> &conditions,
                  const double                                    time,
                  std::string                                    &error);
} // namespace stickslip

#endif
