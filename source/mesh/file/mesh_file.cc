#include <stickslip/mesh/file/mesh_file.h>

#include <algorithm>

namespace stickslip
{
  std::size_t
  MeshFile::add_element(const unsigned int               type,
                        const std::vector<unsigned int> &nodes)
  {
    for (unsigned int i = 0; i < nodes.size(); ++i)
      for (unsigned int j = 0; j < i; ++j)
        if (nodes[i] == nodes[j])
          throw MeshFileError(
            "an element has the same node twice; collapsed "
            "elements are not supported");
    types.push_back(type);
    first_nodes.push_back(all_nodes.size());
    all_nodes.insert(all_nodes.end(), nodes.begin(), nodes.end());
    sets.push_back(0);
    return types.size() - 1;
  }



  unsigned int
  MeshFile::group(const unsigned int dimension,
                  const int          number,
                  const std::string &name)
  {
    const unsigned int next = groups.size();
    const auto         found =
      number >= 0
                ? groups_by_number.insert({{dimension, number}, next}).first->second
                : groups_by_name.insert({{dimension, name}, next}).first->second;
    if (found == next)
      groups.push_back({dimension, number, name});
    else if (groups[found].name.empty())
      groups[found].name = name;
    return found;
  }



  void
  MeshFile::add_to_group(const std::size_t element, const unsigned int group)
  {
    sets[element] = set_with(sets[element], group);
  }



  unsigned int
  MeshFile::set_with(const unsigned int set, const unsigned int group)
  {
    const auto found = larger_sets.find({set, group});
    if (found != larger_sets.end())
      return found->second;

    std::vector<unsigned int> groups = group_sets[set];
    const auto place = std::lower_bound(groups.begin(), groups.end(), group);
    if (place == groups.end() || *place != group)
      groups.insert(place, group);
    const auto known = known_sets.insert({groups, group_sets.size()});
    if (known.second)
      group_sets.push_back(groups);
    return larger_sets[{set, group}] = known.first->second;
  }



  unsigned int
  MeshFile::dimension() const
  {
    unsigned int dim = 0;
    for (std::size_t e = 0; e < n_elements(); ++e)
      dim = std::max(dim, dimension(e));
    return dim;
  }



  std::string
  MeshFile::elements_in_words(const unsigned int dim) const
  {
    std::vector<std::size_t> numbers(element_types().size(), 0);
    for (const unsigned char type : types)
      ++numbers[type];

    std::string text;
    for (unsigned int t = 0; t < numbers.size(); ++t)
      if (numbers[t] > 0 && dimension_of(element_types()[t].shape) == dim)
        text += (text.empty() ? "" : ", ") + std::to_string(numbers[t]) + " " +
                element_types()[t].plural();
    for (const auto &[name, number] : unknown_types)
      text += (text.empty() ? "" : ", ") + std::to_string(number) +
              " elements of " + name;
    return text;
  }
} // namespace stickslip
