#include <stickslip/mesh/file/vtu_file.h>

#include <stickslip/mesh/file/mesh_scanner.h>
#include <stickslip/mesh/file/vtk_cells.h>
#include <stickslip/mesh/file/vtk_numbers.h>

#include <zlib.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace stickslip
{
  namespace
  {
    struct XmlTag
    {
      std::string                        name; ///< "/Points" for an end
      std::map<std::string, std::string> attributes;

      std::string
      value(const std::string &attribute) const
      {
        const auto found = attributes.find(attribute);
        return found == attributes.end() ? "" : found->second;
      }
    };



    class VtuReader
    {
    public:
      explicit VtuReader(const std::string_view text)
        : text(text)
      {}

      MeshFile
      read();

    private:
      [[noreturn]] void
      fail(const std::string &message) const;

      /// Goes to the next tag; false at the end.
      bool
      next_tag(XmlTag &tag);

      void
      read_attributes(std::string_view inside, XmlTag &tag) const;

      void
      check_file(const XmlTag &tag);

      std::vector<double>
      read_array(const XmlTag &tag);

      /// The data of an array, after its header and decompressed.
      std::string
      binary_data(const std::string &bytes) const;

      std::string
      uncompressed(const std::string         &bytes,
                   const std::vector<double> &header) const;

      void
      keep(const std::string &section, const XmlTag &tag);

      std::string_view text;
      std::size_t      position = 0;
      std::string_view appended;
      bool             appended_is_base64 = false;
      bool             is_big_endian = false, is_compressed = false;
      VtkNumber        header_type = VtkNumber::uint32;
      VtkGrid          grid;
      bool             has_piece = false;
    };



    void
    VtuReader::fail(const std::string &message) const
    {
      throw MeshFileError(message,
                          1 + std::count(text.begin(),
                                         text.begin() +
                                           std::min(position, text.size()),
                                         '\n'));
    }



    void
    VtuReader::read_attributes(std::string_view inside, XmlTag &tag) const
    {
      while (true)
        {
          const std::size_t equal = inside.find('=');
          if (equal == std::string_view::npos || equal + 1 >= inside.size())
            return;
          const char        quote = inside[equal + 1];
          const std::size_t end   = inside.find(quote, equal + 2);
          if ((quote != '"' && quote != '\'') || end == std::string_view::npos)
            fail("the attributes of <" + tag.name + "> are no XML");
          std::string name(inside.substr(0, equal));
          name.erase(std::remove_if(name.begin(),
                                    name.end(),
                                    [](const unsigned char c) {
                                      return std::isspace(c) || c == '/';
                                    }),
                     name.end());
          tag.attributes[name] =
            std::string(inside.substr(equal + 2, end - equal - 2));
          inside.remove_prefix(end + 1);
        }
    }



    bool
    VtuReader::next_tag(XmlTag &tag)
    {
      tag                     = XmlTag();
      const std::size_t begin = text.find('<', position);
      if (begin == std::string_view::npos)
        return false;
      position              = begin;
      const std::size_t end = text.find('>', begin);
      if (end == std::string_view::npos)
        fail("a tag of XML is not closed: the file is incomplete");
      const std::string_view inside = text.substr(begin + 1, end - begin - 1);
      const std::size_t      name_end =
        std::min(inside.find_first_of(" \t\r\n"), inside.size());
      tag.name = std::string(inside.substr(0, name_end));
      if (tag.name.size() > 1 && tag.name.back() == '/')
        tag.name.pop_back();
      if (tag.name[0] != '?' && tag.name[0] != '!')
        read_attributes(inside.substr(name_end), tag);
      position = end + 1;
      return true;
    }



    void
    VtuReader::check_file(const XmlTag &tag)
    {
      if (tag.value("type") != "UnstructuredGrid")
        fail("the VTK file is of the type " + quoted_word(tag.value("type")) +
             "; UnstructuredGrid is expected");
      is_big_endian = (tag.value("byte_order") == "BigEndian");
      if (!tag.value("header_type").empty())
        header_type = vtk_number(tag.value("header_type"));
      const std::string compressor = tag.value("compressor");
      is_compressed                = !compressor.empty();
      if (is_compressed && compressor != "vtkZLibDataCompressor")
        fail("the data are compressed with " + quoted_word(compressor) +
             "; vtkZLibDataCompressor or none is expected");
    }



    std::string
    VtuReader::uncompressed(const std::string         &bytes,
                            const std::vector<double> &header) const
    {
      // Number of blocks, their length, that of the last, compressed lengths.
      const std::size_t n_blocks = static_cast<std::size_t>(header[0]);
      std::size_t       begin    = (3 + n_blocks) * size_of(header_type);
      std::string       result;
      for (std::size_t b = 0; b < n_blocks; ++b)
        {
          const bool   is_last = (b + 1 == n_blocks && header[2] > 0.);
          const double length  = is_last ? header[2] : header[1];
          const double packed  = header[3 + b];
          // zlib packs 1032 bytes into one at best.
          if (!(packed >= 0. && packed <= bytes.size() - begin &&
                length >= 0. && length <= 1100. * (packed + 1.)))
            fail("compressed data do not have the length that they promise");
          std::string block(static_cast<std::size_t>(length), '\0');
          uLongf      n = block.size();
          if (uncompress(reinterpret_cast<Bytef *>(&block[0]),
                         &n,
                         reinterpret_cast<const Bytef *>(bytes.data() + begin),
                         static_cast<uLong>(packed)) != Z_OK ||
              n != block.size())
            fail("compressed data cannot be decompressed");
          result += block;
          begin += static_cast<std::size_t>(packed);
        }
      return result;
    }



    std::string
    VtuReader::binary_data(const std::string &bytes) const
    {
      const unsigned int size = size_of(header_type);
      const auto         head = [&](const std::size_t n) {
        if (bytes.size() < n * size)
          fail("binary data end within their header");
        return vtk_numbers({bytes.data(), n * size},
                           header_type,
                           is_big_endian);
      };
      const double first = head(1)[0];
      if (!is_compressed)
        {
          if (!(first >= 0. && first <= bytes.size() - size))
            fail("binary data are shorter than they promise");
          return bytes.substr(size, static_cast<std::size_t>(first));
        }
      if (!(first >= 0. && first <= bytes.size()))
        fail("binary data have " + std::to_string(first) + " blocks");
      return first == 0.
               ? ""
               : uncompressed(bytes, head(3 + static_cast<std::size_t>(first)));
    }



    std::vector<double>
    VtuReader::read_array(const XmlTag &tag)
    {
      const std::string format = tag.value("format");
      const std::size_t end = std::min(text.find('<', position), text.size());
      const std::string_view inside = text.substr(position, end - position);
      if (format == "ascii")
        {
          MeshScanner         scanner(inside);
          std::vector<double> values;
          try
            {
              while (!scanner.is_at_end())
                values.push_back(scanner.number("a value"));
            }
          catch (const MeshFileError &error)
            {
              position += std::min<std::size_t>(inside.find_first_not_of(" \n"),
                                                inside.size());
              fail(std::string("in the array ") +
                   quoted_word(tag.value("Name")) + ": " + error.what());
            }
          return values;
        }
      const VtkNumber type = vtk_number(tag.value("type"));
      if (format == "binary")
        return vtk_numbers(binary_data(decoded_base64(inside)),
                           type,
                           is_big_endian);
      if (format != "appended")
        fail("an array has the format " + quoted_word(format) +
             "; ascii, binary or appended is expected");
      long offset = 0;
      if (!parse_integer(tag.value("offset"), offset) || offset < 0 ||
          static_cast<std::size_t>(offset) >= appended.size())
        fail("the array " + quoted_word(tag.value("Name")) +
             " is not where its offset says");
      const std::string_view rest = appended.substr(offset);
      return vtk_numbers(
        binary_data(
          appended_is_base64
            ? decoded_base64(rest.substr(
                0,
                rest.find_first_not_of(
                  "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz"
                  "0123456789+/=\n\r\t ")))
            : std::string(rest)),
        type,
        is_big_endian);
    }



    void
    VtuReader::keep(const std::string &section, const XmlTag &tag)
    {
      const std::string name = tag.value("Name");
      if (section == "Points")
        grid.coordinates = read_array(tag);
      else if (section == "Cells" && name == "connectivity")
        grid.connectivity = read_array(tag);
      else if (section == "Cells" && name == "offsets")
        grid.offsets = read_array(tag);
      else if (section == "Cells" && name == "types")
        grid.types = read_array(tag);
      else if (section == "CellData" && is_vtk_id_array(name))
        grid.ids = read_array(tag);
    }



    MeshFile
    VtuReader::read()
    {
      // Appended data may be binary and come last: cut them off first.
      const std::size_t begin = text.find("<AppendedData");
      if (begin != std::string_view::npos)
        {
          XmlTag tag;
          position = begin;
          next_tag(tag);
          appended_is_base64      = (tag.value("encoding") == "base64");
          const std::size_t first = text.find('_', position);
          if (first == std::string_view::npos)
            fail("appended data do not begin with '_'");
          appended = text.substr(first + 1);
          text     = text.substr(0, begin);
          position = 0;
        }

      XmlTag      tag;
      std::string section;
      bool        is_vtk = false;
      while (next_tag(tag))
        if (tag.name == "VTKFile")
          {
            is_vtk = true;
            check_file(tag);
          }
        else if (tag.name == "Piece")
          {
            if (has_piece)
              fail("it has more than one piece. Save it as one");
            has_piece = true;
          }
        else if (tag.name == "Points" || tag.name == "Cells" ||
                 tag.name == "CellData" || tag.name == "PointData")
          section = tag.name;
        else if (tag.name == "DataArray")
          keep(section, tag);
      if (!is_vtk)
        throw MeshFileError("it has no <VTKFile>: it is no VTK file in XML");
      return grid.mesh_file();
    }
  } // namespace



  MeshFile
  read_vtu(const std::string &contents)
  {
    return VtuReader(contents).read();
  }
} // namespace stickslip
