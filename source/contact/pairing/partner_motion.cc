#include <stickslip/contact/pairing/partner_motion.h>

namespace stickslip
{
  template <int dim>
  PartnerMotion<dim>::PartnerMotion(const FaceShape<dim>  &slave_shape,
                                    const FaceShape<dim>  &master_shape,
                                    const MortarFace<dim> &slave)
    : slave_shape(slave_shape)
    , master_shape(master_shape)
    , slave(slave)
    , n_0(projection_plane(slave.face, slave_shape, slave.positions).n)
    , D_n_0(outward_normal_derivative(slave.face,
                                      slave.positions,
                                      slave_shape.at_centre()))
  {}



  template <int dim>
  void
  PartnerMotion<dim>::evaluate(const SegmentPoint<dim>           &point,
                               const std::vector<Tensor<1, dim>> &master,
                               Partner                           &partner) const
  {
    slave_shape.evaluate_values(point.xi, partner.N);
    master_shape.evaluate_gradients(point.eta, partner.master);
    partner.a = surface_tangents<dim>(partner.master.gradient, master);

    Tensor<2, dim> jacobian;
    for (unsigned int i = 0; i < dim; ++i)
      {
        for (unsigned int d = 0; d < dim - 1; ++d)
          jacobian[i][d] = partner.a[d][i];
        jacobian[i][dim - 1] = n_0[i];
      }
    const Tensor<2, dim> inverse = invert(jacobian);
    partner.distance = (interpolate<dim>(partner.N, slave.positions) -
                        interpolate<dim>(partner.master.value, master)) *
                       n_0;
    for (unsigned int d = 0; d < dim - 1; ++d)
      partner.dual[d] = inverse[d];
  }



  template <int dim>
  void
  PartnerMotion<dim>::partner_derivative(const Partner       &partner,
                                         const unsigned int   d,
                                         std::vector<double> &D_eta) const
  {
    const unsigned int    n    = slave_shape.n_nodes();
    const Tensor<1, dim> &dual = partner.dual[d];
    D_eta.resize((n + master_shape.n_nodes()) * dim);
    for (unsigned int k = 0; k < n; ++k)
      {
        const Tensor<1, dim> along_slave =
          partner.N[k] * dual - partner.distance * (dual * D_n_0[k]);
        for (unsigned int c = 0; c < dim; ++c)
          D_eta[k * dim + c] = along_slave[c];
      }
    for (unsigned int k = 0; k < master_shape.n_nodes(); ++k)
      for (unsigned int c = 0; c < dim; ++c)
        D_eta[(n + k) * dim + c] = -partner.master.value[k] * dual[c];
  }



  template <int dim>
  void
  PartnerMotion<dim>::border_motion(const SegmentEnd<dim>             &end,
                                    const std::vector<Tensor<1, dim>> &master,
                                    std::vector<double> &motion) const
  {
    const unsigned int n        = slave_shape.n_nodes();
    const unsigned int n_master = master_shape.n_nodes();
    motion.resize((n + n_master) * dim);
    N_border.assign(end.on_slave ? n : n_master, 0.);
    slave_shape.evaluate_values(end.xi, N);
    N_border[end.nodes[0]] += 1. - end.share;
    N_border[end.nodes[1]] += end.share;
    const double distance =
      (interpolate<dim>(N_border, end.on_slave ? slave.positions : master) -
       interpolate<dim>(N, slave.positions)) *
      n_0;
    for (unsigned int k = 0; k < n; ++k)
      {
        const Tensor<1, dim> along_slave =
          ((end.on_slave ? N_border[k] : 0.) - N[k]) * end.outward -
          distance * (end.outward * D_n_0[k]);
        for (unsigned int c = 0; c < dim; ++c)
          motion[k * dim + c] = end.weight * along_slave[c];
      }
    for (unsigned int k = 0; k < n_master; ++k)
      for (unsigned int c = 0; c < dim; ++c)
        motion[(n + k) * dim + c] =
          end.on_slave ? 0. : end.weight * N_border[k] * end.outward[c];
  }

  template class PartnerMotion<2>;
  template class PartnerMotion<3>;
} // namespace stickslip
