#ifndef stickslip_mesh_file_vtk_numbers_h
#define stickslip_mesh_file_vtk_numbers_h

#include <string>
#include <string_view>
#include <vector>

namespace stickslip
{
  /// The types of numbers in VTK's binary data.
  enum class VtkNumber
  {
    int8,
    uint8,
    int16,
    uint16,
    int32,
    uint32,
    int64,
    uint64,
    float32,
    float64
  };

  /// Of the names in legacy files ("unsigned_char", "vtktypeint64") and in XML
  /// ("UInt8", "Int64"). Throws MeshFileError for others.
  VtkNumber
  vtk_number(const std::string &name);

  unsigned int
  size_of(const VtkNumber type);

  /// Binary data as numbers; a rest that is no whole number is left out.
  /// Throws MeshFileError for numbers that are not finite.
  std::vector<double>
  vtk_numbers(const std::string_view bytes,
              const VtkNumber        type,
              const bool             is_big_endian);

  /// Decodes base64, which may consist of several padded parts. Throws
  /// MeshFileError.
  std::string
  decoded_base64(const std::string_view text);
} // namespace stickslip

#endif
