#include <stickslip/simulation/force_tables.h>

namespace stickslip
{
  ForceTables::ForceTables(const CaseParameters &parameters,
                           const MPI_Comm        communicator)
    : resultant_table(parameters.output.directory + "/resultants", communicator)
    , reaction_table(parameters.output.directory + "/reactions", communicator)
  {
    for (const auto &pair : parameters.contact_pairs)
      pair_names.push_back(pair.first);
  }



  void
  ForceTables::resume(const double time)
  {
    resultant_table.resume(time);
    reaction_table.resume(time);
  }



  template <int dim>
  void
  ForceTables::write(const unsigned int                         step,
                     const double                               time,
                     const std::vector<ContactResultants<dim>> &resultants,
                     const ContactProblem<dim>                 &problem)
  {
    if (!resultants.empty())
      {
        resultant_table.add("step", step);
        resultant_table.add("time", time);
        for (unsigned int p = 0; p < resultants.size(); ++p)
          for (const auto &resultant : resultants[p].named_values())
            resultant_table.add(pair_names[p] + "." + resultant.name,
                                resultant.value);
        resultant_table.finish_row();
      }
    const bool is_axisymmetric = problem.bodies().cross_section.is_axisymmetric;
    const auto reactions       = problem.reactions();
    const auto cuts            = problem.cut_reactions();
    const auto points          = problem.reference_points();
    if (!reactions.empty() || !cuts.empty() || !points.empty())
      {
        reaction_table.add("step", step);
        reaction_table.add("time", time);
        for (const auto &[name, force] : reactions)
          for (unsigned int d = 0; d < dim; ++d)
            reaction_table.add(name + ".force_" + "xyz"[d], force[d]);
        for (const auto &[name, reaction] : points)
          for (const auto &result : reaction.named_values())
            if (!(is_axisymmetric && result.quantity == "moment"))
              reaction_table.add(name + "." + result.name, result.value);
        for (const auto &[name, cut] : cuts)
          {
            reaction_table.add(name + ".force", cut.force);
            reaction_table.add(name + ".shortening", cut.shortening);
          }
        reaction_table.finish_row();
      }
  }

  template void
  ForceTables::write(const unsigned int,
                     const double,
                     const std::vector<ContactResultants<2>> &,
                     const ContactProblem<2> &);
  template void
  ForceTables::write(const unsigned int,
                     const double,
                     const std::vector<ContactResultants<3>> &,
                     const ContactProblem<3> &);
} // namespace stickslip
