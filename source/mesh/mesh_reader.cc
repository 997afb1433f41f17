#include <stickslip/mesh/mesh_reader.h>

#include <stickslip/base/user_error.h>
#include <stickslip/mesh/file/abaqus_file.h>
#include <stickslip/mesh/file/gmsh_file.h>
#include <stickslip/mesh/file/ucd_file.h>
#include <stickslip/mesh/file/vtk_file.h>
#include <stickslip/mesh/file/vtu_file.h>

#include <boost/serialization/utility.hpp>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <utility>
#include <vector>

namespace stickslip
{
  namespace
  {
    /// Reads the first file that exists, on rank 0. Returns whether there was
    /// one, on all ranks.
    bool
    read_on_root(const std::vector<std::string> &candidates,
                 const MPI_Comm                  communicator,
                 std::string                    &contents)
    {
      std::pair<bool, std::string> result(false, "");
      if (Utilities::MPI::this_mpi_process(communicator) == 0)
        for (const std::string &candidate : candidates)
          {
            std::ifstream   file(candidate, std::ios::binary);
            std::error_code error; // a directory opens, but cannot be read
            if (file && !std::filesystem::is_directory(candidate, error))
              {
                result.first = true;
                result.second.assign(std::istreambuf_iterator<char>(file), {});
                break;
              }
          }
      result   = Utilities::MPI::broadcast(communicator, result, 0);
      contents = std::move(result.second);
      return result.first;
    }



    std::string
    extension_of(const std::string &file_name)
    {
      const auto  dot = file_name.rfind('.');
      std::string extension =
        (dot == std::string::npos ? "" : file_name.substr(dot + 1));
      std::transform(extension.begin(),
                     extension.end(),
                     extension.begin(),
                     [](const unsigned char c) { return std::tolower(c); });
      return extension;
    }
  } // namespace



  MeshFormat
  format_of_mesh_file(const std::string &file_name, const std::string &contents)
  {
    const std::string extension = extension_of(file_name);
    if (extension == "msh")
      return MeshFormat::gmsh;
    if (extension == "vtk")
      return MeshFormat::vtk;
    if (extension == "vtu")
      return MeshFormat::vtu;
    if (extension == "ucd")
      return MeshFormat::ucd;
    // Abaqus and UCD share the extension inp; Abaqus keywords start with '*'.
    if (extension == "inp")
      return contents.find('*') != std::string::npos ? MeshFormat::abaqus
                                                     : MeshFormat::ucd;
    return MeshFormat::automatic;
  }



  MeshFile
  parse_mesh_file(const std::string &contents, const MeshFormat format)
  {
    switch (format)
      {
        case MeshFormat::gmsh:
          return read_gmsh(contents);
        case MeshFormat::abaqus:
          return read_abaqus(contents);
        case MeshFormat::vtk:
          return read_vtk(contents);
        case MeshFormat::vtu:
          return read_vtu(contents);
        case MeshFormat::ucd:
          return read_ucd(contents);
        case MeshFormat::automatic:
          break;
      }
    throw dealii::ExcInternalError();
  }



  std::string
  in_words(const std::string &file_name, const MeshFileError &error)
  {
    return "'" + file_name + "'" +
           (error.line > 0 ? ", line " + std::to_string(error.line) : "") +
           ": " + error.what() + ".";
  }



  const MeshFile &
  MeshFiles::read(const std::string &file_name,
                  const MeshFormat   format,
                  const std::string &path)
  {
    std::unique_ptr<MeshFile> &file = files[{file_name, format}];
    if (file)
      return *file;

    std::vector<std::string> candidates;
    if (file_name[0] != '/' && !directory.empty() && directory != ".")
      candidates.push_back(directory + "/" + file_name);
    candidates.push_back(file_name);

    const std::string where = path + "/Mesh file: ";
    std::string       contents;
    if (!read_on_root(candidates, communicator, contents))
      {
        std::string places;
        for (const std::string &candidate : candidates)
          places += (places.empty() ? "" : " and ") + candidate;
        throw UserError(where + "'" + file_name + "' cannot be read (tried " +
                        places + ").");
      }
    if (contents.find_first_not_of(" \t\r\n") == std::string::npos)
      throw UserError(where + "'" + file_name + "' is empty.");

    const MeshFormat used_format = (format == MeshFormat::automatic
                                      ? format_of_mesh_file(file_name, contents)
                                      : format);
    if (used_format == MeshFormat::automatic)
      throw UserError(path + "/Mesh format: cannot tell the format of '" +
                      file_name +
                      "' from its extension (known: msh, inp, vtk, vtu, ucd). "
                      "Give 'Mesh format' as gmsh, abaqus, vtk, vtu or ucd, or "
                      "convert the file: meshio convert " +
                      file_name + " mesh.vtu");
    try
      {
        file =
          std::make_unique<MeshFile>(parse_mesh_file(contents, used_format));
      }
    catch (const MeshFileError &error)
      {
        throw UserError(where + in_words(file_name, error) +
                        " It is no complete mesh in the format " +
                        name_of(used_format, all_mesh_formats()) + ".");
      }
    return *file;
  }
} // namespace stickslip
