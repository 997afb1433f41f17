#include <stickslip/mesh/file/vtk_file.h>

#include <stickslip/mesh/file/mesh_scanner.h>
#include <stickslip/mesh/file/vtk_cells.h>
#include <stickslip/mesh/file/vtk_numbers.h>

#include <string>
#include <string_view>
#include <vector>

namespace stickslip
{
  namespace
  {
    class VtkReader
    {
    public:
      explicit VtkReader(const std::string_view text)
        : scanner(text)
      {}

      MeshFile
      read();

    private:
      void
      read_header();

      void
      read_section(const std::string &keyword);

      void
      read_cells();

      void
      read_scalars();

      void
      read_fields();

      /// @p n numbers of the type @p type, as text or binary.
      std::vector<double>
      numbers(const std::size_t n, const std::string &type);

      MeshScanner scanner;
      VtkGrid     grid;
      bool        is_binary    = false;
      std::size_t n_data       = 0; ///< of CELL_DATA or POINT_DATA
      bool        is_cell_data = false;
    };



    std::vector<double>
    VtkReader::numbers(const std::size_t n, const std::string &type)
    {
      if (!is_binary)
        {
          scanner.check_count("the number of values", n, 2);
          std::vector<double> values(n);
          for (double &value : values)
            value = scanner.number("a value");
          return values;
        }
      scanner.rest_of_line();
      const VtkNumber number = vtk_number(type);
      scanner.check_count("the number of values", n, size_of(number));
      const std::size_t n_bytes = n * size_of(number);
      return vtk_numbers({scanner.bytes(n_bytes, "a value"), n_bytes},
                         number,
                         true);
    }



    void
    VtkReader::read_header()
    {
      if (scanner.rest_of_line().substr(0, 5) != "# vtk")
        scanner.fail("it does not begin with '# vtk DataFile'");
      scanner.rest_of_line(); // the title
      const std::string encoding(scanner.word("ASCII or BINARY"));
      if (encoding != "ASCII" && encoding != "BINARY")
        scanner.fail("found " + quoted_word(encoding) +
                     " where ASCII or BINARY is expected");
      is_binary = (encoding == "BINARY");
      scanner.expect("DATASET");
      const std::string_view kind = scanner.word("the kind of data set");
      if (kind != "UNSTRUCTURED_GRID")
        scanner.fail("the data set is of the kind " + quoted_word(kind) +
                     "; UNSTRUCTURED_GRID is expected");
    }



    void
    VtkReader::read_cells()
    {
      const std::size_t n       = scanner.count("the number of cells");
      const std::size_t n_all   = scanner.count("the length of CELLS");
      MeshScanner       further = scanner;
      if (further.word("the cells") == "OFFSETS") // version 5
        {
          scanner.expect("OFFSETS");
          const std::string offset_type(scanner.word("a type"));
          grid.offsets = numbers(n, offset_type);
          if (!grid.offsets.empty())
            grid.offsets.erase(grid.offsets.begin());
          scanner.expect("CONNECTIVITY");
          const std::string type(scanner.word("a type"));
          grid.connectivity = numbers(n_all, type);
          return;
        }
      const std::vector<double> all = numbers(n_all, "int");
      std::size_t               i   = 0;
      for (std::size_t c = 0; c < n; ++c)
        {
          if (i >= all.size() || !(all[i] >= 0. && all[i] < all.size() - i))
            scanner.fail("CELLS do not hold as many points as they say");
          const std::size_t n_points = static_cast<std::size_t>(all[i]);
          grid.connectivity.insert(grid.connectivity.end(),
                                   all.begin() + i + 1,
                                   all.begin() + i + 1 + n_points);
          grid.offsets.push_back(grid.connectivity.size());
          i += 1 + n_points;
        }
    }



    void
    VtkReader::read_scalars()
    {
      const std::string      name(scanner.word("the name of scalars"));
      const std::string      type(scanner.word("a type"));
      const std::string_view rest         = scanner.rest_of_line();
      double                 n_components = 1.;
      if (!MeshScanner(rest).is_at_end())
        n_components = MeshScanner(rest).number("a number of components");
      if (!(n_components >= 1. && n_components <= 4.))
        scanner.fail("scalars with " + std::to_string(n_components) +
                     " components; 1 to 4 are expected");
      scanner.expect("LOOKUP_TABLE");
      scanner.word("the name of a table");
      const std::vector<double> values =
        numbers(n_data * static_cast<std::size_t>(n_components), type);
      if (is_cell_data && n_components == 1. && is_vtk_id_array(name))
        grid.ids = values;
    }



    void
    VtkReader::read_fields()
    {
      scanner.word("the name of a field");
      const std::size_t n = scanner.count("the number of arrays");
      for (std::size_t a = 0; a < n; ++a)
        {
          const std::string name(scanner.word("the name of an array"));
          if (name == "METADATA")
            {
              scanner.skip_behind("\n\n");
              --a;
              continue;
            }
          const std::size_t n_components = scanner.count("the components");
          const std::size_t n_tuples     = scanner.count("the tuples", 0);
          const std::string type(scanner.word("a type"));
          if (type == "string")
            {
              for (std::size_t t = 0; t < n_tuples + 1; ++t)
                scanner.rest_of_line();
              continue;
            }
          scanner.check_count("the number of values",
                              1. * n_components * n_tuples,
                              1);
          const auto values = numbers(n_components * n_tuples, type);
          if (is_cell_data && n_components == 1 && is_vtk_id_array(name))
            grid.ids = values;
        }
    }



    void
    VtkReader::read_section(const std::string &keyword)
    {
      if (keyword == "POINTS")
        {
          const std::size_t n = scanner.count("the number of points");
          const std::string type(scanner.word("a type"));
          grid.coordinates = numbers(3 * n, type);
        }
      else if (keyword == "CELLS")
        read_cells();
      else if (keyword == "CELL_TYPES")
        {
          const std::size_t n = scanner.count("the number of types");
          grid.types          = numbers(n, "int");
        }
      else if (keyword == "CELL_DATA" || keyword == "POINT_DATA")
        {
          is_cell_data = (keyword == "CELL_DATA");
          n_data       = scanner.count("the number of data", 0);
        }
      else if (keyword == "SCALARS")
        read_scalars();
      else if (keyword == "VECTORS" || keyword == "NORMALS")
        {
          scanner.word("a name");
          const std::string type(scanner.word("a type"));
          numbers(3 * n_data, type);
        }
      else if (keyword == "FIELD")
        read_fields();
      else if (keyword == "METADATA")
        scanner.skip_behind("\n\n");
      else
        scanner.fail("found " + quoted_word(keyword) +
                     " where POINTS, CELLS, CELL_TYPES, CELL_DATA, POINT_DATA, "
                     "SCALARS, VECTORS, NORMALS or FIELD is expected");
    }



    MeshFile
    VtkReader::read()
    {
      read_header();
      while (!scanner.is_at_end())
        read_section(std::string(scanner.word("a section")));
      return grid.mesh_file();
    }
  } // namespace



  MeshFile
  read_vtk(const std::string &contents)
  {
    const auto first = contents.find('\n');
    const auto second =
      first == std::string::npos ? first : contents.find('\n', first + 1);
    if (second != std::string::npos &&
        contents.compare(second + 1, 6, "BINARY") == 0)
      return VtkReader(contents).read();
    const std::string text = plain_text(contents);
    return VtkReader(text).read();
  }
} // namespace stickslip
