#include <stickslip/mesh/generator_arguments.h>

#include <stickslip/base/short_number.h>
#include <stickslip/base/user_error.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>

namespace stickslip
{
  namespace
  {
    /// Does the argument count cells or something like it?
    bool
    counts_cells(const GeneratorArgument &argument)
    {
      for (const std::string word :
           {"cells", "shells", "slices", "repetitions", "holes"})
        if (argument.name.find(word) != std::string::npos)
          return true;
      return false;
    }



    /// "4, 2" -> 8; "3" per direction -> 3^dim; "0 |5| 1 |3, 2| 4" -> 8.
    double
    cells_in_argument(const GeneratorArgument &argument,
                      const std::string       &text,
                      const unsigned int       dim)
    {
      if (argument.name.find("positions") != std::string::npos)
        {
          const auto parts = Utilities::split_string_list(text, '|');
          double     sum   = 0.;
          for (unsigned int i = 1; i < parts.size(); i += 2)
            sum += std::max(std::strtod(parts[i].c_str(), nullptr), 0.);
          return std::max(sum, 1.);
        }
      const auto numbers = Utilities::split_string_list(text, ',');
      double     product = 1.;
      for (const std::string &number : numbers)
        product *= std::max(std::strtod(number.c_str(), nullptr), 1.);
      const bool is_for_each_direction =
        argument.name.find("per direction") != std::string::npos &&
        numbers.size() == 1;
      return is_for_each_direction ? std::pow(product, dim) : product;
    }
  } // namespace



  double
  estimated_cells(const std::string &name,
                  const std::string &arguments,
                  const unsigned int dim)
  {
    const auto values = Utilities::split_string_list(arguments, ':');
    double     n      = 1.;
    for (const GeneratorDescription &generator : generator_descriptions())
      if (generator.name == name)
        for (unsigned int i = 0;
             i < std::min(values.size(), generator.arguments.size());
             ++i)
          if (counts_cells(generator.arguments[i]) ||
              generator.arguments[i].name.find("positions") !=
                std::string::npos)
            n *= cells_in_argument(generator.arguments[i], values[i], dim);
    return n;
  }



  namespace
  {
    /// The number at the beginning of @p text, if there is one.
    std::optional<double>
    number_in(const std::string &text)
    {
      char        *end   = nullptr;
      const double value = std::strtod(text.c_str(), &end);
      return end == text.c_str() ? std::optional<double>() : value;
    }



    bool
    is_length(const GeneratorArgument &argument)
    {
      for (const std::string word : {"radius", "length", "thickness", "width"})
        if (argument.name.find(word) != std::string::npos)
          return true;
      return false;
    }



    void
    check_number(const GeneratorArgument &argument,
                 const std::string       &text,
                 const std::string       &path)
    {
      const auto complain = [&](const std::string &allowed) {
        throw UserError(path + ": '" + argument.name + "' is '" + text +
                        "', but has to be " + allowed + ".");
      };
      const std::optional<double> value = number_in(text);
      if (!value)
        return;
      if (is_length(argument) && !(*value > 0.))
        complain("greater than 0");
      const double least = argument.default_2d == "0" ? 0. : 1.;
      if (counts_cells(argument) && !(*value >= least))
        complain("at least " + std::string(least == 0. ? "0" : "1"));
    }



    /// One number for all directions or one for each, as the generator has it.
    void
    check_directions(const GeneratorDescription &generator,
                     const GeneratorArgument    &argument,
                     const std::string          &text,
                     const unsigned int          dim,
                     const std::string          &path)
    {
      if (argument.name.find("per direction") == std::string::npos)
        return;
      const unsigned int expected =
        generator.name == "subdivided_hyper_cube" ? 1 : dim;
      const unsigned int n = Utilities::split_string_list(text, ',').size();
      if (n != expected)
        throw UserError(path + ": '" + argument.name + "' is '" + text +
                        "', but has to be " + std::to_string(expected) +
                        " number" + (expected == 1 ? "" : "s") + ".");
    }
  } // namespace



  void
  check_generator_arguments(const GeneratorDescription     &generator,
                            const std::vector<std::string> &values,
                            const unsigned int              dim,
                            const std::string              &path)
  {
    std::optional<double> inner, outer;
    for (unsigned int i = 0; i < values.size(); ++i)
      {
        const GeneratorArgument &argument = generator.arguments[i];
        const std::string       &missing =
          dim == 2 ? argument.default_2d : argument.default_3d;
        const bool is_missing = missing == "none";
        if (is_missing && values[i] != "none" && values[i] != "false")
          throw UserError(path + ": '" + generator.name + "' has '" +
                          argument.name + "' only in " +
                          (dim == 2 ? "3D" : "2D") + ".");
        if (!is_missing && values[i] == "none")
          throw UserError(path + ": '" + argument.name + "' of '" +
                          generator.name + "' cannot be 'none'.");
        check_directions(generator, argument, values[i], dim, path);
        if (argument.name.find("positions") == std::string::npos)
          for (const auto &number :
               Utilities::split_string_list(values[i], ','))
            check_number(argument, number, path);
        if (argument.name == "inner radius")
          inner = number_in(values[i]);
        if (argument.name == "outer radius")
          outer = number_in(values[i]);
      }
    if (inner && outer && !(*inner < *outer))
      throw UserError(
        path + ": needs 0 < inner radius < outer radius, but they are " +
        short_number(*inner) + " and " + short_number(*outer) + ".");
  }
} // namespace stickslip
