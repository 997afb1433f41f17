#include <stickslip/simulation/pair_checks.h>

#include <stickslip/base/user_error.h>

#include <algorithm>
#include <string>
#include <vector>

namespace stickslip
{
  namespace
  {
    bool
    have_common(const std::vector<std::string> &a,
                const std::vector<std::string> &b)
    {
      return std::find_first_of(a.begin(), a.end(), b.begin(), b.end()) !=
             a.end();
    }
  } // namespace



  void
  check_pairs_differ(const NamedList<ContactPairParameters> &pairs)
  {
    for (auto second = pairs.begin(); second != pairs.end(); ++second)
      for (auto first = pairs.begin(); first != second; ++first)
        {
          const ContactPairParameters &a = first->second, &b = second->second;
          if (a.slave_body == b.slave_body && a.master_body == b.master_body &&
              have_common(a.slave_boundary, b.slave_boundary) &&
              have_common(a.master_boundary, b.master_boundary))
            throw UserError("'Contact/" + first->first + "' and 'Contact/" +
                            second->first +
                            "' have the same slave and master surface, or "
                            "parts of them. One pair is enough; name other "
                            "boundaries, or remove one of them.");
        }
  }



  void
  check_pairs_suit(const Algorithm                         algorithm,
                   const NamedList<ContactPairParameters> &pairs)
  {
    if (!needs_law_per_multiplier(algorithm))
      return;
    const std::string algorithm_is =
      "'Algorithm/Name = " + name_of(algorithm) + "' ";
    for (const auto &[name, pair] : pairs)
      {
        const std::string path = "'Contact/" + name;
        if (!has_one_multiplier_per_point(pair.quadrature))
          throw UserError(path + "/Quadrature' = " +
                          name_of(pair.quadrature, all_contact_rules()) + ": " +
                          algorithm_is +
                          "needs 'segments' or 'nodal', where the law holds "
                          "at each multiplier.");
        if (pair.is_bilateral())
          throw UserError(path +
                          "/Law = " + name_of(pair.law, all_pair_laws()) +
                          "': " + algorithm_is +
                          "knows 'contact' only. Take another algorithm.");
      }
  }
} // namespace stickslip
