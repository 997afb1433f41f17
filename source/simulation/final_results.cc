#include <stickslip/simulation/final_results.h>

#include <stickslip/base/short_number.h>

#include <stickslip/contact/results/contact_results.h>

#include <stickslip/output/material_fields.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <map>
#include <ostream>

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
  FinalResults::add_of_pair(const std::string    &pair,
                            const NamedResultant &resultant)
  {
    const std::string full_name = pair + "." + resultant.name;
    switch (resultant.family)
      {
        case ResultantFamily::force:
          return add("force", full_name, resultant.value);
        case ResultantFamily::moment:
          return add(pair + ".moment", full_name, resultant.value);
        case ResultantFamily::position:
          return add(pair + ".position", full_name, resultant.value);
        case ResultantFamily::single:
          return add(full_name, full_name, resultant.value);
      }
  }



  NamedValues
  FinalResults::values() const
  {
    std::map<std::string, double> largest;
    for (unsigned int i = 0; i < named_values.size(); ++i)
      largest[families[i]] =
        std::max(largest[families[i]], std::abs(named_values[i].second));
    NamedValues results;
    for (unsigned int i = 0; i < named_values.size(); ++i)
      {
        const auto &[name, value] = named_values[i];
        const bool is_zero = std::abs(value) < roundoff * largest[families[i]];
        results.push_back({name, value, short_number(is_zero ? 0. : value)});
      }
    return results;
  }



  void
  FinalResults::print(std::ostream &out) const
  {
    for (const NamedResultValue &result : values())
      out << std::left << std::setw(39) << result.name << ' ' << result.text
          << '\n';
  }



  template <int dim>
  FinalResults
  final_results(const CaseParameters   &parameters,
                ContactProblem<dim>    &problem,
                const PointValues<dim> &point_values)
  {
    FinalResults results;
    const auto   faces = contact_results(problem.contact());
    for (const auto &result : point_values.named_values(
           problem.ghosted_displacement(),
           material_fields(problem.solid(), problem.ghosted_displacement()),
           faces))
      results.add(result.family, result.name, result.value);
    const auto resultants =
      compute_contact_resultants(faces,
                                 parameters.contact_pairs.size(),
                                 problem.contact().get_communicator(),
                                 problem.bodies().cross_section);
    for (unsigned int p = 0; p < resultants.size(); ++p)
      for (const NamedResultant &resultant : resultants[p].named_values())
        results.add_of_pair(parameters.contact_pairs[p].first, resultant);
    for (const auto &[name, reaction] : problem.reference_points())
      for (const auto &result : reaction.named_values())
        if (result.quantity != "moment") // which is a matter of equilibrium
          results.add(name, name + "." + result.name, result.value);
    for (const auto &[name, cut] : problem.cut_reactions())
      {
        results.add("force", name + ".force", cut.force);
        results.add(name, name + ".shortening", cut.shortening);
      }
    return results;
  }

  template FinalResults
  final_results(const CaseParameters &,
                ContactProblem<2> &,
                const PointValues<2> &);
  template FinalResults
  final_results(const CaseParameters &,
                ContactProblem<3> &,
                const PointValues<3> &);
} // namespace stickslip
