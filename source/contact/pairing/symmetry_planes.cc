#include <stickslip/contact/pairing/symmetry_planes.h>

#include <deal.II/base/symmetric_tensor.h>

#include <algorithm>

namespace stickslip
{
  namespace
  {
    /// Nodes nearer to a plane, over the size of the facets, lie in it.
    constexpr double same_plane = 1e-6;



    /// The direction in which the constraint of component @p c of the node
    /// that begins with dof @p first holds it.
    template <int dim>
    Tensor<1, dim>
    held_direction(const types::global_dof_index first,
                   const unsigned int            c,
                   const Constraints            &supports)
    {
      Tensor<1, dim> direction;
      direction[c] = 1.;
      for (const auto &[other, weight] :
           *supports.get_constraint_entries(first + c))
        if (other >= first && other < first + dim)
          direction[other - first] -= weight;
      return direction / direction.norm();
    }



    template <int dim>
    bool
    are_on_one_side(const std::vector<Point<dim>> &points,
                    const Point<dim>              &x,
                    const Tensor<1, dim>          &n)
    {
      double low = 0., high = 0., size = 0.;
      for (const Point<dim> &p : points)
        {
          low  = std::min(low, n * (p - x));
          high = std::max(high, n * (p - x));
          size = std::max(size, p.distance(x));
        }
      return std::min(-low, high) < same_plane * size;
    }
  } // namespace



  template <int dim>
  std::vector<Tensor<1, dim>>
  held_directions(const types::global_dof_index first,
                  const Tensor<2, dim>         &rotation,
                  const Constraints            &supports)
  {
    std::vector<Tensor<1, dim>> directions;
    for (unsigned int c = 0; c < dim; ++c)
      if (supports.is_constrained(first + c))
        directions.push_back(rotation *
                             held_direction<dim>(first, c, supports));
    if (directions.size() == dim)
      directions.clear();
    return directions;
  }



  template <int dim>
  Tensor<2, dim>
  symmetry_projection(const std::vector<Point<dim>> &positions,
                      const unsigned int             own,
                      const types::global_dof_index  first,
                      const Tensor<2, dim>          &rotation,
                      const Constraints             &supports)
  {
    Tensor<2, dim> projection = unit_symmetric_tensor<dim>();
    for (Tensor<1, dim> n : held_directions<dim>(first, rotation, supports))
      {
        if (!are_on_one_side(positions, positions[own], n))
          continue;
        n = projection * n;
        n /= n.norm();
        projection -= outer_product(n, n);
      }
    return projection;
  }

#define INSTANTIATE(dim)                                                       \
  template std::vector<Tensor<1, dim>> held_directions(                        \
    const types::global_dof_index,                                             \
    const Tensor<2, dim> &,                                                    \
    const Constraints &);                                                      \
  template Tensor<2, dim> symmetry_projection(const std::vector<Point<dim>> &, \
                                              const unsigned int,              \
                                              const types::global_dof_index,   \
                                              const Tensor<2, dim> &,          \
                                              const Constraints &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
