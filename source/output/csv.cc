#include <stickslip/output/csv.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <fstream>
#include <limits>

namespace stickslip
{
  std::string
  exact_number(const double value)
  {
    std::array<char, 40> buffer;
    const auto           result =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    return std::string(buffer.data(), result.ptr);
  }



  std::optional<double>
  number_in_cell(const std::string &cell)
  {
    double     value = 0.;
    const auto result =
      std::from_chars(cell.data(), cell.data() + cell.size(), value);
    if (cell.empty() || result.ec != std::errc() ||
        result.ptr != cell.data() + cell.size())
      return {};
    return value;
  }



  std::string
  quoted_for_csv(const std::string &cell)
  {
    if (cell.find_first_of(",\"\n") == std::string::npos)
      return cell;
    std::string result = "\"";
    for (const char c : cell)
      result += (c == '"' ? "\"\"" : std::string(1, c));
    return result + "\"";
  }



  std::vector<std::string>
  split_csv_line(const std::string &line)
  {
    std::vector<std::string> cells(1);
    bool                     is_quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i)
      if (line[i] == '"')
        {
          if (is_quoted && i + 1 < line.size() && line[i + 1] == '"')
            cells.back() += line[i++];
          else
            is_quoted = !is_quoted;
        }
      else if (line[i] == ',' && !is_quoted)
        cells.emplace_back();
      else if (line[i] != '\r')
        cells.back() += line[i];
    return cells;
  }



  std::string
  CsvTable::read(const std::string &path)
  {
    columns.clear();
    rows.clear();
    std::ifstream file(path);
    std::string   line;
    if (!std::getline(file, line) || line.empty())
      return "There is no table '" + path + "'.";
    columns = split_csv_line(line);
    while (std::getline(file, line))
      rows.push_back(split_csv_line(line));
    return "";
  }



  bool
  CsvTable::has(const std::string &column) const
  {
    return std::find(columns.begin(), columns.end(), column) != columns.end();
  }



  std::string
  CsvTable::text(const unsigned int row, const std::string &column) const
  {
    const std::size_t i =
      std::find(columns.begin(), columns.end(), column) - columns.begin();
    return i < rows[row].size() ? rows[row][i] : "";
  }



  double
  CsvTable::number(const unsigned int row, const std::string &column) const
  {
    return number_in_cell(text(row, column))
      .value_or(std::numeric_limits<double>::quiet_NaN());
  }
} // namespace stickslip
