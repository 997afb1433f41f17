#include <stickslip/problem/rigid_tools.h>

#include <stickslip/base/axes_across.h>
#include <stickslip/base/user_error.h>

#include <stickslip/contact/surface/tool_shapes.h>

#include <stickslip/mesh/body_mesh.h>
#include <stickslip/mesh/mesh_generator.h>
#include <stickslip/mesh/tool_generators.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace stickslip
{
  namespace
  {
    /// Reads the arguments of a tool.
    struct Reader
    {
      std::string              name;
      std::vector<std::string> values;
      std::string              path;

      double
      number(const unsigned int i) const
      {
        return tool_numbers(values[i], 1, path)[0];
      }

      template <int dim>
      Point<dim>
      point(const unsigned int i) const
      {
        return tool_point<dim>(values[i], path);
      }

      ToolSide
      side(const unsigned int i) const
      {
        if (values[i] == "inside")
          return ToolSide::inside;
        if (values[i] == "around")
          return ToolSide::around;
        throw UserError(path + ": '" + values[i] +
                        "' is no side. Allowed: inside, around.");
      }

      bool
      yes(const unsigned int i) const
      {
        if (values[i] == "true" || values[i] == "false")
          return values[i] == "true";
        throw UserError(path + ": 'closed' is '" + values[i] +
                        "'. Allowed: true, false.");
      }

      ToolProfile
      profile() const
      {
        std::vector<ProfileVertex> vertices;
        for (const auto &text : Utilities::split_string_list(values[0], ';'))
          {
            const auto numbers = tool_numbers(text, 0, path);
            if (numbers.size() != 2 && numbers.size() != 3)
              throw UserError(path + ": the vertex '" + text +
                              "' has to be 'x, y' or 'x, y, fillet'.");
            vertices.push_back({Point<2>(numbers[0], numbers[1]),
                                numbers.size() == 3 ? numbers[2] : 0.});
          }
        return ToolProfile::polyline(vertices, yes(1), path);
      }
    };



    ToolSurface<2>
    surface_of(const Reader &read, const ToolSurface<2> *)
    {
      if (read.name == "tool_circle")
        return make_circle(read.point<2>(0),
                           read.number(1),
                           read.side(2),
                           read.path);
      if (read.name == "tool_plane")
        return make_plane<2>(read.point<2>(0),
                             read.point<2>(1),
                             read.number(2),
                             read.path);
      return ToolSurface<2>(read.profile());
    }



    ToolSurface<3>
    swept(const Reader &read)
    {
      ToolSweep sweep;
      if (read.name == "tool_revolved")
        {
          sweep.origin = read.point<3>(2);
          sweep.axis   = read.point<3>(3);
          sweep.first  = axes_across(sweep.axis)[0];
          return {read.profile(), sweep, read.path};
        }
      const double length = read.number(2);
      sweep.kind          = ToolSweep::Kind::extruded;
      sweep.origin        = read.point<3>(3);
      sweep.axis          = read.point<3>(4);
      sweep.first         = read.point<3>(5);
      sweep.from          = -0.5 * length;
      sweep.to            = 0.5 * length;
      return {read.profile(), sweep, read.path};
    }



    ToolSurface<3>
    surface_of(const Reader &read, const ToolSurface<3> *)
    {
      const auto &path = read.path;
      if (read.name == "tool_extruded" || read.name == "tool_revolved")
        return swept(read);
      const Point<3> centre = read.point<3>(0);
      if (read.name == "tool_sphere")
        return make_sphere(centre, read.number(1), read.side(2), path);
      const Point<3> axis = read.point<3>(1);
      if (read.name == "tool_plane")
        return make_plane<3>(centre, axis, read.number(2), path);
      if (read.name == "tool_cylinder")
        return make_cylinder(
          centre, axis, read.number(2), read.number(3), read.side(4), path);
      if (read.name == "tool_rounded_cylinder")
        return make_rounded_cylinder(
          centre, axis, read.number(2), read.number(3), read.number(4), path);
      if (read.name == "tool_cone")
        return make_cone(
          centre, axis, read.number(2), read.number(3), read.number(4), path);
      return make_torus(
        centre, axis, read.number(2), read.number(3), read.side(4), path);
    }



    template <int dim>
    ToolSurface<dim>
    given_surface(const BodyParameters &parameters, const std::string &path)
    {
      const Reader read{parameters.generator,
                        generator_arguments(parameters.generator,
                                            parameters.arguments,
                                            dim,
                                            path),
                        path + "/Arguments"};
      return surface_of(read, static_cast<const ToolSurface<dim> *>(nullptr));
    }



    template <int dim>
    std::function<double(const Point<3> &)>
    distance_in(const BodyParameters &parameters, const std::string &path)
    {
      const auto           motion = body_motion<dim>(parameters, path);
      const Tensor<2, dim> back   = invert(motion.linear);
      return [surface = given_surface<dim>(parameters, path), motion, back](
               const Point<3> &p) {
        Tensor<1, dim> x;
        for (unsigned int d = 0; d < dim; ++d)
          x[d] = p[d];
        const auto foot =
          surface.closest(Point<dim>(back * (x - motion.shift)));
        if (!foot.found)
          return std::numeric_limits<double>::infinity();
        const Tensor<1, dim> nearest = surface.evaluate(foot.chart, foot.xi).x;
        return (x - motion.linear * nearest - motion.shift).norm();
      };
    }



    /// Vertices of a cell that span it.
    template <int dim>
    std::vector<unsigned int>
    spanning_vertices(const ReferenceCell &cell)
    {
      if (cell.is_simplex())
        return dim == 2 ? std::vector<unsigned int>{0, 1, 2}
                        : std::vector<unsigned int>{0, 1, 2, 3};
      return dim == 2 ? std::vector<unsigned int>{0, 1, 2}
                      : std::vector<unsigned int>{0, 1, 2, 4};
    }



    /// The frame of one of this rank's cells behind @p boundary, as a face; or
    /// none.
    template <int dim>
    std::vector<SurfaceFace<dim>>
    local_frame(const std::set<types::boundary_id> &boundary,
                const DoFHandler<dim>              &dof_handler)
    {
      std::vector<SurfaceFace<dim>> frames;
      for (const auto &cell : dof_handler.active_cell_iterators())
        for (const unsigned int f : cell->face_indices())
          if (frames.empty() && cell->is_locally_owned() &&
              cell->at_boundary(f) &&
              boundary.count(cell->face(f)->boundary_id()) > 0)
            {
              SurfaceFace<dim> frame;
              frame.id.cell = cell->id().template to_binary<dim>();
              frame.id.face = f;
              frame.owner   = Utilities::MPI::this_mpi_process(
                dof_handler.get_communicator());
              frame.diameter = cell->diameter();
              for (const unsigned int v :
                   spanning_vertices<dim>(cell->reference_cell()))
                {
                  frame.reference_positions.push_back(cell->vertex(v));
                  for (unsigned int c = 0; c < dim; ++c)
                    frame.dofs.push_back(cell->vertex_dof_index(v, c));
                }
              frame.n_nodes = frame.reference_positions.size();
              frames.push_back(frame);
            }
      return frames;
    }
  } // namespace



  template <int dim>
  ToolMaster<dim>
  make_tool_master(const BodyParameters               &parameters,
                   const std::string                  &path,
                   const std::set<types::boundary_id> &boundary,
                   const DoFHandler<dim>              &dof_handler,
                   const MPI_Comm                     &communicator)
  {
    const auto surface = given_surface<dim>(parameters, path);

    ToolMaster<dim>  master;
    const auto       own = local_frame(boundary, dof_handler);
    const auto       all = Utilities::MPI::all_gather(communicator, own);
    SurfaceFace<dim> frame;
    for (const auto &of_rank : all)
      if (!of_rank.empty() &&
          (frame.n_nodes == 0 || of_rank.front().id < frame.id))
        frame = of_rank.front();
    if (!own.empty() && own.front().id == frame.id)
      master.owned_frame = own;

    const auto              motion = body_motion<dim>(parameters, path);
    const Tensor<2, dim>    back   = invert(motion.linear);
    std::vector<Point<dim>> nodes;
    for (const auto &x : frame.reference_positions)
      nodes.emplace_back(back * (x - motion.shift));
    master.tool = std::make_shared<RigidTool<dim>>(
      RigidTool<dim>{surface, ToolFrame<dim>(nodes)});
    return master;
  }



  std::function<double(const Point<3> &)>
  distance_from_tool(const BodyParameters &parameters,
                     const std::string    &path,
                     const unsigned int    dim)
  {
    return dim == 2 ? distance_in<2>(parameters, path)
                    : distance_in<3>(parameters, path);
  }

#define INSTANTIATE(dim)                     \
  template ToolMaster<dim> make_tool_master( \
    const BodyParameters &,                  \
    const std::string &,                     \
    const std::set<types::boundary_id> &,    \
    const DoFHandler<dim> &,                 \
    const MPI_Comm &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
