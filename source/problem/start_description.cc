#include <stickslip/problem/start_description.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

namespace stickslip
{
  namespace
  {
    /// Bodies whose sizes differ by this factor have different units.
    constexpr double other_unit = 100.;

    /// Bodies that are farther from each other than this times the larger
    /// one do not meet.
    constexpr double out_of_reach = 5.;

    /// Facets that change the overlap of a press fit by this fraction change
    /// its largest pressure by about a half.
    constexpr double tolerable_ripple = 0.02;

    /// Where surfaces only touch facets do not matter below this fraction of a
    /// face's size: curved faces of degree 2 have less.
    constexpr double negligible_ripple = 3e-4;

    template <int dim>
    double
    size_of(const BoundingBox<dim> &box)
    {
      return box.get_boundary_points().first.distance(
        box.get_boundary_points().second);
    }



    template <int dim>
    double
    distance_between(const BoundingBox<dim> &a, const BoundingBox<dim> &b)
    {
      Tensor<1, dim> way;
      for (unsigned int c = 0; c < dim; ++c)
        way[c] = std::max({0.,
                           a.lower_bound(c) - b.upper_bound(c),
                           b.lower_bound(c) - a.upper_bound(c)});
      return way.norm();
    }



    /// Points of surfaces that are to be bonded, but have nothing opposite;
    /// empty: none.
    template <int dim>
    std::string
    about_bond(const ContactPair<dim> &pair, const ContactAtStart<dim> &start)
    {
      if (!pair.parameters.is_bilateral() || start.n_paired == start.n_points)
        return "";
      const auto [low, high] = start.unpaired.get_boundary_points();
      std::ostringstream text;
      text << "contact pair '" << start.pair << "' ("
           << name_of(pair.parameters.law, all_pair_laws())
           << "): " << start.n_points - start.n_paired << " of "
           << start.n_points << " points of '" << start.slave_body
           << "' have nothing of '" << start.master_body
           << "' opposite and stay free: between (" << low << ") and (" << high
           << ").";
      return text.str();
    }



    bool
    have_common(const std::set<types::boundary_id> &a,
                const std::set<types::boundary_id> &b)
    {
      return std::any_of(a.begin(), a.end(), [&b](const auto id) {
        return b.count(id) > 0;
      });
    }



    /// What is wrong with two pairs together; empty: nothing.
    std::string
    about_pairs(const PairSurfaces &a, const PairSurfaces &b)
    {
      const auto share = [](const auto &slave,
                            const auto &master,
                            const auto &other_slave,
                            const auto &other_master) {
        return have_common(slave, other_slave) &&
               have_common(master, other_master);
      };
      if (share(a.slave, a.master, b.slave, b.master) ||
          share(a.slave, a.master, b.master, b.slave))
        return "have the same surfaces or parts of them: what touches "
               "there "
               "carries two pressures. Remove one of them.";
      if (a.have_common_faces() || b.have_common_faces())
        return ""; // who is slave there is nobody's choice
      if (have_common(a.slave, b.master) || have_common(a.master, b.slave))
        return "share a surface that is slave of one and master of the "
               "other: "
               "give it the same part in both, if it can touch both at the "
               "same place.";
      return "";
    }



    /// Why the surfaces of a pair without any partner may never meet;
    /// empty: they may.
    template <int dim>
    std::string
    about_distance(const ContactAtStart<dim> &start)
    {
      const double slave    = size_of(start.slave);
      const double master   = size_of(start.master);
      const double distance = distance_between(start.slave, start.master);
      const bool   has_other_unit =
        std::max(slave, master) > other_unit * std::min(slave, master);
      if (start.n_paired > 0 ||
          !(has_other_unit ||
            distance > out_of_reach * std::max(slave, master)))
        return "";
      std::ostringstream text;
      text << "the surfaces of contact pair '" << start.pair
           << "' can hardly meet: that of '" << start.slave_body
           << "' has the size " << slave << ", that of '" << start.master_body
           << "' the size " << master << ", and they are " << distance
           << " apart."
           << (has_other_unit ? " Do both meshes have the same unit of length?"
                              : "");
      return text.str();
    }



    /// Why the pressure of a press fit will be far off; empty: it will not.
    template <int dim>
    std::string
    about_facets(const ContactPairParameters &parameters,
                 const ContactAtStart<dim>   &start)
    {
      const double ripple = start.facet_ripple;
      // else the surfaces only touch, or do not
      const bool is_fit = start.mean_overlap > 3. * ripple;
      if (start.mean_overlap < -3. * ripple ||
          ripple <= (is_fit ? tolerable_ripple * start.mean_overlap
                            : negligible_ripple * start.face_size))
        return "";
      std::ostringstream text;
      text << "contact pair '" << start.pair
           << "': the cells do not match and follow the round surfaces so "
              "roughly that these overlap by "
           << start.mean_overlap << " in the mean, but by " << ripple
           << " more or less within a face (root mean square). Stiff bodies "
              "turn that into pressures that swing from node to node and may "
              "be many times too large. "
           << (parameters.has_curved_facets()
                 ? ""
                 : "'Facets = curved' takes the curves from the angles between "
                   "the faces; ")
           << "'Degree = 2' follows the curves of generators, second-order "
              "mesh files and 'Coordinates'; nodes that match have no such "
              "error; cells of half the size have a quarter of it, or less.";
      return text.str();
    }



    template <int dim>
    std::string
    description_of(const ContactAtStart<dim> &start)
    {
      std::ostringstream text;
      text << "contact pair '" << start.pair
           << "' at the start: " << start.n_paired << " of " << start.n_points
           << " points of '" << start.slave_body << "' have '"
           << start.master_body << "' opposite";
      if (start.n_open > 0)
        text << "; smallest gap " << start.smallest_gap << " at ("
             << start.gap_at << ")";
      if (start.largest_overlap > 0.)
        text << "; largest overlap " << start.largest_overlap << " at ("
             << start.overlap_at << ")";
      return text.str();
    }
  } // namespace



  template <int dim>
  std::vector<std::string>
  describe(const ContactAssembler<dim>            &contact,
           const std::vector<ContactAtStart<dim>> &start)
  {
    const std::string        warning = "Warning: ";
    const auto              &pairs   = contact.contact_pairs();
    std::vector<std::string> lines;
    std::string              far_away; // names
    for (unsigned int p = 0; p < pairs.size(); ++p)
      {
        const bool is_automatic = pairs[p]->parameters.is_automatic;
        if (is_automatic && start[p].n_paired == 0)
          {
            far_away += (far_away.empty() ? "'" : ", '") + start[p].pair + "'";
            continue;
          }
        lines.push_back(description_of(start[p]));
        const std::string alone = about_distance(start[p]);
        if (!alone.empty())
          lines.push_back(warning + alone);
        const std::string facets = about_facets(pairs[p]->parameters, start[p]);
        if (!facets.empty())
          lines.push_back(warning + facets);
        const std::string bond = about_bond(*pairs[p], start[p]);
        if (!bond.empty())
          lines.push_back(warning + bond);
        for (unsigned int q = 0; q < p; ++q)
          {
            // bodies of automatic pairs touch in different places
            if (is_automatic || pairs[q]->parameters.is_automatic)
              continue;
            const std::string together =
              about_pairs(pairs[q]->surfaces, pairs[p]->surfaces);
            if (!together.empty())
              lines.push_back(warning + "contact pairs '" + pairs[q]->name +
                              "' and '" + pairs[p]->name + "' " + together);
          }
      }
    if (!far_away.empty())
      lines.push_back("automatic contact: nothing opposite at the start for " +
                      far_away);
    return lines;
  }

#define INSTANTIATE(dim)                      \
  template std::vector<std::string> describe( \
    const ContactAssembler<dim> &, const std::vector<ContactAtStart<dim>> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
