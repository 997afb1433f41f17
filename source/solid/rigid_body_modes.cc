#include <stickslip/solid/rigid_body_modes.h>

#include <deal.II/base/mpi.h>

#include <deal.II/lac/vector.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

namespace stickslip
{
  namespace
  {
    /// e_r x offset, where the only axis in 2D is z.
    template <int dim>
    Tensor<1, dim>
    rotation_displacement(const unsigned int r, const Tensor<1, dim> &offset)
    {
      Tensor<1, 3> axis, arm;
      axis[dim == 2 ? 2 : r] = 1.;
      for (unsigned int d = 0; d < dim; ++d)
        arm[d] = offset[d];
      const Tensor<1, 3> cross = cross_product_3d(axis, arm);
      Tensor<1, dim>     result;
      for (unsigned int d = 0; d < dim; ++d)
        result[d] = cross[d];
      return result;
    }



    /// A basis of the null space of a symmetric matrix by row reduction. The
    /// last columns that can be free are.
    std::vector<Vector<double>>
    null_space_basis(FullMatrix<double> matrix)
    {
      const unsigned int        n = matrix.m();
      std::vector<unsigned int> pivot_columns;
      std::vector<unsigned int> free_columns;

      double size = 0.;
      for (unsigned int i = 0; i < n; ++i)
        size = std::max(size, matrix(i, i));

      for (unsigned int column = 0; column < n; ++column)
        {
          const unsigned int first = pivot_columns.size();
          unsigned int       best  = first;
          for (unsigned int i = first; i < n; ++i)
            if (std::abs(matrix(i, column)) > std::abs(matrix(best, column)))
              best = i;
          if (first == n || std::abs(matrix(best, column)) <= 1e-10 * size)
            {
              free_columns.push_back(column);
              continue;
            }
          matrix.swap_row(first, best);
          const double pivot = matrix(first, column);
          for (unsigned int j = 0; j < n; ++j)
            matrix(first, j) /= pivot;
          for (unsigned int i = 0; i < n; ++i)
            if (i != first)
              matrix.add_row(i, -matrix(i, column), first);
          pivot_columns.push_back(column);
        }

      std::vector<Vector<double>> basis;
      for (const unsigned int column : free_columns)
        {
          Vector<double> vector(n);
          vector(column) = 1.;
          for (unsigned int i = 0; i < pivot_columns.size(); ++i)
            vector(pivot_columns[i]) = -matrix(i, column);
          basis.push_back(vector);
        }
      return basis;
    }



    /// "x", or "(1, 1, 0)" if the direction is not along an axis.
    std::string
    direction_name(const std::vector<double> &direction)
    {
      double largest = 0.;
      for (const double component : direction)
        largest = std::max(largest, std::abs(component));

      unsigned int       n_components = 0;
      std::string        axis;
      std::ostringstream all;
      all.precision(3);
      for (unsigned int d = 0; d < direction.size(); ++d)
        {
          const double relative = direction[d] / largest;
          const bool   counts   = std::abs(relative) > 1e-6;
          all << (d == 0 ? "(" : ", ") << (counts ? relative : 0.);
          if (counts)
            {
              ++n_components;
              axis = std::string(1, "xyz"[d]);
            }
        }
      return n_components == 1 ? axis : all.str() + ")";
    }
  } // namespace



  template <int dim>
  Tensor<1, dim>
  rigid_mode(const unsigned int mode, const Tensor<1, dim> &offset)
  {
    if (mode >= dim)
      return rotation_displacement<dim>(mode - dim, offset);
    Tensor<1, dim> translation;
    translation[mode] = 1.;
    return translation;
  }



  template <int dim>
  RigidBodyModes<dim>::RigidBodyModes(const Point<dim> &lower,
                                      const Point<dim> &upper)
    : centre(lower + 0.5 * (upper - lower))
    , length(0.5 * (upper - lower).norm())
    , gram(n_modes, n_modes)
  {}



  template <int dim>
  void
  RigidBodyModes<dim>::hold(const Point<dim>     &position,
                            const Tensor<1, dim> &direction)
  {
    Vector<double> row(n_modes);
    for (unsigned int d = 0; d < dim; ++d)
      row(d) = direction[d];
    for (unsigned int r = 0; r < n_rotations; ++r)
      row(dim + r) =
        rotation_displacement<dim>(r, (position - centre) / length) * direction;
    add_row(row);
  }



  template <int dim>
  void
  RigidBodyModes<dim>::hold_rotation(const Tensor<1, 3> &axis)
  {
    Vector<double> row(n_modes);
    for (unsigned int r = 0; r < n_rotations; ++r)
      row(dim + r) = axis[dim == 2 ? 2 : r];
    add_row(row);
  }



  template <int dim>
  void
  RigidBodyModes<dim>::tie(const PeriodicMotion &motion)
  {
    const Tensor<2, dim>        Q = motion.rotation_matrix<dim>();
    std::vector<Tensor<1, dim>> arms(1); // of the centre, and of places around
    for (unsigned int c = 0; c < dim; ++c)
      {
        arms.emplace_back();
        arms.back()[c] = length;
      }
    for (const Tensor<1, dim> &arm : arms)
      {
        const Tensor<1, dim> there =
          motion(Tensor<1, dim>(centre + arm)) - Tensor<1, dim>(centre);
        for (unsigned int d = 0; d < dim; ++d)
          {
            Vector<double> row(n_modes);
            for (unsigned int m = 0; m < n_modes; ++m)
              row(m) =
                (rigid_mode<dim>(m, there) - Q * rigid_mode<dim>(m, arm))[d] /
                (m < dim ? 1. : length);
            add_row(row);
          }
      }
  }



  template <int dim>
  void
  RigidBodyModes<dim>::add_row(const Vector<double> &row)
  {
    for (unsigned int i = 0; i < n_modes; ++i)
      for (unsigned int j = 0; j < n_modes; ++j)
        gram(i, j) += row(i) * row(j);
  }



  template <int dim>
  void
  RigidBodyModes<dim>::sum_over_ranks(const MPI_Comm communicator)
  {
    Utilities::MPI::sum(gram, communicator, gram);
  }



  template <int dim>
  std::vector<Vector<double>>
  RigidBodyModes<dim>::unheld() const
  {
    std::vector<Vector<double>> motions = null_space_basis(gram);
    for (Vector<double> &motion : motions)
      for (unsigned int r = dim; r < n_modes; ++r)
        motion(r) /= length; // rows have arms relative to it
    return motions;
  }



  template <int dim>
  std::string
  RigidBodyModes<dim>::motion_name(const Vector<double> &motion) const
  {
    std::vector<double> translation(dim), rotation(3);
    for (unsigned int d = 0; d < dim; ++d)
      translation[d] = motion(d);
    double largest_rotation = 0.;
    for (unsigned int r = 0; r < n_rotations; ++r)
      {
        rotation[dim == 2 ? 2 : r] = length * motion(dim + r);
        largest_rotation =
          std::max(largest_rotation, length * std::abs(motion(dim + r)));
      }
    if (largest_rotation > 1e-6)
      return "rotation about " + direction_name(rotation);
    return "translation along " + direction_name(translation);
  }



  template <int dim>
  std::vector<std::pair<Point<dim>, Point<dim>>>
  body_boxes(const Triangulation<dim> &triangulation, const Bodies &bodies)
  {
    // -max(-x) = min(x): one reduction for both corners.
    const unsigned int  n = bodies.bodies.size();
    std::vector<double> extremes(2 * dim * n,
                                 std::numeric_limits<double>::lowest());
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          const unsigned int b = bodies.body_of(cell->material_id());
          for (const unsigned int v : cell->vertex_indices())
            for (unsigned int d = 0; d < dim; ++d)
              {
                double &upper = extremes[(b * dim + d) * 2];
                double &lower = extremes[(b * dim + d) * 2 + 1];
                upper         = std::max(upper, cell->vertex(v)[d]);
                lower         = std::max(lower, -cell->vertex(v)[d]);
              }
        }
    const std::vector<double> local = extremes;
    Utilities::MPI::max(local, triangulation.get_communicator(), extremes);

    std::vector<std::pair<Point<dim>, Point<dim>>> boxes(n);
    for (unsigned int b = 0; b < n; ++b)
      for (unsigned int d = 0; d < dim; ++d)
        {
          boxes[b].second[d] = extremes[(b * dim + d) * 2];
          boxes[b].first[d]  = -extremes[(b * dim + d) * 2 + 1];
        }
    return boxes;
  }



  template Tensor<1, 2>
  rigid_mode(const unsigned int, const Tensor<1, 2> &);
  template Tensor<1, 3>
  rigid_mode(const unsigned int, const Tensor<1, 3> &);
  template class RigidBodyModes<2>;
  template class RigidBodyModes<3>;
  template std::vector<std::pair<Point<2>, Point<2>>>
  body_boxes(const Triangulation<2> &, const Bodies &);
  template std::vector<std::pair<Point<3>, Point<3>>>
  body_boxes(const Triangulation<3> &, const Bodies &);
} // namespace stickslip
