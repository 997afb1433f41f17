#ifndef stickslip_output_statistics_table_h
#define stickslip_output_statistics_table_h

#include <deal.II/base/mpi.h>

#include <map>
#include <string>
#include <vector>

namespace stickslip
{
  /**
   * A table with one row per accepted step, written by rank 0 as NAME.csv
   * (every digit) and NAME.txt (aligned, six digits). A row is on the disk when
   * finish_row() returns. Columns stand in the order of their first add(); one
   * that appears later is empty in the rows before.
   *
   * All ranks may call every function with the same arguments; only rank 0
   * does something, and only it keeps the rows.
   */
  class StatisticsTable
  {
  public:
    /**
     * @p base_name is the path without extension. Existing files are replaced
     * at the first row. @p write_text = false leaves the .txt away.
     */
    StatisticsTable(const std::string &base_name,
                    const MPI_Comm     communicator,
                    const bool         write_text = true);

    /**
     * Continues after a restart: reads the rows of an existing NAME.csv whose
     * column @p time_column is not later than @p time. Collective; throws
     * UserError on all ranks if the file cannot be understood.
     */
    void
    resume(const double time, const std::string &time_column = "time");

    void
    add(const std::string &column, const double value);

    void
    add(const std::string &column, const unsigned int value);

    void
    add(const std::string &column, const int value);

    void
    add(const std::string &column, const std::string &value);

    void
    add(const std::string &column, const char *value);

    /**
     * Writes the row. Collective; throws UserError on all ranks if the files
     * cannot be written.
     */
    void
    finish_row();

    /// The numbers of the column @p column by those of the column @p key, as
    /// {time: value}. Rank 0 only; empty if there is no such column.
    std::map<double, double>
    numbers(const std::string &column, const std::string &key = "time") const;

    /// Names of all columns. Rank 0 only.
    const std::vector<std::string> &
    column_names() const
    {
      return columns;
    }

  private:
    using Row = std::vector<std::string>; ///< may be shorter than `columns`

    void
    add_text(const std::string &column, const std::string &csv);

    std::string
    csv_line(const Row &row) const;

    std::string
    text_line(const Row &row) const;

    std::string
    rewrite_files() const;

    std::string
    append_last_row() const;

    const std::string base_name;
    const MPI_Comm    communicator;
    const bool        write_text;
    const bool        is_writer;

    std::vector<std::string>            columns;
    std::map<std::string, unsigned int> index_of_column;
    std::vector<Row>                    rows;
    Row                                 current_row;

    /// The columns changed or the files are of another run: write all anew.
    bool must_rewrite = true;
  };
} // namespace stickslip

#endif
