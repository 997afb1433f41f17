#include <stickslip/mesh/mesh_file_checks.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <set>
#include <sstream>
#include <vector>

namespace stickslip
{
  using namespace dealii;

  namespace
  {
    /// Elements of a version 2 file refer to nodes that must be there.
    std::string
    complaint_about_gmsh_nodes(const std::string &contents)
    {
      const auto nodes    = contents.find("$Nodes");
      const auto elements = contents.find("$Elements");
      if (nodes == std::string::npos || elements == std::string::npos)
        return "it has no $Nodes or no $Elements.";

      std::istringstream node_stream(contents.substr(nodes + 6));
      unsigned int       n_nodes = 0, n_elements = 0;
      std::string        line;
      std::set<long>     known_nodes;
      node_stream >> n_nodes;
      std::getline(node_stream, line);
      for (unsigned int i = 0; i < n_nodes && std::getline(node_stream, line);
           ++i)
        known_nodes.insert(std::atol(line.c_str()));

      std::istringstream element_stream(contents.substr(elements + 9));
      element_stream >> n_elements;
      std::getline(element_stream, line);
      for (unsigned int i = 0;
           i < n_elements && std::getline(element_stream, line);
           ++i)
        {
          std::istringstream entries(line);
          long               id, type, n_tags = 0, entry;
          entries >> id >> type >> n_tags;
          for (long t = 0; t < n_tags && (entries >> entry); ++t)
            ;
          while (entries >> entry)
            if (known_nodes.count(entry) == 0)
              return "element " + std::to_string(id) + " refers to node " +
                     std::to_string(entry) + ", which is not there.";
        }
      return "";
    }



    std::string
    complaint_about_gmsh_header(const std::string &contents)
    {
      std::istringstream stream(contents);
      std::string        word, version;
      int                file_type = -1;
      stream >> word;
      if (word == "$NOD") // version 1
        return "";
      if (word != "$MeshFormat" || !(stream >> version >> file_type))
        return "it does not start with $MeshFormat, version and type.";
      if (file_type != 0)
        return "it is binary. Save it as ASCII (in Gmsh: Mesh.Binary = 0).";
      const std::set<std::string> versions = {
        "2", "2.0", "2.1", "2.2", "4", "4.0", "4.1"};
      if (versions.count(version) == 0)
        return "its version " + version + " is unknown. Known: 2.0 to 4.1.";
      return version[0] == '2' ? complaint_about_gmsh_nodes(contents) : "";
    }



    /// Keyword lines of an Abaqus file in upper case without blanks.
    std::vector<std::vector<std::string>>
    abaqus_keyword_lines(const std::string &contents)
    {
      std::vector<std::vector<std::string>> lines;
      std::istringstream                    stream(contents);
      std::string                           line;
      while (std::getline(stream, line))
        {
          line.erase(std::remove_if(line.begin(),
                                    line.end(),
                                    [](const unsigned char c) {
                                      return std::isspace(c);
                                    }),
                     line.end());
          std::transform(line.begin(),
                         line.end(),
                         line.begin(),
                         [](const unsigned char c) { return std::toupper(c); });
          lines.push_back(Utilities::split_string_list(line, ','));
        }
      return lines;
    }



    /// The value of "NAME=value" in a keyword line, or "".
    std::string
    abaqus_option(const std::vector<std::string> &line, const std::string &name)
    {
      for (const std::string &entry : line)
        if (entry.compare(0, name.size() + 1, name + "=") == 0)
          return entry.substr(name.size() + 1);
      return "";
    }



    /// The lines of a *SURFACE are element sets, which must be there, and
    /// sides.
    std::string
    complaint_about_abaqus_surfaces(const std::string &contents,
                                    const unsigned int dim)
    {
      const auto            lines = abaqus_keyword_lines(contents);
      std::set<std::string> sets;
      for (const auto &line : lines)
        if (!line.empty() && (line[0] == "*ELSET" || line[0] == "*ELEMENT"))
          sets.insert(abaqus_option(line, "ELSET"));

      bool in_surface = false;
      for (const auto &line : lines)
        if (!line.empty() && !line[0].empty())
          {
            if (line[0][0] == '*')
              in_surface = line[0] == "*SURFACE";
            else if (!in_surface)
              continue;
            else if (sets.count(line[0]) == 0 &&
                     line[0].find_first_not_of("0123456789") !=
                       std::string::npos)
              return "a *SURFACE names the element set " + line[0] +
                     ", which is not there.";
            else if (line.size() < 2 || line[1].size() != 2 ||
                     line[1][0] != 'S' || line[1][1] < '1' ||
                     line[1][1] > static_cast<char>('0' + 2 * dim))
              return "a *SURFACE has the side '" +
                     (line.size() < 2 ? "" : line[1]) + "', expected S1 to S" +
                     std::to_string(2 * dim) + ".";
          }
      return "";
    }



    /// The upper-case values of TYPE= in the *ELEMENT lines.
    std::set<std::string>
    abaqus_element_types(const std::string &contents)
    {
      std::set<std::string> types;
      for (const auto &line : abaqus_keyword_lines(contents))
        if (!line.empty() && line[0] == "*ELEMENT")
          types.insert(abaqus_option(line, "TYPE"));
      types.erase("");
      return types;
    }



    std::string
    complaint_about_abaqus_elements(const std::string &contents,
                                    const unsigned int dim)
    {
      const std::set<std::string> types = abaqus_element_types(contents);
      if (types.empty())
        return "it has no *ELEMENT line with a TYPE.";

      const std::string wanted =
        (dim == 2 ? "4-node quadrilaterals (CPE4, CPS4, CAX4, S4, ...)"
                  : "8-node hexahedra (C3D8...)");
      for (const std::string &type : types)
        {
          const bool        is_solid = type.compare(0, 3, "C3D") == 0;
          const std::string nodes    = type.substr(is_solid ? 3 : 0);
          const auto        digit    = nodes.find_first_of("123456789");
          const auto        end = nodes.find_first_not_of("0123456789", digit);
          const std::string number =
            digit == std::string::npos ? "" : nodes.substr(digit, end - digit);
          if ((is_solid && (dim == 2 || number != "8")) ||
              (!is_solid && dim == 2 && number != "4"))
            return "it has elements of the type " + type + ", expected " +
                   wanted + ".";
        }
      return complaint_about_abaqus_surfaces(contents, dim);
    }



    std::string
    complaint_about_ucd_elements(const std::string &contents,
                                 const unsigned int dim)
    {
      std::istringstream stream(contents);
      std::string        line;
      while (std::getline(stream, line) && (line.empty() || line[0] == '#'))
        ;
      std::istringstream header(line);
      long               n_vertices = -1, n_cells = -1;
      if (!(header >> n_vertices >> n_cells) || n_vertices < 1 || n_cells < 1)
        return "its header has no numbers of vertices and cells.";
      if (n_vertices + n_cells > static_cast<long>(contents.size()))
        return "its header promises more vertices and cells than there are "
               "lines.";

      for (long i = 0; i < n_vertices && std::getline(stream, line); ++i)
        ;
      std::set<std::string> types;
      for (long i = 0; i < n_cells && std::getline(stream, line); ++i)
        {
          std::istringstream entries(line);
          std::string        id, material, type;
          entries >> id >> material >> type;
          types.insert(type);
        }

      const std::string cell = (dim == 2 ? "quad" : "hex");
      for (const std::string &type : types)
        if (type != cell && type != "line" && type != "quad")
          return "it has elements of the type '" + type + "', expected '" +
                 cell + "'.";
      if (types.count(cell) == 0)
        return "it has no elements of the type '" + cell + "'.";
      return "";
    }



    /// Each line of CELLS is the number of vertices and the vertices.
    std::string
    complaint_about_vtk_connectivity(const std::string &contents)
    {
      const auto points = contents.find("POINTS"),
                 cells  = contents.find("CELLS");
      if (points == std::string::npos || cells == std::string::npos)
        return "it has no POINTS or no CELLS.";

      long               n_points = 0, n_cells = 0, n_numbers = 0;
      std::istringstream point_stream(contents.substr(points + 6));
      std::istringstream stream(contents.substr(cells + 5));
      point_stream >> n_points;
      stream >> n_cells >> n_numbers;
      for (long c = 0; c < n_cells; ++c)
        {
          long n_vertices = 0, vertex = -1;
          if (!(stream >> n_vertices) ||
              (n_vertices != 2 && n_vertices != 4 && n_vertices != 8))
            return "cell " + std::to_string(c) +
                   " of CELLS is not made of 2, 4 or 8 vertices.";
          for (long v = 0; v < n_vertices; ++v)
            if (!(stream >> vertex) || vertex < 0 || vertex >= n_points)
              return "cell " + std::to_string(c) +
                     " of CELLS refers to a vertex that is not there.";
        }
      return "";
    }



    /// VTK numbers: 3 line, 5 triangle, 9 quadrilateral, 10 tetrahedron,
    /// 12 hexahedron.
    std::string
    complaint_about_vtk_elements(const std::string &contents,
                                 const unsigned int dim)
    {
      if (contents.compare(0, 5, "# vtk") != 0)
        return "it does not start with '# vtk' (legacy format).";
      if (contents.find("ASCII") == std::string::npos)
        return "it is binary. Save it as ASCII.";
      const auto position = contents.find("CELL_TYPES");
      if (position == std::string::npos)
        return "it has no CELL_TYPES (an unstructured grid is needed).";

      std::istringstream stream(contents.substr(position + 10));
      unsigned int       n_cells = 0, type = 0;
      const unsigned int wanted        = (dim == 2 ? 9 : 12);
      bool               has_any_cells = false;
      stream >> n_cells;
      for (unsigned int i = 0; i < n_cells && (stream >> type); ++i)
        {
          has_any_cells = has_any_cells || type == wanted;
          if (type != wanted && type != 3 && !(dim == 3 && type == 9))
            return "it has cells of the VTK type " + std::to_string(type) +
                   ", expected " + std::to_string(wanted) + ".";
        }
      if (!has_any_cells)
        return "it has no cells of the VTK type " + std::to_string(wanted) +
               ".";
      return complaint_about_vtk_connectivity(contents);
    }
  } // namespace



  std::string
  complaint_about_mesh_file(const std::string &contents,
                            const MeshFormat   format,
                            const unsigned int dim)
  {
    switch (format)
      {
        case MeshFormat::gmsh:
          return complaint_about_gmsh_header(contents);
        case MeshFormat::abaqus:
          return complaint_about_abaqus_elements(contents, dim);
        case MeshFormat::ucd:
          return complaint_about_ucd_elements(contents, dim);
        case MeshFormat::vtk:
          return complaint_about_vtk_elements(contents, dim);
        case MeshFormat::automatic:
          break;
      }
    throw dealii::ExcInternalError();
  }
} // namespace stickslip
