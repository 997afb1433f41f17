#include <stickslip/contact/pairing/share_derivatives.h>

#include <stickslip/base/add_scaled.h>

#include <stickslip/contact/pairing/partner_motion.h>
#include <stickslip/contact/surface/facet_rise.h>

namespace stickslip
{
  template <int dim>
  ShareDerivatives<dim>::ShareDerivatives(
    const FaceShape<dim> &displacement_shape,
    const FaceShape<dim> &multiplier_shape)
    : displacement_shape(displacement_shape)
    , multiplier_shape(multiplier_shape)
  {}



  template <int dim>
  void
  ShareDerivatives<dim>::expect(const std::vector<MortarNode<dim>> &nodes)
  {
    std::map<unsigned int, unsigned int> last_node; // by face
    for (unsigned int i = 0; i < nodes.size(); ++i)
      for (const auto &around : nodes[i].faces)
        last_node[around.face] = i;
    last_of.assign(nodes.size(), {});
    for (const auto &[face, node] : last_node)
      last_of[node].push_back(face);
    clear();
  }



  template <int dim>
  const std::vector<typename ShareDerivatives<dim>::OfMaster> &
  ShareDerivatives<dim>::of_face(const unsigned int        f,
                                 const MortarFace<dim>    &slave,
                                 const FaceSegments<dim>  &segments,
                                 const FullMatrix<double> &weighting,
                                 const MasterPatch<dim>   &patch)
  {
    auto position = kept.find(f);
    if (position == kept.end())
      position =
        kept.emplace(f, evaluate(slave, segments, weighting, patch)).first;
    return position->second;
  }



  template <int dim>
  void
  ShareDerivatives<dim>::finish_node(const unsigned int i)
  {
    for (const unsigned int face : last_of[i])
      kept.erase(face);
  }



  template <int dim>
  std::vector<typename ShareDerivatives<dim>::OfMaster>
  ShareDerivatives<dim>::evaluate(const MortarFace<dim>    &slave,
                                  const FaceSegments<dim>  &segments,
                                  const FullMatrix<double> &weighting,
                                  const MasterPatch<dim>   &patch) const
  {
    const FaceShape<dim>    &master_shape = patch.face_shape();
    const unsigned int       n            = displacement_shape.n_nodes();
    const unsigned int       n_master     = master_shape.n_nodes();
    const unsigned int       n_rows       = n_master + 1; // the rise is last
    const unsigned int       n_mult       = multiplier_shape.n_nodes();
    const unsigned int       n_columns    = (n + n_master) * dim;
    const PartnerMotion<dim> motion(displacement_shape, master_shape, slave);
    std::vector<OfMaster>    D_M(segments.masters.size(),
                              OfMaster(n_mult,
                                       FullMatrix<double>(n_rows, n_columns)));
    // how the shares change where the plane of projection turns:
    // [l * n_rows + i]
    std::vector<std::vector<Tensor<1, dim>>> D_M_of_plane(
      segments.masters.size(), std::vector<Tensor<1, dim>>(n_mult * n_rows));
    std::vector<double>                  L, psi(n_mult), D_N(n_columns);
    typename PartnerMotion<dim>::Partner partner;
    for (const auto &point : segments.points)
      {
        multiplier_shape.evaluate_values(point.xi, L);
        for (unsigned int l = 0; l < n_mult; ++l)
          psi[l] = point.weight * combination(weighting, l, L);
        const unsigned int m = segments.masters[point.master];
        motion.evaluate(point, patch.configuration(m).positions, partner);
        const bool has_rise = !patch.face(m).rise.empty();
        partner.master.gradient.push_back(
          rise_gradient(patch.face(m), point.eta));
        for (unsigned int i = 0; i < (has_rise ? n_rows : n_master); ++i)
          {
            // N_i or the rise of the master per motion of the slave
            Tensor<1, dim> along;
            for (unsigned int d = 0; d < dim - 1; ++d)
              along += partner.master.gradient[i][d] * partner.dual[d];
            for (unsigned int k = 0; k < n; ++k)
              for (unsigned int c = 0; c < dim; ++c)
                D_N[k * dim + c] = partner.N[k] * along[c];
            for (unsigned int k = 0; k < n_master; ++k)
              for (unsigned int c = 0; c < dim; ++c)
                D_N[(n + k) * dim + c] = -partner.master.value[k] * along[c];
            for (unsigned int l = 0; l < n_mult; ++l)
              {
                if (psi[l] == 0.)
                  continue;
                add_scaled(psi[l], D_N, &D_M[point.master][l](i, 0));
                D_M_of_plane[point.master][l * n_rows + i] -=
                  (psi[l] * partner.distance) * along;
              }
          }
      }
    for (unsigned int m = 0; m < D_M.size(); ++m)
      for (unsigned int l = 0; l < n_mult; ++l)
        for (unsigned int i = 0; i < n_rows; ++i)
          for (unsigned int k = 0; k < n; ++k)
            {
              const Tensor<1, dim> along = D_M_of_plane[m][l * n_rows + i] *
                                           motion.plane_normal_derivative()[k];
              for (unsigned int c = 0; c < dim; ++c)
                D_M[m][l](i, k * dim + c) += along[c];
            }
    return D_M;
  }

  template class ShareDerivatives<2>;
  template class ShareDerivatives<3>;
} // namespace stickslip
