#include <stickslip/solid/displacement_constraints.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

namespace stickslip
{
  template <int dim>
  std::string
  in_brackets(const Tensor<1, dim> &vector)
  {
    std::ostringstream text;
    for (unsigned int d = 0; d < dim; ++d)
      text << (d == 0 ? "(" : " ")
           << (std::abs(vector[d]) < 1e-10 * vector.norm() ? 0. : vector[d]);
    return text.str() + ')';
  }



  namespace
  {
    /// A row in which the component `pivot` has been made one; `origin` is its
    /// index among the node's rows.
    template <int dim>
    struct PivotRow
    {
      unsigned int   pivot;
      Tensor<1, dim> direction;
      double         value;
      unsigned int   origin;
    };



    /// The first component that is about as large as the largest: the same
    /// one whatever the rounding.
    template <int dim>
    unsigned int
    robust_pivot(const Tensor<1, dim> &direction)
    {
      double largest = 0.;
      for (unsigned int d = 0; d < dim; ++d)
        largest = std::max(largest, std::abs(direction[d]));
      unsigned int pivot = 0;
      while (std::abs(direction[pivot]) < (1. - 1e-6) * largest)
        ++pivot;
      return pivot;
    }



    /// Up to which prescribed displacements are the same.
    template <int dim>
    double
    tolerance_of_values(const HeldNode<dim> &node)
    {
      double largest_value = 0.;
      for (const auto &row : node.rows)
        largest_value = std::max(largest_value, std::abs(row.value));
      return 1e-8 * largest_value + 1e-10 * node.cell_diameter;
    }



    /// The same for a row beside those before it, at the displacement @p u.
    /// That at an image: its place is rounded.
    template <int dim>
    double
    tolerance_of(const HeldNode<dim>  &node,
                 const unsigned int    row,
                 const Tensor<1, dim> &u)
    {
      double tolerance = tolerance_of_values(node);
      if (node.rows[row].image)
        {
          double largest = u.norm();
          for (const auto &other : node.rows)
            largest = std::max(largest, std::abs(other.value));
          tolerance += node.rows[row].same_direction() * largest +
                       2e-5 * node.cell_diameter;
        }
      return tolerance;
    }



    /// Where a row is prescribed.
    template <int dim>
    const Point<dim> &
    place_of(const HeldNode<dim> &node, const unsigned int row)
    {
      return node.rows[row].image ? node.rows[row].image->position
                                  : node.position;
    }



    /// A node that has other places, too, where the same condition or another
    /// one holds it.
    template <int dim>
    std::string
    image_contradiction_text(
      const HeldNode<dim>                            &node,
      const unsigned int                              row,
      const unsigned int                              other,
      const std::vector<PrescribedDisplacement<dim>> &conditions)
    {
      const auto prescribed = [&](const unsigned int r) {
        std::ostringstream text;
        text << node.rows[r].value << " along the direction "
             << in_brackets(node.rows[r].turned(node.rows[r].direction))
             << " at " << in_brackets<dim>(place_of(node, r));
        return text.str();
      };
      const std::string &name = conditions[node.rows[other].condition].name;
      const std::string &its  = conditions[node.rows[row].condition].name;
      return "Boundary conditions/" + name +
             (its == name ? " is not the same on both sides: "
                          : " and Boundary conditions/" + its +
                              " contradict each other: ") +
             "a displacement of " + prescribed(other) + " against " +
             prescribed(row) +
             ", but periodic boundaries or sides of cyclic symmetry make one "
             "node of the two. Prescribe what is the same in all sectors (with "
             "'Components = cylindrical', along the axis), hold one of the two "
             "places only ('Where'), or compute the whole model.";
    }



    template <int dim>
    std::string
    contradiction_text(
      const HeldNode<dim>                            &node,
      const unsigned int                              row,
      const std::vector<PrescribedDisplacement<dim>> &conditions,
      const std::vector<PivotRow<dim>>               &earlier)
    {
      // The earlier row that is closest to parallel is the one to name.
      unsigned int other = earlier.front().origin;
      for (const PivotRow<dim> &candidate : earlier)
        if (std::abs(node.rows[candidate.origin].direction *
                     node.rows[row].direction) >
            std::abs(node.rows[other].direction * node.rows[row].direction))
          other = candidate.origin;
      if (node.rows[row].image || node.rows[other].image)
        return image_contradiction_text(node, row, other, conditions);

      std::ostringstream text;
      text << "Boundary conditions/"
           << conditions[node.rows[other].condition].name
           << " and Boundary conditions/"
           << conditions[node.rows[row].condition].name
           << " contradict each other at the node (" << node.position
           << "): a displacement of " << node.rows[other].value
           << " along the direction (" << node.rows[other].direction
           << ") against " << node.rows[row].value << " along ("
           << node.rows[row].direction << ").";
      return text.str();
    }
  } // namespace



  template <int dim>
  std::vector<ConstraintLine>
  resolve_held_node(const HeldNode<dim>                            &node,
                    const Tensor<1, dim>                           &u,
                    const std::vector<PrescribedDisplacement<dim>> &conditions,
                    std::string                                    &error)
  {
    // Gauss-Jordan elimination, at most dim rows survive.
    std::vector<PivotRow<dim>> rows;
    for (unsigned int r = 0; r < node.rows.size(); ++r)
      {
        PivotRow<dim> row{0,
                          node.rows[r].direction,
                          node.rows[r].value - node.rows[r].direction * u,
                          r};
        for (const PivotRow<dim> &known : rows)
          {
            const double factor = row.direction[known.pivot];
            row.direction -= factor * known.direction;
            row.value -= factor * known.value;
          }
        if (row.direction.norm() < node.rows[r].same_direction())
          {
            if (std::abs(row.value) > tolerance_of(node, r, u) && error.empty())
              error = contradiction_text(node, r, conditions, rows);
            continue;
          }

        row.pivot          = robust_pivot(row.direction);
        const double scale = row.direction[row.pivot];
        row.direction /= scale;
        row.value /= scale;
        for (PivotRow<dim> &known : rows)
          {
            const double factor = known.direction[row.pivot];
            known.direction -= factor * row.direction;
            known.value -= factor * row.value;
          }
        rows.push_back(row);
      }

    std::vector<ConstraintLine> lines;
    for (const PivotRow<dim> &row : rows)
      {
        ConstraintLine line{node.dofs[row.pivot], {}, row.value};
        for (unsigned int d = 0; d < dim; ++d)
          if (d != row.pivot && std::abs(row.direction[d]) > 1e-12)
            line.entries.emplace_back(node.dofs[d], -row.direction[d]);
        lines.push_back(line);
      }
    return lines;
  }



  namespace
  {
    /// True if no free component of @p motion moves what is at @p arm along
    /// @p direction, however far it goes.
    template <int dim>
    bool
    never_moves_along(const RigidMotion<dim> &motion,
                      const Tensor<1, dim>   &arm,
                      const Tensor<1, dim>   &direction)
    {
      const auto   in_space     = RigidState<dim>().current_arm(direction);
      const auto   arm_in_space = RigidState<dim>().current_arm(arm);
      const double roundoff     = 1e-8 * arm.norm();
      for (unsigned int c = 0; c < motion.n_components; ++c)
        if (motion.is_free(c))
          {
            if (c < dim)
              {
                if (std::abs(direction[c]) > 1e-8)
                  return false;
                continue;
              }
            const Tensor<1, 3> &axis    = motion.rotation_axis(c);
            const auto          tangent = cross_product_3d(axis, arm_in_space);
            if (tangent.norm() > roundoff &&
                cross_product_3d(axis, in_space).norm() > 1e-8)
              return false;
          }
      return true;
    }
  } // namespace



  template <int dim>
  void
  check_coupled_node(const HeldNode<dim>                            &node,
                     const std::vector<PrescribedDisplacement<dim>> &conditions,
                     const double                                    time,
                     std::string                                    &error)
  {
    const PrescribedDisplacement<dim> &coupling = conditions[node.coupling];
    const Tensor<1, dim> u = coupling.motion.displacement(node.position, time);
    const double         tolerance = tolerance_of_values(node);
    for (const auto &row : node.rows)
      {
        if (row.image) // the image itself is checked
          continue;
        const bool is_free_of =
          never_moves_along(coupling.motion,
                            Tensor<1, dim>(node.position -
                                           coupling.motion.reference_point()),
                            row.direction);
        if ((is_free_of &&
             std::abs(u * row.direction - row.value) <= tolerance) ||
            !error.empty())
          continue;
        std::ostringstream text;
        text << "Boundary conditions/" << conditions[row.condition].name
             << " prescribes a displacement of " << row.value
             << " along the direction (" << row.direction << ") at the node ("
             << node.position << "), which Boundary conditions/"
             << coupling.name
             << (is_free_of ? " moves otherwise."
                            : " leaves free to move there: hold this component "
                              "of its motion, or leave the node out with "
                              "'Where'.");
        error = text.str();
      }
  }



  namespace
  {
    void
    add_constraint_line(const ConstraintLine &line, Constraints &constraints)
    {
      if (constraints.is_constrained(line.dof))
        return;
      constraints.add_line(line.dof);
      constraints.add_entries(line.dof, line.entries);
      constraints.set_inhomogeneity(line.dof, line.inhomogeneity);
    }
  } // namespace



  void
  add_lines_on_all_ranks(const std::vector<ConstraintLine> &lines,
                         const IndexSet                    &locally_owned_dofs,
                         const MPI_Comm                     communicator,
                         Constraints                       &constraints)
  {
    for (const ConstraintLine &line : lines)
      add_constraint_line(line, constraints);
    if (Utilities::MPI::n_mpi_processes(communicator) == 1)
      return;

    std::map<types::global_dof_index, const ConstraintLine *> line_of;
    for (const ConstraintLine &line : lines)
      line_of[line.dof] = &line;

    IndexSet foreign = constraints.get_local_lines();
    foreign.subtract_set(locally_owned_dofs);
    const std::vector<unsigned int> owners =
      Utilities::MPI::compute_index_owner(locally_owned_dofs,
                                          foreign,
                                          communicator);
    std::map<unsigned int, std::vector<types::global_dof_index>> questions;
    unsigned int                                                 i = 0;
    for (const types::global_dof_index dof : foreign)
      questions[owners[i++]].push_back(dof);

    std::map<unsigned int, std::vector<ConstraintLine>> answers;
    for (const auto &question :
         Utilities::MPI::some_to_some(communicator, questions))
      for (const types::global_dof_index dof : question.second)
        {
          const auto line = line_of.find(dof);
          if (line != line_of.end())
            answers[question.first].push_back(*line->second);
        }

    for (const auto &answer :
         Utilities::MPI::some_to_some(communicator, answers))
      for (const ConstraintLine &line : answer.second)
        add_constraint_line(line, constraints);
  }



  template std::string
  in_brackets(const Tensor<1, 2> &);
  template std::string
  in_brackets(const Tensor<1, 3> &);
  template void
  check_coupled_node(const HeldNode<2> &,
                     const std::vector<PrescribedDisplacement<2>> &,
                     const double,
                     std::string &);
  template void
  check_coupled_node(const HeldNode<3> &,
                     const std::vector<PrescribedDisplacement<3>> &,
                     const double,
                     std::string &);
  template std::vector<ConstraintLine>
  resolve_held_node(const HeldNode<2> &,
                    const Tensor<1, 2> &,
                    const std::vector<PrescribedDisplacement<2>> &,
                    std::string &);
  template std::vector<ConstraintLine>
  resolve_held_node(const HeldNode<3> &,
                    const Tensor<1, 3> &,
                    const std::vector<PrescribedDisplacement<3>> &,
                    std::string &);
} // namespace stickslip
