#include <stickslip/problem/residual_norms.h>

#include <deal.II/base/array_view.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace stickslip
{
  namespace
  {
    /// Squares of sums over the rows of all ranks [force^2].
    struct Squares
    {
      double imbalance = 0., reactions = 0., loads = 0., contact = 0.;
    };



    /// What a node that is held along an oblique direction, or that follows a
    /// reference point, passes on: the component that is held depends on
    /// others, maybe of another rank, so that their rows get its share of the
    /// reaction. Collective.
    LA::Vector
    forces_passed_on(const LA::Vector &unbalanced, const Constraints &increment)
    {
      std::map<types::global_dof_index, double> passed;
      for (const auto i : unbalanced.locally_owned_elements())
        if (const auto *const entries = increment.get_constraint_entries(i))
          for (const auto &[j, weight] : *entries)
            if (unbalanced(i) != 0.)
              passed[j] += weight * unbalanced(i);
      LA::Vector result(unbalanced.locally_owned_elements(),
                        unbalanced.get_mpi_communicator());
      for (const auto &[j, force] : passed)
        result(j) += force;
      result.compress(VectorOperation::add);
      return result;
    }



    void
    add_forces(const ResidualParts &parts,
               const Constraints   &increment,
               Squares             &squares)
    {
      const LA::Vector passed = forces_passed_on(parts.unbalanced, increment);
      for (const auto i : parts.unbalanced.locally_owned_elements())
        {
          const double r    = parts.unbalanced(i) + passed(i);
          const double load = parts.loads(i);
          (increment.is_constrained(i) ? squares.reactions
                                       : squares.imbalance) += r * r;
          squares.loads += load * load;
        }
    }



    /// Returns the largest relative error of a row of this rank.
    double
    add_contact_rows(const ResidualParts &parts,
                     const Constraints   &increment,
                     Squares             &squares)
    {
      const types::global_dof_index n_displacements = parts.unbalanced.size();
      double                        largest         = 0.;
      for (const auto i : parts.contact_rows.locally_owned_elements())
        if (!increment.is_constrained(n_displacements + i) &&
            parts.row_sizes.scale(i) > 0.)
          {
            const double known =
              std::abs(parts.contact_rows(i)) - parts.row_sizes.roundoff(i);
            const double error = std::max(known, 0.) / parts.row_sizes.scale(i);
            largest            = std::max(largest, error);
            // An error beyond 1 is no worse: in slip a Lambda that is too long
            // leaves the traction as it is, and the next iteration mends it.
            const double force = std::min(error, 1.) * parts.row_sizes.force(i);
            squares.contact += force * force;
          }
      return largest;
    }
  } // namespace



  ResidualNorms
  residual_norms(const ResidualParts &parts,
                 const Constraints   &increment,
                 const double         force_floor,
                 const MPI_Comm      &communicator)
  {
    Squares own;
    add_forces(parts, increment, own);
    const double          largest = add_contact_rows(parts, increment, own);
    std::array<double, 4> sums    = {
         {own.imbalance, own.reactions, own.loads, own.contact}};
    Utilities::MPI::sum(ArrayView<const double>(sums.data(), sums.size()),
                        communicator,
                        ArrayView<double>(sums.data(), sums.size()));
    const auto [imbalance, reactions, loads, contact] = sums;

    ResidualNorms norms;
    norms.equilibrium =
      std::sqrt(imbalance) /
      std::max({std::sqrt(reactions), std::sqrt(loads), force_floor});
    norms.contact = Utilities::MPI::max(largest, communicator);
    norms.merit   = std::sqrt(imbalance + contact);
    return norms;
  }
} // namespace stickslip
