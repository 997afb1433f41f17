#ifndef stickslip_mesh_mesh_generator_h
#define stickslip_mesh_mesh_generator_h

#include <deal.II/grid/tria.h>

#include <string>
#include <vector>

namespace stickslip
{
  using namespace dealii;

  /// A generator's argument; an empty default means that it must be given.
  struct GeneratorArgument
  {
    std::string name;
    std::string default_2d;
    std::string default_3d;
  };

  /// What a user needs to know about a generator.
  struct GeneratorDescription
  {
    std::string                    name;
    unsigned int                   dimension; ///< 2 or 3 if only there, else 0
    std::vector<GeneratorArgument> arguments; ///< separated by ':'
    bool                           is_own; ///< in mesh_shapes.h, not in deal.II
  };

  /// All generators, deal.II's GridGenerator functions and our own.
  const std::vector<GeneratorDescription> &
  generator_descriptions();

  /// Names that exist in dimension @p dim.
  std::vector<std::string>
  generator_names(const unsigned int dim);

  /// All arguments of a generator, those at the end from their defaults. Throws
  /// UserError that blames parameters below @p path.
  std::vector<std::string>
  generator_arguments(const std::string &name,
                      const std::string &arguments,
                      const unsigned int dim,
                      const std::string &path);

  /**
   * Fills @p triangulation (empty before) and its manifolds. Arguments are
   * separated by ':' and missing ones at the end get their defaults. Throws
   * UserError blaming parameters below @p path if the name is unknown or the
   * arguments do not make sense.
   */
  template <int dim>
  void
  generate_mesh(const std::string  &name,
                const std::string  &arguments,
                const std::string  &path,
                Triangulation<dim> &triangulation);
} // namespace stickslip

#endif
