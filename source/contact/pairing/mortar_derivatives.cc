#include <stickslip/contact/pairing/mortar_derivatives.h>

#include <stickslip/contact/pairing/corner_normals.h>
#include <stickslip/contact/pairing/end_sums.h>
#include <stickslip/contact/pairing/partner_motion.h>
#include <stickslip/contact/pairing/tool_motion.h>
#include <stickslip/contact/surface/facet_rise.h>

#include <algorithm>
#include <map>

namespace stickslip
{
  namespace
  {
    /// Numbers of the master nodes that a mortar node meets.
    using MasterNumbers = std::map<NodeName, unsigned int>;



    template <int dim>
    MasterNumbers
    master_numbers(const MortarAverage<dim> &average)
    {
      MasterNumbers numbers;
      for (unsigned int l = 0; l < average.n_master_nodes(); ++l)
        numbers[average.masters.name(l)] = l;
      return numbers;
    }
  } // namespace



  template <int dim>
  MortarDerivatives<dim>::MortarDerivatives(
    const FaceShape<dim> &displacement_shape,
    const FaceShape<dim> &multiplier_shape)
    : displacement_shape(displacement_shape)
    , multiplier_shape(multiplier_shape)
  {}



  template <int dim>
  void
  MortarDerivatives<dim>::add_ends(
    const MortarFace<dim>                        &slave,
    const typename MortarNode<dim>::Around       &around,
    const FaceSegments<dim>                      &segments,
    const FaceIntegrals<dim>                     &integrals,
    const MasterPatch<dim>                       &patch,
    const std::vector<std::vector<unsigned int>> &rows,
    MortarDerivative<dim>                        &derivative) const
  {
    const FaceShape<dim>    &master_shape = patch.face_shape();
    const unsigned int       l            = around.multiplier;
    const PartnerMotion<dim> partners(displacement_shape, master_shape, slave);

    const unsigned int n_multipliers = multiplier_shape.n_nodes();
    EndSums<dim>       sums(displacement_shape.n_nodes(),
                      master_shape.n_nodes(),
                      n_multipliers);

    std::vector<double> L, N, N_master, motion;
    unsigned int        master = segments.ends.front().master;
    for (const SegmentEnd<dim> &end : segments.ends)
      {
        if (end.master != master) // those of one follow each other
          {
            sums.move_to(derivative, around, integrals, rows, master);
          }
        master = end.master;
        multiplier_shape.evaluate_values(end.xi, L);
        displacement_shape.evaluate_values(end.xi, N);
        master_shape.evaluate_values(end.eta, N_master);
        // the area that the border gains
        partners.border_motion(
          end,
          patch.configuration(segments.masters[end.master]).positions,
          motion);
        const double psi     = combination(integrals.weighting, l, L);
        double       of_area = psi;
        for (unsigned int k = 0; k < N.size(); ++k)
          sums.add_to_slave(k, psi * N[k], motion);
        for (unsigned int k = 0; k < N_master.size(); ++k)
          sums.add_to_master(k, psi * N_master[k], motion);
        sums.add_to_rise(psi * rise_between(slave.face,
                                            end.xi,
                                            patch.face(
                                              segments.masters[end.master]),
                                            end.eta),
                         motion);
        // dual functions stay dual on the part that has a master:
        // D psi_l = sum_m y_m psi_m, y_m from the derivative of D M^-1
        if (slave.weighting_kind == WeightingFunctions::dual)
          for (unsigned int m = 0; m < n_multipliers; ++m)
            {
              if (slave.missing.is_missing[m])
                continue;
              const double phi = combination(slave.extended, m, L);
              const double y =
                ((m == l ? phi : 0.) - psi * phi) / integrals.area[m];
              of_area += y * integrals.area[m];
              sums.add_to_dual(m, y, motion);
            }
        sums.add_to_area(of_area, motion);
      }
    sums.move_to(derivative, around, integrals, rows, master);
  }



  template <int dim>
  void
  MortarDerivatives<dim>::add_tool_motion(
    const MortarNode<dim>                  &node,
    const typename MortarNode<dim>::Around &around,
    const MortarAverage<dim>               &average,
    const MortarFace<dim>                  &slave,
    const FaceSegments<dim>                &segments,
    const FaceIntegrals<dim>               &integrals,
    const MasterPatch<dim>                 &patch,
    const bool                              has_normal_of_tool,
    const bool                              partners_move,
    MortarDerivative<dim>                  &derivative) const
  {
    const unsigned int  n       = displacement_shape.n_nodes();
    const unsigned int  n_slave = node.n_stencil_nodes();
    std::vector<double> L;
    ToolMotion<dim>     motion;
    for (const auto &point : segments.points)
      {
        multiplier_shape.evaluate_values(point.xi, L);
        const double psi =
          point.weight * combination(integrals.weighting, around.multiplier, L);
        if (psi == 0.)
          continue;
        motion.evaluate(displacement_shape, slave, point, patch, partners_move);
        for (unsigned int k = 0; k < motion.D_n.size(); ++k)
          {
            const unsigned int c = k % dim, i = k / dim;
            const unsigned int of_node =
              i < n ? around.stencil[i] : n_slave + i - n;
            if (has_normal_of_tool)
              {
                const auto D_n = psi * node.projection * motion.D_n[k];
                for (unsigned int j = 0; j < dim; ++j)
                  derivative.D_normal[of_node][j][c] += D_n[j];
              }
            for (unsigned int l = 0; l < average.n_master_nodes(); ++l)
              for (unsigned int d = 0; d < dim - 1; ++d)
                derivative.D_M(l, of_node * dim + c) +=
                  psi * motion.master.shape.gradient[l][d] * motion.D_xi[d][k];
          }
      }
  }



  template <int dim>
  void
  MortarDerivatives<dim>::differentiate(
    const MortarNode<dim>                 &node,
    const MortarAverage<dim>              &average,
    const MortarFrame<dim>                &frame,
    const std::vector<MortarFace<dim>>    &faces,
    const std::vector<FaceSegments<dim>>  &segments,
    const std::vector<FaceIntegrals<dim>> &integrals,
    const MasterPatch<dim>                &patch,
    const bool                             partners_move,
    ShareDerivatives<dim>                 &shares,
    MortarDerivative<dim>                 &derivative) const
  {
    const unsigned int n_slave = node.n_stencil_nodes();
    derivative.D_M.reinit(average.n_master_nodes(),
                          (n_slave + average.n_master_nodes()) * dim);
    derivative.D_rise.assign(derivative.D_M.n(), 0.);
    derivative.D_normal.assign(n_slave + average.n_master_nodes(),
                               Tensor<2, dim>());
    if (frame.is_of_corner && average.paired && patch.tool() == nullptr)
      add_corner_normal_derivative(displacement_shape,
                                   node,
                                   average,
                                   faces,
                                   segments,
                                   patch,
                                   partners_move,
                                   derivative.D_normal);
    derivative.D_D.reinit(0, 0);
    derivative.D_area.clear();
    const MasterNumbers numbers = master_numbers(average);
    for (const auto &around : node.faces)
      {
        const MortarFace<dim>   &slave   = faces[around.face];
        const FaceSegments<dim> &of_face = segments[around.face];
        const unsigned int       n       = slave.face.n_nodes;
        if (!frame.is_of_corner && slave.counts_for_normals())
          {
            const auto D_node_normal =
              outward_normal_derivative(slave.face,
                                        slave.positions,
                                        displacement_shape.at_node(
                                          around.displacement));
            for (unsigned int k = 0; k < n; ++k)
              derivative.D_normal[around.stencil[k]] +=
                node.projection * D_node_normal[k];
          }
        if (average.paired && patch.tool() != nullptr)
          add_tool_motion(node,
                          around,
                          average,
                          slave,
                          of_face,
                          integrals[around.face],
                          patch,
                          frame.is_of_corner,
                          partners_move,
                          derivative);
        if (!average.paired || !partners_move || patch.tool() != nullptr)
          continue;

        const auto &D_M = shares.of_face(
          around.face, slave, of_face, integrals[around.face].weighting, patch);
        std::vector<std::vector<unsigned int>> rows(D_M.size());
        for (unsigned int i = 0; i < D_M.size(); ++i)
          {
            const SurfaceFace<dim> &master = patch.face(of_face.masters[i]);
            for (unsigned int k = 0; k < master.n_nodes; ++k)
              rows[i].push_back(numbers.at(master.name(k)));
            const auto  columns = around.columns(n_slave, rows[i]);
            const auto &D_M_i   = D_M[i][around.multiplier];
            for (unsigned int l = 0; l < master.n_nodes; ++l)
              for (unsigned int k = 0; k < columns.size(); ++k)
                derivative.D_M(rows[i][l], columns[k]) += D_M_i(l, k);
            if (!master.rise.empty())
              for (unsigned int k = 0; k < columns.size(); ++k)
                derivative.D_rise[columns[k]] += D_M_i(master.n_nodes, k);
          }
        if (of_face.ends.empty())
          continue;
        if (derivative.D_area.empty())
          {
            derivative.D_area.assign(derivative.D_M.n(), 0.);
            derivative.D_D.reinit(n_slave, derivative.D_M.n());
          }
        add_ends(slave,
                 around,
                 of_face,
                 integrals[around.face],
                 patch,
                 rows,
                 derivative);
      }
  }

  template class MortarDerivatives<2>;
  template class MortarDerivatives<3>;
} // namespace stickslip
