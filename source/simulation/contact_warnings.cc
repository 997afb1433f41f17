#include <stickslip/simulation/contact_warnings.h>

namespace stickslip
{
  ContactWarnings::ContactWarnings(
    const NamedList<ContactPairParameters> &pairs)
    : is_paired(pairs.size(), true)
    , was_paired(pairs.size(), false)
  {
    for (const auto &[name, pair] : pairs)
      {
        names.push_back(name);
        if (pair.has_friction() &&
            pair.regularization.factors(pair.quadrature).status_over_law() > 2.)
          about_parameters.push_back(
            "'Contact/" + name +
            "/Regularization/r_t status' is more than twice 'r_t law': points "
            "that slip against their traction satisfy the discrete equations. "
            "A step that converges to such a state will be rejected.");
      }
  }



  template <int dim>
  std::vector<std::string>
  ContactWarnings::of_step(
    const std::vector<ContactResultants<dim>> &resultants)
  {
    ++n_steps;
    std::vector<std::string> texts;
    for (unsigned int p = 0; p < resultants.size(); ++p)
      {
        const bool was_paired_before = is_paired[p];
        is_paired[p]  = resultants[p].n_unpaired < resultants[p].n_points;
        was_paired[p] = was_paired[p] || is_paired[p];
        if (was_paired_before && !is_paired[p])
          texts.push_back("no point of contact pair '" + names[p] +
                          "' has a master face opposite and near it: the slave "
                          "is far away, has slid off the master or has fallen "
                          "through it.");
      }
    return texts;
  }



  std::vector<std::string>
  ContactWarnings::at_end() const
  {
    std::vector<std::string> texts;
    for (unsigned int p = 0; n_steps > 0 && p < names.size(); ++p)
      if (!was_paired[p])
        texts.push_back("contact pair '" + names[p] +
                        "' has not acted: in none of the steps of this run " +
                        "had any of its points a master face opposite and "
                        "near it. Look at 'Slave boundary', 'Master boundary' "
                        "and 'Search distance' of 'Contact/" +
                        names[p] + "'.");
    return texts;
  }



  template std::vector<std::string>
  ContactWarnings::of_step(const std::vector<ContactResultants<2>> &);
  template std::vector<std::string>
  ContactWarnings::of_step(const std::vector<ContactResultants<3>> &);
} // namespace stickslip
