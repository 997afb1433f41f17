#include <stickslip/base/amplitude.h>
#include <stickslip/base/choice.h>
#include <stickslip/base/nearest_name.h>
#include <stickslip/base/number_table.h>
#include <stickslip/base/user_error.h>

#include <deal.II/base/patterns.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace stickslip
{
  namespace
  {
    using Table = NumberTable;



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
          table = read_number_table(given.file,
                                    directory,
                                    given.columns,
                                    path_of(name) + "/File",
                                    communicator);
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
