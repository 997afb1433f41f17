#include <stickslip/simulation/cell_records.h>

#include <stickslip/base/mixed_bits.h>

#include <cerrno>
#include <cstring>

namespace stickslip
{
  namespace
  {
    /// "sslipchk" as a number: a file of another byte order does not have it.
    constexpr std::uint64_t cell_record_magic  = 0x7373'6c69'7063'686bull;
    constexpr std::uint64_t cell_record_format = 3;

    /// magic, format, identity
    constexpr unsigned int n_head_words = 3;
    /// identity, number of cells, checksum of the index, magic
    constexpr unsigned int n_tail_words = 4;
    /// of an index entry: cell (2), end of its record, checksum
    constexpr unsigned int n_entry_words = 4;



    template <typename T>
    void
    write_numbers(std::ofstream &file, const T *numbers, const std::size_t n)
    {
      file.write(reinterpret_cast<const char *>(numbers), n * sizeof(T));
    }



    template <typename T>
    bool
    read_numbers(std::ifstream &file, T *numbers, const std::size_t n)
    {
      return static_cast<bool>(
        file.read(reinterpret_cast<char *>(numbers), n * sizeof(T)));
    }
  } // namespace



  std::uint64_t
  hash_of_bytes(const void *data, const std::size_t size)
  {
    // FNV-1a, with the bits mixed at the end (its low bits are poor)
    const auto   *bytes = static_cast<const unsigned char *>(data);
    std::uint64_t hash  = 0xcbf29ce484222325ull;
    for (std::size_t i = 0; i < size; ++i)
      hash = (hash ^ bytes[i]) * 0x100000001b3ull;
    return mixed_bits(hash);
  }



  CellRecordWriter::CellRecordWriter(const std::string  &name,
                                     const std::uint64_t identity)
    : name(name)
    , identity(identity)
  {
    errno = 0;
    file.open(name, std::ios::binary | std::ios::trunc);
    const std::uint64_t head[n_head_words] = {cell_record_magic,
                                              cell_record_format,
                                              identity};
    write_numbers(file, head, n_head_words);
    if (!file)
      error_number = errno;
  }



  void
  CellRecordWriter::add(const CellKey &cell, const std::vector<double> &record)
  {
    if (!file)
      return;
    errno = 0;
    write_numbers(file, record.data(), record.size());
    if (!file)
      error_number = errno;
    position += record.size();
    std::uint64_t key[2];
    std::memcpy(key, cell.data(), sizeof(key));
    index.insert(index.end(),
                 {key[0],
                  key[1],
                  position,
                  hash_of_bytes(record.data(),
                                record.size() * sizeof(double))});
  }



  std::string
  CellRecordWriter::finish()
  {
    const std::uint64_t tail[n_tail_words] = {
      identity,
      index.size() / n_entry_words,
      hash_of_bytes(index.data(), index.size() * sizeof(std::uint64_t)),
      cell_record_magic};
    if (file)
      {
        errno = 0;
        write_numbers(file, index.data(), index.size());
        write_numbers(file, tail, n_tail_words);
        file.close();
        if (!file)
          error_number = errno;
      }
    return file ? ""
                : "Cannot write '" + name +
                    "': " + std::strerror(error_number) + ".";
  }



  CellRecordReader::CellRecordReader(const std::string  &name,
                                     const std::uint64_t identity)
  {
    errno = 0;
    file.open(name, std::ios::binary);
    error_text = file ? read_index(identity) : std::strerror(errno);
    if (!error_text.empty())
      error_text = "'" + name + "': " + error_text;
  }



  std::string
  CellRecordReader::read_index(const std::uint64_t identity)
  {
    std::uint64_t head[n_head_words], tail[n_tail_words];
    if (!read_numbers(file, head, n_head_words) || head[0] != cell_record_magic)
      return "it is no checkpoint file of this kind of machine";
    if (head[1] != cell_record_format)
      return "it was written in format " + std::to_string(head[1]) +
             "; this version reads format " +
             std::to_string(cell_record_format);
    if (head[2] != identity)
      return "it belongs to another checkpoint";

    file.seekg(0, std::ios::end);
    const std::uint64_t n_words = file.tellg() / sizeof(std::uint64_t);
    const bool          is_whole =
      file.tellg() % sizeof(std::uint64_t) == 0 &&
      n_words >= n_head_words + n_tail_words &&
      file.seekg((n_words - n_tail_words) * sizeof(std::uint64_t)) &&
      read_numbers(file, tail, n_tail_words) && tail[0] == identity &&
      tail[3] == cell_record_magic &&
      tail[1] <= (n_words - n_head_words - n_tail_words) / n_entry_words;
    if (!is_whole)
      return "it is not complete";

    const std::uint64_t        n_index_words = tail[1] * n_entry_words;
    std::vector<std::uint64_t> index(n_index_words);
    file.seekg((n_words - n_tail_words - n_index_words) *
               sizeof(std::uint64_t));
    if (!read_numbers(file, index.data(), index.size()) ||
        hash_of_bytes(index.data(), index.size() * sizeof(std::uint64_t)) !=
          tail[2])
      return "its index is damaged";

    cells.resize(tail[1]);
    for (std::size_t i = 0; i < cells.size(); ++i)
      {
        const std::uint64_t *entry = &index[i * n_entry_words];
        std::memcpy(cells[i].key.data(), entry, sizeof(CellKey));
        cells[i].end      = entry[2];
        cells[i].checksum = entry[3];
      }
    return "";
  }



  bool
  CellRecordReader::read(const unsigned int i, std::vector<double> &record)
  {
    const std::uint64_t begin = i > 0 ? cells[i - 1].end : 0;
    record.resize(cells[i].end - begin);
    // seeking would empty the stream's buffer
    if (position == 0 || position != begin)
      file.seekg(n_head_words * sizeof(std::uint64_t) + begin * sizeof(double));
    position = cells[i].end;
    return read_numbers(file, record.data(), record.size()) &&
           hash_of_bytes(record.data(), record.size() * sizeof(double)) ==
             cells[i].checksum;
  }
} // namespace stickslip
