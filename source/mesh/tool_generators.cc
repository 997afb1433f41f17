#include <stickslip/mesh/tool_generators.h>

#include <stickslip/base/user_error.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <exception>

namespace stickslip
{
  const std::vector<GeneratorDescription> &
  tool_descriptions()
  {
    using Argument = GeneratorArgument;

    const Argument radius{"radius", "", ""};
    const Argument axis{"axis", "", ""};
    const Argument centre{"centre", "", ""};
    const Argument side{"tool (inside or around)", "inside", "inside"};
    const Argument vertices{"vertices (x, y, fillet; ...)", "", ""};
    const Argument origin{"origin", "0, 0, 0", "0, 0, 0"};

    // clang-format off
    static const std::vector<GeneratorDescription> descriptions = {
      {"tool_circle", 2, {centre, radius, side}, true},
      {"tool_cone", 3, {{"tip", "", ""}, axis, {"half angle", "", ""}, {"height", "", ""}, {"tip radius", "", ""}}, true},
      {"tool_cylinder", 3, {centre, axis, radius, {"length", "", ""}, side}, true},
      {"tool_extruded", 3, {vertices, {"closed", "true", "true"}, {"length", "", ""}, origin, {"axis", "0, 1, 0", "0, 1, 0"},
                            {"direction of x", "1, 0, 0", "1, 0, 0"}}, true},
      {"tool_plane", 0, {centre, {"outward direction", "", ""}, {"edge length", "", ""}}, true},
      {"tool_polyline", 2, {vertices, {"closed", "true", "true"}}, true},
      {"tool_revolved", 3, {vertices, {"closed", "false", "false"}, origin, {"axis", "0, 0, 1", "0, 0, 1"}}, true},
      {"tool_rounded_cylinder", 3, {centre, axis, radius, {"length", "", ""}, {"edge radius", "", ""}}, true},
      {"tool_sphere", 3, {centre, radius, side}, true},
      {"tool_torus", 3, {centre, axis, radius, {"tube radius", "", ""}, side}, true},
    };
    // clang-format on
    return descriptions;
  }



  bool
  is_tool(const std::string &generator)
  {
    return std::any_of(tool_descriptions().begin(),
                       tool_descriptions().end(),
                       [&](const auto &tool) {
                         return tool.name == generator;
                       });
  }



  std::vector<double>
  tool_numbers(const std::string &text,
               const unsigned int n,
               const std::string &path)
  {
    std::vector<double> numbers;
    try
      {
        numbers =
          Utilities::string_to_double(Utilities::split_string_list(text, ','));
      }
    catch (const std::exception &)
      {
        throw UserError(path + ": '" + text +
                        "' has to be numbers separated by ','.");
      }
    const bool are_finite =
      std::all_of(numbers.begin(), numbers.end(), [](const double x) {
        return std::isfinite(x);
      });
    if (!are_finite || (n > 0 && numbers.size() != n))
      throw UserError(path + ": '" + text + "' has to be " +
                      (n > 0 ? std::to_string(n) + " finite" : "finite") +
                      " numbers separated by ','.");
    return numbers;
  }



  template <int dim>
  Point<dim>
  tool_point(const std::string &text, const std::string &path)
  {
    const auto numbers = tool_numbers(text, dim, path);
    Point<dim> point;
    std::copy(numbers.begin(), numbers.end(), point.begin_raw());
    return point;
  }



  template <int dim>
  std::pair<Point<dim>, Point<dim>>
  tool_cell(const std::string              &generator,
            const std::vector<std::string> &values,
            const std::string              &path)
  {
    // Nothing depends on it but the size of the model. It lies on one side of
    // an axis x = 0 of a body of revolution.
    Point<dim> first;
    double     size = 0.;
    if (generator == "tool_polyline" || generator == "tool_extruded" ||
        generator == "tool_revolved")
      {
        for (const auto &vertex : Utilities::split_string_list(values[0], ';'))
          for (const double x : tool_numbers(vertex, 0, path))
            size = std::max(size, std::abs(x));
        if (generator != "tool_polyline")
          first =
            tool_point<dim>(values[generator == "tool_extruded" ? 3 : 2], path);
      }
    else
      {
        const unsigned int of_size =
          generator == "tool_cone"                                   ? 3
          : generator == "tool_circle" || generator == "tool_sphere" ? 1
                                                                     : 2;
        first = tool_point<dim>(values[0], path);
        size  = tool_numbers(values[of_size], 1, path)[0];
      }
    if (!(size > 0.))
      throw UserError(path + ": the tool has no size.");
    Point<dim> last = first;
    for (unsigned int d = 0; d < dim; ++d)
      last[d] += size;
    return {first, last};
  }

#define INSTANTIATE(dim)                                                    \
  template Point<dim> tool_point(const std::string &, const std::string &); \
  template std::pair<Point<dim>, Point<dim>> tool_cell(                     \
    const std::string &,                                                    \
    const std::vector<std::string> &,                                       \
    const std::string &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
