#include <stickslip/mesh/file/abaqus_model.h>

#include <stickslip/mesh/file/abaqus_lines.h>
#include <stickslip/mesh/file/mesh_scanner.h>

#include <deal.II/base/numbers.h>

#include <deal.II/physics/transformations.h>

#include <algorithm>
#include <set>

namespace stickslip
{
  Point<3>
  AbaqusPlace::operator()(const Point<3> &point) const
  {
    // Abaqus translates first.
    const Point<3> moved = point + translation;
    if (rotation.empty())
      return moved;
    const Point<3> a(rotation[0], rotation[1], rotation[2]);
    const Point<3> b(rotation[3], rotation[4], rotation[5]);
    const auto     axis = b - a;
    return a +
           Physics::Transformations::Rotations::rotation_matrix_3d(
             Point<3>(axis / axis.norm()), rotation[6] * numbers::PI / 180.) *
             (moved - a);
  }



  namespace
  {
    /// The number in the name of a set or surface; -1 if there is none or it
    /// has too many digits.
    int
    number_in_name(const std::string &name)
    {
      const auto        first = name.find_first_of("0123456789");
      const auto        end   = name.find_first_not_of("0123456789", first);
      const std::string digits =
        first == std::string::npos ? "" : name.substr(first, end - first);
      return digits.empty() || digits.size() > 9 ? -1 : std::stoi(digits);
    }
  } // namespace



  void
  AbaqusModel::number_groups(
    const std::vector<std::shared_ptr<const AbaqusPart>> &parts)
  {
    unsigned int dim = 2;
    for (const auto &part : parts)
      for (const AbaqusElement &element : part->elements)
        dim = std::max(dim, dimension_of(element_types()[element.type].shape));

    std::vector<std::pair<unsigned int, std::string>> names;
    for (const auto &part : parts)
      {
        for (const AbaqusSet &set : part->sets)
          if (set.has_number)
            names.emplace_back(set.dimension, set.name);
        for (const AbaqusSurface &surface : part->surfaces)
          names.emplace_back(dim - 1, surface.name);
      }

    std::map<unsigned int, std::set<int>> used;
    for (const auto &name : names)
      if (const int number = number_in_name(name.second);
          number >= 0 && numbers_by_name.count(name) == 0 &&
          used[name.first].insert(number).second)
        numbers_by_name[name] = number;
    for (const auto &name : names)
      if (numbers_by_name.count(name) == 0)
        {
          int number = 1;
          while (!used[name.first].insert(number).second)
            ++number;
          numbers_by_name[name] = number;
        }
  }



  unsigned int
  AbaqusModel::group(const unsigned int dimension, const std::string &name)
  {
    const auto number = numbers_by_name.find({dimension, name});
    return file.group(dimension,
                      number == numbers_by_name.end() ? -1 : number->second,
                      name);
  }



  void
  AbaqusModel::add(const std::shared_ptr<const AbaqusPart> &part,
                   const std::string                       &instance_name,
                   const AbaqusPlace                       &place)
  {
    const std::string key      = upper_case(instance_name);
    Instance         &instance = instances[key];
    instance                   = {part, file.points.size(), file.n_elements()};
    for (const Point<3> &point : part->points)
      file.points.push_back(place(point));
    add_elements(instance, instance_name);

    Scope &scope = scopes[key];
    scope.own    = &instance;
    add_sets(*part, scope);
    for (const AbaqusSurface &surface : part->surfaces)
      add_surface(surface, scope);
  }



  void
  AbaqusModel::add_elements(const Instance &instance, const std::string &name)
  {
    std::vector<unsigned int> nodes;
    for (const AbaqusElement &element : instance.part->elements)
      {
        nodes = element.nodes;
        for (unsigned int &node : nodes)
          node += instance.first_point;
        const std::size_t index = file.add_element(element.type, nodes);
        if (!name.empty())
          file.add_to_group(index, group(file.dimension(index), name));
      }
  }



  bool
  AbaqusModel::find_label(const long      label,
                          const bool      is_element,
                          const Instance &instance,
                          std::size_t    &index)
  {
    if (is_element)
      {
        const auto found = instance.part->element_numbers.find(label);
        if (found == instance.part->element_numbers.end())
          return false;
        index = found->second == skipped_element
                  ? skipped_element
                  : instance.first_element + found->second;
        return true;
      }
    unsigned int point = 0;
    if (!instance.part->point_numbers.find(label, point))
      return false;
    index = instance.first_point + point;
    return true;
  }



  bool
  AbaqusModel::find_members(const std::string &text,
                            const bool         is_element,
                            const Scope       &scope,
                            Indices           &members) const
  {
    const Scope      *place = &scope;
    std::string       name  = upper_case(text);
    const std::size_t dot   = name.find('.');
    if (dot != std::string::npos)
      {
        const auto other = scopes.find(name.substr(0, dot));
        if (other != scopes.end())
          {
            place = &other->second;
            name  = name.substr(dot + 1);
          }
      }
    const auto set = place->sets(is_element).find(name);
    if (set != place->sets(is_element).end())
      {
        members = set->second;
        return true;
      }
    long        label = 0;
    std::size_t index = 0;
    if (!parse_integer(name, label) ||
        !find_label(label, is_element, *place->own, index))
      return false;
    members.assign(index == skipped_element ? 0 : 1, index);
    return true;
  }



  const AbaqusModel::Instance &
  AbaqusModel::instance_of(const AbaqusSet &set, const Scope &scope) const
  {
    if (set.instance.empty())
      return *scope.own;
    const auto found = instances.find(upper_case(set.instance));
    if (found == instances.end())
      throw MeshFileError("the set " + quoted_word(set.name) +
                            " belongs to the instance " +
                            quoted_word(set.instance) + ", which is not there",
                          set.line);
    return found->second;
  }



  AbaqusModel::Indices
  AbaqusModel::members_of(const AbaqusSet &set, const Scope &scope) const
  {
    const Instance   &instance   = instance_of(set, scope);
    const bool        is_element = set.is_of_elements;
    const std::string kind       = is_element ? "element" : "node";
    Indices           members;
    std::size_t       index = 0;
    for (const long label : set.labels)
      if (!find_label(label, is_element, instance, index))
        throw MeshFileError("the set " + quoted_word(set.name) + " has " +
                              kind + " " + std::to_string(label) +
                              ", which is not there",
                            set.line);
      else if (index != skipped_element)
        members.push_back(index);

    const auto add_if_in_range = [&](const long                 label,
                                     const std::array<long, 3> &range) {
      if (label >= range[0] && label <= range[1] &&
          (label - range[0]) % range[2] == 0 &&
          find_label(label, is_element, instance, index) &&
          index != skipped_element)
        members.push_back(index);
    };
    for (const std::array<long, 3> &range : set.ranges)
      if (is_element)
        for (const AbaqusElement &element : instance.part->elements)
          add_if_in_range(element.label, range);
      else
        for (const long label : instance.part->point_labels)
          add_if_in_range(label, range);

    for (const std::string &name : set.names)
      {
        const auto other = scopes.find(upper_case(set.instance));
        Indices    others;
        if (!find_members(name,
                          is_element,
                          set.instance.empty() ? scope : other->second,
                          others))
          throw MeshFileError("the set " + quoted_word(set.name) +
                                " names the " + kind + " set " +
                                quoted_word(name) + ", which is not there",
                              set.line);
        members.insert(members.end(), others.begin(), others.end());
      }
    return members;
  }



  void
  AbaqusModel::add_sets(const AbaqusPart &part, Scope &scope)
  {
    for (const AbaqusSet &set : part.sets)
      {
        // meshio keeps what it does not understand of a Gmsh file in such sets.
        if (set.name.compare(0, 5, "gmsh:") == 0)
          continue;
        const Indices members = members_of(set, scope);
        Indices &all = scope.sets(set.is_of_elements)[upper_case(set.name)];
        all.insert(all.end(), members.begin(), members.end());
        if (set.is_internal)
          continue;
        if (set.is_of_elements)
          add_to_groups(set, members);
        else
          file.point_sets[set.name].insert(file.point_sets[set.name].end(),
                                           members.begin(),
                                           members.end());
      }
  }



  void
  AbaqusModel::add_to_groups(const AbaqusSet &set, const Indices &elements)
  {
    std::array<int, 4> groups = {{-1, -1, -1, -1}};
    for (const std::size_t element : elements)
      {
        const unsigned int dim = file.dimension(element);
        if (groups[dim] < 0)
          groups[dim] = group(dim, set.name);
        file.add_to_group(element, groups[dim]);
      }
  }



  void
  AbaqusModel::add_surface(const AbaqusSurface &surface, const Scope &scope)
  {
    for (const AbaqusSide &side : surface.sides)
      {
        Indices members;
        if (!find_members(side.elements, !surface.is_of_nodes, scope, members))
          throw MeshFileError("the surface " + quoted_word(surface.name) +
                                " names the " +
                                (surface.is_of_nodes ? "node" : "element") +
                                " set " + quoted_word(side.elements) +
                                ", which is not there",
                              side.line);
        if (surface.is_of_nodes)
          file.point_sets[surface.name].insert(
            file.point_sets[surface.name].end(),
            members.begin(),
            members.end());
        else
          for (const std::size_t element : members)
            add_side(element, side, surface.name);
      }
  }



  void
  AbaqusModel::add_side(const std::size_t  element,
                        const AbaqusSide  &side,
                        const std::string &surface)
  {
    const MeshElementType &type      = file.type(element);
    const auto            &all_sides = sides_of(type.shape);
    const auto             own_nodes = file.nodes(element);
    const auto             nodes_of  = [&](const unsigned int s) {
      std::vector<unsigned int> nodes;
      for (const unsigned int v : all_sides[s])
        nodes.push_back(own_nodes[v]);
      return nodes;
    };

    // Of a shell, the face is the element itself.
    if (side.side == "SPOS" || side.side == "SNEG")
      return file.add_to_group(element,
                               group(dimension_of(type.shape), surface));
    if (side.side.empty())
      {
        for (unsigned int s = 0; s < all_sides.size(); ++s)
          if (is_free(nodes_of(s)))
            add_face(nodes_of(s), surface);
        return;
      }
    const unsigned int number =
      side.side.size() == 2 && side.side[0] == 'S' ? side.side[1] - '0' : 0;
    if (number < 1 || number > all_sides.size())
      throw MeshFileError("the surface " + quoted_word(surface) +
                            " has the side " + quoted_word(side.side) + " of " +
                            type.plural() + "; S1 to S" +
                            std::to_string(all_sides.size()) + " are expected",
                          side.line);
    add_face(nodes_of(number - 1), surface);
  }



  void
  AbaqusModel::add_face(const std::vector<unsigned int> &nodes,
                        const std::string               &surface)
  {
    const ElementShape shape = nodes.size() == 2 ? ElementShape::line
                               : nodes.size() == 3
                                 ? ElementShape::triangle
                                 : ElementShape::quadrilateral;
    const std::size_t  face =
      file.add_element(element_type_of(shape, nodes.size()), nodes);
    file.add_to_group(face, group(dimension_of(shape), surface));
  }



  bool
  AbaqusModel::is_free(std::vector<unsigned int> nodes)
  {
    for (; n_counted_elements < file.n_elements(); ++n_counted_elements)
      for (const auto &side : sides_of(file.type(n_counted_elements).shape))
        {
          const auto                all = file.nodes(n_counted_elements);
          std::vector<unsigned int> vertices;
          for (const unsigned int v : side)
            vertices.push_back(all[v]);
          std::sort(vertices.begin(), vertices.end());
          ++n_elements_at[vertices];
        }
    std::sort(nodes.begin(), nodes.end());
    return n_elements_at[nodes] == 1;
  }
} // namespace stickslip
