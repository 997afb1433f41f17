#include <stickslip/solid/history_fields.h>

#include <deal.II/base/numbers.h>

#include <algorithm>

namespace stickslip
{
  namespace
  {
    bool
    is_out_of_plane_shear(const std::string &name)
    {
      const std::string end =
        name.substr(name.size() < 3 ? 0 : name.size() - 3);
      return end == "_xz" || end == "_yz";
    }
  } // namespace



  HistoryFields::HistoryFields(
    const std::vector<std::shared_ptr<const ConstitutiveLaw>> &laws,
    const unsigned int                                         dim)
    : places(laws.size())
  {
    for (unsigned int m = 0; m < laws.size(); ++m)
      if (laws[m])
        for (const std::string &name : laws[m]->history_names())
          {
            if (dim == 2 && is_out_of_plane_shear(name))
              {
                places[m].push_back(numbers::invalid_unsigned_int);
                continue;
              }
            const auto known =
              std::find(all_names.begin(), all_names.end(), name);
            places[m].push_back(known - all_names.begin());
            if (known == all_names.end())
              all_names.push_back(name);
          }
  }



  const std::vector<std::string> &
  HistoryFields::names() const
  {
    return all_names;
  }



  std::vector<double>
  HistoryFields::values(const unsigned int             material,
                        const ArrayView<const double> &history) const
  {
    AssertDimension(history.size(), places[material].size());
    std::vector<double> result(all_names.size(), 0.);
    for (unsigned int v = 0; v < places[material].size(); ++v)
      if (places[material][v] != numbers::invalid_unsigned_int)
        result[places[material][v]] = history[v];
    return result;
  }
} // namespace stickslip
