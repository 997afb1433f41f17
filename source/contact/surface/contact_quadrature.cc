#include <stickslip/contact/surface/contact_quadrature.h>

#include <stickslip/base/user_error.h>
#include <stickslip/mesh/reference_cells.h>

#include <deal.II/base/polynomial.h>
#include <deal.II/base/quadrature_lib.h>

#include <vector>

namespace stickslip
{
  namespace
  {
    /// Closed Newton-Cotes rule: integrals of the equidistant Lagrange basis.
    Quadrature<1>
    newton_cotes(const unsigned int n_intervals)
    {
      std::vector<Point<1>> points;
      for (unsigned int i = 0; i <= n_intervals; ++i)
        points.emplace_back(double(i) / n_intervals);
      const auto basis = Polynomials::generate_complete_Lagrange_basis(points);
      const QGauss<1>     exact(n_intervals / 2 + 1);
      std::vector<double> weights(points.size(), 0.);
      for (unsigned int i = 0; i < points.size(); ++i)
        for (unsigned int q = 0; q < exact.size(); ++q)
          weights[i] += basis[i].value(exact.point(q)[0]) * exact.weight(q);
      return Quadrature<1>(points, weights);
    }



    void
    check_order(const bool         ok,
                const unsigned int order,
                const std::string &allowed,
                const std::string &path)
    {
      if (!ok)
        throw UserError("'" + path +
                        "/Quadrature order = " + std::to_string(order) +
                        "' is not available. Allowed: " + allowed + ".");
    }



    Quadrature<2>
    quadrature_on_triangles(const ContactRule   rule,
                            const unsigned int  order,
                            const FaceShape<3> &multiplier_shape,
                            const std::string  &path)
    {
      const unsigned int n = multiplier_shape.n_nodes();
      switch (rule)
        {
          case ContactRule::nodal:
          case ContactRule::segments:
            {
              Assert(multiplier_shape.degree() == 1, ExcNotImplemented());
              std::vector<Point<2>> vertices;
              for (unsigned int j = 0; j < n; ++j)
                vertices.push_back(multiplier_shape.node(j));
              return {vertices, std::vector<double>(n, 0.5 / n)};
            }
          case ContactRule::Gauss:
            check_order(order >= 1 && order <= 4, order, "1 to 4", path);
            return gauss_quadrature<2>(multiplier_shape.reference_cell(),
                                       order);
          default:
            throw UserError("'" + path + "/Quadrature = " +
                            name_of(rule, all_contact_rules()) +
                            "' is not available on tetrahedra. Allowed: "
                            "segments, nodal, Gauss.");
        }
    }
  } // namespace



  const Choices<ContactRule> &
  all_contact_rules()
  {
    static const Choices<ContactRule> choices = {
      {"nodal", ContactRule::nodal},
      {"Gauss", ContactRule::Gauss},
      {"Simpson", ContactRule::Simpson},
      {"Newton-Cotes", ContactRule::Newton_Cotes},
      {"segments", ContactRule::segments}};
    return choices;
  }



  template <int dim>
  Quadrature<dim - 1>
  contact_quadrature(const ContactRule     rule,
                     const unsigned int    order,
                     const FaceShape<dim> &multiplier_shape,
                     const std::string    &path)
  {
    constexpr int facedim = dim - 1;
    if constexpr (dim == 3)
      if (multiplier_shape.is_triangle())
        return quadrature_on_triangles(rule, order, multiplier_shape, path);
    switch (rule)
      {
        case ContactRule::nodal:
        case ContactRule::segments:
          return QGaussLobatto<facedim>(multiplier_shape.degree() + 1);
        case ContactRule::Gauss:
          check_order(order >= 1 && order <= 20, order, "1 to 20", path);
          return QGauss<facedim>(order);
        case ContactRule::Simpson:
          check_order(order >= 1 && order <= 20, order, "1 to 20", path);
          return QIterated<facedim>(QSimpson<1>(), order);
        case ContactRule::Newton_Cotes:
          check_order((order >= 1 && order <= 7) || order == 9,
                      order,
                      "1 to 7 and 9 (order 8 has negative weights)",
                      path);
          return Quadrature<facedim>(newton_cotes(order));
      }
    throw ExcInternalError();
  }

  template <int dim>
  void
  check_multipliers_are_determined(const Quadrature<dim - 1> &quadrature,
                                   const FaceShape<dim>      &multiplier_shape,
                                   const std::string         &path)
  {
    const unsigned int needed = multiplier_shape.n_nodes();
    if (quadrature.size() >= needed)
      return;
    throw UserError(
      "'" + path + "/Quadrature' and 'Quadrature order' place " +
      std::to_string(quadrature.size()) +
      " contact points on a slave face, but 'Multiplier space' and 'Degree' "
      "put " +
      std::to_string(needed) +
      " multipliers there: that leaves some undetermined. Raise the order, or "
      "set 'Quadrature = segments' or 'Multiplier space = vertices'.");
  }

  template void
  check_multipliers_are_determined(const Quadrature<1> &,
                                   const FaceShape<2> &,
                                   const std::string &);
  template void
  check_multipliers_are_determined(const Quadrature<2> &,
                                   const FaceShape<3> &,
                                   const std::string &);
  template Quadrature<1>
  contact_quadrature(const ContactRule,
                     const unsigned int,
                     const FaceShape<2> &,
                     const std::string &);
  template Quadrature<2>
  contact_quadrature(const ContactRule,
                     const unsigned int,
                     const FaceShape<3> &,
                     const std::string &);
} // namespace stickslip
