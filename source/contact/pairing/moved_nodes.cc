#include <stickslip/contact/pairing/moved_nodes.h>

#include <stickslip/contact/pairing/master_patch.h>

#include <algorithm>

namespace stickslip
{
  template <int dim>
  void
  MovedNodes<dim>::read(const std::vector<const SurfaceFace<dim> *> &faces,
                        const LA::Vector                            &u)
  {
    now.resize(faces.size());
    for (unsigned int f = 0; f < faces.size(); ++f)
      read_positions(*faces[f], faces[f]->n_nodes, u, now[f]);
  }



  template <int dim>
  double
  MovedNodes<dim>::largest_motion() const
  {
    double motion = 0.;
    for (unsigned int f = 0; f < remembered.size(); ++f)
      for (unsigned int j = 0; j < remembered[f].size(); ++j)
        motion = std::max(motion, (now[f][j] - remembered[f][j]).norm());
    return motion;
  }



  template <int dim>
  std::vector<BoundingBox<dim>>
  MovedNodes<dim>::boxes() const
  {
    std::vector<BoundingBox<dim>> result;
    for (const auto &nodes : now)
      result.emplace_back(std::vector<Point<dim>>(nodes.begin(), nodes.end()));
    return result;
  }

  template class MovedNodes<2>;
  template class MovedNodes<3>;
} // namespace stickslip
