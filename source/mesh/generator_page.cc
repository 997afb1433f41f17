#include <stickslip/mesh/generator_page.h>

#include <stickslip/mesh/mesh_generator.h>

#include <deal.II/grid/tria.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace stickslip
{
  namespace
  {
    /// Arguments of an example, without those at the end that have defaults.
    std::string
    example_arguments(const std::string &name, const unsigned int dim)
    {
      static const std::map<std::string, std::pair<std::string, std::string>>
        examples = {
          {"annular_sector",
           {"1 : 2 : 0 : 90 : 2 : 4", "1 : 2 : 0 : 90 : 2 : 4"}},
          {"cheese", {"1, 1", "1, 1, 1"}},
          {"cylinder_shell", {"", "3 : 1 : 2 : 8 : 2"}},
          {"eccentric_hyper_shell",
           {"0.1, 0 : 0, 0 : 1 : 2 : 12", "0.1, 0, 0 : 0, 0, 0 : 1 : 2 : 12"}},
          {"general_cell",
           {"0, 0; 2, 0; 0, 1; 2, 1",
            "0, 0, 0; 2, 0, 0; 0, 1, 0; 2, 1, 0; 0, 0, 1; 2, 0, 1; 0, 1, 1; "
            "2, 1, 1"}},
          {"graded_annular_sector",
           {"1 |2, 3| 2 : 0 |4| 90", "1 |2, 3| 2 : 0 |4| 90 : 0 |2| 1"}},
          {"graded_hyper_rectangle",
           {"0 |2| 2 : 0 |2| 1", "0 |2| 2 : 0 |2| 1 : 0 |2| 3"}},
          {"half_hyper_shell", {"0, 0 : 1 : 2", "0, 0, 0 : 1 : 2"}},
          {"hyper_cross", {"1, 1, 1, 1", "1, 1, 1, 1, 1, 1"}},
          {"hyper_rectangle", {"0, 0 : 2, 1", "0, 0, 0 : 2, 1, 3"}},
          {"hyper_shell", {"0, 0 : 1 : 2", "0, 0, 0 : 1 : 2"}},
          {"moebius", {"", "20 : 1 : 2 : 0.5"}},
          {"quarter_hyper_shell", {"0, 0 : 1 : 2", "0, 0, 0 : 1 : 2"}},
          {"subdivided_cylinder", {"", "4"}},
          {"subdivided_hyper_cube", {"2", "2"}},
          {"subdivided_hyper_rectangle",
           {"2, 2 : 0, 0 : 2, 1", "2, 2, 2 : 0, 0, 0 : 2, 1, 3"}},
          {"tool_circle", {"0, 0 : 1", ""}},
          {"tool_cone", {"", "0, 0, 0 : 0, 0, 1 : 30 : 2 : 0.1"}},
          {"tool_cylinder", {"", "0, 0, 0 : 0, 0, 1 : 1 : 4"}},
          {"tool_extruded", {"", "0, 0, 0.1; 1, 0, 0.1; 0, 1, 0.1 : true : 2"}},
          {"tool_plane", {"0, 0 : 0, 1 : 2", "0, 0, 0 : 0, 0, 1 : 2"}},
          {"tool_polyline", {"0, 0, 0.1; 1, 0, 0.1; 0, 1, 0.1", ""}},
          {"tool_revolved", {"", "0, 0, 0.1; 1, 0, 0.1; 1, 1"}},
          {"tool_rounded_cylinder", {"", "0, 0, 0 : 0, 0, 1 : 1 : 4 : 0.2"}},
          {"tool_sphere", {"", "0, 0, 0 : 1"}},
          {"tool_torus", {"", "0, 0, 0 : 0, 0, 1 : 2 : 0.5"}},
          {"torus", {"", "2 : 0.5"}}};
      const auto found = examples.find(name);
      return found == examples.end() ? ""
             : dim == 2              ? found->second.first
                                     : found->second.second;
    }



    /// With all arguments, and colorize = true where it exists.
    std::string
    coloured_example(const GeneratorDescription &generator,
                     const unsigned int          dim)
    {
      std::string  text = example_arguments(generator.name, dim);
      unsigned int n =
        text.empty() ? 0 : 1 + std::count(text.begin(), text.end(), ':');
      for (; n < generator.arguments.size(); ++n)
        {
          const GeneratorArgument &argument = generator.arguments[n];
          const std::string       &value =
            dim == 2 ? argument.default_2d : argument.default_3d;
          if (value != "none")
            text += (text.empty() ? "" : " : ") +
                    (value == "false" && argument.name == "colorize" ? "true"
                                                                     : value);
        }
      return text;
    }



    std::string
    number_in_page(const double value)
    {
      char text[32];
      std::snprintf(text,
                    sizeof(text),
                    "%.4g",
                    std::abs(value) < 1e-9 ? 0. : value);
      return text;
    }



    /// "x = 0", "radius 2", or the ranges of the coordinates.
    template <int dim>
    std::string
    place_in_words(const std::vector<Point<dim>> &vertices)
    {
      const double large = std::numeric_limits<double>::max();
      Point<dim>   low, high;
      double       least_radius = large, largest_radius = 0.;
      for (unsigned int d = 0; d < dim; ++d)
        {
          low[d]  = large;
          high[d] = -large;
        }
      for (const Point<dim> &vertex : vertices)
        {
          for (unsigned int d = 0; d < dim; ++d)
            {
              low[d]  = std::min(low[d], vertex[d]);
              high[d] = std::max(high[d], vertex[d]);
            }
          least_radius   = std::min(least_radius, vertex.norm());
          largest_radius = std::max(largest_radius, vertex.norm());
        }
      for (unsigned int d = 0; d < dim; ++d)
        if (high[d] - low[d] < 1e-9)
          return std::string(1, "xyz"[d]) + " = " + number_in_page(low[d]);
      if (largest_radius - least_radius < 1e-9)
        return "radius " + number_in_page(least_radius);
      std::string text;
      for (unsigned int d = 0; d < dim; ++d)
        text += (d > 0 ? ", " : "") + std::string(1, "xyz"[d]) + " " +
                number_in_page(low[d]) + " to " + number_in_page(high[d]);
      return text;
    }



    template <int dim>
    std::string
    boundary_ids_in_words(const GeneratorDescription &generator)
    {
      Triangulation<dim> triangulation;
      const std::string  arguments = coloured_example(generator, dim);
      generate_mesh(generator.name, arguments, "", triangulation);
      std::map<types::boundary_id, std::vector<Point<dim>>> vertices;
      for (const auto &face : triangulation.active_face_iterators())
        if (face->at_boundary())
          for (const unsigned int v : face->vertex_indices())
            vertices[face->boundary_id()].push_back(face->vertex(v));
      std::string text = "`" + arguments + "`";
      for (const auto &[id, points] : vertices)
        text += (id == vertices.begin()->first ? ": " : "; ") +
                std::to_string(id) + " " +
                (vertices.size() == 1 ? "everywhere" : place_in_words(points));
      return text;
    }



    std::string
    arguments_in_words(const GeneratorDescription &generator)
    {
      std::string text;
      for (const GeneratorArgument &argument : generator.arguments)
        {
          const std::string &value = argument.default_3d == "none"
                                       ? argument.default_2d
                                       : argument.default_3d;
          text += (text.empty() ? "" : " : ") + argument.name +
                  (value.empty() ? "" : " (" + value + ")");
        }
      return text;
    }
  } // namespace



  void
  print_generators(std::ostream &out)
  {
    const auto in_cell = [](std::string text) {
      for (std::size_t bar = text.find('|'); bar != std::string::npos;
           bar             = text.find('|', bar + 2))
        text.insert(bar, "\\");
      return text;
    };
    out << "\n## Generators\n\n"
           "For `Bodies/<body>/Generator`, with its `Arguments` (defaults in "
           "3D in parentheses) and an example with all of\n"
           "them and the boundary ids that its faces have. With `colorize` "
           "false, most have the id 0 everywhere.\n\n"
           "| Generator | Arguments | 2D | 3D |\n|---|---|---|---|\n";
    for (const GeneratorDescription &generator : generator_descriptions())
      out << "| " << generator.name << " | "
          << in_cell(arguments_in_words(generator)) << " | "
          << (generator.dimension == 3
                ? "-"
                : in_cell(boundary_ids_in_words<2>(generator)))
          << " | "
          << (generator.dimension == 2
                ? "-"
                : in_cell(boundary_ids_in_words<3>(generator)))
          << " |\n";
  }
} // namespace stickslip
