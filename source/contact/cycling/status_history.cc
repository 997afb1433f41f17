#include <stickslip/contact/cycling/status_history.h>

#include <stickslip/base/mixed_bits.h>

#include <algorithm>

namespace stickslip
{
  namespace
  {
    // Layout of a code: state, sense of slip, master facet.
    constexpr std::uint32_t state_bits     = 0x3;
    constexpr std::uint32_t direction_bits = 0xc;
    constexpr unsigned int  facet_shift    = 4;

    // Values of direction_bits.
    constexpr std::uint32_t no_direction = 0x0;
    constexpr std::uint32_t forward      = 0x4;
    constexpr std::uint32_t backward     = 0x8;



    std::uint64_t
    hash_of(const FaceId &face, const std::uint64_t start)
    {
      std::uint64_t hash = mixed_bits(start + face.face);
      for (const unsigned int word : face.cell)
        hash = mixed_bits(hash ^ word);
      return hash;
    }



    /// Entry @p age of a ring with @p n entries so far; 0 is the last one.
    template <typename Ring>
    auto
    past(const Ring &ring, const unsigned int n, const unsigned int age)
    {
      return ring[(n - 1 - age) % ring.size()];
    }



    /// Smallest period from 2 to @p longest with which the last @p n_periods
    /// periods of a ring repeat and do not stay the same; 0 if there is none.
    template <typename Ring>
    unsigned int
    period_of(const Ring        &ring,
              const unsigned int n,
              const unsigned int longest,
              const unsigned int n_periods)
    {
      const unsigned int n_kept = std::min<unsigned int>(n, ring.size());
      for (unsigned int period = 2;
           period <= longest && n_periods * period <= n_kept;
           ++period)
        {
          bool is_constant = true, repeats = true;
          for (unsigned int age = 1; age < period; ++age)
            is_constant = is_constant && past(ring, n, age) == past(ring, n, 0);
          for (unsigned int age = 0; age < (n_periods - 1) * period; ++age)
            repeats =
              repeats && past(ring, n, age) == past(ring, n, age + period);
          if (repeats && !is_constant)
            return period;
        }
      return 0;
    }



    ContactState
    state_of(const std::uint32_t code)
    {
      return static_cast<ContactState>(code & state_bits);
    }



    char
    letter(const std::uint32_t code)
    {
      switch (state_of(code))
        {
          case ContactState::unpaired:
            return 'u';
          case ContactState::open:
            return 'o';
          case ContactState::stick:
            return 's';
          default:
            break;
        }
      const std::uint32_t direction = code & direction_bits;
      return direction == no_direction ? 'c' : direction == forward ? 'f' : 'b';
    }



    /// The last @p period entries of a ring alternate in this.
    template <typename Ring>
    CycleKind
    kind_of(const Ring &ring, const unsigned int n, const unsigned int period)
    {
      const auto is_constant = [&](const auto &property) {
        for (unsigned int age = 1; age < period; ++age)
          if (property(past(ring, n, age)) != property(past(ring, n, 0)))
            return false;
        return true;
      };
      const auto is_paired = [](const std::uint32_t code) {
        return state_of(code) != ContactState::unpaired;
      };
      const auto is_closed = [](const std::uint32_t code) {
        return state_of(code) == ContactState::stick ||
               state_of(code) == ContactState::slip;
      };
      const auto direction = [](const std::uint32_t code) {
        return code & direction_bits;
      };
      if (!is_constant(is_paired))
        return CycleKind::pairing;
      if (!is_constant(is_closed))
        return CycleKind::contact;
      if (!is_constant(state_of))
        return CycleKind::stick;
      if (!is_constant(direction))
        return CycleKind::direction;
      return CycleKind::facet;
    }
  } // namespace



  std::string
  name_of(const CycleKind kind)
  {
    switch (kind)
      {
        case CycleKind::pairing:
          return "paired/unpaired";
        case CycleKind::contact:
          return "contact/open";
        case CycleKind::stick:
          return "stick/slip";
        case CycleKind::direction:
          return "forward/backward slip";
        case CycleKind::facet:
          break;
      }
    return "facet to facet";
  }



  std::string
  name_of(const PointTreatment treatment)
  {
    switch (treatment)
      {
        case PointTreatment::other_r_n:
          return "another r_n";
        case PointTreatment::other_r_t:
          return "another r_t";
        case PointTreatment::fixed_closed:
          return "fixed closed";
        case PointTreatment::fixed_open:
          return "fixed open";
        case PointTreatment::fixed_stick:
          return "fixed in stick";
        case PointTreatment::fixed_slip:
          return "fixed in slip";
        case PointTreatment::none:
          break;
      }
    return "";
  }



  template <int dim>
  void
  StatusHistory<dim>::clear()
  {
    forget_records();
    treatments.clear();
  }



  template <int dim>
  void
  StatusHistory<dim>::forget_records()
  {
    n_recorded = 0;
    for (auto &of_pair : points)
      for (auto &records : of_pair)
        {
          records.last_direction = Tensor<1, dim>();
          records.is_backward    = false;
        }
  }



  template <int dim>
  void
  StatusHistory<dim>::name_points(const ContactAssembler<dim> &contact)
  {
    for (unsigned int p = 0; p < contact.contact_pairs().size(); ++p)
      {
        const ContactPair<dim> &pair = *contact.contact_pairs()[p];
        points.emplace_back(pair.points.size());
        for (unsigned int i = 0; i < pair.points.size(); ++i)
          {
            const auto &point      = pair.points[i];
            points[p][i].name_hash = mixed_bits(
              hash_of(pair.slave_faces[point.geometry.slave_face].face.id, p) ^
              point.geometry.quadrature_index);
          }
      }
  }



  template <int dim>
  typename StatusHistory<dim>::Code
  StatusHistory<dim>::encode(const ContactPoint<dim> &point,
                             PointRecords            &records)
  {
    Code        code      = static_cast<Code>(point.observed.state);
    const auto &direction = point.observed.slip_direction;
    if (direction.norm_square() > 0.)
      {
        if (direction * records.last_direction < 0.)
          records.is_backward = !records.is_backward;
        records.last_direction = direction;
        code |= records.is_backward ? backward : forward;
      }
    if (point.pairing.paired)
      code |= static_cast<Code>(
        hash_of(point.pairing.face_id, point.pairing.is_interior())
        << facet_shift);
    return code;
  }



  template <int dim>
  void
  StatusHistory<dim>::record(const ContactAssembler<dim> &contact)
  {
    if (points.empty())
      name_points(contact);
    const unsigned int slot = n_recorded % capacity;
    std::uint64_t      hash = 0;
    for (unsigned int p = 0; p < points.size(); ++p)
      for (unsigned int i = 0; i < points[p].size(); ++i)
        {
          PointRecords &records = points[p][i];
          records.codes[slot] =
            encode(contact.contact_pairs()[p]->points[i], records);
          hash ^= mixed_bits(records.name_hash ^ records.codes[slot]);
        }
    const int error = MPI_Allreduce(&hash,
                                    &hashes[slot],
                                    1,
                                    MPI_UINT64_T,
                                    MPI_BXOR,
                                    contact.get_communicator());
    AssertThrowMPI(error);
    ++n_recorded;
  }



  template <int dim>
  StatusCycle
  StatusHistory<dim>::cycle() const
  {
    return {period_of(hashes, n_recorded, longest_period, n_periods)};
  }



  template <int dim>
  std::vector<PointCycle>
  StatusHistory<dim>::cycling_points() const
  {
    std::vector<PointCycle> result;
    for (unsigned int p = 0; p < points.size(); ++p)
      for (unsigned int i = 0; i < points[p].size(); ++i)
        {
          const auto        &codes = points[p][i].codes;
          const unsigned int period =
            period_of(codes, n_recorded, longest_period, n_periods);
          if (period == 0)
            continue;
          bool changes_facet = false;
          for (unsigned int age = 0; age < period; ++age)
            changes_facet =
              changes_facet || past(codes, n_recorded, age) >> facet_shift !=
                                 past(codes, n_recorded, 0) >> facet_shift;
          result.push_back(
            {p, i, kind_of(codes, n_recorded, period), period, changes_facet});
        }
    return result;
  }



  template <int dim>
  std::string
  StatusHistory<dim>::text(const unsigned int pair,
                           const unsigned int point) const
  {
    std::string letters;
    for (unsigned int age = std::min(n_recorded, capacity); age-- > 0;)
      letters += letter(past(points[pair][point].codes, n_recorded, age));
    return letters;
  }



  template <int dim>
  void
  StatusHistory<dim>::note_treatment(const unsigned int   pair,
                                     const unsigned int   point,
                                     const PointTreatment treatment)
  {
    treatments[{pair, point}] = treatment;
  }



  template <int dim>
  PointTreatment
  StatusHistory<dim>::treatment(const unsigned int pair,
                                const unsigned int point) const
  {
    const auto found = treatments.find({pair, point});
    return found == treatments.end() ? PointTreatment::none : found->second;
  }



  template <int dim>
  unsigned int
  StatusHistory<dim>::n_facet_changes(const unsigned int pair,
                                      const unsigned int point) const
  {
    const auto  &codes = points[pair][point].codes;
    unsigned int n     = 0;
    for (unsigned int age = 1; age < std::min(n_recorded, capacity); ++age)
      n += past(codes, n_recorded, age) >> facet_shift !=
           past(codes, n_recorded, age - 1) >> facet_shift;
    return n;
  }

  template class StatusHistory<2>;
  template class StatusHistory<3>;
} // namespace stickslip
