#include <stickslip/adaptivity/recovery_estimator.h>

#include <stickslip/adaptivity/cell_stresses.h>
#include <stickslip/adaptivity/linear_moduli.h>

#include <stickslip/mesh/reference_cells.h>

#include <deal.II/fe/fe_values.h>

#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

namespace stickslip
{
  namespace
  {
    /// Stresses at points of the undeformed body.
    template <int dim>
    struct Samples
    {
      std::vector<Point<dim>>            points;
      std::vector<SymmetricTensor<2, 3>> stresses;
    };



    /// The polynomials of degree p in coordinates from @p centre, in units of
    /// @p size.
    template <int dim>
    class Monomials
    {
    public:
      Monomials(const unsigned int p,
                const Point<dim>  &centre,
                const double       size)
        : p(p)
        , centre(centre)
        , size(size)
      {}

      /// The constant comes first.
      std::vector<double>
      operator()(const Point<dim> &X) const
      {
        const Tensor<1, dim> x = (X - centre) / size;
        std::vector<double>  values;
        for (unsigned int i = 0; i <= p; ++i)
          for (unsigned int j = 0; i + j <= p; ++j)
            for (unsigned int k = 0; i + j + k <= (dim == 3 ? p : i + j); ++k)
              values.push_back(std::pow(x[0], i) * std::pow(x[1], j) *
                               (dim == 3 ? std::pow(x[dim - 1], k) : 1.));
        return values;
      }

    private:
      const unsigned int p;
      const Point<dim>   centre;
      const double       size;
    };



    /// Coefficients of the polynomial nearest to the samples.
    template <int dim>
    std::vector<SymmetricTensor<2, 3>>
    nearest_polynomial(const Monomials<dim>                    &monomials,
                       const std::vector<const Samples<dim> *> &patch)
    {
      // Directions in which a patch has too few points: what they leave
      // undetermined is zero, and nothing else notices the small number.
      constexpr double                   indifference = 1e-10;
      FullMatrix<double>                 squares;
      std::vector<SymmetricTensor<2, 3>> right_hand_side, coefficients;
      for (const Samples<dim> *samples : patch)
        for (unsigned int s = 0; s < samples->points.size(); ++s)
          {
            const std::vector<double> m = monomials(samples->points[s]);
            if (squares.m() == 0)
              {
                squares.reinit(m.size(), m.size());
                right_hand_side.resize(m.size());
                for (unsigned int i = 1; i < m.size(); ++i)
                  squares(i, i) = indifference;
              }
            for (unsigned int i = 0; i < m.size(); ++i)
              {
                right_hand_side[i] += m[i] * samples->stresses[s];
                for (unsigned int j = 0; j < m.size(); ++j)
                  squares(i, j) += m[i] * m[j];
              }
          }
      squares.gauss_jordan();
      coefficients.resize(right_hand_side.size());
      for (unsigned int i = 0; i < coefficients.size(); ++i)
        for (unsigned int j = 0; j < coefficients.size(); ++j)
          coefficients[i] += squares(i, j) * right_hand_side[j];
      return coefficients;
    }



    template <int dim>
    class Recovery
    {
    public:
      using CellIterator = typename Triangulation<dim>::active_cell_iterator;

      explicit Recovery(ContactProblem<dim> &problem)
        : dofs(problem.layout())
        , triangulation(dofs.dof_handler.get_triangulation())
        , moduli(problem)
        , cross_section(problem.bodies().cross_section)
        , stresses(problem, StressMeasure::cauchy)
        , neighbours(GridTools::vertex_to_cell_map(triangulation))
        , fe_values(dofs.mapping[0],
                    stresses.space(),
                    gauss_quadrature<dim>(dofs.cells(), dofs.degree() + 1),
                    update_values | update_quadrature_points |
                      update_JxW_values)
        , samples(triangulation.n_active_cells())
      {
        FEValues<dim> at_samples(dofs.mapping[0],
                                 stresses.space(),
                                 gauss_quadrature<dim>(dofs.cells(),
                                                       dofs.degree()),
                                 update_values | update_quadrature_points);
        for (const auto &cell : triangulation.active_cell_iterators())
          if (!cell->is_artificial() && !stresses.of(cell).empty())
            {
              at_samples.reinit(cell);
              samples[cell->active_cell_index()] = {
                at_samples.get_quadrature_points(),
                stresses_at(cell, at_samples)};
            }
      }

      Vector<double>
      indicators()
      {
        Vector<double> squares(triangulation.n_active_cells());
        for (const auto &cell : triangulation.active_cell_iterators())
          if (cell->is_locally_owned() && moduli.is_deformable(cell) &&
              !stresses.of(cell).empty())
            squares[cell->active_cell_index()] = indicator(cell);
        return squares;
      }

    private:
      const DofLayout<dim>               &dofs;
      const Triangulation<dim>           &triangulation;
      const LinearModuliOf<dim>           moduli;
      const CrossSection                  cross_section;
      const CellStresses<dim>             stresses;
      std::vector<std::set<CellIterator>> neighbours; ///< of vertices
      FEValues<dim>                       fe_values;
      std::vector<Samples<dim>>           samples; ///< of cells

      std::vector<SymmetricTensor<2, 3>>
      stresses_at(const CellIterator &cell, const FEValues<dim> &values) const
      {
        const auto                        &nodal = stresses.of(cell);
        std::vector<SymmetricTensor<2, 3>> result(values.n_quadrature_points);
        for (unsigned int q = 0; q < result.size(); ++q)
          for (unsigned int i = 0; i < nodal.size(); ++i)
            result[q] += values.shape_value(i, q) * symmetrize(nodal[i]);
        return result;
      }

      using Patch = std::vector<const Samples<dim> *>;

      /// What is smoothed around a vertex.
      struct Smoothed
      {
        Monomials<dim>                     monomials;
        std::vector<SymmetricTensor<2, 3>> coefficients;

        SymmetricTensor<2, 3>
        operator()(const Point<dim> &X) const
        {
          const std::vector<double> m = monomials(X);
          SymmetricTensor<2, 3>     stress;
          for (unsigned int i = 0; i < m.size(); ++i)
            stress += m[i] * coefficients[i];
          return stress;
        }
      };

      /// Cells of the material of @p cell at @p vertices.
      Patch
      patch_around(const std::vector<unsigned int> &vertices,
                   const CellIterator              &cell) const
      {
        std::set<CellIterator> cells;
        for (const unsigned int v : vertices)
          for (const CellIterator &other : neighbours[v])
            if (!other->is_artificial() &&
                other->material_id() == cell->material_id())
              cells.insert(other);
        Patch patch;
        for (const CellIterator &other : cells)
          patch.push_back(&samples[other->active_cell_index()]);
        return patch;
      }

      Smoothed
      smoothed_around(const std::vector<unsigned int> &vertices,
                      const CellIterator              &cell) const
      {
        const Monomials<dim> monomials(dofs.degree(),
                                       cell->center(),
                                       cell->diameter());
        return {monomials,
                nearest_polynomial(monomials, patch_around(vertices, cell))};
      }

      /// For the vertices of @p cell around which as many cells meet as inside
      /// of a regular mesh, with the numbers of these vertices in the cell; the
      /// others have to do with these. If there is none, all cells around the
      /// cell have to help.
      std::vector<std::pair<unsigned int, Smoothed>>
      smoothed_at_vertices(const CellIterator &cell) const
      {
        const unsigned int                             enough = 1U << dim;
        std::vector<std::pair<unsigned int, Smoothed>> result;
        std::vector<unsigned int>                      all;
        for (const unsigned int v : cell->vertex_indices())
          {
            const unsigned int vertex = cell->vertex_index(v);
            all.push_back(vertex);
            if (patch_around({vertex}, cell).size() >= enough)
              result.emplace_back(v, smoothed_around({vertex}, cell));
          }
        if (result.empty())
          result.emplace_back(0, smoothed_around(all, cell));
        return result;
      }

      double
      indicator(const CellIterator &cell)
      {
        const auto at_vertices = smoothed_at_vertices(cell);
        fe_values.reinit(cell);
        const auto computed = stresses_at(cell, fe_values);
        double     square   = 0.;
        for (const unsigned int q : fe_values.quadrature_point_indices())
          {
            // what is missing of the linear functions falls to all alike
            std::vector<double> shares;
            double              rest = 1.;
            for (const auto &entry : at_vertices)
              {
                shares.push_back(
                  dofs.cells().template d_linear_shape_function<dim>(
                    fe_values.get_quadrature().point(q), entry.first));
                rest -= shares.back();
              }
            SymmetricTensor<2, 3> difference = -1. * computed[q];
            for (unsigned int k = 0; k < shares.size(); ++k)
              difference +=
                (shares[k] + rest / shares.size()) *
                at_vertices[k].second(fe_values.quadrature_point(q));
            square += moduli.of(cell).square(difference) * fe_values.JxW(q) *
                      cross_section.circumference(
                        Tensor<1, dim>(fe_values.quadrature_point(q)));
          }
        return square;
      }
    };
  } // namespace



  template <int dim>
  Vector<double>
  RecoveryEstimator<dim>::indicators(ContactProblem<dim> &problem,
                                     const LA::BlockVector & /*x*/) const
  {
    return Recovery<dim>(problem).indicators();
  }

  template class RecoveryEstimator<2>;
  template class RecoveryEstimator<3>;
} // namespace stickslip
