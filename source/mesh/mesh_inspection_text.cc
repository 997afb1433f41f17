#include <stickslip/mesh/mesh_inspection_text.h>

#include <stickslip/base/short_number.h>

#include <cstdio>
#include <ostream>
#include <string>
#include <vector>

namespace stickslip
{
  namespace
  {
    std::string
    point_in_words(const Point<3> &point, const unsigned int dim)
    {
      std::string text;
      for (unsigned int d = 0; d < dim; ++d)
        text += (d == 0 ? "(" : ", ") + short_number(point[d]);
      return text + ")";
    }



    std::string
    box_in_words(const PointBox &box, const unsigned int dim)
    {
      std::string text;
      for (unsigned int d = 0; d < dim; ++d)
        text += std::string(d == 0 ? "" : ", ") + "xyz"[d] + " " +
                short_number(box.low[d]) + " to " + short_number(box.high[d]);
      return text;
    }



    std::string
    list_in_words(const std::vector<std::string> &list)
    {
      std::string text;
      for (const std::string &entry : list)
        text += (text.empty() ? "" : ", ") + entry;
      return text;
    }



    std::string
    json_text(const std::string &text)
    {
      std::string result = "\"";
      for (const char letter : text)
        if (letter == '"' || letter == '\\')
          result += std::string("\\") + letter;
        else if (static_cast<unsigned char>(letter) < 32)
          result += ' ';
        else
          result += letter;
      return result + "\"";
    }



    std::string
    json_number(const double value)
    {
      char text[32];
      std::snprintf(text, sizeof(text), "%.10g", value);
      return text;
    }



    std::string
    json_point(const Point<3> &point, const unsigned int dim)
    {
      std::string text = "[";
      for (unsigned int d = 0; d < dim; ++d)
        text += (d > 0 ? ", " : "") + json_number(point[d]);
      return text + "]";
    }



    std::string
    json_box(const PointBox &box, const unsigned int dim)
    {
      return "[" + json_point(box.low, dim) + ", " + json_point(box.high, dim) +
             "]";
    }



    std::string
    json_list(const std::vector<std::string> &list)
    {
      std::string text = "[";
      for (const std::string &entry : list)
        text += (text.size() > 1 ? ", " : "") + json_text(entry);
      return text + "]";
    }



    void
    print_near_surfaces(std::ostream &out, const MeshInspection &inspection)
    {
      if (inspection.interfaces.near_surfaces.empty())
        return;
      out << "Surfaces near each other (candidates for contact):\n";
      for (const NearSurfaces &pair : inspection.interfaces.near_surfaces)
        {
          const std::string first  = list_in_words(pair.first_surfaces);
          const std::string second = list_in_words(pair.second_surfaces);
          out << "  body " << pair.first + 1 << " and body " << pair.second + 1
              << ": gap " << short_number(pair.gap) << " at "
              << point_in_words(pair.place, inspection.dimension) << ", "
              << pair.n_points << " nodes, "
              << (pair.has_matching_nodes ? "some nodes match"
                                          : "nodes do not match")
              << "; " << (first.empty() ? "no named surface" : first) << " - "
              << (second.empty() ? "no named surface" : second) << '\n';
        }
    }
  } // namespace



  void
  print_inspection(std::ostream &out, const MeshInspection &inspection)
  {
    const unsigned int dim = inspection.dimension;
    out << inspection.file << ": " << inspection.format << ", " << dim << "D, "
        << inspection.n_points << " nodes, " << inspection.cells << '\n'
        << "Extent: " << box_in_words(inspection.box, dim) << '\n'
        << "Edges: " << short_number(inspection.shortest_edge) << " to "
        << short_number(inspection.longest_edge) << "; worst scaled Jacobian "
        << short_number(inspection.worst_quality);
    if (inspection.worst_quality < 1.)
      out << " at " << point_in_words(inspection.worst_place, dim);
    out << '\n';
    if (inspection.is_of_second_order)
      {
        out << "Degree 2, "
            << (inspection.deviation.is_curved() ? "curved" : "straight")
            << ": nodes between vertices are ";
        if (inspection.deviation.is_curved())
          out << "up to " << short_number(inspection.deviation.largest)
              << " away from the middle of a straight edge or side, at "
              << point_in_words(inspection.deviation.place, dim) << '\n';
        else
          out << "in the middles of straight edges and sides\n";
      }
    out << "Bodies (cells that share nodes):\n";
    for (unsigned int b = 0; b < inspection.bodies.size(); ++b)
      {
        const InspectedBody &body = inspection.bodies[b];
        out << "  " << b + 1 << ": " << body.n_cells << " cells, "
            << box_in_words(body.box, dim);
        if (!body.groups.empty())
          out << "; groups " << list_in_words(body.groups);
        out << '\n';
      }
    out << "Groups (name, number):\n";
    for (const InspectedGroup &group : inspection.groups)
      {
        out << "  " << group.kind << " "
            << in_words(MeshGroup{0, group.number, group.name}) << ": "
            << group.n_elements;
        if (group.n_elements > 0)
          out << ", " << box_in_words(group.box, dim);
        out << '\n';
      }
    if (inspection.groups.empty())
      out << "  none\n";
    print_near_surfaces(out, inspection);
    for (const std::string &warning : inspection.warnings)
      out << "Warning: " << warning << ".\n";
  }



  void
  print_inspection_json(std::ostream &out, const MeshInspection &inspection)
  {
    const unsigned int dim       = inspection.dimension;
    std::string        separator = "\n";
    const auto         next      = [&]() {
      const std::string now = separator;
      separator             = ",\n";
      return now;
    };
    const auto begin = [&](const std::string &name) {
      separator = "\n";
      out << ",\n  " << json_text(name) << ": [";
    };

    out << "{\n  \"file\": " << json_text(inspection.file)
        << ",\n  \"format\": " << json_text(inspection.format)
        << ",\n  \"dimension\": " << dim
        << ",\n  \"nodes\": " << inspection.n_points
        << ",\n  \"nodes without cell\": " << inspection.n_unused_points
        << ",\n  \"cells\": " << json_text(inspection.cells)
        << ",\n  \"box\": " << json_box(inspection.box, dim)
        << ",\n  \"shortest edge\": " << json_number(inspection.shortest_edge)
        << ",\n  \"longest edge\": " << json_number(inspection.longest_edge)
        << ",\n  \"worst scaled Jacobian\": "
        << json_number(inspection.worst_quality)
        << ",\n  \"worst cell at\": " << json_point(inspection.worst_place, dim)
        << ",\n  \"inverted cells\": " << inspection.n_inverted
        << ",\n  \"degree\": " << (inspection.is_of_second_order ? 2 : 1)
        << ",\n  \"curved\": "
        << (inspection.deviation.is_curved() ? "true" : "false")
        << ",\n  \"distance from straight\": "
        << json_number(inspection.deviation.largest)
        << ",\n  \"cells inside out\": " << inspection.n_inside_out
        << ",\n  \"coincident nodes\": " << inspection.interfaces.n_coincident
        << ",\n  \"coincident nodes of one body\": "
        << inspection.interfaces.n_crack
        << ",\n  \"hanging nodes\": " << inspection.interfaces.n_hanging;
    begin("bodies");
    for (const InspectedBody &body : inspection.bodies)
      out << next() << "    {\"cells\": " << body.n_cells
          << ", \"box\": " << json_box(body.box, dim)
          << ", \"groups\": " << json_list(body.groups) << "}";
    out << "]";
    begin("groups");
    for (const InspectedGroup &group : inspection.groups)
      {
        out << next() << "    {\"kind\": " << json_text(group.kind)
            << ", \"name\": " << json_text(group.name) << ", \"number\": ";
        if (group.number >= 0)
          out << group.number;
        else
          out << "null";
        out << ", \"size\": " << group.n_elements << ", \"box\": "
            << (group.n_elements > 0 ? json_box(group.box, dim) : "null")
            << "}";
      }
    out << "]";
    begin("near surfaces");
    for (const NearSurfaces &pair : inspection.interfaces.near_surfaces)
      out << next() << "    {\"bodies\": [" << pair.first + 1 << ", "
          << pair.second + 1 << "], \"gap\": " << json_number(pair.gap)
          << ", \"at\": " << json_point(pair.place, dim)
          << ", \"nodes\": " << pair.n_points << ", \"matching nodes\": "
          << (pair.has_matching_nodes ? "true" : "false") << ", \"surfaces\": ["
          << json_list(pair.first_surfaces) << ", "
          << json_list(pair.second_surfaces) << "]}";
    out << "],\n  \"warnings\": " << json_list(inspection.warnings) << "\n}\n";
  }
} // namespace stickslip
