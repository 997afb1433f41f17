#include <stickslip/base/nearest_name.h>

#include <algorithm>
#include <cctype>
#include <utility>

namespace stickslip
{
  namespace
  {
    std::string
    in_lower_case(std::string text)
    {
      for (char &letter : text)
        letter = std::tolower(static_cast<unsigned char>(letter));
      return text;
    }
  } // namespace



  unsigned int
  edit_distance(const std::string &first, const std::string &second)
  {
    const std::string a = in_lower_case(first), b = in_lower_case(second);

    // d[i][j] is the distance of the first i letters of a to the first j of b.
    std::vector<std::vector<unsigned int>> d(
      a.size() + 1, std::vector<unsigned int>(b.size() + 1));
    for (std::size_t i = 0; i <= a.size(); ++i)
      d[i][0] = i;
    for (std::size_t j = 0; j <= b.size(); ++j)
      d[0][j] = j;

    for (std::size_t i = 1; i <= a.size(); ++i)
      for (std::size_t j = 1; j <= b.size(); ++j)
        {
          const unsigned int replacement = (a[i - 1] == b[j - 1]) ? 0 : 1;
          d[i][j]                        = std::min(
            {d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + replacement});
          if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
            d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
        }
    return d[a.size()][b.size()];
  }



  std::vector<std::string>
  nearest_names(const std::string              &name,
                const std::vector<std::string> &known_names)
  {
    const std::string  wanted      = in_lower_case(name);
    const unsigned int n_tolerated = std::max<std::size_t>(1, name.size() / 3);

    std::vector<std::pair<unsigned int, std::string>> candidates;
    for (const std::string &known : known_names)
      {
        const std::string  other    = in_lower_case(known);
        const unsigned int distance = edit_distance(wanted, other);
        const bool is_part = std::min(wanted.size(), other.size()) > 3 &&
                             (other.find(wanted) != std::string::npos ||
                              wanted.find(other) != std::string::npos);

        if (distance <= n_tolerated)
          candidates.emplace_back(distance, known);
        else if (is_part)
          candidates.emplace_back(n_tolerated + 1, known);
      }
    // stable: names of equal distance stay in the order of their declaration
    std::stable_sort(candidates.begin(),
                     candidates.end(),
                     [](const auto &x, const auto &y) {
                       return x.first < y.first;
                     });

    std::vector<std::string> nearest;
    for (const auto &[distance, known] : candidates)
      if (nearest.size() < 3 && distance <= candidates.front().first + 1)
        nearest.push_back(known);
    return nearest;
  }



  std::string
  did_you_mean(const std::string              &name,
               const std::vector<std::string> &known_names)
  {
    const std::vector<std::string> nearest = nearest_names(name, known_names);

    std::string text;
    for (std::size_t i = 0; i < nearest.size(); ++i)
      {
        if (i > 0)
          text += (i + 1 == nearest.size()) ? " or " : ", ";
        text += "'" + nearest[i] + "'";
      }
    return text.empty() ? text : " Did you mean " + text + "?";
  }



  std::string
  quoted_list(const std::vector<std::string> &names)
  {
    std::string text;
    for (const std::string &name : names)
      text += (text.empty() ? "'" : ", '") + name + "'";
    return text.empty() ? "none" : text;
  }
} // namespace stickslip
