#ifndef stickslip_mesh_condition_list_h
#define stickslip_mesh_condition_list_h

#include <stickslip/mesh/labelled_ids.h>

#include <deal.II/base/function_parser.h>
#include <deal.II/base/point.h>
#include <deal.II/base/types.h>

#include <memory>
#include <set>
#include <string>
#include <vector>

namespace stickslip
{
  using namespace dealii;

  /**
   * A list "label: condition; label: condition" of the input file, where a
   * condition is an expression of x, y, z (z = 0 in 2D) and of `id`, the id
   * that the face or cell has so far, or "in NAME" for the faces or cells of a
   * group. Later conditions win.
   */
  class ConditionList
  {
  public:
    /// Throws UserError that blames @p parameter_path for syntax errors.
    ConditionList(const std::string &text, const std::string &parameter_path);

    unsigned int
    size() const
    {
      return labels.size();
    }

    const std::string &
    label(const unsigned int index) const
    {
      return labels[index];
    }

    const std::string &
    expression(const unsigned int index) const
    {
      return expressions[index];
    }

    /// Throws UserError if a label is neither a boundary id nor a name, which
    /// begins with a letter.
    void
    check_boundary_labels() const;

    /// Throws UserError if a condition "in NAME" names a group that @p ids do
    /// not know. @p present are the ids that occur.
    void
    check_groups(const LabelledIds            &ids,
                 const std::set<unsigned int> &present) const;

    template <int dim>
    bool
    holds(const unsigned int index,
          const Point<dim>  &position,
          const unsigned int id,
          const LabelledIds &ids) const;

  private:
    std::string                                     parameter_path;
    std::vector<std::string>                        labels;
    std::vector<std::string>                        expressions;
    std::vector<std::string>                        groups; ///< of "in NAME"
    std::vector<std::unique_ptr<FunctionParser<3>>> conditions;
  };
} // namespace stickslip

#endif
