#include <stickslip/mesh/condition_list.h>

#include <stickslip/base/nearest_name.h>
#include <stickslip/base/parsed_expression.h>
#include <stickslip/base/user_error.h>

#include <deal.II/base/types.h>
#include <deal.II/base/utilities.h>

#include <cctype>

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
        const std::string &text = expressions.back();
        const bool         names_group =
          text.size() > 3 && text.compare(0, 2, "in") == 0 &&
          std::isspace(static_cast<unsigned char>(text[2]));
        groups.push_back(names_group ? Utilities::trim(text.substr(3)) : "");
        conditions.push_back(
          names_group
            ? nullptr
            : parse_expressions<3>("x,y,z,id", {text}, parameter_path));
      }
  }



  void
  ConditionList::check_boundary_labels() const
  {
    for (const std::string &label : labels)
      if (!is_id(label) && !std::isalpha(static_cast<unsigned char>(label[0])))
        throw UserError(
          parameter_path + ": '" + label +
          "' is no boundary id (a whole number from 0, of at most "
          "9 digits) and no name (which begins with a letter).");
  }



  void
  ConditionList::check_groups(const LabelledIds            &ids,
                              const std::set<unsigned int> &present) const
  {
    for (unsigned int i = 0; i < groups.size(); ++i)
      if (!groups[i].empty())
        {
          bool is_known = false;
          for (const unsigned int id : ids.ids(groups[i]))
            is_known = is_known || present.count(id) > 0;
          if (!is_known)
            throw UserError(parameter_path + ": '" + labels[i] + ": " +
                            expressions[i] + "' names no group of this body." +
                            did_you_mean(groups[i], ids.names(present)) +
                            " Known: " + ids.in_words(present) + ".");
        }
  }



  template <int dim>
  bool
  ConditionList::holds(const unsigned int index,
                       const Point<dim>  &position,
                       const unsigned int id,
                       const LabelledIds &ids) const
  {
    if (!groups[index].empty())
      return ids.ids(groups[index]).count(id) > 0;
    Point<3> position_3d;
    for (unsigned int d = 0; d < dim; ++d)
      position_3d[d] = position[d];
    conditions[index]->set_time(ids.number(id));
    return conditions[index]->value(position_3d) != 0.;
  }



  template bool
  ConditionList::holds(const unsigned int,
                       const Point<2> &,
                       const unsigned int,
                       const LabelledIds &) const;
  template bool
  ConditionList::holds(const unsigned int,
                       const Point<3> &,
                       const unsigned int,
                       const LabelledIds &) const;
} // namespace stickslip
