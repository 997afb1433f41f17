#include <stickslip/base/space_time_function.h>

#include <stickslip/base/user_error.h>

#include <stickslip/base/parsed_expression.h>

#include <deal.II/base/utilities.h>

#include <algorithm>

namespace stickslip
{
  std::vector<std::string>
  split_components(const std::string &text,
                   const unsigned int n_components,
                   const std::string &path)
  {
    const std::vector<std::string> parts =
      Utilities::split_string_list(text, ";");
    if (parts.size() != n_components ||
        std::any_of(parts.begin(), parts.end(), [](const std::string &part) {
          return part.empty();
        }))
      throw UserError(
        path + " is '" + text + "', but has to have " +
        std::to_string(n_components) +
        (n_components == 1 ? " component." : " components, separated by ';'."));
    return parts;
  }



  template <int dim>
  SpaceTimeFunction<dim>::SpaceTimeFunction(const std::string &expressions,
                                            const unsigned int n_components,
                                            const std::string &path,
                                            const bool         allow_free,
                                            const bool         depends_on_time)
    : free_components(n_components, false)
  {
    std::vector<std::string> parts =
      split_components(expressions, n_components, path);
    if (allow_free)
      for (unsigned int c = 0; c < n_components; ++c)
        if (parts[c] == free_word)
          {
            free_components[c] = true;
            parts[c]           = "0";
          }
    parser =
      parse_expressions<3>(depends_on_time ? "x,y,z,t" : "x,y,z", parts, path);
  }



  template <int dim>
  double
  SpaceTimeFunction<dim>::value(const Point<dim>  &reference_position,
                                const double       time,
                                const unsigned int component) const
  {
    Point<3> position;
    for (unsigned int d = 0; d < dim; ++d)
      position[d] = reference_position[d];
    parser->set_time(time);
    return (amplitude ? amplitude->value(time) : 1.) *
           parser->value(position, component);
  }



  template <int dim>
  Tensor<1, dim>
  SpaceTimeFunction<dim>::vector(const Point<dim> &reference_position,
                                 const double      time) const
  {
    Tensor<1, dim> result;
    for (unsigned int d = 0; d < dim; ++d)
      result[d] = value(reference_position, time, d);
    return result;
  }



  template class SpaceTimeFunction<2>;
  template class SpaceTimeFunction<3>;
} // namespace stickslip
