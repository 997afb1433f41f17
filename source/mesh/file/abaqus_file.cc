#include <stickslip/mesh/file/abaqus_file.h>

#include <stickslip/mesh/file/abaqus_reader.h>
#include <stickslip/mesh/file/mesh_scanner.h>

#include <string>

namespace stickslip
{
  MeshFile
  read_abaqus(const std::string &contents)
  {
    const std::string text = plain_text(contents);
    return AbaqusReader(text).read();
  }
} // namespace stickslip
