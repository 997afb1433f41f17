// A quantity in the output: a sum over contact points, the same on any number
// of ranks. The manual shows these functions (doc/developers.md).

#include <stickslip/contact/results/contact_result.h>

#include <deal.II/base/mpi.h>

#include "print.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace stickslip;

namespace
{
  // [quantity]
  /// Largest pressure times slip of the step at a point [stress * length] of
  /// the pair, what wears the surface there (Archard). Collective.
  template <int dim>
  double
  largest_wear(const std::vector<ContactFaceResult<dim>> &faces,
               const unsigned int                         pair,
               const MPI_Comm                             communicator)
  {
    double largest = 0.;
    for (const ContactFaceResult<dim> &face : faces)
      if (face.pair == pair)
        for (const ContactPointResult<dim> &point : face.points)
          if (point.state == ContactState::slip)
            largest = std::max(largest, point.pressure * point.slip.norm());
    return Utilities::MPI::max(largest, communicator);
  }
  // [end of quantity]



  ContactPointResult<2>
  slipping(const double pressure, const double slip)
  {
    ContactPointResult<2> point{};
    point.state    = ContactState::slip;
    point.pressure = pressure;
    point.slip[0]  = slip;
    return point;
  }
} // namespace



int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  // One face, on the last rank: no rank sees more than its own faces.
  std::vector<ContactFaceResult<2>> faces;
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) + 1 ==
      Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD))
    {
      ContactFaceResult<2> face;
      face.pair      = 1;
      face.points    = {slipping(2., 0.1), slipping(10., -0.05)};
      auto sticking  = slipping(1000., 1e-9);
      sticking.state = ContactState::stick;
      face.points.push_back(sticking);
      faces.push_back(face);
    }
  const double wear  = largest_wear(faces, 1, MPI_COMM_WORLD);
  const double other = largest_wear(faces, 0, MPI_COMM_WORLD);
  print("the wear of the point that slips under the largest pressure",
        std::abs(wear - 0.5) < 1e-12);
  print("none of the other pair", other == 0.);
}
