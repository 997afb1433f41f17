#include <stickslip/solid/pretension_cut.h>

#include <stickslip/base/over_ranks.h>
#include <stickslip/base/user_error.h>

#include <deal.II/numerics/rtree.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <sstream>
#include <utility>

namespace stickslip
{
  namespace
  {
    /// Opposite nodes are this close, relative to their cells.
    constexpr double same_place = 1e-6;

    /// Normals and directions that differ by less are the same.
    constexpr double same_direction = 1e-4;



    /// The nodes of both sides with the normals of their faces, as those of two
    /// symmetry boundaries: these are plane.
    template <int dim>
    std::array<std::vector<HeldNode<dim>>, 2>
    nodes_of_sides(const Pretension<dim>            &condition,
                   const hp::MappingCollection<dim> &mapping,
                   const DoFHandler<dim>            &dof_handler,
                   const Bodies                     &bodies)
    {
      std::array<std::vector<HeldNode<dim>>, 2> sides;
      std::string                               error;
      for (unsigned int s = 0; s < 2; ++s)
        {
          PrescribedDisplacement<dim> plane;
          plane.name         = condition.name;
          plane.type         = BoundaryConditionType::symmetry;
          plane.body         = condition.sides[s].body;
          plane.boundary_ids = condition.sides[s].boundary_ids;
          for (const auto &[first_dof, node] : find_held_nodes(
                 mapping, dof_handler, bodies, {plane}, 0., error))
            sides[s].push_back(node);
        }
      throw_collectively(error, dof_handler.get_communicator());
      return sides;
    }
  } // namespace



  template <int dim>
  PretensionCut<dim>::PretensionCut(
    const Pretension<dim>                                  &condition,
    const hp::MappingCollection<dim>                       &mapping,
    const DoFHandler<dim>                                  &dof_handler,
    const Bodies                                           &bodies,
    const std::map<types::global_dof_index, HeldNode<dim>> &held,
    const std::vector<PrescribedDisplacement<dim>>         &conditions,
    const Constraints                                      &geometric)
    : condition(condition)
    , communicator(dof_handler.get_communicator())
    , all_masters(dof_handler.n_dofs())
  {
    const auto sides = nodes_of_sides(condition, mapping, dof_handler, bodies);
    find_normal(sides[0], bodies);

    std::array<std::vector<SideNode>, 2> own;
    std::vector<double>                  tolerances;
    std::string                          error;
    for (unsigned int s = 0; s < 2; ++s)
      for (const HeldNode<dim> &node : sides[s])
        {
          const auto known = held.find(node.dofs[0]);
          SideNode   result{node.position,
                          node.dofs,
                          {},
                          !geometric.is_constrained(node.dofs[0])};
          if (known != held.end())
            {
              result.held = held_directions(known->second, conditions, error);
              result.is_free = false;
            }
          own[s].push_back(result);
          if (s == 1)
            tolerances.push_back(same_place * node.cell_diameter);
        }
    throw_collectively(error, communicator);

    std::vector<SideNode> first_side;
    for (const auto &of_rank : Utilities::MPI::all_gather(communicator, own[0]))
      first_side.insert(first_side.end(), of_rank.begin(), of_rank.end());
    match(first_side, own[1], tolerances);
    this->first_side.set_size(dof_handler.n_dofs());
    second_side.set_size(dof_handler.n_dofs());
    for (const SideNode &node : first_side)
      this->first_side.add_indices(node.dofs.begin(), node.dofs.end());
    for (const OppositeNodes &nodes : pairs)
      second_side.add_indices(nodes.second.begin(), nodes.second.end());
    all_masters.add_indices(this->first_side);
    all_masters.add_index(second_pivot);
    all_masters.compress();
  }



  template <int dim>
  void
  PretensionCut<dim>::refuse(const std::string &problem) const
  {
    throw UserError("Boundary conditions/" + condition.name + ": " + problem);
  }



  template <int dim>
  void
  PretensionCut<dim>::find_normal(const std::vector<HeldNode<dim>> &first_side,
                                  const Bodies                     &bodies)
  {
    Tensor<1, dim> sum;
    for (const HeldNode<dim> &node : first_side)
      for (const auto &row : node.rows)
        sum += row.direction;
    sum = Utilities::MPI::sum(sum, communicator);
    if (sum.norm() == 0.)
      refuse("its boundary is not plane.");
    normal = sum / sum.norm();
    for (unsigned int d = 0; d < dim; ++d)
      if (std::abs(normal[d]) < 1e-10)
        normal[d] = 0.;
    double largest_difference = 0.;
    for (const HeldNode<dim> &node : first_side)
      for (const auto &row : node.rows)
        largest_difference =
          std::max(largest_difference, (row.direction - normal).norm());
    if (Utilities::MPI::max(largest_difference, communicator) > same_direction)
      refuse("the faces of 'Boundary' are not on one plane.");
    if (bodies.cross_section.is_axisymmetric &&
        std::abs(normal[0]) > same_direction)
      refuse("with 'Axisymmetric = true' a cut has to be across the axis.");
    for (unsigned int d = 1; d < dim; ++d)
      if (std::abs(normal[d]) > std::abs(normal[p]) + same_direction)
        p = d;
  }



  template <int dim>
  Tensor<2, dim>
  PretensionCut<dim>::held_directions(
    const HeldNode<dim>                            &node,
    const std::vector<PrescribedDisplacement<dim>> &conditions,
    std::string                                    &error) const
  {
    const auto add_to_error = [&](const unsigned int c,
                                  const std::string &problem) {
      std::ostringstream text;
      text << "Boundary conditions/" << conditions[c].name << problem << " ("
           << node.position << ") of the cut of Boundary conditions/"
           << condition.name << ". Restrict it with 'Where'.";
      if (error.empty())
        error = text.str();
    };
    if (node.is_coupled())
      add_to_error(node.coupling, " couples the node");
    Tensor<2, dim>              projector;
    std::vector<Tensor<1, dim>> known;
    for (const auto &row : node.rows)
      {
        if (std::abs(row.direction * normal) > same_direction)
          add_to_error(row.condition, " holds, along the bolt, the node");
        const auto &condition_of_row = conditions[row.condition];
        // values and times could be others on the other side
        if (condition_of_row.type != BoundaryConditionType::symmetry &&
            !condition_of_row.is_of_axis)
          add_to_error(row.condition, ", no symmetry, holds the node");
        else if (!condition_of_row.active.is_always())
          add_to_error(row.condition, " holds, for a time only, the node");
        Tensor<1, dim> direction = row.direction;
        for (const auto &other : known)
          direction -= (row.direction * other) * other;
        if (direction.norm() < same_direction)
          continue;
        known.push_back(direction / direction.norm());
        projector += outer_product(known.back(), known.back());
      }
    return projector;
  }



  template <int dim>
  void
  PretensionCut<dim>::match(const std::vector<SideNode> &first_side,
                            const std::vector<SideNode> &second_side,
                            const std::vector<double>   &tolerances)
  {
    namespace bgi = boost::geometry::index;
    std::vector<std::pair<Point<dim>, unsigned int>> places;
    for (unsigned int i = 0; i < first_side.size(); ++i)
      places.emplace_back(first_side[i].position, i);
    const auto tree = pack_rtree(places);

    std::ostringstream problem;
    first_pivot = second_pivot = numbers::invalid_dof_index;
    for (unsigned int i = 0; i < second_side.size(); ++i)
      {
        const SideNode &second = second_side[i];
        std::vector<std::pair<Point<dim>, unsigned int>> nearest;
        tree.query(bgi::nearest(second.position, 1),
                   std::back_inserter(nearest));
        if (nearest.empty() ||
            nearest[0].first.distance(second.position) > tolerances[i])
          {
            problem << "no node of 'Boundary' is at the node ("
                    << second.position << ") of 'Second boundary'";
            break;
          }
        const SideNode &first = first_side[nearest[0].second];
        if ((first.held - second.held).norm() > same_direction)
          {
            problem << "another condition holds the node (" << second.position
                    << ") on one side of the cut only";
            break;
          }
        pairs.push_back({first.dofs, second.dofs});
        if (first.is_free && second.is_free && second.dofs[p] < second_pivot)
          {
            first_pivot  = first.dofs[p];
            second_pivot = second.dofs[p];
          }
      }
    std::string error = problem.str();
    if (Utilities::MPI::sum(second_side.size(), communicator) !=
          first_side.size() &&
        error.empty())
      error = "its two sides do not have the same nodes";
    error = first_error(error, communicator);
    if (!error.empty())
      refuse(error +
             ". Both sides of a cut need the same mesh and the same "
             "conditions.");

    const auto lowest = Utilities::MPI::min(second_pivot, communicator);
    if (second_pivot != lowest)
      first_pivot = numbers::invalid_dof_index;
    second_pivot = lowest;
    first_pivot  = Utilities::MPI::min(first_pivot, communicator);
    if (second_pivot == numbers::invalid_dof_index)
      refuse("other conditions hold all nodes of its cut.");
  }



  template <int dim>
  bool
  PretensionCut<dim>::shares_nodes_with(const PretensionCut &other) const
  {
    const bool shares = !(first_side & other.first_side).is_empty() ||
                        !(second_side & other.second_side).is_empty() ||
                        !(first_side & other.second_side).is_empty() ||
                        !(second_side & other.first_side).is_empty();
    return any_rank(shares, communicator);
  }



  template <int dim>
  std::vector<ConstraintLine>
  PretensionCut<dim>::lines(const double time) const
  {
    const bool                  is_drawn = condition.is_drawn(time);
    std::vector<ConstraintLine> result;
    for (const OppositeNodes &nodes : pairs)
      for (unsigned int d = 0; d < dim; ++d)
        {
          if (is_drawn && nodes.second[d] == second_pivot)
            continue;
          ConstraintLine line{nodes.second[d], {{nodes.first[d], 1.}}, 0.};
          const double   weight = normal[d] / normal[p];
          if (is_drawn && weight != 0.)
            {
              line.entries.emplace_back(second_pivot, weight);
              line.entries.emplace_back(first_pivot, -weight);
            }
          result.push_back(line);
        }
    return result;
  }



  template <int dim>
  void
  PretensionCut<dim>::add_driving_forces(const double time,
                                         LA::Vector  &forces) const
  {
    if (!condition.is_drawn(time))
      return;
    const double force = condition.force(time) / normal[p];
    if (forces.in_local_range(first_pivot))
      forces(first_pivot) += force;
    if (forces.in_local_range(second_pivot))
      forces(second_pivot) -= force;
  }



  template <int dim>
  CutReaction
  PretensionCut<dim>::reaction(const LA::Vector &u,
                               const LA::Vector &unbalanced) const
  {
    CutReaction own{0., 0.};
    for (const OppositeNodes &nodes : pairs)
      for (unsigned int d = 0; d < dim; ++d)
        own.force -= normal[d] * unbalanced(nodes.second[d]);
    if (u.in_local_range(first_pivot))
      own.shortening += u(first_pivot) / normal[p];
    if (u.in_local_range(second_pivot))
      own.shortening -= u(second_pivot) / normal[p];
    return {Utilities::MPI::sum(own.force, communicator),
            Utilities::MPI::sum(own.shortening, communicator)};
  }

  template class PretensionCut<2>;
  template class PretensionCut<3>;
} // namespace stickslip
