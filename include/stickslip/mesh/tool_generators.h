#ifndef stickslip_mesh_tool_generators_h
#define stickslip_mesh_tool_generators_h

#include <stickslip/mesh/mesh_generator.h>

#include <deal.II/base/point.h>

#include <string>
#include <utility>
#include <vector>

namespace stickslip
{
  /*
   * Rigid tools whose surface is known in closed form: the names of their
   * shapes are those of generators. What is generated is one cell, with whose
   * nodes the tool moves; its surface is that of problem/rigid_tools.h.
   */

  const std::vector<GeneratorDescription> &
  tool_descriptions();

  bool
  is_tool(const std::string &generator);

  /// The numbers of a list separated by ','. Throws UserError that blames
  /// @p path if one is none, or if there are not @p n (0: any number of them).
  std::vector<double>
  tool_numbers(const std::string &text,
               const unsigned int n,
               const std::string &path);

  template <int dim>
  Point<dim>
  tool_point(const std::string &text, const std::string &path);

  /// Two opposite corners of the cell of a tool with all its arguments.
  template <int dim>
  std::pair<Point<dim>, Point<dim>>
  tool_cell(const std::string              &generator,
            const std::vector<std::string> &values,
            const std::string              &path);
} // namespace stickslip

#endif
