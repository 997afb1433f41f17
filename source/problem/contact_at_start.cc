#include <stickslip/problem/contact_at_start.h>

#include <stickslip/base/user_error.h>

#include <stickslip/problem/overlaps_at_start.h>

#include <stickslip/contact/pairing/segment_depth.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

namespace stickslip
{
  namespace
  {
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



    /// Around the @p points of all ranks; the box of a point if there are none.
    template <int dim>
    BoundingBox<dim>
    box_around(const std::vector<Point<dim>> &points,
               const MPI_Comm                &communicator)
    {
      Point<dim> low, high;
      for (unsigned int c = 0; c < dim; ++c)
        {
          low[c]  = std::numeric_limits<double>::max();
          high[c] = std::numeric_limits<double>::lowest();
          for (const auto &p : points)
            {
              low[c]  = std::min(low[c], p[c]);
              high[c] = std::max(high[c], p[c]);
            }
          low[c]  = Utilities::MPI::min(low[c], communicator);
          high[c] = Utilities::MPI::max(high[c], communicator);
        }
      if (low[0] > high[0])
        return BoundingBox<dim>();
      return BoundingBox<dim>({low, high});
    }



    template <int dim, typename Faces, typename FaceOf>
    BoundingBox<dim>
    box_of_surface(const Faces    &faces,
                   const FaceOf   &face_of,
                   const MPI_Comm &communicator)
    {
      std::vector<Point<dim>> points;
      for (const auto &face : faces)
        for (const auto &p : face_of(face).reference_positions)
          points.push_back(p);
      return box_around(points, communicator);
    }



    /// Of one pair in the present configuration; @p depths as in GapOffsets.
    template <int dim>
    ContactAtStart<dim>
    look_at_pair(ContactAssembler<dim>  &contact,
                 const ContactPair<dim> &pair,
                 std::vector<double>    &depths)
    {
      ContactAtStart<dim>     start;
      const MPI_Comm         &communicator = contact.get_communicator();
      Extremes<dim>           extremes;
      std::vector<Point<dim>> without_partner;
      for (const auto &point : pair.points)
        {
          ++start.n_points;
          depths.push_back(0.);
          const Point<dim> x(point.geometry.reference_position);
          if (!point.pairing.paired)
            {
              without_partner.push_back(x);
              continue;
            }
          ++start.n_paired;
          const double d_n = contact.evaluate(pair, point).kinematics.d_n;
          depths.back()    = d_n;
          // averages of dual functions are nearer where surfaces are round
          extremes.add(pair.mortar ? node_depth(pair, point).value_or(d_n)
                                   : d_n,
                       x);
        }
      if (pair.mortar)
        {
          // a node that touches is between integration points
          const Extremes<dim> of_nodes = extremes;
          extremes = look_at_segments(pair, communicator, start);
          extremes.take_gaps(of_nodes);
        }
      take_largest(extremes.overlap, extremes.overlap_at, communicator);
      take_largest(extremes.nearest, extremes.gap_at, communicator);
      start.n_open          = extremes.n_open;
      start.largest_overlap = extremes.overlap;
      start.overlap_at      = extremes.overlap_at;
      start.gap_at          = extremes.gap_at;
      start.smallest_gap    = std::max(0., -extremes.nearest);
      for (unsigned int *count :
           {&start.n_points, &start.n_paired, &start.n_open})
        *count = Utilities::MPI::sum(*count, communicator);
      start.unpaired    = box_around(without_partner, communicator);
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



    /// A bond without anything that it could bind.
    template <int dim>
    void
    check_partners(const ContactPair<dim>    &pair,
                   const ContactAtStart<dim> &start)
    {
      if (!pair.parameters.is_bilateral() || start.n_paired > 0)
        return;
      std::ostringstream text;
      text << "'Contact/" << pair.name
           << "/Law = " << name_of(pair.parameters.law, all_pair_laws())
           << "': none of the " << start.n_points << " points of '"
           << start.slave_body << "' has '" << start.master_body
           << "' opposite at the start, within the search distance "
           << pair.patch->tolerances.search_distance
           << ". Do the surfaces meet? Else set 'Search distance'.";
      throw UserError(text.str());
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
    if (contact.choose_sides())
      contact.configure(u, u, lambda);

    std::vector<ContactAtStart<dim>> start;
    for (const auto &pair : contact.contact_pairs())
      {
        std::vector<double> depths;
        start.push_back(look_at_pair(contact, *pair, depths));
        check_overlap(*pair, start.back());
        check_partners(*pair, start.back());
        pair->set_start(depths);
      }
    return start;
  }

#define INSTANTIATE(dim)                                     \
  template std::vector<ContactAtStart<dim>> look_at_contact( \
    ContactAssembler<dim> &, const DofLayout<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
