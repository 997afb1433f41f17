#include <stickslip/solid/direction_parameters.h>

#include <stickslip/base/user_error.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/utilities.h>

#include <vector>

namespace stickslip
{
  template <int dim>
  std::pair<Tensor<1, 3>, Point<dim>>
  axis_of(const std::string &rotation_axis,
          const std::string &rotation_centre,
          const std::string &path)
  {
    Tensor<1, 3> axis;
    axis[2] = 1.;
    if (dim == 3)
      axis = vector_from_parameter<3>(rotation_axis, path + "/Rotation axis");
    if (axis.norm() == 0.)
      throw UserError(path + "/Rotation axis has no length.");
    axis /= axis.norm();

    Point<dim> centre;
    if (!rotation_centre.empty())
      centre = Point<dim>(
        vector_from_parameter<dim>(rotation_centre, path + "/Rotation centre"));
    return {axis, centre};
  }



  template <int dim>
  Tensor<1, dim>
  vector_from_parameter(const std::string &text, const std::string &path)
  {
    Tensor<1, dim>           result;
    const std::string        axes  = "xyz";
    const std::string        word  = Utilities::trim(text);
    const std::size_t        axis  = axes.find(word);
    std::vector<std::string> parts = Utilities::split_string_list(word, ",");

    if (word.size() == 1 && axis < dim)
      {
        result[axis] = 1.;
        return result;
      }
    try
      {
        AssertThrow(parts.size() == dim,
                    ExcDimensionMismatch(parts.size(), dim));
        for (unsigned int d = 0; d < dim; ++d)
          result[d] = Utilities::string_to_double(parts[d]);
      }
    catch (const ExceptionBase &)
      {
        throw UserError(path + " is '" + text + "', but has to be one of " +
                        (dim == 2 ? "x, y" : "x, y, z") + " or " +
                        std::to_string(dim) + " numbers separated by commas.");
      }
    return result;
  }



  template std::pair<Tensor<1, 3>, Point<2>>
  axis_of<2>(const std::string &, const std::string &, const std::string &);
  template std::pair<Tensor<1, 3>, Point<3>>
  axis_of<3>(const std::string &, const std::string &, const std::string &);
  template Tensor<1, 2>
  vector_from_parameter<2>(const std::string &, const std::string &);
  template Tensor<1, 3>
  vector_from_parameter<3>(const std::string &, const std::string &);
} // namespace stickslip
