#ifndef stickslip_mesh_generator_arguments_h
#define stickslip_mesh_generator_arguments_h

#include <stickslip/mesh/mesh_generator.h>

#include <string>
#include <vector>

namespace stickslip
{
  /// A lower bound of the number of cells that generate_mesh() would make: the
  /// product of the numbers of cells in the arguments. At least 1, also for
  /// what makes no sense.
  double
  estimated_cells(const std::string &name,
                  const std::string &arguments,
                  const unsigned int dim);

  /**
   * Numbers of cells have to be positive (0 where that is the default and means
   * a choice of the generator's own), radii, lengths and thicknesses greater
   * than 0, an outer radius greater than the inner one, and numbers of cells
   * per direction as many as there are directions. @p values are complete;
   * what is no number is left to the generator. Throws UserError that blames
   * @p path.
   */
  void
  check_generator_arguments(const GeneratorDescription     &generator,
                            const std::vector<std::string> &values,
                            const unsigned int              dim,
                            const std::string              &path);
} // namespace stickslip

#endif
