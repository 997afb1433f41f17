#include <stickslip/mesh/file/vtk_numbers.h>

#include <stickslip/mesh/file/mesh_file.h>
#include <stickslip/mesh/file/mesh_scanner.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>

namespace stickslip
{
  VtkNumber
  vtk_number(const std::string &name)
  {
    static const std::map<std::string, VtkNumber> types = {
      {"char", VtkNumber::int8},
      {"signed_char", VtkNumber::int8},
      {"unsigned_char", VtkNumber::uint8},
      {"short", VtkNumber::int16},
      {"unsigned_short", VtkNumber::uint16},
      {"int", VtkNumber::int32},
      {"unsigned_int", VtkNumber::uint32},
      {"vtkIdType", VtkNumber::int32},
      {"long", VtkNumber::int64},
      {"unsigned_long", VtkNumber::uint64},
      {"vtktypeint8", VtkNumber::int8},
      {"vtktypeuint8", VtkNumber::uint8},
      {"vtktypeint16", VtkNumber::int16},
      {"vtktypeuint16", VtkNumber::uint16},
      {"vtktypeint32", VtkNumber::int32},
      {"vtktypeuint32", VtkNumber::uint32},
      {"vtktypeint64", VtkNumber::int64},
      {"vtktypeuint64", VtkNumber::uint64},
      {"float", VtkNumber::float32},
      {"double", VtkNumber::float64},
      {"Int8", VtkNumber::int8},
      {"UInt8", VtkNumber::uint8},
      {"Int16", VtkNumber::int16},
      {"UInt16", VtkNumber::uint16},
      {"Int32", VtkNumber::int32},
      {"UInt32", VtkNumber::uint32},
      {"Int64", VtkNumber::int64},
      {"UInt64", VtkNumber::uint64},
      {"Float32", VtkNumber::float32},
      {"Float64", VtkNumber::float64}};
    const auto found = types.find(name);
    if (found == types.end())
      throw MeshFileError("numbers of the type " + quoted_word(name) +
                          " are not known");
    return found->second;
  }



  unsigned int
  size_of(const VtkNumber type)
  {
    constexpr std::array<unsigned int, 10> sizes = {
      {1, 1, 2, 2, 4, 4, 8, 8, 4, 8}};
    return sizes[static_cast<unsigned int>(type)];
  }



  namespace
  {
    template <typename T>
    double
    number_in_bytes(const char *bytes, const bool is_reversed)
    {
      std::array<char, sizeof(T)> copy;
      std::copy(bytes, bytes + sizeof(T), copy.begin());
      if (is_reversed)
        std::reverse(copy.begin(), copy.end());
      T value;
      std::memcpy(&value, copy.data(), sizeof(T));
      return value;
    }



    double
    number_in_bytes(const char     *bytes,
                    const VtkNumber type,
                    const bool      is_reversed)
    {
      switch (type)
        {
          case VtkNumber::int8:
            return number_in_bytes<std::int8_t>(bytes, is_reversed);
          case VtkNumber::uint8:
            return number_in_bytes<std::uint8_t>(bytes, is_reversed);
          case VtkNumber::int16:
            return number_in_bytes<std::int16_t>(bytes, is_reversed);
          case VtkNumber::uint16:
            return number_in_bytes<std::uint16_t>(bytes, is_reversed);
          case VtkNumber::int32:
            return number_in_bytes<std::int32_t>(bytes, is_reversed);
          case VtkNumber::uint32:
            return number_in_bytes<std::uint32_t>(bytes, is_reversed);
          case VtkNumber::int64:
            return number_in_bytes<std::int64_t>(bytes, is_reversed);
          case VtkNumber::uint64:
            return number_in_bytes<std::uint64_t>(bytes, is_reversed);
          case VtkNumber::float32:
            return number_in_bytes<float>(bytes, is_reversed);
          case VtkNumber::float64:
            return number_in_bytes<double>(bytes, is_reversed);
        }
      return 0.;
    }
  } // namespace



  std::vector<double>
  vtk_numbers(const std::string_view bytes,
              const VtkNumber        type,
              const bool             is_big_endian)
  {
    const std::uint16_t one = 1;
    char                first_byte;
    std::memcpy(&first_byte, &one, 1);
    const bool          is_reversed = is_big_endian == (first_byte == 1);
    const unsigned int  size        = size_of(type);
    std::vector<double> numbers(bytes.size() / size);
    for (std::size_t i = 0; i < numbers.size(); ++i)
      {
        numbers[i] =
          number_in_bytes(bytes.data() + i * size, type, is_reversed);
        if (!std::isfinite(numbers[i]))
          throw MeshFileError("a binary number is not finite");
      }
    return numbers;
  }



  std::string
  decoded_base64(const std::string_view text)
  {
    const auto value_of = [](const char letter) {
      return letter >= 'A' && letter <= 'Z'   ? letter - 'A'
             : letter >= 'a' && letter <= 'z' ? letter - 'a' + 26
             : letter >= '0' && letter <= '9' ? letter - '0' + 52
             : letter == '+'                  ? 62
             : letter == '/'                  ? 63
                                              : -1;
    };
    std::string  result;
    unsigned int bits = 0, n_letters = 0, n_padding = 0;
    for (const char letter : text)
      {
        if (letter == ' ' || letter == '\n' || letter == '\t' || letter == '\r')
          continue;
        const int value = value_of(letter);
        if (value < 0 && letter != '=')
          throw MeshFileError("found " + quoted_word({&letter, 1}) +
                              " in base64 data");
        n_padding += letter == '=';
        bits = (bits << 6) | (value < 0 ? 0 : value);
        if (++n_letters < 4)
          continue;
        for (unsigned int b = 0; b + n_padding < 3; ++b)
          result += static_cast<char>((bits >> (16 - 8 * b)) & 0xFF);
        bits = n_letters = n_padding = 0;
      }
    if (n_letters != 0)
      throw MeshFileError("base64 data are incomplete");
    return result;
  }
} // namespace stickslip
