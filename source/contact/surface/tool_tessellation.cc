#include <stickslip/contact/surface/tool_tessellation.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace stickslip
{
  namespace
  {
    /// Cells along a segment of the outline.
    unsigned int
    n_along(const ToolProfile &profile,
            const unsigned int segment,
            const unsigned int n_per_turn)
    {
      if (profile.radius(segment) == 0.)
        return 1;
      const double turns =
        profile.length(segment) / (2. * numbers::PI * profile.radius(segment));
      // a full circle makes no cell more by roundoff
      return std::max(1., std::ceil(turns * n_per_turn - 1e-6));
    }
  } // namespace



  template <int dim>
  ToolTessellation<dim>
  tessellate(const ToolSurface<dim> &surface, const unsigned int n_per_turn)
  {
    const ToolProfile    &profile = surface.outline();
    ToolTessellation<dim> result;
    for (unsigned int segment = 0; segment < profile.n_segments(); ++segment)
      {
        const unsigned int n      = n_along(profile, segment, n_per_turn);
        const double       length = profile.length(segment);
        const unsigned int first  = result.points.size();
        if constexpr (dim == 2)
          for (unsigned int i = 0; i <= n; ++i)
            {
              result.points.push_back(
                surface.evaluate(segment, Point<1>(i * length / n)).x);
              if (i < n)
                result.cells.push_back({{first + i, first + i + 1}});
            }
        else
          {
            const auto         across = surface.across_range();
            const unsigned int m      = surface.is_revolved() ? n_per_turn : 1;
            Assert(std::isfinite(across[1] - across[0]),
                   ExcMessage("A surface without ends has no picture."));
            for (unsigned int i = 0; i <= n; ++i)
              for (unsigned int j = 0; j <= m; ++j)
                result.points.push_back(
                  surface
                    .evaluate(surface.first_chart(segment),
                              Point<2>(i * length / n,
                                       across[0] +
                                         j * (across[1] - across[0]) / m))
                    .x);
            for (unsigned int i = 0; i < n; ++i)
              for (unsigned int j = 0; j < m; ++j)
                {
                  const unsigned int corner = first + i * (m + 1) + j;
                  result.cells.push_back(
                    {{corner, corner + m + 1, corner + m + 2, corner + 1}});
                }
          }
      }
    return result;
  }

  template struct ToolTessellation<2>;
  template struct ToolTessellation<3>;
  template ToolTessellation<2>
  tessellate(const ToolSurface<2> &, const unsigned int);
  template ToolTessellation<3>
  tessellate(const ToolSurface<3> &, const unsigned int);
} // namespace stickslip
