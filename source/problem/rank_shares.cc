#include <stickslip/problem/rank_shares.h>

#include <deal.II/base/mpi.h>

#include <algorithm>

namespace stickslip
{
  namespace
  {
    /// "12 to 15 things", or "12 things".
    std::string
    range(const std::vector<unsigned long> &counts, const std::string &things)
    {
      const auto [least, most] =
        std::minmax_element(counts.begin(), counts.end());
      return std::to_string(*least) +
             (*least == *most ? "" : " to " + std::to_string(*most)) + " " +
             things;
    }
  } // namespace



  template <int dim>
  std::vector<std::string>
  describe_rank_shares(const DoFHandler<dim>       &dof_handler,
                       const ContactAssembler<dim> &contact)
  {
    const MPI_Comm communicator = dof_handler.get_communicator();
    unsigned long  n_points     = 0;
    for (const auto &pair : contact.contact_pairs())
      n_points += pair->points.size();
    const auto displacements =
      Utilities::MPI::all_gather(communicator,
                                 static_cast<unsigned long>(
                                   dof_handler.n_locally_owned_dofs()));
    auto       points  = Utilities::MPI::all_gather(communicator, n_points);
    const auto n_ranks = displacements.size();
    if (n_ranks == 1)
      return {};

    std::string line = std::to_string(n_ranks) + " ranks: " +
                       range(displacements, "displacement unknowns on each");
    points.erase(std::remove(points.begin(), points.end(), 0ul), points.end());
    if (!points.empty())
      line +=
        "; " + range(points, "contact points on ") +
        (points.size() == n_ranks ? "each"
                                  : std::to_string(points.size()) + " of them");
    return {line};
  }

  template std::vector<std::string>
  describe_rank_shares(const DoFHandler<2> &, const ContactAssembler<2> &);
  template std::vector<std::string>
  describe_rank_shares(const DoFHandler<3> &, const ContactAssembler<3> &);
} // namespace stickslip
