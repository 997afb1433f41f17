#ifndef stickslip_mesh_mesh_reader_h
#define stickslip_mesh_mesh_reader_h

#include <stickslip/mesh/file/mesh_file.h>
#include <stickslip/mesh/mesh_format.h>

#include <deal.II/base/mpi.h>

#include <map>
#include <memory>
#include <string>
#include <utility>

namespace stickslip
{
  /// The format by the extension of the name, .inp by the contents; automatic
  /// if the extension is not known.
  MeshFormat
  format_of_mesh_file(const std::string &file_name,
                      const std::string &contents);

  /// Throws MeshFileError. @p format is not automatic.
  MeshFile
  parse_mesh_file(const std::string &contents, const MeshFormat format);

  /// "'part.msh', line 12, found ..." of an error.
  std::string
  in_words(const std::string &file_name, const MeshFileError &error);

  /**
   * The mesh files of a case, each read once. A relative name is looked for in
   * the directory, then in the working directory.
   */
  class MeshFiles
  {
  public:
    MeshFiles(const std::string &directory, const MPI_Comm communicator)
      : directory(directory)
      , communicator(communicator)
    {}

    /**
     * Rank 0 reads the file, every rank gets its contents. Collective. Throws
     * UserError, on all ranks, blaming parameters below @p path, for a file
     * that cannot be read or has other contents than its format says.
     */
    const MeshFile &
    read(const std::string &file_name,
         const MeshFormat   format,
         const std::string &path);

  private:
    const std::string directory;
    const MPI_Comm    communicator;

    std::map<std::pair<std::string, MeshFormat>, std::unique_ptr<MeshFile>>
      files;
  };
} // namespace stickslip

#endif
