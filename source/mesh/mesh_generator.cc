#include <stickslip/mesh/mesh_generator.h>

#include <stickslip/base/nearest_name.h>
#include <stickslip/base/short_message.h>
#include <stickslip/base/user_error.h>
#include <stickslip/mesh/generator_arguments.h>
#include <stickslip/mesh/mesh_checks.h>
#include <stickslip/mesh/mesh_shapes.h>
#include <stickslip/mesh/subdivided_line.h>
#include <stickslip/mesh/tool_generators.h>

#include <deal.II/base/patterns.h>
#include <deal.II/base/utilities.h>

#include <deal.II/grid/grid_generator.h>

#include <array>
#include <exception>
#include <new>

namespace stickslip
{
  const std::vector<GeneratorDescription> &
  generator_descriptions()
  {
    using Argument = GeneratorArgument;

    const Argument left{"left", "0", "0"};
    const Argument right{"right", "1", "1"};
    const Argument colorize{"colorize", "false", "false"};
    const Argument p1{"first corner", "", ""};
    const Argument p2{"opposite corner", "", ""};
    const Argument centre{"centre", "0, 0", "0, 0, 0"};
    const Argument radius{"radius", "1", "1"};
    const Argument half_length{"half length", "1", "1"};
    const Argument inner_radius{"inner radius", "", ""};
    const Argument outer_radius{"outer radius", "", ""};
    const Argument n_cells{"number of cells", "0", "0"};

    // clang-format off
    static std::vector<GeneratorDescription> descriptions = {
      {"annular_sector", 0, {inner_radius, outer_radius, {"first angle", "", ""}, {"last angle", "", ""},
                             {"radial cells", "", ""}, {"angular cells", "", ""}, {"length", "1", "1"}, {"axial cells", "1", "1"}}, true},
      {"channel_with_cylinder", 0, {{"shell region width", "0.03", "0.03"}, {"number of shells", "2", "2"}, {"skewness", "2", "2"}, colorize}, false},
      {"cheese", 0, {{"holes per direction", "", ""}}, false},
      {"concentric_hyper_shells", 0, {centre, {"inner radius", "0.125", "0.125"}, {"outer radius", "0.25", "0.25"}, {"number of shells", "1", "1"},
                                      {"skewness", "0.1", "0.1"}, {"cells per shell", "0", "0"}, colorize}, false},
      {"cylinder", 0, {radius, half_length}, false},
      {"cylinder_shell", 3, {{"length", "", ""}, inner_radius, outer_radius, {"radial cells", "0", "0"}, {"axial cells", "0", "0"}}, false},
      {"eccentric_hyper_shell", 0, {{"inner centre", "", ""}, {"outer centre", "", ""}, inner_radius, outer_radius, {"number of cells", "", ""}}, false},
      {"enclosed_hyper_cube", 0, {left, right, {"thickness", "1", "1"}, colorize}, false},
      {"general_cell", 0, {{"vertices (points separated by ';')", "", ""}, colorize}, false},
      {"graded_annular_sector", 0, {{"radial positions", "", ""}, {"angular positions", "", ""}, {"z positions", "none", ""}}, true},
      {"graded_hyper_rectangle", 0, {{"x positions", "", ""}, {"y positions", "", ""}, {"z positions", "none", ""}}, true},
      {"half_hyper_ball", 0, {centre, radius}, false},
      {"half_hyper_shell", 0, {centre, inner_radius, outer_radius, n_cells, colorize}, false},
      {"hyper_L", 0, {{"left", "-1", "-1"}, right, {"colorize", "false", "none"}}, false},
      {"hyper_ball", 0, {centre, radius, {"spherical manifold on boundary cells", "false", "false"}}, false},
      {"hyper_ball_balanced", 0, {centre, radius}, false},
      {"hyper_cross", 0, {{"sizes", "", ""}, colorize}, false},
      {"hyper_cube", 0, {left, right, colorize}, false},
      {"hyper_cube_slit", 0, {left, right, colorize}, false},
      {"hyper_cube_with_cylindrical_hole", 0, {{"inner radius", "0.25", "0.25"}, {"outer radius", "0.5", "0.5"}, {"length", "0.5", "0.5"},
                                               {"repetitions", "1", "1"}, colorize}, false},
      {"hyper_rectangle", 0, {p1, p2, colorize}, false},
      {"hyper_shell", 0, {centre, inner_radius, outer_radius, n_cells, colorize}, false},
      {"moebius", 3, {{"cells", "", ""}, {"rotations", "", ""}, {"large radius", "", ""}, {"small radius", "", ""}}, false},
      {"plate_with_a_hole", 0, {{"inner radius", "0.4", "0.4"}, {"outer radius", "1", "1"}, {"bottom pad", "2", "2"}, {"top pad", "2", "2"},
                                {"left pad", "1", "1"}, {"right pad", "1", "1"}, centre, {"polar manifold id", "0", "0"},
                                {"transfinite manifold id", "1", "1"}, {"thickness", "1", "1"}, {"slices", "2", "2"}, colorize}, false},
      {"quarter_hyper_ball", 0, {centre, radius}, false},
      {"quarter_hyper_shell", 0, {centre, inner_radius, outer_radius, n_cells, colorize}, false},
      {"subdivided_cylinder", 3, {{"axial cells", "", ""}, radius, half_length}, false},
      {"subdivided_hyper_cube", 0, {{"cells per direction", "", ""}, left, right, colorize}, false},
      {"subdivided_hyper_rectangle", 0, {{"cells per direction", "", ""}, p1, p2, colorize}, false},
      {"torus", 3, {{"large radius", "", ""}, {"small radius", "", ""}, {"toroidal cells", "6", "6"}, {"angle in radians", "6.283185307179586", "6.283185307179586"}}, false},
      {"truncated_cone", 0, {{"first radius", "1", "1"}, {"last radius", "0.5", "0.5"}, half_length}, false},
    };
    // clang-format on
    static const bool has_tools = [] {
      const auto &tools = tool_descriptions();
      descriptions.insert(descriptions.end(), tools.begin(), tools.end());
      return true;
    }();
    (void)has_tools;
    return descriptions;
  }



  std::vector<std::string>
  generator_names(const unsigned int dim)
  {
    std::vector<std::string> names;
    for (const GeneratorDescription &description : generator_descriptions())
      if (description.dimension == 0 || description.dimension == dim)
        names.push_back(description.name);
    return names;
  }



  namespace
  {
    const GeneratorDescription &
    find_generator(const std::string &name,
                   const unsigned int dim,
                   const std::string &path)
    {
      for (const GeneratorDescription &description : generator_descriptions())
        if (description.name == name)
          {
            if (description.dimension != 0 && description.dimension != dim)
              throw UserError(path + "/Generator: '" + name +
                              "' exists only in " +
                              std::to_string(description.dimension) + "D.");
            return description;
          }
      const std::vector<std::string> names = generator_names(dim);
      throw UserError(path + "/Generator: '" + name + "' is unknown." +
                      did_you_mean(name, names) +
                      " Known: " + quoted_list(names) + ".");
    }



    std::string
    default_argument(const GeneratorArgument &argument, const unsigned int dim)
    {
      return dim == 2 ? argument.default_2d : argument.default_3d;
    }



    /// "'hyper_cube' takes left (0) : right (1) : colorize (false)".
    std::string
    generator_usage(const GeneratorDescription &generator,
                    const unsigned int          dim)
    {
      std::string text;
      for (const GeneratorArgument &argument : generator.arguments)
        {
          const std::string value = default_argument(argument, dim);
          text += (text.empty() ? "" : " : ") + argument.name +
                  (value.empty() ? "" : " (" + value + ")");
        }
      return "'" + generator.name + "' takes, separated by ':' and with " +
             "defaults in parentheses: " + text + ". A point is " +
             (dim == 2 ? "'x, y'." : "'x, y, z'.");
    }



    /// All arguments, trailing ones from the defaults.
    std::vector<std::string>
    complete_arguments(const GeneratorDescription &generator,
                       const std::string          &arguments,
                       const unsigned int          dim,
                       const std::string          &path)
    {
      std::vector<std::string> values =
        Utilities::split_string_list(arguments, ':');
      if (values.size() > generator.arguments.size())
        throw UserError(path + ": " + std::to_string(values.size()) +
                        " arguments are too many. " +
                        generator_usage(generator, dim));

      values.resize(generator.arguments.size());
      for (unsigned int i = 0; i < values.size(); ++i)
        {
          if (values[i].empty())
            values[i] = default_argument(generator.arguments[i], dim);
          if (values[i].empty())
            throw UserError(path + ": the argument '" +
                            generator.arguments[i].name + "' is missing. " +
                            generator_usage(generator, dim));
        }
      return values;
    }



    std::vector<double>
    equal_parts(const double begin, const double length, const int n_parts)
    {
      std::vector<double> positions;
      for (int i = 0; i <= n_parts; ++i)
        positions.push_back(begin + length * i / n_parts);
      return positions;
    }



    AnnularSector
    equally_divided_sector(const std::vector<std::string> &values,
                           const std::string              &path)
    {
      const double inner     = Utilities::string_to_double(values[0]);
      const double outer     = Utilities::string_to_double(values[1]);
      const double first     = Utilities::string_to_double(values[2]);
      const double last      = Utilities::string_to_double(values[3]);
      const int    n_radial  = Utilities::string_to_int(values[4]);
      const int    n_angular = Utilities::string_to_int(values[5]);
      const double length    = Utilities::string_to_double(values[6]);
      const int    n_axial   = Utilities::string_to_int(values[7]);

      if (n_radial < 1 || n_angular < 1 || n_axial < 1)
        throw UserError(path + ": numbers of cells start at 1.");
      if (!(length > 0.))
        throw UserError(path + ": the length must be positive.");
      return {equal_parts(inner, outer - inner, n_radial),
              equal_parts(first, last - first, n_angular),
              equal_parts(0., length, n_axial)};
    }



    template <int dim>
    void
    check_and_make(const AnnularSector &sector,
                   const std::string   &path,
                   Triangulation<dim>  &triangulation)
    {
      if (!(sector.radii.front() > 0. &&
            sector.radii.back() > sector.radii.front()))
        throw UserError(path + ": needs 0 < inner radius < outer radius.");
      const double range = sector.angles.back() - sector.angles.front();
      if (!(range > 0. && range < 360. + 1e-9))
        throw UserError(path +
                        ": needs first angle < last angle, at most 360 "
                        "degrees apart.");
      for (unsigned int j = 1; j < sector.angles.size(); ++j)
        if (sector.angles[j] - sector.angles[j - 1] > 120. + 1e-9)
          throw UserError(path +
                          ": a cell may cover at most 120 degrees; give "
                          "more angular cells.");
      make_annular_sector(sector, triangulation);
    }



    template <int dim>
    void
    generate_own(const std::string              &name,
                 const std::vector<std::string> &values,
                 const std::string              &path,
                 Triangulation<dim>             &triangulation)
    {
      if (name == "annular_sector")
        return check_and_make(equally_divided_sector(values, path),
                              path,
                              triangulation);

      if (is_tool(name))
        {
          const auto [first, last] = tool_cell<dim>(name, values, path);
          return GridGenerator::hyper_rectangle(triangulation, first, last);
        }
      std::array<std::vector<double>, dim> positions;
      for (unsigned int d = 0; d < dim; ++d)
        positions[d] = subdivided_line(values[d], path);
      if (name == "graded_annular_sector")
        {
          AnnularSector sector{positions[0], positions[1], {}};
          if constexpr (dim == 3)
            sector.heights = positions[2];
          return check_and_make(sector, path, triangulation);
        }
      make_graded_hyper_rectangle<dim>(positions, triangulation);
    }



    /// As deal.II's own generators take them.
    std::string
    joined_arguments(const std::string              &name,
                     const std::vector<std::string> &values)
    {
      std::string text;
      // deal.II wants values of what it does not know in this dimension, too
      for (const std::string &value : values)
        text +=
          (text.empty() ? "" : " : ") + (value == "none" ? "false" : value);
#if DEAL_II_VERSION_GTE(9, 6, 0)
      if (name == "cylinder_shell")
        text += " : false"; // not colorized, as it always was
#else
      (void)name;
#endif
      return text;
    }
  } // namespace



  std::vector<std::string>
  generator_arguments(const std::string &name,
                      const std::string &arguments,
                      const unsigned int dim,
                      const std::string &path)
  {
    return complete_arguments(find_generator(name, dim, path),
                              arguments,
                              dim,
                              path + "/Arguments");
  }



  template <int dim>
  void
  generate_mesh(const std::string  &name,
                const std::string  &arguments,
                const std::string  &path,
                Triangulation<dim> &triangulation)
  {
    const GeneratorDescription    &generator = find_generator(name, dim, path);
    const std::string              where     = path + "/Arguments";
    const std::vector<std::string> values =
      complete_arguments(generator, arguments, dim, where);
    check_generator_arguments(generator, values, dim, where);

    try
      {
        if (generator.is_own)
          generate_own(name, values, where, triangulation);
        else
          GridGenerator::generate_from_name_and_arguments(
            triangulation, name, joined_arguments(name, values));
      }
    catch (const UserError &)
      {
        throw;
      }
    catch (const Patterns::Tools::ExcNoMatch &)
      {
        throw UserError(where + ": cannot understand '" + arguments + "'. " +
                        generator_usage(generator, dim));
      }
    catch (const std::bad_alloc &)
      {
        throw UserError(where + ": '" + name + "' needs more memory with '" +
                        arguments + "' than there is. " +
                        generator_usage(generator, dim));
      }
    catch (const std::exception &exception)
      {
        throw UserError(where + ": '" + name + "' failed with '" + arguments +
                        "'. " + short_message(exception) + " " +
                        generator_usage(generator, dim));
      }
  }



  template void
  generate_mesh(const std::string &,
                const std::string &,
                const std::string &,
                Triangulation<2> &);
  template void
  generate_mesh(const std::string &,
                const std::string &,
                const std::string &,
                Triangulation<3> &);
} // namespace stickslip
