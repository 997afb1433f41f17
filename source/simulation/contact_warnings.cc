#include <stickslip/simulation/contact_warnings.h>

#include <algorithm>

namespace stickslip
{
  namespace
  {
    /// What is known to be inaccurate about the rule of a pair; empty: nothing.
    std::string
    about_rule(const ContactPairParameters &pair, const bool master_is_rigid)
    {
      if (master_is_rigid)
        return ""; // its own nodes need no pressure
      switch (pair.quadrature)
        {
          case ContactRule::nodal:
            return "single nodes carry what belongs to their neighbours: a "
                   "flat patch test is 16 % off, the largest pressure of "
                   "Hertz' contact 7 to 8 %";
          case ContactRule::Gauss:
            return "the pressure swings from node to node: a flat patch test "
                   "is 1.5 % off with two points, the pressure of Hertz' "
                   "contact 2 to 7 % in the mean square";
          default:
            return "";
        }
    }
  } // namespace



  ContactWarnings::ContactWarnings(
    const NamedList<ContactPairParameters> &pairs,
    const NamedList<BodyParameters>        &bodies)
    : is_paired(pairs.size(), true)
    , was_paired(pairs.size(), false)
    , was_closed(pairs.size(), false)
  {
    for (const auto &[name, pair] : pairs)
      {
        names.push_back(name);
        may_be_far.push_back(pair.is_automatic ||
                             pair.slave_body == pair.master_body);
        may_stay_far.push_back(
          pair.is_automatic ||
          (may_be_far.back() && pair.slave_boundary == pair.master_boundary));
        const std::string path = "'Contact/" + name;
        const auto        master =
          std::find_if(bodies.begin(),
                       bodies.end(),
                       [&wanted = pair.master_body](const auto &body) {
                         return body.first == wanted;
                       });
        const std::string rule = about_rule(
          pair, master != bodies.end() && master->second.moves_as_a_whole());
        if (!rule.empty())
          about_parameters.push_back(
            path +
            "/Quadrature = " + name_of(pair.quadrature, all_contact_rules()) +
            "': where the faces of the two surfaces do not match, " + rule +
            ". 'segments' is exact.");
        if (pair.normals == Normals::facet && !pair.has_segments())
          about_parameters.push_back(
            path +
            "/Normals = facet': what slides over a curved master "
            "surface is braked where normals jump between facets, "
            "without friction, too (by 1 % of the normal force in an "
            "ironing test). 'smoothed' normals and 'Quadrature = "
            "segments' do not.");
        if (pair.has_friction() &&
            pair.regularization.factors(pair.quadrature).status_over_law() > 2.)
          about_parameters.push_back(
            path +
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
        was_closed[p] = was_closed[p] || resultants[p].n_closed() > 0;
        if (was_paired_before && !is_paired[p] && !may_be_far[p])
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
      if (may_stay_far[p])
        continue; // most of these are there in case that bodies come near
      else if (!was_paired[p])
        texts.push_back("contact pair '" + names[p] +
                        "' has not acted: in none of the steps of this run " +
                        "had any of its points a master face opposite and "
                        "near it. Look at 'Slave boundary', 'Master boundary' "
                        "and 'Search distance' of 'Contact/" +
                        names[p] + "'.");
      else if (!was_closed[p])
        texts.push_back("contact pair '" + names[p] +
                        "' has never touched: its gap was open at all points " +
                        "at the end of each step of this run.");
    return texts;
  }



  template std::vector<std::string>
  ContactWarnings::of_step(const std::vector<ContactResultants<2>> &);
  template std::vector<std::string>
  ContactWarnings::of_step(const std::vector<ContactResultants<3>> &);
} // namespace stickslip
