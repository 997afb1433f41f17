#include <stickslip/problem/rank_shares.h>

#include <deal.II/base/mpi.h>

namespace stickslip
{
  namespace
  {
    /// "12 to 15 things", or "12 things".
    std::string
    range(const double least, const double most, const std::string &things)
    {
      const auto text = [](const double count) {
        return std::to_string(static_cast<unsigned long>(count));
      };
      return text(least) + (least == most ? "" : " to " + text(most)) + " " +
             things;
    }
  } // namespace



  template <int dim>
  std::vector<std::string>
  describe_rank_shares(const DoFHandler<dim>       &dof_handler,
                       const ContactAssembler<dim> &contact)
  {
    const MPI_Comm     communicator = dof_handler.get_communicator();
    const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(communicator);
    if (n_ranks == 1)
      return {};
    double n_points = 0.;
    for (const auto &pair : contact.contact_pairs())
      n_points += pair->points.size();
    const auto displacements =
      Utilities::MPI::min_max_avg(dof_handler.n_locally_owned_dofs(),
                                  communicator);
    const double       most = Utilities::MPI::max(n_points, communicator);
    const unsigned int n_in_contact =
      Utilities::MPI::sum(n_points > 0. ? 1u : 0u, communicator);
    const double least =
      Utilities::MPI::min(n_points > 0. ? n_points : most, communicator);

    std::string line = std::to_string(n_ranks) + " ranks: " +
                       range(displacements.min,
                             displacements.max,
                             "displacement unknowns on each");
    if (n_in_contact > 0)
      line +=
        "; " + range(least, most, "contact points on ") +
        (n_in_contact == n_ranks ? "each"
                                 : std::to_string(n_in_contact) + " of them");
    return {line};
  }

  template std::vector<std::string>
  describe_rank_shares(const DoFHandler<2> &, const ContactAssembler<2> &);
  template std::vector<std::string>
  describe_rank_shares(const DoFHandler<3> &, const ContactAssembler<3> &);
} // namespace stickslip
