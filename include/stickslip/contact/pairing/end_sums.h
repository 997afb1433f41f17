#ifndef stickslip_contact_pairing_end_sums_h
#define stickslip_contact_pairing_end_sums_h

#include <stickslip/contact/point/mortar_node.h>

#include <stickslip/contact/pairing/mortar_integrals.h>

#include <deal.II/lac/full_matrix.h>

#include <vector>

namespace stickslip
{
  /**
   * What the motion of the ends of segments with one master face changes in
   * the integrals of a mortar node, along the columns of the nodes of the slave
   * face and of the master face: sums over these ends of the border's motion
   * times factors. A face may have thousands of masters, so that sums over
   * those of a single one come first.
   */
  template <int dim>
  class EndSums
  {
  public:
    /// Nodes of a slave face and of a master face, multipliers of a slave
    /// face.
    EndSums(const unsigned int n_slave,
            const unsigned int n_master,
            const unsigned int n_multipliers);

    /// @p motion of the border [column] times psi N_k of slave node @p k.
    void
    add_to_slave(const unsigned int         k,
                 const double               factor,
                 const std::vector<double> &motion);

    /// The same of master node @p k.
    void
    add_to_master(const unsigned int         k,
                  const double               factor,
                  const std::vector<double> &motion);

    /// y_m, where the weighting function changes by sum_m y_m psi_m.
    void
    add_to_dual(const unsigned int         m,
                const double               factor,
                const std::vector<double> &motion);

    void
    add_to_area(const double factor, const std::vector<double> &motion);

    /// psi times the rise of both faces.
    void
    add_to_rise(const double factor, const std::vector<double> &motion);

    /// Adds the sums, which are of @p master, to @p derivative and begins anew.
    /// @p rows are the numbers of the nodes of each master.
    void
    move_to(MortarDerivative<dim>                        &derivative,
            const typename MortarNode<dim>::Around       &around,
            const FaceIntegrals<dim>                     &integrals,
            const std::vector<std::vector<unsigned int>> &rows,
            const unsigned int                            master);

  private:
    FullMatrix<double> area;      ///< [0][column]: of the area
    FullMatrix<double> of_rise;   ///< [0][column]: of the rise
    FullMatrix<double> of_slave;  ///< [node][column]
    FullMatrix<double> of_master; ///< [node][column]
    FullMatrix<double> of_dual;   ///< [multiplier][column]
  };
} // namespace stickslip

#endif
