#ifndef stickslip_base_space_time_function_h
#define stickslip_base_space_time_function_h

#include <stickslip/base/amplitude.h>
#include <stickslip/base/types.h>

#include <deal.II/base/function_parser.h>
#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <memory>
#include <string>
#include <vector>

namespace stickslip
{
  /**
   * Components of a vector or scalar, given by the user as muparser
   * expressions of x, y, z (0 in 2D) and t. The constant pi and muparser's
   * functions, including if(condition, a, b), are known.
   */
  template <int dim>
  class SpaceTimeFunction
  {
  public:
    /// The word for a component without a value.
    static constexpr const char *free_word = "free";

    /**
     * Parses @p expressions, @p n_components of them separated by semicolons.
     * With @p allow_free a component may be `free`; without @p depends_on_time
     * there is no t. Throws UserError naming
     * @p path for a wrong number of components and, with muparser's own words,
     * for an expression that cannot be parsed.
     */
    SpaceTimeFunction(const std::string &expressions,
                      const unsigned int n_components,
                      const std::string &path,
                      const bool         allow_free      = false,
                      const bool         depends_on_time = true);

    /// Multiplies all values by an amplitude of the time.
    void
    multiply_by(const std::shared_ptr<const Amplitude> &factor)
    {
      amplitude = factor;
    }

    bool
    is_free(const unsigned int component) const
    {
      return free_components[component];
    }

    /// Value of one component; zero if it is free.
    double
    value(const Point<dim>  &reference_position,
          const double       time,
          const unsigned int component = 0) const;

    /// All of dim components.
    Tensor<1, dim>
    vector(const Point<dim> &reference_position, const double time) const;

  private:
    std::vector<bool>                free_components;
    std::shared_ptr<const Amplitude> amplitude;

    // set_time() is not const; the time is an argument here, not a state.
    std::shared_ptr<FunctionParser<3>> parser;
  };

  /// Splits @p text at semicolons; throws UserError naming @p path unless
  /// there are @p n_components parts, none of them empty.
  std::vector<std::string>
  split_components(const std::string &text,
                   const unsigned int n_components,
                   const std::string &path);
} // namespace stickslip

#endif
