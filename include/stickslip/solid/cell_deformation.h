#ifndef stickslip_solid_cell_deformation_h
#define stickslip_solid_cell_deformation_h

#include <stickslip/solid/cell_kernel.h>
#include <stickslip/solid/mean_dilatation.h>

#include <optional>
#include <vector>

namespace stickslip
{
  /**
   * What the constitutive law sees at the quadrature points of one cell, and
   * how its answer enters the arrays of the cell: directly, or by way of the
   * cell's mean dilatation.
   */
  template <int dim>
  class CellDeformation
  {
  public:
    explicit CellDeformation(const unsigned int n_points);

    /**
     * For the cell that @p fe_values and @p element are at. Without
     * @p mean_dilatation what the law sees is F, and nothing can fail;
     * otherwise returns false if a point has no volume, failed_point().
     */
    bool
    compute(const FEValuesBase<dim>                  &fe_values,
            const std::optional<MeanDilatation<dim>> &mean_dilatation,
            ElementArrays<dim>                       &element);

    /// The deformation gradient for the law.
    const Tensor<2, 3> &
    for_law(const unsigned int q) const
    {
      return seen[q];
    }

    /// First Piola-Kirchhoff stress in the cell, @p P being the law's answer at
    /// point @p q.
    Tensor<2, 3>
    nominal_stress(const unsigned int q, const Tensor<2, 3> &P) const
    {
      return rule ? rule->nominal_stress(F[q], mean, P) : P;
    }

    unsigned int
    failed_point() const
    {
      return failed;
    }

    /// Adds the law's answer at point @p q; no tangent if @p dP_dF is null.
    void
    add_response(const FEValuesBase<dim> &fe_values,
                 const unsigned int       q,
                 const Tensor<2, 3>      &P,
                 const Tensor<4, 3>      *dP_dF,
                 ElementArrays<dim>      &element) const;

    /// After the responses with tangent of all points.
    void
    finish_tangent(ElementArrays<dim> &element) const;

  private:
    std::vector<Tensor<2, 3>>          F, seen;
    std::optional<MeanDilatation<dim>> rule;
    double                             mean   = 0.;
    unsigned int                       failed = 0;
  };
} // namespace stickslip

#endif
