#ifndef stickslip_output_csv_h
#define stickslip_output_csv_h

#include <optional>
#include <string>
#include <vector>

namespace stickslip
{
  // Tables of comma-separated values (RFC 4180, without line breaks in a cell).

  /// The shortest text that reads back as the same number.
  std::string
  exact_number(const double value);

  /// Nothing if @p cell is not a number.
  std::optional<double>
  number_in_cell(const std::string &cell);

  std::string
  quoted_for_csv(const std::string &cell);

  std::vector<std::string>
  split_csv_line(const std::string &line);



  /// A table as it was read from a file. Not collective.
  struct CsvTable
  {
    std::vector<std::string>              columns;
    std::vector<std::vector<std::string>> rows; ///< may be shorter

    /// Returns an empty string, or what went wrong.
    std::string
    read(const std::string &path);

    bool
    has(const std::string &column) const;

    /// Empty if there is no such cell.
    std::string
    text(const unsigned int row, const std::string &column) const;

    /// NaN if there is no number.
    double
    number(const unsigned int row, const std::string &column) const;
  };
} // namespace stickslip

#endif
