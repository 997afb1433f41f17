#include <stickslip/mesh/condition_list.h>

#include <stickslip/base/parsed_expression.h>
#include <stickslip/base/user_error.h>

#include <deal.II/base/types.h>
#include <deal.II/base/utilities.h>

namespace stickslip
{
  ConditionList::ConditionList(const std::string &text,
                               const std::string &parameter_path)
    : parameter_path(parameter_path)
  {
    for (const std::string &entry : Utilities::split_string_list(text, ';'))
      {
        // A colon can also be part of muparser's (condition ? a : b).
        const auto colon = entry.find(':');
        if (colon == std::string::npos || colon == 0)
          throw UserError(parameter_path + ": '" + entry +
                          "' is not of the form 'label: condition'.");
        labels.push_back(Utilities::trim(entry.substr(0, colon)));
        expressions.push_back(Utilities::trim(entry.substr(colon + 1)));
        if (expressions.back().empty())
          throw UserError(parameter_path + ": '" + labels.back() +
                          "' has no condition.");
        conditions.push_back(parse_expressions<3>("x,y,z,id",
                                                  {expressions.back()},
                                                  parameter_path));
      }
  }



  types::boundary_id
  ConditionList::boundary_id(const unsigned int index) const
  {
    const std::string &text = labels[index];
    // More than 9 digits do not fit; the largest ids are deal.II's own.
    if (text.size() > 9 ||
        text.find_first_not_of("0123456789") != std::string::npos)
      throw UserError(parameter_path + ": '" + text +
                      "' is no boundary id (a whole number from 0).");
    return Utilities::string_to_int(text);
  }



  template <int dim>
  bool
  ConditionList::holds(const unsigned int index,
                       const Point<dim>  &position,
                       const unsigned int id) const
  {
    Point<3> position_3d;
    for (unsigned int d = 0; d < dim; ++d)
      position_3d[d] = position[d];
    conditions[index]->set_time(id);
    return conditions[index]->value(position_3d) != 0.;
  }



  template bool
  ConditionList::holds(const unsigned int,
                       const Point<2> &,
                       const unsigned int) const;
  template bool
  ConditionList::holds(const unsigned int,
                       const Point<3> &,
                       const unsigned int) const;
} // namespace stickslip
