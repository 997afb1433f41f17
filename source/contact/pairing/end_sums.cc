#include <stickslip/contact/pairing/end_sums.h>

#include <stickslip/base/add_scaled.h>

namespace stickslip
{
  template <int dim>
  EndSums<dim>::EndSums(const unsigned int n_slave,
                        const unsigned int n_master,
                        const unsigned int n_multipliers)
    : area(1, (n_slave + n_master) * dim)
    , of_rise(1, (n_slave + n_master) * dim)
    , of_slave(n_slave, (n_slave + n_master) * dim)
    , of_master(n_master, (n_slave + n_master) * dim)
    , of_dual(n_multipliers, (n_slave + n_master) * dim)
  {}



  template <int dim>
  void
  EndSums<dim>::add_to_slave(const unsigned int         k,
                             const double               factor,
                             const std::vector<double> &motion)
  {
    add_scaled(factor, motion, &of_slave(k, 0));
  }



  template <int dim>
  void
  EndSums<dim>::add_to_master(const unsigned int         k,
                              const double               factor,
                              const std::vector<double> &motion)
  {
    add_scaled(factor, motion, &of_master(k, 0));
  }



  template <int dim>
  void
  EndSums<dim>::add_to_dual(const unsigned int         m,
                            const double               factor,
                            const std::vector<double> &motion)
  {
    add_scaled(factor, motion, &of_dual(m, 0));
  }



  template <int dim>
  void
  EndSums<dim>::add_to_area(const double               factor,
                            const std::vector<double> &motion)
  {
    add_scaled(factor, motion, &area(0, 0));
  }



  template <int dim>
  void
  EndSums<dim>::add_to_rise(const double               factor,
                            const std::vector<double> &motion)
  {
    add_scaled(factor, motion, &of_rise(0, 0));
  }



  template <int dim>
  void
  EndSums<dim>::move_to(MortarDerivative<dim>                  &derivative,
                        const typename MortarNode<dim>::Around &around,
                        const FaceIntegrals<dim>               &integrals,
                        const std::vector<std::vector<unsigned int>> &rows,
                        const unsigned int                            master)
  {
    const auto columns = around.columns(derivative.D_D.m(), rows[master]);
    const auto add     = [&](const double              factor,
                         const FullMatrix<double> &values,
                         const unsigned int        of_row,
                         FullMatrix<double>       &D,
                         const unsigned int        row) {
      if (factor != 0.)
        for (unsigned int k = 0; k < columns.size(); ++k)
          D(row, columns[k]) += factor * values(of_row, k);
    };
    for (unsigned int k = 0; k < columns.size(); ++k)
      {
        derivative.D_area[columns[k]] += area(0, k);
        derivative.D_rise[columns[k]] += of_rise(0, k);
        for (unsigned int m = 0; m < of_dual.m(); ++m)
          derivative.D_rise[columns[k]] += integrals.rise[m] * of_dual(m, k);
      }
    for (unsigned int j = 0; j < of_slave.m(); ++j)
      {
        const unsigned int own = around.stencil[j];
        add(1., of_slave, j, derivative.D_D, own);
        for (unsigned int m = 0; m < of_dual.m(); ++m)
          add(integrals.D(m, j), of_dual, m, derivative.D_D, own);
      }
    for (unsigned int j = 0; j < of_master.m(); ++j)
      {
        add(1., of_master, j, derivative.D_M, rows[master][j]);
        for (unsigned int m = 0; m < of_dual.m(); ++m)
          for (unsigned int i = 0; i < rows.size(); ++i)
            add(integrals.M[i](m, j), of_dual, m, derivative.D_M, rows[i][j]);
      }
    for (FullMatrix<double> *sums :
         {&area, &of_rise, &of_slave, &of_master, &of_dual})
      *sums = 0.;
  }

  template class EndSums<2>;
  template class EndSums<3>;
} // namespace stickslip
