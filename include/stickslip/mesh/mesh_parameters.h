#ifndef stickslip_mesh_mesh_parameters_h
#define stickslip_mesh_mesh_parameters_h

#include <stickslip/base/choice.h>
#include <stickslip/mesh/refinement_parameters.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/types.h>

#include <string>
#include <vector>

namespace stickslip
{
  using namespace dealii;

  /// What distributes the cells over the ranks.
  enum class Partitioner
  {
    automatic, ///< one of the others
    p4est,     ///< a space-filling curve
    metis      ///< partitioning of the graph of cells
  };

  const Choices<Partitioner> &
  all_partitioners();

  /// What concerns the joined triangulation of all bodies.
  struct MeshParameters
  {
    Partitioner  partitioner        = Partitioner::automatic;
    unsigned int global_refinements = 0;
    double       contact_weight     = 0.;

    /// Where relative mesh file names are looked for first (set by the caller,
    /// usually the directory of the .prm file); then the working directory.
    std::string input_directory;

    /// What is made of each cell beside the mesh (set by the caller) [byte].
    double bytes_per_cell    = 0.;
    double bytes_per_simplex = 0.; ///< of each triangle or tetrahedron

    /// The degree of the displacements (set by the caller): what it makes of
    /// curved cells is said.
    unsigned int degree = 1;

    /// The bodies are bodies of revolution (set by the caller).
    bool is_axisymmetric = false;

    /// Local refinements, after all others (set by the caller).
    std::vector<RefinementRequest> refinements;

    /// The parameter that wants cells refined later, or empty (set by the
    /// caller).
    std::string later_refinement;

    /// A run goes on from a checkpoint whose cells are refined ones (set by the
    /// caller).
    bool goes_on_refined = false;

    /// Whether anything may ask where the sides of a cell are between its
    /// vertices: displacements of degree 2, cells that are refined.
    bool
    has_use_for_curves() const;

    void
    add_parameters(ParameterHandler &prm);
  };
} // namespace stickslip

#endif
