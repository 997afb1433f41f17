#include <stickslip/output/statistics_table.h>

#include <stickslip/base/short_number.h>
#include <stickslip/base/user_error.h>

#include <stickslip/output/csv.h>
#include <stickslip/output/output_directory.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <optional>
#include <sstream>

namespace stickslip
{
  using namespace dealii;

  namespace
  {
    /// For people: six digits, empty cells as '-', no blanks within a cell.
    std::string
    readable_cell(const std::string &cell)
    {
      if (cell.empty())
        return "-";
      if (const std::optional<double> value = number_in_cell(cell))
        return short_number(*value);
      std::string text = cell;
      std::replace(text.begin(), text.end(), ' ', '_');
      return text;
    }
  } // namespace



  StatisticsTable::StatisticsTable(const std::string &base_name,
                                   const MPI_Comm     communicator,
                                   const bool         write_text)
    : base_name(base_name)
    , communicator(communicator)
    , write_text(write_text)
    , is_writer(Utilities::MPI::this_mpi_process(communicator) == 0)
  {}



  void
  StatisticsTable::resume(const double time, const std::string &time_column)
  {
    std::string error;
    if (is_writer)
      {
        columns.clear();
        index_of_column.clear();
        rows.clear();
        must_rewrite = true;

        std::ifstream file(base_name + ".csv");
        std::string   line;
        if (std::getline(file, line) && !line.empty())
          for (const std::string &column : split_csv_line(line))
            {
              index_of_column[column] = columns.size();
              columns.push_back(column);
            }
        if (!columns.empty() && index_of_column.count(time_column) == 0)
          error = "Cannot continue '" + base_name +
                  ".csv': it has no column '" + time_column + "'.";
        else
          while (std::getline(file, line))
            {
              const Row  row      = split_csv_line(line);
              const auto column   = index_of_column.at(time_column);
              const auto row_time = column < row.size()
                                      ? number_in_cell(row[column])
                                      : std::optional<double>();
              // A row without a time was cut off by the end of the old run.
              if (row_time && row.size() <= columns.size() &&
                  *row_time <= time + 1e-12 * std::abs(time))
                rows.push_back(row);
            }
      }
    throw_collectively(error, communicator);
  }



  void
  StatisticsTable::add(const std::string &column, const double value)
  {
    add_text(column, exact_number(value));
  }



  void
  StatisticsTable::add(const std::string &column, const unsigned int value)
  {
    add_text(column, std::to_string(value));
  }



  void
  StatisticsTable::add(const std::string &column, const int value)
  {
    add_text(column, std::to_string(value));
  }



  void
  StatisticsTable::add(const std::string &column, const std::string &value)
  {
    add_text(column, value);
  }



  void
  StatisticsTable::add(const std::string &column, const char *value)
  {
    add_text(column, value);
  }



  void
  StatisticsTable::add_text(const std::string &column, const std::string &csv)
  {
    if (!is_writer)
      return;
    const auto [position, is_new] =
      index_of_column.try_emplace(column, columns.size());
    if (is_new)
      {
        columns.push_back(column);
        must_rewrite = true;
      }
    current_row.resize(columns.size());
    current_row[position->second] = csv;
  }



  void
  StatisticsTable::finish_row()
  {
    std::string error;
    if (is_writer)
      {
        rows.push_back(current_row);
        current_row.clear();
        error        = must_rewrite ? rewrite_files() : append_last_row();
        must_rewrite = false;
      }
    throw_collectively(error, communicator);
  }



  std::map<double, double>
  StatisticsTable::numbers(const std::string &column,
                           const std::string &key) const
  {
    std::map<double, double> result;
    const auto               value_column = index_of_column.find(column);
    const auto               key_column   = index_of_column.find(key);
    if (value_column == index_of_column.end() ||
        key_column == index_of_column.end())
      return result;
    for (const Row &row : rows)
      if (std::max(value_column->second, key_column->second) < row.size())
        {
          const auto value = number_in_cell(row[value_column->second]);
          const auto time  = number_in_cell(row[key_column->second]);
          if (value && time)
            result[*time] = *value;
        }
    return result;
  }



  std::string
  StatisticsTable::csv_line(const Row &row) const
  {
    std::string line;
    for (unsigned int c = 0; c < columns.size(); ++c)
      line += (c > 0 ? "," : "") +
              (c < row.size() ? quoted_for_csv(row[c]) : std::string());
    return line + "\n";
  }



  std::string
  StatisticsTable::text_line(const Row &row) const
  {
    std::ostringstream line;
    for (unsigned int c = 0; c < columns.size(); ++c)
      line << (c > 0 ? "  " : "")
           << std::setw(std::max<int>(columns[c].size(), 12))
           << readable_cell(c < row.size() ? row[c] : "");
    return line.str() + "\n";
  }



  std::string
  StatisticsTable::rewrite_files() const
  {
    std::string csv  = csv_line(columns);
    std::string text = text_line(columns);
    for (const Row &row : rows)
      {
        csv += csv_line(row);
        text += text_line(row);
      }
    const std::string error = write_file_atomically(base_name + ".csv", csv);
    return error.empty() && write_text
             ? write_file_atomically(base_name + ".txt", text)
             : error;
  }



  std::string
  StatisticsTable::append_last_row() const
  {
    const auto append = [](const std::string &name, const std::string &line) {
      std::ofstream file(name, std::ios::app);
      file << line << std::flush;
      return file ? std::string() : "Cannot write '" + name + "'.";
    };

    const std::string error = append(base_name + ".csv", csv_line(rows.back()));
    return error.empty() && write_text
             ? append(base_name + ".txt", text_line(rows.back()))
             : error;
  }
} // namespace stickslip
