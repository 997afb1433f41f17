#ifndef stickslip_simulation_cell_records_h
#define stickslip_simulation_cell_records_h

#include <array>
#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

namespace stickslip
{
  /// Names a cell whatever the partition; see PartitionFreeNames.
  using CellKey = std::array<unsigned int, 4>;

  /// A hash for checksums and fingerprints, the same on all machines.
  std::uint64_t
  hash_of_bytes(const void *data, const std::size_t size);

  /**
   * Writes a file of records (numbers that belong to a cell). Records are
   * streamed; an index of all cells, 32 bytes each, follows them and an end
   * mark closes the file, so that a file that was not finished is known as
   * such. Numbers are in the machine's byte order. Not collective.
   */
  class CellRecordWriter
  {
  public:
    /// All files of one checkpoint have the same @p identity.
    CellRecordWriter(const std::string &name, const std::uint64_t identity);

    void
    add(const CellKey &cell, const std::vector<double> &record);

    /// Completes the file. Returns an empty string, or what went wrong.
    std::string
    finish();

  private:
    const std::string   name;
    const std::uint64_t identity;
    std::ofstream       file;
    int                 error_number = 0;

    std::vector<std::uint64_t> index;
    std::uint64_t              position = 0;
  };



  /// Reads a file of CellRecordWriter. Not collective.
  class CellRecordReader
  {
  public:
    /// Opens @p name and reads its index; see error().
    CellRecordReader(const std::string &name, const std::uint64_t identity);

    /// Empty, or why the file cannot be used: not there, of another
    /// checkpoint, not complete, damaged.
    const std::string &
    error() const
    {
      return error_text;
    }

    unsigned int
    n_cells() const
    {
      return cells.size();
    }

    const CellKey &
    cell(const unsigned int i) const
    {
      return cells[i].key;
    }

    /// The record of the i-th cell; false if it is damaged. Reading in
    /// increasing order is fast.
    bool
    read(const unsigned int i, std::vector<double> &record);

  private:
    struct Entry
    {
      CellKey       key;
      std::uint64_t end; ///< of the record, in numbers from the first one
      std::uint64_t checksum;
    };

    std::ifstream      file;
    std::string        error_text;
    std::vector<Entry> cells;
    std::uint64_t      position = 0; ///< after the last read(); 0: unknown

    /// Returns what is wrong.
    std::string
    read_index(const std::uint64_t identity);
  };
} // namespace stickslip

#endif
