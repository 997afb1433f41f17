#include <stickslip/contact/surface/weighting_functions.h>

#include <algorithm>
#include <limits>

namespace stickslip
{
  namespace
  {
    /// Who takes over from node @p m: its heir, or else the nearest multiplier
    /// nodes that are not missing.
    template <int dim>
    std::vector<unsigned int>
    heirs_of(const FaceShape<dim> &shape,
             const MissingNodes   &missing,
             const unsigned int    m)
    {
      const unsigned int heir =
        missing.heir.empty() ? numbers::invalid_unsigned_int : missing.heir[m];
      if (heir != numbers::invalid_unsigned_int && !missing.is_missing[heir])
        return {heir};
      constexpr double          tie      = 1e-9;
      double                    smallest = std::numeric_limits<double>::max();
      std::vector<unsigned int> nearest;
      for (unsigned int l = 0; l < shape.n_nodes(); ++l)
        {
          if (missing.is_missing[l])
            continue;
          const double distance = shape.distance(l, m);
          if (distance < smallest - tie)
            nearest.clear();
          if (distance < smallest + tie)
            nearest.push_back(l);
          smallest = std::min(smallest, distance);
        }
      return nearest;
    }



    template <int dim>
    FullMatrix<double>
    extended_functions(const FaceShape<dim> &shape, const MissingNodes &missing)
    {
      const unsigned int n = shape.n_nodes();
      FullMatrix<double> W(n, n);
      for (unsigned int m = 0; m < n; ++m)
        if (!missing.is_missing[m])
          W(m, m) = 1.;
        else
          {
            const auto others = heirs_of(shape, missing, m);
            for (const unsigned int l : others)
              W(l, m) = 1. / static_cast<double>(others.size());
          }
      return W;
    }



    /// The dual functions of @p W among the rows of nodes that are not missing.
    template <int dim>
    FullMatrix<double>
    dual_functions(const FullMatrix<double>  &W,
                   const FaceShape<dim>      &shape,
                   const MissingNodes        &missing,
                   const Quadrature<dim - 1> &quadrature,
                   const std::vector<double> &areas)
    {
      const unsigned int  n = shape.n_nodes();
      FullMatrix<double>  mass(n, n), integrals(n, n);
      std::vector<double> L;
      Vector<double>      phi(n), values(n);
      for (unsigned int q = 0; q < quadrature.size(); ++q)
        {
          shape.evaluate_values(quadrature.point(q), L);
          std::copy(L.begin(), L.end(), values.begin());
          W.vmult(phi, values);
          for (unsigned int l = 0; l < n; ++l)
            {
              integrals(l, l) += areas[q] * phi(l);
              for (unsigned int m = 0; m < n; ++m)
                mass(l, m) += areas[q] * phi(l) * phi(m);
            }
        }
      for (unsigned int l = 0; l < n; ++l)
        if (missing.is_missing[l])
          mass(l, l) = 1.; // and nothing else in this row
      mass.gauss_jordan();
      FullMatrix<double> product(n, n), dual(n, n);
      integrals.mmult(product, mass);
      product.mmult(dual, W);
      return dual;
    }
  } // namespace



  const Choices<WeightingFunctions> &
  all_weighting_functions()
  {
    static const Choices<WeightingFunctions> choices = {
      {"standard", WeightingFunctions::standard},
      {"dual", WeightingFunctions::dual}};
    return choices;
  }



  template <int dim>
  FullMatrix<double>
  weighting_functions(const WeightingFunctions   kind,
                      const FaceShape<dim>      &multiplier_shape,
                      const MissingNodes        &missing,
                      const Quadrature<dim - 1> &quadrature,
                      const std::vector<double> &areas)
  {
    const FullMatrix<double> W = extended_functions(multiplier_shape, missing);
    return kind == WeightingFunctions::standard
             ? W
             : dual_functions(W, multiplier_shape, missing, quadrature, areas);
  }

#define INSTANTIATE(dim)                           \
  template FullMatrix<double> weighting_functions( \
    const WeightingFunctions,                      \
    const FaceShape<dim> &,                        \
    const MissingNodes &,                          \
    const Quadrature<dim - 1> &,                   \
    const std::vector<double> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
