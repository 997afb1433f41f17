#include <stickslip/mesh/file/abaqus_reader.h>

#include <stickslip/mesh/file/abaqus_elements.h>
#include <stickslip/mesh/file/element_type.h>
#include <stickslip/mesh/file/mesh_scanner.h>

#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace stickslip
{
  std::string
  AbaqusReader::required(const std::string &option) const
  {
    const std::string value = lines.keyword().value(option);
    if (value.empty())
      lines.fail("*" + lines.keyword().name + " needs " + option + "=...");
    return value;
  }



  void
  AbaqusReader::check_is_complete() const
  {
    if (!element.empty())
      throw MeshFileError("element " + std::to_string(element[0]) +
                            " of the type " + type_name + " has " +
                            std::to_string(element.size() - 1) + " nodes; " +
                            std::to_string(element_types()[type].n_nodes) +
                            " are expected",
                          element_line);
  }



  void
  AbaqusReader::begin_instance()
  {
    const std::string name  = required("NAME");
    const std::string of    = required("PART");
    const auto        found = parts.find(upper_case(of));
    if (found == parts.end())
      lines.fail("the instance " + quoted_word(name) + " is of the part " +
                 quoted_word(of) + ", which is not there");
    // An instance may have nodes and sets of its own.
    part = std::make_shared<AbaqusPart>(*found->second);
    instances.push_back({part, name, AbaqusPlace(), 0});
    mode = Mode::instance;
  }



  void
  AbaqusReader::begin_set(const bool is_of_elements, const std::string &name)
  {
    AbaqusSet set;
    set.name           = name;
    set.is_of_elements = is_of_elements;
    set.line           = lines.line();
    if (lines.keyword().name == "ELSET" || lines.keyword().name == "NSET")
      {
        set.instance    = lines.keyword().value("INSTANCE");
        set.is_internal = lines.keyword().has("INTERNAL");
      }
    generates = lines.keyword().has("GENERATE");
    part->sets.push_back(set);
  }



  void
  AbaqusReader::begin_elements()
  {
    type_name = upper_case(required("TYPE"));
    type      = element_type_of_abaqus(type_name);
    set_name  = lines.keyword().value("ELSET");
    mode      = Mode::elements;
    if (set_name.empty())
      return;
    begin_set(true, set_name);
    part->sets.back().has_number = (type >= 0);
    if (type >= 0)
      part->sets.back().dimension = dimension_of(element_types()[type].shape);
  }



  void
  AbaqusReader::begin_surface()
  {
    const std::string type_of_surface =
      upper_case(lines.keyword().value("TYPE"));
    if (!lines.keyword().value("COMBINE").empty())
      lines.fail(
        "*SURFACE with COMBINE is not supported. Name the sides of "
        "the elements");
    mode = Mode::skip;
    if (!type_of_surface.empty() && type_of_surface != "ELEMENT" &&
        type_of_surface != "NODE")
      return;
    AbaqusSurface surface;
    surface.name        = required("NAME");
    surface.is_of_nodes = (type_of_surface == "NODE");
    part->surfaces.push_back(surface);
    mode = Mode::surface;
  }



  void
  AbaqusReader::read_keyword()
  {
    check_is_complete();
    static const std::set<std::string> refused = {
      "NGEN", "NFILL", "NCOPY", "NMAP", "ELGEN", "ELCOPY", "SYSTEM", "INCLUDE"};
    const AbaqusKeyword &keyword = lines.keyword();
    const std::string   &name    = keyword.name;
    mode                         = Mode::skip;
    if (refused.count(name) > 0)
      lines.fail("*" + name +
                 " is not supported. Write the file with all nodes and "
                 "elements in it, in global coordinates");
    const bool is_of_mesh = (name == "NODE" || name == "ELEMENT" ||
                             name == "NSET" || name == "ELSET");
    if (is_of_mesh && keyword.has("INPUT"))
      lines.fail("*" + name +
                 " with INPUT=... is not supported. Put these lines into "
                 "the file");

    if (name == "PART")
      part = parts[upper_case(required("NAME"))] =
        std::make_shared<AbaqusPart>();
    else if (name == "ENDPART" || name == "ENDINSTANCE")
      part = outside;
    else if (name == "INSTANCE")
      begin_instance();
    else if (name == "NODE")
      {
        if (upper_case(keyword.value("SYSTEM")) != "R" && keyword.has("SYSTEM"))
          lines.fail("*NODE with SYSTEM=" + keyword.value("SYSTEM") +
                     " is not supported: the coordinates have to be "
                     "Cartesian");
        has_nodes = true;
        mode      = Mode::nodes;
        set_name  = keyword.value("NSET");
        if (!set_name.empty())
          begin_set(false, set_name);
      }
    else if (name == "ELEMENT")
      begin_elements();
    else if (name == "ELSET" || name == "NSET")
      {
        begin_set(name == "ELSET", required(name));
        mode = Mode::set;
      }
    else if (name == "SURFACE")
      begin_surface();
  }



  void
  AbaqusReader::read_node()
  {
    const long label = lines.integer(0, "the number of a node");
    if (!part->point_numbers.add(label, part->points.size()))
      lines.fail("there are two nodes " + std::to_string(label));
    Point<3> point;
    for (unsigned int d = 0; d < 3; ++d)
      point[d] = lines.number(1 + d, "a coordinate of a node");
    part->points.push_back(point);
    part->point_labels.push_back(label);
    if (!set_name.empty())
      part->sets.back().labels.push_back(label);
  }



  void
  AbaqusReader::add_element(const long label)
  {
    const bool is_known = (type >= 0);
    if (!part->element_numbers
           .insert({label, is_known ? part->elements.size() : skipped_element})
           .second)
      lines.fail("there are two elements " + std::to_string(label));
    if (!set_name.empty())
      part->sets.back().labels.push_back(label);
    if (!is_known)
      {
        ++unknown_types["the type " + type_name];
        return;
      }
    AbaqusElement added{label, static_cast<unsigned int>(type), {}};
    for (unsigned int n = 1; n < element.size(); ++n)
      {
        unsigned int point = 0;
        if (!part->point_numbers.find(element[n], point))
          lines.fail("element " + std::to_string(label) + " refers to node " +
                     std::to_string(element[n]) + ", which is not there");
        for (const unsigned int other : added.nodes)
          if (other == point)
            lines.fail("element " + std::to_string(label) + " has node " +
                       std::to_string(element[n]) +
                       " twice; collapsed elements are not supported");
        added.nodes.push_back(point);
      }
    added.nodes =
      nodes_in_order(added.nodes, node_order_of_abaqus(element_types()[type]));
    part->elements.push_back(added);
  }



  void
  AbaqusReader::read_element()
  {
    if (type < 0)
      {
        // How many lines it has is not known; commas tell.
        if (element.empty())
          add_element(lines.integer(0, "the number of an element"));
        element.clear();
        if (lines.is_continued())
          element.push_back(0);
        return;
      }
    if (element.empty())
      element_line = lines.line();
    for (unsigned int i = 0; i < lines.entries().size(); ++i)
      element.push_back(lines.integer(i,
                                      element.empty()
                                        ? "the number of an element"
                                        : "a node of an element"));
    const unsigned int n_nodes = element_types()[type].n_nodes;
    if (element.size() < n_nodes + 1 && lines.is_continued())
      return;
    if (element.size() != n_nodes + 1)
      check_is_complete();
    add_element(element[0]);
    element.clear();
  }



  void
  AbaqusReader::read_members()
  {
    AbaqusSet &set = part->sets.back();
    set.line       = lines.line();
    if (generates)
      {
        const long first     = lines.integer(0, "the first member of a set");
        const long last      = lines.entries().size() > 1
                                 ? lines.integer(1, "the last member of a set")
                                 : first;
        const long increment = lines.entries().size() > 2
                                 ? lines.integer(2, "the increment of a set")
                                 : 1;
        if (increment < 1 || last < first)
          lines.fail("a set goes from " + std::to_string(first) + " to " +
                     std::to_string(last) + " in steps of " +
                     std::to_string(increment));
        set.ranges.push_back({{first, last, increment}});
        return;
      }
    long label = 0;
    for (const std::string_view entry : lines.entries())
      if (parse_integer(entry, label))
        set.labels.push_back(label);
      else if (!entry.empty())
        set.names.emplace_back(entry);
  }



  void
  AbaqusReader::read_side()
  {
    AbaqusSide side;
    side.line     = lines.line();
    side.elements = std::string(lines.entries()[0]);
    if (side.elements.empty())
      lines.fail("the surface " + quoted_word(part->surfaces.back().name) +
                 " has a line without elements");
    if (lines.entries().size() > 1 && !part->surfaces.back().is_of_nodes)
      side.side = upper_case(lines.entries()[1]);
    part->surfaces.back().sides.push_back(side);
  }



  void
  AbaqusReader::read_place()
  {
    PlacedPart        &instance = instances.back();
    const unsigned int n        = ++instance.n_lines == 1 ? 3 : 7;
    if (instance.n_lines > 2)
      lines.fail(
        "an instance has two lines at most: translation and "
        "rotation");
    for (unsigned int i = 0; i < n; ++i)
      {
        const double value =
          lines.number(i, "a number of the instance's place");
        if (n == 3)
          instance.place.translation[i] = value;
        else
          instance.place.rotation.push_back(value);
      }
    const auto &r = instance.place.rotation;
    if (n == 7 && r[0] == r[3] && r[1] == r[4] && r[2] == r[5])
      lines.fail("the axis of the instance's rotation has no length");
  }



  void
  AbaqusReader::read_data()
  {
    switch (mode)
      {
        case Mode::nodes:
          return read_node();
        case Mode::elements:
          return read_element();
        case Mode::set:
          return read_members();
        case Mode::surface:
          return read_side();
        case Mode::instance:
          return read_place();
        case Mode::skip:
          return;
      }
  }



  MeshFile
  AbaqusReader::read()
  {
    while (lines.next())
      if (lines.is_keyword())
        read_keyword();
      else
        read_data();
    if (type >= 0)
      check_is_complete();
    if (!has_nodes)
      throw MeshFileError("it has no *NODE lines");

    std::vector<std::shared_ptr<const AbaqusPart>> all;
    for (const PlacedPart &instance : instances)
      all.push_back(instance.part);
    // A file of one part without an assembly.
    if (instances.empty())
      for (const auto &[name, own] : parts)
        {
          instances.push_back({own, name, AbaqusPlace(), 0});
          all.push_back(own);
        }
    all.push_back(outside);
    model.number_groups(all);
    for (const PlacedPart &instance : instances)
      model.add(instance.part, instance.name, instance.place);
    model.add(outside, "", AbaqusPlace());
    model.file.unknown_types = unknown_types;
    return std::move(model.file);
  }
} // namespace stickslip
