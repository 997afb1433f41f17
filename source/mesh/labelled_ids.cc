#include <stickslip/mesh/labelled_ids.h>

#include <algorithm>
#include <cctype>

namespace stickslip
{
  namespace
  {
    std::string
    lower_case(std::string text)
    {
      std::transform(text.begin(),
                     text.end(),
                     text.begin(),
                     [](const unsigned char c) { return std::tolower(c); });
      return text;
    }
  } // namespace



  bool
  is_id(const std::string &label)
  {
    return !label.empty() && label.size() <= 9 &&
           label.find_first_not_of("0123456789") == std::string::npos;
  }



  void
  LabelledIds::add(const GroupLabel &label, const unsigned int id)
  {
    if (label.number >= 0)
      ids_of_number[label.number].insert(id);
    if (!label.name.empty())
      {
        ids_of_name[label.name].insert(id);
        number_of_name.insert({label.name, label.number});
      }
  }



  unsigned int
  LabelledIds::id_of(const std::vector<GroupLabel> &groups)
  {
    if (groups.empty())
      return 0;
    unsigned int id = 0;
    if (groups.size() == 1 && groups[0].number >= 0)
      id = groups[0].number;
    else
      {
        id                   = next_own_id++;
        const auto first     = std::find_if(groups.begin(),
                                        groups.end(),
                                        [](const GroupLabel &group) {
                                          return group.number >= 0;
                                        });
        number_of_own_id[id] = first == groups.end() ? 0 : first->number;
      }
    for (const GroupLabel &group : groups)
      add(group, id);
    return id;
  }



  unsigned int
  LabelledIds::id_of(const std::string &label)
  {
    if (is_id(label))
      {
        const unsigned int id = std::stoi(label);
        ids_of_number[id].insert(id);
        return id;
      }
    const auto known = own_id_of_name.insert({label, next_own_id});
    if (known.second)
      {
        add({-1, label}, next_own_id);
        number_of_own_id[next_own_id++] = 0;
      }
    return known.first->second;
  }



  std::set<unsigned int>
  LabelledIds::ids(const std::string &label) const
  {
    if (is_id(label))
      {
        const unsigned int id     = std::stoi(label);
        const auto         number = ids_of_number.find(id);
        return number == ids_of_number.end() ? std::set<unsigned int>{id}
                                             : number->second;
      }
    const auto name = ids_of_name.find(label);
    if (name != ids_of_name.end())
      return name->second;

    std::set<unsigned int> result;
    unsigned int           n_names = 0;
    for (const auto &[other, ids] : ids_of_name)
      if (lower_case(other) == lower_case(label))
        {
          result = ids;
          ++n_names;
        }
    return n_names == 1 ? result : std::set<unsigned int>();
  }



  unsigned int
  LabelledIds::number(const unsigned int id) const
  {
    const auto own = number_of_own_id.find(id);
    return own == number_of_own_id.end() ? id : own->second;
  }



  std::vector<std::string>
  LabelledIds::names(const std::set<unsigned int> &present) const
  {
    std::vector<std::string> result;
    for (const auto &[name, ids] : ids_of_name)
      if (std::any_of(ids.begin(), ids.end(), [&](const unsigned int id) {
            return present.count(id) > 0;
          }))
        result.push_back(name);
    return result;
  }



  std::string
  LabelledIds::in_words(const std::set<unsigned int> &present) const
  {
    std::string            text;
    std::set<unsigned int> named;
    for (const std::string &name : names(present))
      {
        const auto number = number_of_name.find(name);
        text += (text.empty() ? "'" : ", '") + name + "'";
        if (number != number_of_name.end() && number->second >= 0)
          {
            text += " (" + std::to_string(number->second) + ")";
            named.insert(number->second);
          }
      }
    std::set<unsigned int> numbers;
    for (const unsigned int id : present)
      if (id < first_own_id)
        numbers.insert(id);
    for (const auto &[number, ids] : ids_of_number)
      for (const unsigned int id : ids)
        if (present.count(id) > 0)
          numbers.insert(number);
    for (const unsigned int number : numbers)
      if (named.count(number) == 0)
        text += (text.empty() ? "" : ", ") + std::to_string(number);
    return text.empty() ? "none" : text;
  }
} // namespace stickslip
