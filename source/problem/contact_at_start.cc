#include <stickslip/problem/contact_at_start.h>

#include <stickslip/base/user_error.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <sstream>
#include <utility>

namespace stickslip
{
  namespace
  {
    /// Bodies whose sizes differ by this factor have different units.
    constexpr double other_unit = 100.;

    /// Bodies that are farther from each other than this times the larger one
    /// do not meet.
    constexpr double out_of_reach = 5.;

    /// Gaps below this fraction of a position are roundoff.
    constexpr double smallest_gap_seen = 1e-12;



    /// The largest @p value over ranks that have any, and where it is.
    template <int dim>
    void
    take_largest(double &value, Point<dim> &where, const MPI_Comm &communicator)
    {
      const auto of_ranks =
        Utilities::MPI::all_gather(communicator, std::make_pair(value, where));
      for (const auto &[other, at] : of_ranks)
        if (other > value)
          {
            value = other;
            where = at;
          }
      // all ranks take the first of equal ones
      for (const auto &[other, at] : of_ranks)
        if (other == value)
          {
            where = at;
            return;
          }
    }



    template <int dim, typename Faces, typename FaceOf>
    BoundingBox<dim>
    box_of_surface(const Faces    &faces,
                   const FaceOf   &face_of,
                   const MPI_Comm &communicator)
    {
      Point<dim> low, high;
      for (unsigned int c = 0; c < dim; ++c)
        {
          low[c]  = std::numeric_limits<double>::max();
          high[c] = std::numeric_limits<double>::lowest();
          for (const auto &face : faces)
            for (const auto &p : face_of(face).reference_positions)
              {
                low[c]  = std::min(low[c], p[c]);
                high[c] = std::max(high[c], p[c]);
              }
          low[c]  = Utilities::MPI::min(low[c], communicator);
          high[c] = Utilities::MPI::max(high[c], communicator);
        }
      return BoundingBox<dim>({low, high});
    }



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



    /// Of one pair in the present configuration; @p depths as in GapOffsets.
    template <int dim>
    ContactAtStart<dim>
    look_at_pair(ContactAssembler<dim>  &contact,
                 const ContactPair<dim> &pair,
                 std::vector<double>    &depths)
    {
      ContactAtStart<dim> start;
      const MPI_Comm     &communicator = contact.get_communicator();
      double              nearest      = std::numeric_limits<double>::lowest();
      for (const auto &point : pair.points)
        {
          ++start.n_points;
          depths.push_back(0.);
          if (!point.pairing.paired)
            continue;
          ++start.n_paired;
          const Point<dim> x(point.geometry.reference_position);
          double           d_n = contact.evaluate(pair, point).kinematics.d_n;
          depths.back()        = d_n;
          if (std::abs(d_n) < smallest_gap_seen * x.norm())
            d_n = 0.;
          if (d_n > start.largest_overlap)
            {
              start.largest_overlap = d_n;
              start.overlap_at      = x;
            }
          if (d_n <= 0.)
            ++start.n_open;
          if (d_n <= 0. && d_n > nearest)
            {
              nearest      = d_n;
              start.gap_at = x;
            }
        }
      take_largest(start.largest_overlap, start.overlap_at, communicator);
      take_largest(nearest, start.gap_at, communicator);
      start.smallest_gap = std::max(0., -nearest);
      for (unsigned int *count :
           {&start.n_points, &start.n_paired, &start.n_open})
        *count = Utilities::MPI::sum(*count, communicator);
      start.pair        = pair.name;
      start.slave_body  = pair.parameters.slave_body;
      start.master_body = pair.parameters.master_body;
      start.slave       = box_of_surface<dim>(
        pair.slave_faces,
        [](const auto &slave) -> const auto       &{ return slave.face; },
        communicator);
      start.master = box_of_surface<dim>(
        pair.patch->owned_faces(),
        [](const auto &face) -> const auto & { return face; },
        communicator);
      return start;
    }



    template <int dim>
    void
    check_overlap(const ContactPair<dim>    &pair,
                  const ContactAtStart<dim> &start)
    {
      const double largest = pair.parameters.initial_gaps.largest_overlap;
      if (largest == 0. || start.largest_overlap <= largest)
        return;
      std::ostringstream text;
      text << "'Contact/" << pair.name << "/Largest initial overlap' is "
           << largest << ", but the meshes of '" << start.slave_body
           << "' and '" << start.master_body << "' overlap by "
           << start.largest_overlap << " at (" << start.overlap_at << ").";
      throw UserError(text.str());
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
        return "have the same surfaces or parts of them: what touches there "
               "carries two pressures. Remove one of them.";
      if (have_common(a.slave, b.master) || have_common(a.master, b.slave))
        return "share a surface that is slave of one and master of the other: "
               "give it the same part in both, if it can touch both at the "
               "same place.";
      return "";
    }



    /// Why the surfaces of a pair without any partner may never meet; empty:
    /// they may.
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
  std::vector<ContactAtStart<dim>>
  look_at_contact(ContactAssembler<dim> &contact, const DofLayout<dim> &dofs)
  {
    const MPI_Comm  &communicator = contact.get_communicator();
    const auto      &multipliers  = contact.multipliers();
    LA::Vector       u(dofs.owned, dofs.relevant, communicator);
    const LA::Vector lambda(multipliers.locally_owned(),
                            multipliers.locally_relevant(),
                            communicator);
    contact.update_patches(u, true);
    u.reinit(dofs.owned, contact.needed_displacements(), communicator);
    contact.configure(u, u, lambda);

    std::vector<ContactAtStart<dim>> start;
    for (const auto &pair : contact.contact_pairs())
      {
        std::vector<double> depths;
        start.push_back(look_at_pair(contact, *pair, depths));
        check_overlap(*pair, start.back());
        pair->set_depths_at_start(depths);
      }
    return start;
  }



  template <int dim>
  std::vector<std::string>
  describe(const ContactAssembler<dim>            &contact,
           const std::vector<ContactAtStart<dim>> &start)
  {
    const std::string        warning = "Warning: ";
    const auto              &pairs   = contact.contact_pairs();
    std::vector<std::string> lines;
    for (unsigned int p = 0; p < pairs.size(); ++p)
      {
        lines.push_back(description_of(start[p]));
        const std::string alone = about_distance(start[p]);
        if (!alone.empty())
          lines.push_back(warning + alone);
        for (unsigned int q = 0; q < p; ++q)
          {
            const std::string together =
              about_pairs(pairs[q]->surfaces, pairs[p]->surfaces);
            if (!together.empty())
              lines.push_back(warning + "contact pairs '" + pairs[q]->name +
                              "' and '" + pairs[p]->name + "' " + together);
          }
      }
    return lines;
  }

#define INSTANTIATE(dim)                                     \
  template std::vector<ContactAtStart<dim>> look_at_contact( \
    ContactAssembler<dim> &, const DofLayout<dim> &);        \
  template std::vector<std::string> describe(                \
    const ContactAssembler<dim> &, const std::vector<ContactAtStart<dim>> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
