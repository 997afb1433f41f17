#include <stickslip/mesh/subdivided_line.h>

#include <stickslip/base/user_error.h>

#include <deal.II/base/utilities.h>

#include <cmath>
#include <exception>

namespace stickslip
{
  using namespace dealii;

  namespace
  {
    /// Appends the positions after @p line.back() up to @p end.
    void
    append_part(const double         end,
                const unsigned int   n_cells,
                const double         ratio,
                std::vector<double> &line)
    {
      const double begin = line.back();
      const double factor =
        n_cells > 1 ? std::pow(ratio, 1. / (n_cells - 1)) : 1.;

      double length = 0.;
      for (unsigned int i = 0; i < n_cells; ++i)
        length += std::pow(factor, i);

      double passed = 0.;
      for (unsigned int i = 0; i + 1 < n_cells; ++i)
        {
          passed += std::pow(factor, i);
          line.push_back(begin + (end - begin) * (passed / length));
        }
      line.push_back(end);
    }
  } // namespace



  std::vector<double>
  subdivided_line(const std::string &text, const std::string &parameter_path)
  {
    const std::string bad = parameter_path + ": '" + text + "' ";

    // Parts alternate: positions | cells | positions | cells | positions.
    const std::vector<std::string> parts =
      Utilities::split_string_list(text, '|');
    if (parts.size() % 2 == 0)
      throw UserError(bad +
                      "lacks a '|': write '0 |4| 1' for 4 cells between 0 "
                      "and 1.");

    std::vector<double> line;
    int                 n_cells = 1;
    double              ratio   = 1.;
    try
      {
        for (unsigned int p = 0; p < parts.size(); ++p)
          {
            const std::vector<double> numbers = Utilities::string_to_double(
              Utilities::split_string_list(parts[p], ','));
            if (numbers.empty())
              throw UserError(bad + "has an empty part.");
            if (p % 2 == 1)
              {
                n_cells = static_cast<int>(numbers[0]);
                ratio   = numbers.size() > 1 ? numbers[1] : 1.;
                if (numbers.size() > 2 || n_cells < 1 || n_cells > 1000000 ||
                    n_cells != numbers[0] || !(ratio > 0.))
                  throw UserError(
                    bad + "has '|" + parts[p] +
                    "|' where a number of cells (and the ratio of "
                    "the last to the first cell) must stand.");
                continue;
              }
            for (const double position : numbers)
              {
                if (line.empty())
                  line.push_back(position);
                else if (!(position > line.back()))
                  throw UserError(bad + "does not increase.");
                else
                  append_part(position, n_cells, ratio, line);
                n_cells = 1;
                ratio   = 1.;
              }
          }
      }
    catch (const UserError &)
      {
        throw;
      }
    catch (const std::exception &)
      {
        throw UserError(bad + "has something that is no number.");
      }
    if (line.size() < 2)
      throw UserError(bad + "needs at least two positions.");
    return line;
  }
} // namespace stickslip
