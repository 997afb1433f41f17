#include <stickslip/contact/pairing/tool_pairing.h>

#include <stickslip/mesh/reference_cells.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>

namespace stickslip
{
  namespace
  {
    /// Points per direction beyond those that are exact for a flat tool, since
    /// the gap to a round one is no polynomial.
    constexpr unsigned int further_points = 2;



    /// gauss_quadrature(), on triangles of any @p n: copies of a rule for more
    /// points than it has.
    template <int facedim>
    Quadrature<facedim>
    dense_quadrature(const ReferenceCell &face, const unsigned int n)
    {
      if constexpr (facedim == 2)
        {
          unsigned int copies = 1; // in each direction, a power of two
          while (face.is_simplex() && most_simplex_points<2> * copies < n)
            copies *= 2;
          if (copies > 1)
            return QIteratedSimplex<facedim>(
              gauss_quadrature<facedim>(face, (n + copies - 1) / copies),
              copies);
        }
      return gauss_quadrature<facedim>(face, n);
    }
  } // namespace



  template <int dim>
  Pairing<dim>
  find_tool_partner(const MasterPatch<dim> &patch,
                    const Tensor<1, dim>   &x_s,
                    const Tensor<1, dim>   &normal)
  {
    Pairing<dim> pairing;
    if (patch.n_faces() == 0)
      return pairing;
    const auto &positions = patch.configuration(0).positions;
    const auto  foot      = project_on_tool(patch.tool()->surface,
                                      patch.tool()->frame,
                                      positions,
                                      x_s);
    if (!foot.found)
      return pairing;
    MasterPoint<dim> point;
    patch.tool()->evaluate(positions, foot.chart, foot.xi, point);
    if ((x_s - point.x).norm() > patch.tolerances.search_distance ||
        point.n * normal <= patch.tolerances.least_cosine * normal.norm())
      return pairing;
    pairing.paired  = true;
    pairing.face    = 0;
    pairing.face_id = patch.face(0).id;
    pairing.chart   = foot.chart;
    pairing.xi      = foot.xi;
    pairing.free    = everywhere<dim>();
    pairing.n       = point.n;
    return pairing;
  }



  template <int dim>
  ToolRule<dim>::ToolRule(const FaceShape<dim> &displacement_shape,
                          const FaceShape<dim> &multiplier_shape,
                          const unsigned int    order,
                          const CrossSection   &cross_section)
    : cross_section(cross_section)
    , quadrature(dense_quadrature<dim - 1>(
        displacement_shape.reference_cell(),
        std::max(order,
                 multiplier_shape.degree() + displacement_shape.degree() +
                   further_points)))
  {
    for (unsigned int q = 0; q < quadrature.size(); ++q)
      {
        shapes.emplace_back();
        displacement_shape.evaluate(quadrature.point(q), shapes.back());
      }
  }



  template <int dim>
  FaceSegments<dim>
  ToolRule<dim>::find_segments(const MortarFace<dim>  &slave,
                               const MasterPatch<dim> &patch) const
  {
    FaceSegments<dim> segments;
    const auto        undeformed = slave.face.undeformed_nodes();
    for (unsigned int q = 0; q < quadrature.size(); ++q)
      {
        const auto normal =
          outward_normal(slave.face,
                         surface_tangents<dim>(shapes[q].gradient,
                                               slave.positions));
        Pairing<dim> partner =
          find_tool_partner(patch,
                            interpolate<dim>(shapes[q].value, slave.positions),
                            normal);
        if (!partner.paired)
          continue;
        SegmentPoint<dim> point;
        point.xi     = quadrature.point(q);
        point.eta    = partner.xi;
        point.chart  = partner.chart;
        point.weight = quadrature.weight(q) *
                       surface_normal<dim>(
                         surface_tangents<dim>(shapes[q].gradient, undeformed))
                         .norm() *
                       cross_section.circumference(
                         interpolate<dim>(shapes[q].value, undeformed));
        segments.points.push_back(point);
      }
    segments.is_partial = segments.points.size() < quadrature.size();
    if (!segments.points.empty())
      {
        segments.masters    = {0};
        segments.master_ids = {patch.face(0).id};
      }
    return segments;
  }

#define INSTANTIATE(dim)                                            \
  template class ToolRule<dim>;                                     \
  template Pairing<dim> find_tool_partner(const MasterPatch<dim> &, \
                                          const Tensor<1, dim> &,   \
                                          const Tensor<1, dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
