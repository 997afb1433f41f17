#include <stickslip/contact/pairing/mortar_face.h>

#include <algorithm>
#include <limits>

namespace stickslip
{
  namespace
  {
    template <int dim>
    double
    shortest_node_distance(const FaceShape<dim>              &shape,
                           const std::vector<Tensor<1, dim>> &nodes)
    {
      double shortest = std::numeric_limits<double>::max();
      for (const NodeCell<dim> &cell : shape.cells())
        for (unsigned int i = 0; i < cell.corners.size(); ++i)
          {
            const unsigned int next = (i + 1) % cell.corners.size();
            shortest                = std::min(
              shortest,
              (nodes[cell.corners[next]] - nodes[cell.corners[i]]).norm());
          }
      return shortest;
    }
  } // namespace



  template <int dim>
  std::vector<double>
  set_weightings(const FaceShape<dim>      &displacement_shape,
                 const FaceShape<dim>      &multiplier_shape,
                 const Quadrature<dim - 1> &quadrature,
                 const CrossSection        &cross_section,
                 MortarFace<dim>           &slave)
  {
    const auto           undeformed = slave.face.undeformed_nodes();
    std::vector<double>  areas;
    FaceShapeValues<dim> values;
    slave.node_distance =
      shortest_node_distance(displacement_shape, undeformed);
    slave.area = 0.;
    for (unsigned int q = 0; q < quadrature.size(); ++q)
      {
        displacement_shape.evaluate(quadrature.point(q), values);
        areas.push_back(quadrature.weight(q) *
                        surface_normal<dim>(
                          surface_tangents<dim>(values.gradient, undeformed))
                          .norm() *
                        cross_section.circumference(
                          interpolate<dim>(values.value, undeformed)));
        slave.area += areas.back();
      }
    const auto functions = [&](const WeightingFunctions which) {
      return weighting_functions<dim>(
        which, multiplier_shape, slave.missing, quadrature, areas);
    };
    slave.extended  = functions(WeightingFunctions::standard);
    slave.weighting = functions(slave.weighting_kind);
    std::vector<double> weights(multiplier_shape.n_nodes(), 0.), L;
    for (unsigned int q = 0; q < quadrature.size(); ++q)
      {
        multiplier_shape.evaluate_values(quadrature.point(q), L);
        for (unsigned int l = 0; l < L.size(); ++l)
          for (unsigned int m = 0; m < L.size(); ++m)
            weights[l] += areas[q] * slave.weighting(l, m) * L[m];
      }
    return weights;
  }

  template std::vector<double>
  set_weightings(const FaceShape<2> &,
                 const FaceShape<2> &,
                 const Quadrature<1> &,
                 const CrossSection &,
                 MortarFace<2> &);
  template std::vector<double>
  set_weightings(const FaceShape<3> &,
                 const FaceShape<3> &,
                 const Quadrature<2> &,
                 const CrossSection &,
                 MortarFace<3> &);
} // namespace stickslip
