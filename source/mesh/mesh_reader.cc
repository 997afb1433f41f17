#include <stickslip/mesh/mesh_reader.h>

#include <stickslip/base/short_message.h>
#include <stickslip/base/user_error.h>
#include <stickslip/mesh/mesh_checks.h>
#include <stickslip/mesh/mesh_file_checks.h>

#include <deal.II/grid/grid_in.h>

#include <boost/serialization/utility.hpp>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>
#include <string>
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
            std::ifstream   file(candidate);
            std::error_code error; // a directory opens, but cannot be read
            if (file && !std::filesystem::is_directory(candidate, error))
              {
                result.first = true;
                result.second.assign(std::istreambuf_iterator<char>(file), {});
                break;
              }
          }
      result   = Utilities::MPI::broadcast(communicator, result, 0);
      contents = result.second;
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



    /// Abaqus and UCD share the extension inp; Abaqus keywords start with '*'.
    MeshFormat
    detect_format(const std::string &file_name,
                  const std::string &contents,
                  const std::string &path)
    {
      const std::string extension = extension_of(file_name);
      if (extension == "msh")
        return MeshFormat::gmsh;
      if (extension == "vtk")
        return MeshFormat::vtk;
      if (extension == "ucd")
        return MeshFormat::ucd;
      if (extension == "inp")
        return (contents.compare(0, 1, "*") == 0 ||
                contents.find("\n*") != std::string::npos)
                 ? MeshFormat::abaqus
                 : MeshFormat::ucd;
      throw UserError(path + "/Mesh format: cannot tell the format of '" +
                      file_name +
                      "' from its extension (known: msh, inp, vtk, ucd). Give "
                      "'Mesh format' as gmsh, abaqus, vtk or ucd.");
    }



    /// The number in the name of an Abaqus surface; -1 if there is none.
    int
    number_in(const std::string &name)
    {
      const auto first = name.find_first_of("0123456789");
      return first == std::string::npos ? -1 : std::atoi(&name[first]);
    }



    /// Gives the *SURFACEs without a number in their names, which deal.II
    /// would not read, the next free numbers from 1, in the order of the file.
    std::string
    with_numbered_surfaces(const std::string &contents)
    {
      const std::regex surface(
        R"((\s*\*\s*surface\s*,.*\bname\s*=\s*"?)([^,"]*)(.*))",
        std::regex::icase);
      std::vector<std::string> lines;
      std::istringstream       stream(contents);
      for (std::string line; std::getline(stream, line);)
        lines.push_back(line);

      std::set<int>             used;
      std::vector<unsigned int> without_number;
      std::smatch               parts;
      for (unsigned int i = 0; i < lines.size(); ++i)
        if (lines[i].find('*') != std::string::npos &&
            std::regex_match(lines[i], parts, surface))
          {
            const int number = number_in(parts[2]);
            used.insert(number);
            if (number < 0)
              without_number.push_back(i);
          }
      int next = 1;
      for (const unsigned int i : without_number)
        {
          while (used.count(next) > 0)
            ++next;
          used.insert(next);
          lines[i] = std::regex_replace(lines[i],
                                        surface,
                                        "$1SS" + std::to_string(next) + "$3");
        }
      std::string result;
      for (const std::string &line : lines)
        result += line + '\n';
      return result;
    }



    template <int dim>
    void
    parse_mesh(const std::string  &contents,
               const MeshFormat    format,
               Triangulation<dim> &triangulation)
    {
      // Without an end, deal.II's Abaqus reader waits for it indefinitely.
      std::istringstream stream(format == MeshFormat::abaqus
                                  ? with_numbered_surfaces(contents) +
                                      "\n*END STEP\n"
                                  : contents + "\n");
      GridIn<dim>        grid_in(triangulation);
      if (format == MeshFormat::gmsh)
        grid_in.read_msh(stream);
      else if (format == MeshFormat::abaqus)
        grid_in.read_abaqus(stream);
      else if (format == MeshFormat::vtk)
        grid_in.read_vtk(stream);
      else
        grid_in.read_ucd(stream);
    }
  } // namespace



  template <int dim>
  void
  read_mesh(const std::string  &file_name,
            const MeshFormat    format,
            const std::string  &directory,
            const std::string  &path,
            const MPI_Comm      communicator,
            Triangulation<dim> &triangulation)
  {
    std::vector<std::string> candidates;
    if (file_name[0] != '/' && !directory.empty())
      candidates.push_back(directory + "/" + file_name);
    candidates.push_back(file_name);

    const std::string where = path + "/Mesh file: '" + file_name + "' ";
    std::string       contents;
    if (!read_on_root(candidates, communicator, contents))
      {
        std::string places;
        for (const std::string &candidate : candidates)
          places += (places.empty() ? "" : " and ") + candidate;
        throw UserError(where + "cannot be read (tried " + places + ").");
      }
    if (contents.find_first_not_of(" \t\r\n") == std::string::npos)
      throw UserError(where + "is empty.");

    const MeshFormat  used_format = (format == MeshFormat::automatic
                                       ? detect_format(file_name, contents, path)
                                       : format);
    const std::string kind =
      "is no usable " + std::to_string(dim) + "D mesh of " +
      (dim == 2 ? "quadrilaterals" : "hexahedra") + " in the format " +
      name_of(used_format, all_mesh_formats());
    const std::string complaint =
      complaint_about_mesh_file(contents, used_format, dim);
    if (!complaint.empty())
      throw UserError(where + kind + ": " + complaint);

    try
      {
        parse_mesh(contents, used_format, triangulation);
      }
    catch (const std::exception &exception)
      {
        throw UserError(where + kind +
                        ". The reader says: " + short_message(exception));
      }
  }



  template void
  read_mesh(const std::string &,
            const MeshFormat,
            const std::string &,
            const std::string &,
            const MPI_Comm,
            Triangulation<2> &);
  template void
  read_mesh(const std::string &,
            const MeshFormat,
            const std::string &,
            const std::string &,
            const MPI_Comm,
            Triangulation<3> &);
} // namespace stickslip
