#include <stickslip/base/amplitude.h>
#include <stickslip/base/choice.h>
#include <stickslip/base/nearest_name.h>
#include <stickslip/base/user_error.h>

#include <deal.II/base/patterns.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace stickslip
{
  namespace
  {
    using Table = std::vector<std::pair<double, double>>;



    const Choices<AmplitudeInterpolation> &
    all_interpolations()
    {
      static const Choices<AmplitudeInterpolation> choices = {
        {"linear", AmplitudeInterpolation::linear},
        {"smooth", AmplitudeInterpolation::smooth},
        {"step", AmplitudeInterpolation::step}};
      return choices;
    }



    std::string
    path_of(const std::string &name)
    {
      return "Amplitudes/" + name;
    }



    /// Numbers of a line that are separated by commas, semicolons or blanks;
    /// empty if one of them is no number.
    std::vector<double>
    numbers_in(std::string line)
    {
      for (char &letter : line)
        if (letter == ',' || letter == ';' || letter == '\t' || letter == '\r')
          letter = ' ';
      std::vector<double> numbers;
      for (const std::string &word :
           Utilities::split_string_list(Utilities::trim(line), ' '))
        if (!word.empty())
          try
            {
              numbers.push_back(Utilities::string_to_double(word));
            }
          catch (const ExceptionBase &)
            {
              return {};
            }
      return numbers;
    }



    /// A first line without numbers has the columns' names; lines that are
    /// empty or begin with # are left out.
    Table
    read_table(const std::string               &file_name,
               const std::vector<unsigned int> &columns,
               const std::string               &path)
    {
      std::ifstream   input(file_name);
      std::error_code error;
      if (!input || std::filesystem::is_directory(file_name, error))
        throw UserError(path + ": the file '" + file_name +
                        "' cannot be opened for reading.");
      Table        table;
      std::string  line;
      unsigned int n_lines  = 0;
      bool         is_first = true;
      while (std::getline(input, line))
        {
          ++n_lines;
          line = Utilities::trim(line.substr(0, line.find('#')));
          if (line.empty() || line == "\r")
            continue;
          const std::vector<double> numbers = numbers_in(line);
          const unsigned int        needed  = std::max(columns[0], columns[1]);
          if (numbers.size() < needed && !(is_first && numbers.empty()))
            throw UserError(file_name + ":" + std::to_string(n_lines) +
                            ": expected a line with at least " +
                            std::to_string(needed) + " numbers (" + path +
                            "), found '" + line.substr(0, 60) + "'.");
          if (!numbers.empty())
            table.emplace_back(numbers[columns[0] - 1],
                               numbers[columns[1] - 1]);
          is_first = false;
        }
      return table;
    }



    void
    check_table(const Table &table, const bool repeat, const std::string &path)
    {
      if (table.size() < 2)
        throw UserError(path + ": the table has " +
                        std::to_string(table.size()) +
                        " points; it needs two at least.");
      for (unsigned int i = 0; i < table.size(); ++i)
        if (!std::isfinite(table[i].first) || !std::isfinite(table[i].second))
          throw UserError(path + ": point " + std::to_string(i + 1) +
                          " of the table is not finite.");
      for (unsigned int i = 1; i < table.size(); ++i)
        if (!(table[i].first > table[i - 1].first))
          {
            std::ostringstream text;
            text << path << ": the times of the table have to increase; "
                 << table[i].first << " comes after " << table[i - 1].first
                 << '.';
            throw UserError(text.str());
          }
      if (repeat && table.front().second != table.back().second)
        throw UserError(path +
                        "/Repeat = true: the first and the last factor of the "
                        "table have to be the same.");
    }
  } // namespace



  void
  AmplitudeParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Table",
                      table,
                      "Points 'time: factor, time: factor' with increasing "
                      "load times. Give this or File.",
                      *Patterns::Tools::Convert<decltype(table)>::to_pattern());
    prm.add_parameter("File",
                      file,
                      "A table of numbers (CSV or columns), a line per point; "
                      "a first line of names and lines that begin with # are "
                      "left out. Relative names start at the folder of the "
                      ".prm file.",
                      Patterns::Anything());
    prm.add_parameter("Columns",
                      columns,
                      "The file's columns of time and factor, counted from 1.",
                      Patterns::List(Patterns::Integer(1, 1000), 2, 2));
    add_choice(prm,
               "Interpolation",
               interpolation,
               all_interpolations(),
               "Between two points. linear; smooth: a polynomial whose first "
               "and second derivatives vanish at the points; step: the factor "
               "of the earlier point.");
    prm.add_parameter("Repeat",
                      repeat,
                      "Begins again after the last point, whose factor has to "
                      "be that of the first. Otherwise the first and the last "
                      "factor hold before and after the table.");
  }



  void
  AmplitudeParameters::check(const std::string &path) const
  {
    if (table.empty() == file.empty())
      throw UserError(path + ": give either 'Table' or 'File'" +
                      (table.empty() ? "." : ", not both."));
  }



  Amplitude::Amplitude(Table                        table,
                       const AmplitudeInterpolation interpolation,
                       const bool                   repeat)
    : table(std::move(table))
    , interpolation(interpolation)
    , repeat(repeat)
  {}



  double
  Amplitude::value(const double time) const
  {
    const double start = table.front().first, end = table.back().first;
    double       t = time;
    if (repeat)
      t -= (end - start) * std::floor((t - start) / (end - start));
    const auto next = std::upper_bound(
      table.begin(), table.end(), t, [](const double value, const auto &point) {
        return value < point.first;
      });
    if (next == table.begin())
      return table.front().second;
    if (next == table.end())
      return table.back().second;
    const auto &[t_0, f_0] = *(next - 1);
    const auto &[t_1, f_1] = *next;
    const double s         = (t - t_0) / (t_1 - t_0);
    switch (interpolation)
      {
        case AmplitudeInterpolation::linear:
          return f_0 + (f_1 - f_0) * s;
        case AmplitudeInterpolation::smooth:
          return f_0 + (f_1 - f_0) * s * s * s * (10. - 15. * s + 6. * s * s);
        default:
          return f_0;
      }
  }



  Amplitudes
  make_amplitudes(const NamedList<AmplitudeParameters> &parameters,
                  const std::string                    &directory,
                  const MPI_Comm                        communicator)
  {
    Amplitudes amplitudes;
    for (const auto &[name, given] : parameters)
      {
        Table table = given.table;
        if (!given.file.empty())
          {
            const std::string file =
              (std::filesystem::path(directory) / given.file).string();
            on_first_rank(
              [&, &name = name, &given = given] {
                table =
                  read_table(file, given.columns, path_of(name) + "/File");
              },
              communicator);
            table = Utilities::MPI::broadcast(communicator, table);
          }
        check_table(table, given.repeat, path_of(name));
        amplitudes[name] =
          std::make_shared<Amplitude>(table, given.interpolation, given.repeat);
      }
    return amplitudes;
  }



  std::shared_ptr<const Amplitude>
  amplitude_called(const std::string &name,
                   const Amplitudes  &amplitudes,
                   const std::string &path)
  {
    const auto found = amplitudes.find(name);
    if (found != amplitudes.end())
      return found->second;
    std::vector<std::string> names;
    for (const auto &amplitude : amplitudes)
      names.push_back(amplitude.first);
    throw UserError(path + ": there is no amplitude '" + name + "'." +
                    did_you_mean(name, names) +
                    " Known: " + quoted_list(names) + ".");
  }
} // namespace stickslip
