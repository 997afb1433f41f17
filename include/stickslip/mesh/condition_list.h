#ifndef stickslip_mesh_condition_list_h
#define stickslip_mesh_condition_list_h

#include <deal.II/base/function_parser.h>
#include <deal.II/base/point.h>
#include <deal.II/base/types.h>

#include <memory>
#include <string>
#include <vector>

namespace stickslip
{
  using namespace dealii;

  /**
   * A list "label: condition; label: condition" of the input file, where a
   * condition is an expression of x, y, z (z = 0 in 2D) and of `id`, the id
   * that the face or cell has so far. Later conditions win.
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

    /// The label as a boundary id. Throws UserError if it is none.
    types::boundary_id
    boundary_id(const unsigned int index) const;

    template <int dim>
    bool
    holds(const unsigned int index,
          const Point<dim>  &position,
          const unsigned int id) const;

  private:
    std::string                                     parameter_path;
    std::vector<std::string>                        labels;
    std::vector<std::string>                        expressions;
    std::vector<std::unique_ptr<FunctionParser<3>>> conditions;
  };
} // namespace stickslip

#endif
