#ifndef stickslip_solid_cell_kernel_h
#define stickslip_solid_cell_kernel_h

#include <stickslip/base/types.h>

#include <stickslip/mesh/cross_section.h>

#include <deal.II/base/aligned_vector.h>
#include <deal.II/base/tensor.h>

#include <deal.II/fe/fe.h>
#include <deal.II/fe/fe_values.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <vector>

namespace stickslip
{
  /**
   * Displacements, forces and stiffness of one cell, and the loops over nodes
   * that one quadrature point needs. It works node by node, with the shape
   * functions of the scalar element, and allocates nothing after construction.
   *
   * In a cross section of bodies of revolution the gradient of the displacement
   * has the hoop strain u_1 / X_1 as its entry 33, whose derivative with
   * respect to the radial displacement of node a is H_a = N_a / X_1 (on the
   * axis, where u_1 = 0, the limit dN_a / dX_1). Below H_a = 0 in all other
   * models.
   */
  template <int dim>
  class ElementArrays
  {
  public:
    /// For an FESystem of dim equal scalar elements.
    explicit ElementArrays(const FiniteElement<dim> &fe,
                           const CrossSection       &cross_section = {});

    /// Zero forces and stiffness; displacements read from the ghosted @p u.
    void
    reinit(const LA::Vector                           &u,
           const std::vector<types::global_dof_index> &dof_indices);

    /// The volume or area of the undeformed body that point @p q of a cell or
    /// face stands for.
    double
    measure(const FEValuesBase<dim> &fe_values, const unsigned int q) const;

    /// Takes the reference gradients of the scalar shape functions at point
    /// @p q of a cell or face.
    void
    set_gradients(const FEValuesBase<dim> &fe_values, const unsigned int q);

    /// F = I + Grad u at the point of set_gradients(); F_33 = 1 in 2D, or
    /// 1 + u_1 / X_1.
    Tensor<2, 3>
    deformation_gradient() const;

    /// sum_a u_a N_a(q)
    Tensor<1, dim>
    displacement(const FEValuesBase<dim> &fe_values,
                 const unsigned int       q) const;

    /// internal_(a i) += (P_iJ G_aJ + delta_i1 P_33 H_a) JxW
    void
    add_stress(const Tensor<2, 3> &P, const double JxW);

    /// stiffness_(a i)(b k) += G_aJ (dP_iJ/dF_kL) G_bL JxW, and the like with
    /// H_a, H_b for the entries 33
    void
    add_stress_tangent(const Tensor<4, 3> &dP_dF, const double JxW);

    /// Forgets the gradient of the mean dilatation.
    void
    clear_mean_dilatation();

    /// m_(a i) += (G_aJ X_iJ + delta_i1 X_33 H_a) weight: the nodal derivative
    /// of the cell's mean dilatation (see MeanDilatation) from those at the
    /// points.
    void
    add_to_mean_dilatation(const Tensor<2, 3> &X, const double weight);

    /// internal_(a i) += p m_(a i) JxW
    void
    add_mean_pressure(const double p, const double JxW);

    /// Remembers the contribution of a point to what is added by
    /// add_mean_dilatation_tangent().
    void
    add_mean_dilatation_response(const Tensor<2, 3> &column,
                                 const Tensor<2, 3> &row,
                                 const double        square,
                                 const double        JxW);

    /// stiffness_(a i)(b k) += C_(a i) m_(b k) + m_(a i) R_(b k)
    /// + S m_(a i) m_(b k), with C_(a i) = sum_q (G_aJ column_iJ + ...) JxW and
    /// R, S alike, since clear_mean_dilatation().
    void
    add_mean_dilatation_tangent();

    /// force_(a i) += t_i N_a(q) JxW
    void
    add_load(const FEValuesBase<dim> &fe_values,
             const unsigned int       q,
             const Tensor<1, dim>    &t,
             Vector<double>          &force) const;

    /// stiffness_(a i)(b k) += N_a (dt_i/dF_kL) G_bL JxW, and
    /// stiffness_(a i)(b 1) += N_a (dt_i/dF_33) H_b JxW
    void
    add_load_gradient_tangent(const FEValuesBase<dim> &fe_values,
                              const unsigned int       q,
                              const Tensor<3, dim>    &dt_dF,
                              const Tensor<1, dim>    &dt_dF_33);

    /// stiffness_(a i)(b k) += N_a (dt_i/du_k) N_b JxW
    void
    add_load_tangent(const FEValuesBase<dim> &fe_values,
                     const unsigned int       q,
                     const Tensor<2, dim>    &dt_du);

    /// Sorts the stiffness into the cell's numbering.
    void
    copy_stiffness(FullMatrix<double> &matrix) const;

    Vector<double> internal; ///< in the cell's numbering
    Vector<double> external;

  private:
    /// G_aJ X_iJ + delta_i1 X_33 H_a
    double
    contracted(const Tensor<2, 3> &X,
               const unsigned int  a,
               const unsigned int  i) const
    {
      double sum = 0.;
      for (unsigned int J = 0; J < dim; ++J)
        sum += X[i][J] * gradients[J * n_nodes + a];
      if (cross_section.is_axisymmetric && i == 0)
        sum += X[2][2] * hoop[a];
      return sum;
    }

    /// vector_(a i) += (G_aJ X_iJ + delta_i1 X_33 H_a) weight
    void
    add_contracted(const Tensor<2, 3>  &X,
                   const double         weight,
                   std::vector<double> &vector) const;

    /// The part of the tangent of a point with H.
    void
    add_hoop_tangent(const Tensor<4, 3> &dP_dF, const double JxW);

    /// Row (a, i), column (k, b): b runs innermost, so that the inner loops
    /// are contiguous.
    double *
    stiffness_row(const unsigned int a, const unsigned int i)
    {
      return stiffness.data() + (a * dim + i) * dim * n_nodes;
    }

    const unsigned int n_nodes;
    const CrossSection cross_section;

    /// Cell's index of component i of node a, at [a * dim + i].
    std::vector<unsigned int> dof_of_node;

    std::vector<double> values; ///< displacements in the cell's numbering
    std::vector<double> nodal_displacements; ///< [i * n_nodes + a]
    std::vector<double> gradients;           ///< [J * n_nodes + a]
    std::vector<double> hoop;                ///< H_a

    AlignedVector<double> stiffness;

    // Of the mean dilatation, each at [a * dim + i].
    std::vector<double> mean_derivative, mean_column, mean_row;
    double              mean_square = 0.;
  };
} // namespace stickslip

#endif
