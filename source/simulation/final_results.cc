#include <stickslip/simulation/final_results.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <map>
#include <ostream>
#include <sstream>

namespace stickslip
{
  namespace
  {
    /// Fraction of the largest value of a family that counts as roundoff.
    constexpr double roundoff = 1e-8;
  } // namespace



  void
  FinalResults::add(const std::string &family,
                    const std::string &name,
                    const double       value)
  {
    families.push_back(family);
    named_values.emplace_back(name, value);
  }



  void
  FinalResults::add_of_pair(const std::string &pair,
                            const std::string &name,
                            const double       value)
  {
    const std::string full     = pair + "." + name;
    const bool        is_force = name.find("force") != std::string::npos;
    const bool is_vector = name.size() > 2 && name[name.size() - 2] == '_';
    add(is_force    ? "force"
        : is_vector ? full.substr(0, full.size() - 2)
                    : full,
        full,
        value);
  }



  void
  FinalResults::print(std::ostream &out) const
  {
    std::map<std::string, double> largest;
    for (unsigned int i = 0; i < named_values.size(); ++i)
      largest[families[i]] =
        std::max(largest[families[i]], std::abs(named_values[i].second));
    for (unsigned int i = 0; i < named_values.size(); ++i)
      {
        const auto &[name, value] = named_values[i];
        std::ostringstream number;
        number << std::setprecision(6)
               << (std::abs(value) < roundoff * largest[families[i]] ? 0.
                                                                     : value);
        out << std::left << std::setw(39) << name << ' ' << number.str()
            << '\n';
      }
  }
} // namespace stickslip
