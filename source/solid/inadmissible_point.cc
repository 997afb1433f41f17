#include <stickslip/solid/inadmissible_point.h>

#include <stickslip/base/over_ranks.h>

#include <algorithm>
#include <vector>

namespace stickslip
{
  template <int dim>
  void
  InadmissiblePoint<dim>::record(const dealii::Point<dim> &new_position,
                                 const unsigned int        new_body,
                                 const bool                new_has_volume)
  {
    // The same point on any number of ranks: the smallest coordinates.
    if (happened && !std::lexicographical_compare(new_position.begin_raw(),
                                                  new_position.end_raw(),
                                                  position.begin_raw(),
                                                  position.end_raw()))
      return;
    happened   = true;
    position   = new_position;
    body       = new_body;
    has_volume = new_has_volume;
  }



  template <int dim>
  bool
  InadmissiblePoint<dim>::exists(const MPI_Comm communicator) const
  {
    return any_rank(happened, communicator);
  }



  template <int dim>
  InadmissibleState
  InadmissiblePoint<dim>::describe(const MPI_Comm communicator,
                                   const Bodies  &bodies) const
  {
    // Position first, so that the smallest coordinates win over the ranks.
    std::vector<double> mine;
    if (happened)
      {
        mine.assign(position.begin_raw(), position.end_raw());
        mine.push_back(body);
        mine.push_back(has_volume);
      }
    std::vector<double> first;
    for (const std::vector<double> &other :
         dealii::Utilities::MPI::all_gather(communicator, mine))
      if (!other.empty() && (first.empty() || other < first))
        first = other;
    if (first.empty())
      return {};

    InadmissibleState result;
    result.reason         = first[dim + 1] != 0.
                              ? "The constitutive law found no stress"
                              : "The volume is not positive";
    result.place.body     = bodies.bodies[first[dim]].name;
    result.place.position = {first.begin(), first.begin() + dim};
    return result;
  }



  template class InadmissiblePoint<2>;
  template class InadmissiblePoint<3>;
} // namespace stickslip
