#include <stickslip/contact/results/neighbour_points.h>

#include <algorithm>
#include <array>
#include <set>
#include <utility>
#include <vector>

namespace stickslip
{
  namespace
  {
    /// First multiplier dofs of nodes and their shares of a value.
    using NodalShares = std::vector<std::pair<types::global_dof_index, double>>;



    /// Calls @p visit with each number of @p point that nodal fields need, in
    /// the same order for reading and writing.
    template <typename Point, typename Visitor>
    void
    for_each_number(Point &point, const Visitor &visit)
    {
      visit(point.reference_weight);
      visit(point.gap);
      visit(point.pressure);
      for (auto *vector : {&point.Lambda,
                           &point.normal,
                           &point.tangential_traction,
                           &point.slip,
                           &point.accumulated_slip})
        for (unsigned int c = 0; c < vector->dimension; ++c)
          visit((*vector)[c]);
    }



    /// Turns the vectors among them.
    template <int dim>
    void
    turn(const Tensor<2, dim> &R, ContactPointResult<dim> &point)
    {
      for (auto *vector : {&point.Lambda,
                           &point.normal,
                           &point.tangential_traction,
                           &point.slip,
                           &point.accumulated_slip})
        *vector = R * *vector;
    }
  } // namespace



  template <int dim>
  void
  add_points_of_neighbours(const ContactAssembler<dim> &contact,
                           const unsigned int           p,
                           ContactFaceResult<dim>      *faces)
  {
    const ContactPair<dim> &pair        = *contact.contact_pairs()[p];
    const auto             &multipliers = contact.multipliers();
    const unsigned int      n_comp      = pair.n_multiplier_components();
    const auto dof_of = [&](const unsigned int f, const unsigned int l) {
      return pair.slave_faces[f].multiplier_dofs[l * n_comp];
    };

    // one vector per number: the state, whether the node has a point, the rest
    std::vector<LA::Vector> numbers;
    std::vector<std::pair<types::global_dof_index, std::vector<double>>> own;
    std::vector<unsigned int>         n_seen(pair.slave_faces.size(), 0);
    std::set<types::global_dof_index> own_dofs;
    for (const auto &point : pair.points)
      {
        const unsigned int f      = point.geometry.slave_face;
        auto               result = faces[f].points[n_seen[f]++];
        turn(transpose(pair.rotation_at_multiplier(
               pair.slave_faces[f].face, point.geometry.quadrature_index)),
             result); // as at the node itself
        std::vector<double> values = {
          1., static_cast<double>(static_cast<unsigned int>(result.state))};
        for_each_number(result,
                        [&values](double &value) { values.push_back(value); });
        own.emplace_back(dof_of(f, point.geometry.quadrature_index), values);
      }
    ContactPointResult<dim> blank{};
    unsigned int            n_numbers = 2;
    for_each_number(blank, [&n_numbers](double &) { ++n_numbers; });
    for (unsigned int k = 0; k < n_numbers; ++k)
      {
        LA::Vector values(multipliers.locally_owned(),
                          contact.get_communicator());
        for (const auto &[dof, all] : own)
          values(dof) += all[k];
        values.compress(VectorOperation::add);
        numbers.emplace_back(multipliers.locally_owned(),
                             multipliers.locally_relevant(),
                             contact.get_communicator());
        numbers.back() = values;
      }

    const auto keys = pair.multiplier_keys();
    // The nodes that give a node its values: itself, or what it hangs on.
    const auto shares_of = [&](const unsigned int f, const unsigned int l) {
      const auto  key    = keys[f * pair.multiplier_shape.n_nodes() + l];
      const auto *others = pair.hanging_nodes().combination(key);
      NodalShares shares;
      double      sum = 0.;
      for (const auto &[other, share] :
           others != nullptr ? *others : HangingNodes::Combination{{key, 1.}})
        if (multipliers.has_node(p, other))
          {
            const auto dof = multipliers.first_dof(p, other);
            if (numbers[0](dof) == 0.)
              continue;
            shares.emplace_back(dof, share);
            sum += share;
          }
      for (auto &[dof, share] : shares)
        share /= sum;
      return shares;
    };

    std::vector<std::set<unsigned int>> has_point(pair.slave_faces.size());
    for (const auto &point : pair.points)
      has_point[point.geometry.slave_face].insert(
        point.geometry.quadrature_index);
    for (unsigned int f = 0; f < pair.slave_faces.size(); ++f)
      for (unsigned int l = 0; l < pair.multiplier_shape.n_nodes(); ++l)
        {
          if (has_point[f].count(l) > 0)
            continue;
          const auto shares = shares_of(f, l);
          if (shares.empty())
            continue;
          const auto sum = [&](const unsigned int k) {
            double value = 0.;
            for (const auto &[dof, share] : shares)
              value += share * numbers[k](dof);
            return value;
          };
          ContactPointResult<dim> result{};
          // states cannot be averaged
          const auto nearest =
            std::max_element(shares.begin(),
                             shares.end(),
                             [](const auto &a, const auto &b) {
                               return a.second < b.second;
                             });
          result.state = static_cast<ContactState>(
            static_cast<unsigned int>(numbers[1](nearest->first)));
          unsigned int k = 2;
          for_each_number(result, [&](double &value) { value = sum(k++); });
          turn(pair.rotation_at_multiplier(pair.slave_faces[f].face, l),
               result);
          std::vector<double> L;
          for (unsigned int j = 0; j < pair.displacement_shape.n_nodes(); ++j)
            {
              pair.multiplier_shape.evaluate_values(
                pair.displacement_shape.node(j), L);
              result.shape_values.push_back(L[l]);
            }
          faces[f].points_of_neighbours.push_back(result);
        }
  }

  template void
  add_points_of_neighbours(const ContactAssembler<2> &,
                           const unsigned int,
                           ContactFaceResult<2> *);
  template void
  add_points_of_neighbours(const ContactAssembler<3> &,
                           const unsigned int,
                           ContactFaceResult<3> *);
} // namespace stickslip
