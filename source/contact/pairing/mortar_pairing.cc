#include <stickslip/contact/pairing/mortar_pairing.h>

namespace stickslip
{
  namespace
  {
    /// The segments with the present numbers of the master faces, without
    /// those whose master is out of reach.
    template <int dim>
    FaceSegments<dim>
    relocated_segments(const FaceSegments<dim> &before,
                       const MasterPatch<dim>  &patch)
    {
      FaceSegments<dim> after;
      after.is_partial = before.is_partial;
      std::vector<unsigned int> number(before.masters.size());
      std::vector<bool>         is_there(before.masters.size());
      for (unsigned int i = 0; i < before.masters.size(); ++i)
        {
          const unsigned int m = patch.index_of(before.master_ids[i]);
          is_there[i]          = m < patch.n_faces();
          number[i]            = after.masters.size();
          if (!is_there[i])
            continue;
          after.masters.push_back(m);
          after.master_ids.push_back(before.master_ids[i]);
        }
      for (SegmentPoint<dim> point : before.points)
        if (is_there[point.master])
          {
            point.master = number[point.master];
            after.points.push_back(point);
          }
      for (SegmentEnd<dim> end : before.ends)
        if (is_there[end.master])
          {
            end.master = number[end.master];
            after.ends.push_back(end);
          }
      return after;
    }
  } // namespace



  template <int dim>
  std::shared_ptr<const MortarPairing<dim>>
  relocated(const MortarPairing<dim> &pairing, const MasterPatch<dim> &patch)
  {
    const auto segments =
      std::make_shared<typename MortarPairing<dim>::Segments>();
    for (const FaceSegments<dim> &of_face : *pairing.segments)
      segments->push_back(relocated_segments(of_face, patch));
    const auto copy = std::make_shared<MortarPairing<dim>>(pairing);
    copy->segments  = segments;
    return copy;
  }

#define INSTANTIATE(dim)                                        \
  template std::shared_ptr<const MortarPairing<dim>> relocated( \
    const MortarPairing<dim> &, const MasterPatch<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
