#ifndef stickslip_problem_rigid_tools_h
#define stickslip_problem_rigid_tools_h

#include <stickslip/contact/pairing/contact_pair.h>

#include <stickslip/mesh/body.h>

#include <functional>
#include <set>
#include <string>

namespace stickslip
{
  /**
   * The surface of the rigid tool that was given with the @p parameters of a
   * body below @p path, moving with the nodes of one of the cells behind
   * @p boundary. Throws UserError (same on all ranks) if there is no such
   * surface. Collective.
   */
  template <int dim>
  ToolMaster<dim>
  make_tool_master(const BodyParameters               &parameters,
                   const std::string                  &path,
                   const std::set<types::boundary_id> &boundary,
                   const DoFHandler<dim>              &dof_handler,
                   const MPI_Comm                     &communicator);

  /// The distance of a place from that surface where nothing has moved, in
  /// @p dim dimensions; infinity if no point of it is the closest one. Throws
  /// UserError (same on all ranks) if there is no such surface.
  std::function<double(const Point<3> &)>
  distance_from_tool(const BodyParameters &parameters,
                     const std::string    &path,
                     const unsigned int    dim);
} // namespace stickslip

#endif
