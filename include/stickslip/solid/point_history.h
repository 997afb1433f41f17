#ifndef stickslip_solid_point_history_h
#define stickslip_solid_point_history_h

#include <deal.II/base/array_view.h>

#include <cstddef>
#include <vector>

namespace stickslip
{
  /**
   * The history variables of the constitutive laws at the quadrature points of
   * the locally owned cells: the accepted ones of the last step and the trial
   * ones of the last evaluation. One flat array each; a cell's variables are
   * contiguous, point by point, in the order of the active cell index.
   */
  class PointHistory
  {
  public:
    /**
     * Room for n_points[c] points with n_variables[c] variables each in cell c
     * (by active cell index; 0 for cells without history).
     */
    void
    reinit(const std::vector<unsigned int> &n_variables,
           const std::vector<unsigned int> &n_points);

    /// Accepted variables of one point.
    dealii::ArrayView<const double>
    accepted(const unsigned int cell, const unsigned int point) const;

    /// Trial variables of one point.
    dealii::ArrayView<double>
    trial(const unsigned int cell, const unsigned int point);

    /// Accepted variables of all points of a cell, to write them to a file or
    /// carry them to another mesh.
    dealii::ArrayView<const double>
    accepted_of_cell(const unsigned int cell) const;

    /// Replaces the accepted variables of all points of a cell (and the trial
    /// ones).
    void
    set_cell(const unsigned int                     cell,
             const dealii::ArrayView<const double> &values);

    /// The trial variables become the accepted ones.
    void
    accept();

    /// The accepted variables become the trial ones.
    void
    restore();

  private:
    std::vector<std::size_t>  first; ///< of each cell, and the total at the end
    std::vector<unsigned int> n_variables; ///< of a point of each cell
    std::vector<double>       accepted_values;
    std::vector<double>       trial_values;
  };
} // namespace stickslip

#endif
