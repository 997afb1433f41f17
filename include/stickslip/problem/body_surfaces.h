#ifndef stickslip_problem_body_surfaces_h
#define stickslip_problem_body_surfaces_h

#include <stickslip/base/parameter_file.h>

#include <stickslip/mesh/mesh_builder.h>

#include <stickslip/solid/boundary_condition_parameters.h>
#include <stickslip/solid/constitutive_law.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <memory>
#include <vector>

namespace stickslip
{
  using namespace dealii;

  /// What is known of one boundary of a body where nothing is deformed. Faces
  /// count as flat between their vertices.
  template <int dim>
  struct BodySurface
  {
    types::boundary_id id      = 0; ///< of the triangulation
    unsigned int       body    = 0;
    bool               is_free = true; ///< no symmetry plane, not periodic
    bool               is_prescribed = false; ///< all its displacements

    double         n_faces           = 0.;
    double         area              = 0.;
    double         sum_of_face_sizes = 0.;
    double         modulus           = 0.; ///< the smallest behind it
    Tensor<1, dim> area_normal;            ///< sum of area times outward normal
    Point<dim>     low, high;

    bool
    is_flat() const;

    Tensor<1, dim>
    mean_normal() const
    {
      return area_normal / area_normal.norm();
    }

    /// Diagonal of its box.
    double
    extent() const
    {
      return low.distance(high);
    }

    /// Between the boxes.
    double
    distance(const BodySurface &other) const;
  };

  /**
   * All boundaries of all bodies, in the order of their ids, the same on all
   * ranks. @p laws is indexed by material id. Collective.
   */
  template <int dim>
  std::vector<BodySurface<dim>>
  body_surfaces(
    const Mesh<dim>                                           &mesh,
    const NamedList<BoundaryConditionParameters>              &conditions,
    const std::vector<std::shared_ptr<const ConstitutiveLaw>> &laws);
} // namespace stickslip

#endif
